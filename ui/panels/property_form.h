#pragma once

#include <QWidget>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "ui/panels/number_field.h"
#include "ui/session/session.h"

class QLabel;
class QVBoxLayout;

namespace ui {

class ChoiceField;
class ColourField;
class FileField;
class Section;
class TextField;
class VectorField;

/// What stands before a field, and where in the scene's file its value is.
struct RowLabel {
  using Counts = std::function<bool(modeling::Scene&, const Item&)>;

  QString text;
  QString help;      ///< the tooltip
  std::string path;  ///< behind the item's own, as in ".resolution.cellSize"
  QString unit{};    ///< said behind the text, where the field does not show it
  Counts counts{};   ///< whether the value is looked at; the row is hidden where it is not
};

/// The properties of one item of the scene, or of several of one kind, as rows in sections. A row reads from
/// the scene and writes into it, for each of the items.
class PropertyForm : public QWidget {
  Q_OBJECT

 public:
  using Scene = modeling::Scene;
  template <class T>
  using Read = std::function<T(Scene&, const Item&)>;
  template <class T>
  using Write = std::function<void(Scene&, const Item&, const T&)>;
  using MaybeNumber = std::optional<double>;

  /// The items are of one kind and at least one; the last is the one whose values are shown.
  PropertyForm(Session& session, std::vector<Item> items, QWidget* parent = nullptr);

  Session& session() { return session_; }
  const std::vector<Item>& items() const { return items_; }
  const Item& current() const { return items_.back(); }
  /// Such as "parts[2]"; "" for the scene.
  std::string itemPath() const;
  /// Where in the scene's file the values of the rows are, whether they are hidden at present or not.
  std::vector<std::string> paths() const;

  /// Rows that follow stand in it. It is folded at first where it is not `open`, until a person opens it.
  Section* beginSection(const QString& title, bool open = true);
  void endSection() { section_ = nullptr; }

  NumberField* addNumber(const RowLabel& label, const NumberFormat& format, const Read<MaybeNumber>& read,
                         const Write<MaybeNumber>& write, MaybeNumber standard);
  /// `place` answers null where there is no such value.
  VectorField* addVector(const RowLabel& label, const NumberFormat& format,
                         const std::function<sim::Vec3*(Scene&, const Item&)>& place,
                         const sim::Vec3& standard);
  QWidget* addCheck(const RowLabel& label, const std::function<bool*(Scene&, const Item&)>& place);
  ChoiceField* addChoice(const RowLabel& label, const std::vector<std::pair<QString, QVariant>>& choices,
                         const Read<QVariant>& read, const Write<QVariant>& write);
  TextField* addText(const RowLabel& label, const Read<QString>& read, const Write<QString>& write);
  /// A path, relative to the scene's folder where it can be, of a file of these patterns.
  FileField* addFile(const RowLabel& label, const QString& patterns,
                     const std::function<std::string*(Scene&, const Item&)>& place);
  ColourField* addColour(const RowLabel& label,
                         const std::function<modeling::Colour*(Scene&, const Item&)>& place);
  /// One that may be absent, which `absent` says in words, with a button that takes it away.
  ColourField* addColour(const RowLabel& label, const QString& absent,
                         const std::function<std::optional<modeling::Colour>*(Scene&, const Item&)>& place);
  /// A field of another kind; `show` brings it up to date.
  QWidget* addRow(const RowLabel& label, QWidget* field, const std::function<void(Scene&)>& show);
  /// Across the whole width, without the label's text.
  void addWide(QWidget* content, const std::function<void(Scene&)>& show = {}, const RowLabel& label = {});

  /// What is typed in it is for things that are not there any more, or not in their places: it changes
  /// nothing from now on.
  void forsake() { forsaken_ = true; }
  /// Brings all rows up to date.
  void showScene();
  /// Shows a problem of the preview at the row it belongs to; null takes it away. False: it is not of these
  /// items.
  bool showProblem(const sim::Problem* problem);

  /// For fields of one's own: an edit of all items. Until one is `finished` they are one step of the history.
  void apply(const QString& what, const std::function<void(Scene&, const Item&)>& change,
             bool finished = true);

 private:
  struct Row {
    std::string path;
    QWidget* widget = nullptr;
    QWidget* field = nullptr;
    QLabel* problem = nullptr;
    RowLabel::Counts counts;
    std::function<void(Scene&)> show;
  };
  Row& insert(const RowLabel& label, QWidget* field, bool wide);
  const Row* rowOf(const std::string& place) const;

  Session& session_;
  std::vector<Item> items_;
  bool forsaken_ = false;
  std::vector<Row> rows_;
  QVBoxLayout* column_;
  QLabel* problem_;  ///< of the item as a whole
  Section* section_ = nullptr;
};

}  // namespace ui
