#pragma once

#include <QObject>
#include <QTimer>
#include <memory>

#include "ui/viewport/draw_preparer.h"

namespace ui {

class Session;

/// The draw data of what the session shows, kept up to date: asks the preparer for it whenever something else
/// is shown, or shown otherwise, and looks for it until it is there.
class DrawFeed : public QObject {
  Q_OBJECT

 public:
  explicit DrawFeed(Session& session, QObject* parent = nullptr);

  /// As chosen, without what the document hides.
  const ViewSettings& settings() const { return settings_; }
  void setSettings(const ViewSettings& settings);
  /// The newest that was ready; never null.
  const std::shared_ptr<const DrawData>& drawn() const { return drawn_; }
  /// What is shown by the session and chosen to view is what is drawn.
  bool isUpToDate() const;

 signals:
  /// There is newer draw data.
  void changed();
  /// What is shown cannot be drawn.
  void failed(const sim::Problem& problem);

 private:
  ViewSettings effectiveSettings() const;
  void prepare();
  void prepareIfHidden();
  void takePrepared();

  Session& session_;
  ViewSettings settings_;
  ViewSettings requested_;  ///< of the preparer
  std::shared_ptr<const DrawData> drawn_;
  QTimer preparing_;
  DrawPreparer preparer_;
};

}  // namespace ui
