#pragma once

#include <QWidget>
#include <memory>

class QAction;
class QLineEdit;
class QListView;
class QStackedWidget;

namespace ui {

class Footage;
class PlayActions;
class Session;
class TakesModel;

/// The takes, newest last, with a picture of each; the one on the timeline is the selected one.
class TakesPanel : public QWidget {
  Q_OBJECT

 public:
  TakesPanel(Session& session, PlayActions& actions, QWidget* parent = nullptr);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* makeEmpty();
  void makeButtons();
  void showTakes();
  void selectInList();
  std::size_t selected() const;
  void takeNote();
  void play();
  void remove();
  void saveAs();
  void open();
  void showMenu(const QPoint& at);

  Session& session_;
  PlayActions& actions_;
  TakesModel* model_ = nullptr;
  QStackedWidget* stack_ = nullptr;
  QListView* list_ = nullptr;
  QLineEdit* note_ = nullptr;
  std::weak_ptr<Footage> noted_;  ///< the take whose note is in the field
  QWidget* bar_ = nullptr;
  QAction* rename_ = nullptr;
  QAction* play_ = nullptr;
  QAction* remove_ = nullptr;
  QAction* save_ = nullptr;
  QAction* open_ = nullptr;
};

}  // namespace ui
