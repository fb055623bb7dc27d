#include "ui/document/place_words.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <optional>

#include "ui/document/selection.h"

namespace ui {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("PlaceWords", text);
}

struct List {
  const char* path;
  ItemKind kind;
  const char* words;
};

constexpr List kLists[] = {
    {"parts", ItemKind::part, QT_TRANSLATE_NOOP("PlaceWords", "Part “%1”")},
    {"glue", ItemKind::gluing, QT_TRANSLATE_NOOP("PlaceWords", "Glue of %1")},
    {"environment.colliders", ItemKind::collider, QT_TRANSLATE_NOOP("PlaceWords", "Collider “%1”")},
    {"materials", ItemKind::material, QT_TRANSLATE_NOOP("PlaceWords", "Material “%1”")},
    {"tracks", ItemKind::track, QT_TRANSLATE_NOOP("PlaceWords", "Track “%1”")}};

/// "outside[2].startAngle" as "outside 3, start angle".
QString fieldInWords(const QString& path) {
  QStringList words;
  for (const QString& step : path.split('.', Qt::SkipEmptyParts)) {
    static const QRegularExpression index(QStringLiteral("\\[(\\d+)\\]"));
    static const QRegularExpression hump(QStringLiteral("([a-z])([A-Z])"));
    QString word = step;
    for (auto match = index.match(word); match.hasMatch(); match = index.match(word))
      word.replace(match.capturedStart(), match.capturedLength(),
                   QStringLiteral(" %1").arg(match.captured(1).toInt() + 1));
    words.append(word.replace(hump, QStringLiteral("\\1 \\2")).toLower());
  }
  return words.join(QStringLiteral(", "));
}

/// The item of the list that the path begins with, and what of the path is left.
std::optional<std::pair<Item, QString>> itemAt(const modeling::Scene& scene, const List& list,
                                               const QString& place) {
  const QString head = QString::fromLatin1(list.path);
  if (!place.startsWith(head)) return std::nullopt;
  const QString rest = place.mid(head.size());
  static const QRegularExpression byIndex(QStringLiteral("^\\[(\\d+)\\](.*)$"));
  if (const auto match = byIndex.match(rest); match.hasMatch())
    return std::pair(Item{list.kind, static_cast<std::size_t>(match.captured(1).toULongLong())},
                     match.captured(2));
  // Materials stand in the file by their names.
  for (std::size_t index = 0; rest.startsWith('.') && index < countOf(scene, list.kind); ++index) {
    const Item item{list.kind, index};
    const QString name = nameOf(scene, item);
    if (rest == '.' + name || rest.startsWith('.' + name + '.'))
      return std::pair(item, rest.mid(1 + name.size()));
  }
  return std::nullopt;
}

}  // namespace

QString placeInWords(const modeling::Scene& scene, const std::string& place) {
  const QString text = QString::fromStdString(place);
  for (const List& list : kLists) {
    const auto found = itemAt(scene, list, text);
    if (!found) continue;
    const QString name = nameOf(scene, found->first);
    if (name.isEmpty()) break;
    const QString field = fieldInWords(found->second);
    const QString item = tr(list.words).arg(name);
    return field.isEmpty() ? item : item + QStringLiteral(", ") + field;
  }
  static const QRegularExpression path(QStringLiteral("^(environment|solver|output|view)\\.[\\w.\\[\\]]+$"));
  if (path.match(text).hasMatch()) {
    QString words = fieldInWords(text);
    words[0] = words[0].toUpper();
    return words;
  }
  return text;
}

}  // namespace ui
