#include "ui/panels/takes_model.h"

#include <QLocale>
#include <QPainter>

#include "ui/session/session.h"
#include "ui/theme/theme.h"
#include "ui/timeline/scene_difference.h"
#include "ui/timeline/time_painting.h"

namespace ui {
namespace {

constexpr QSize kPicture(88, 56);
constexpr int kMargin = 8;
constexpr int kRowHeight = kPicture.height() + 2 * kMargin;

QRect pictureRect(const QRect& row) {
  return {row.left() + kMargin, row.top() + kMargin, kPicture.width(), kPicture.height()};
}

QRect textRect(const QRect& row) {
  return row.adjusted(2 * kMargin + kPicture.width(), kMargin, -kMargin, -kMargin);
}

QString lengthOf(const Take& take) {
  const std::size_t frames = take.footage->frameCount();
  const QString text = frames == 1 ? TakesModel::tr("%1 s, %2 frame") : TakesModel::tr("%1 s, %2 frames");
  return text.arg(take.footage->duration(), 0, 'f', 3).arg(frames);
}

QString originOf(const Take& take) {
  if (!take.note.isEmpty()) return take.note;
  if (take.continuedAt) return TakesModel::tr("continued at %1 s").arg(*take.continuedAt, 0, 'f', 4);
  return take.made.isValid() ? QLocale().toString(take.made.time(), QLocale::ShortFormat) : QString();
}

}  // namespace

TakesModel::TakesModel(Session& session, QObject* parent) : QAbstractListModel(parent), session_(session) {
  connect(&session_.takes(), &TakeList::changed, this, &TakesModel::follow);
  connect(&session_, &Session::runChanged, this, &TakesModel::followRun);
  follow();
}

void TakesModel::follow() {
  const int count = static_cast<int>(session_.takes().size());
  if (count != count_) {
    beginResetModel();
    count_ = count;
    endResetModel();
  } else if (count > 0) {
    emit dataChanged(index(0), index(count - 1));
  }
}

void TakesModel::followRun() {
  for (int row = 0; row < count_; ++row) {
    if (session_.takes()[static_cast<std::size_t>(row)].footage == session_.run()->footage)
      emit dataChanged(index(row), index(row));
  }
}

int TakesModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : count_;
}

QVariant TakesModel::data(const QModelIndex& index, int role) const {
  const auto row = static_cast<std::size_t>(index.row());
  if (!index.isValid() || row >= session_.takes().size()) return {};
  const Take& take = session_.takes()[row];
  if (role == Qt::DisplayRole || role == Qt::EditRole) return take.name;
  if (role == Qt::ToolTipRole) return tipOf(take);
  return {};
}

QString TakesModel::tipOf(const Take& take) const {
  QStringList lines{take.name, lengthOf(take)};
  if (take.made.isValid()) lines << QLocale().toString(take.made, QLocale::ShortFormat);
  if (take.continuedAt) lines << tr("Continued at %1 s").arg(*take.continuedAt, 0, 'f', 4);
  if (!take.note.isEmpty()) lines << take.note;
  if (take.stale) {
    const QStringList differences = differencesOf(*take.footage->scene(), session_.document().scene());
    lines << tr("The scene was changed since: %1").arg(differences.join(QStringLiteral(", ")));
  }
  lines << QString::fromStdString(take.footage->file().string());
  return lines.join(QLatin1Char('\n'));
}

bool TakesModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const QString name = value.toString().trimmed();
  if (role != Qt::EditRole || name.isEmpty()) return false;
  session_.takes().rename(static_cast<std::size_t>(index.row()), name);
  return true;
}

Qt::ItemFlags TakesModel::flags(const QModelIndex& index) const {
  return QAbstractListModel::flags(index) | Qt::ItemIsEditable;
}

TakeDelegate::TakeDelegate(Session& session, QObject* parent)
    : QStyledItemDelegate(parent), session_(session) {}

QSize TakeDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const {
  return {2 * kMargin + kPicture.width() + 80, kRowHeight};
}

void TakeDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                        const QModelIndex&) const {
  QRect line = textRect(option.rect);
  line.setHeight(26);
  editor->setGeometry(line.translated(-6, -4));
}

void TakeDelegate::paintPicture(QPainter& painter, const QRect& frame, const Take& take) const {
  const Colours& colours = Theme::instance().colours();
  painter.fillRect(frame, colours.field);
  if (take.thumbnail.isNull()) {
    Theme::icon(QStringLiteral("takes"))
        .paint(&painter, frame.adjusted(30, 14, -30, -14), Qt::AlignCenter, QIcon::Disabled);
  } else {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(frame, take.thumbnail);
  }
  painter.setPen(colours.line);
  painter.drawRect(frame.adjusted(0, 0, -1, -1));
}

void TakeDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const {
  const auto row = static_cast<std::size_t>(index.row());
  if (row >= session_.takes().size()) return;
  const Take& take = session_.takes()[row];
  const Colours& colours = Theme::instance().colours();
  painter->save();
  const bool current = session_.takes().current() == row;
  if (current) {
    painter->fillRect(option.rect, mixed(colours.panel, colours.accent, 0.22));
    painter->fillRect(QRect(option.rect.left(), option.rect.top(), 3, option.rect.height()), colours.accent);
  } else if (option.state.testFlag(QStyle::State_MouseOver)) {
    painter->fillRect(option.rect, colours.raised);
  }
  paintPicture(*painter, pictureRect(option.rect), take);

  const QRect text = textRect(option.rect);
  QFont strong = option.font;
  strong.setWeight(QFont::DemiBold);
  painter->setFont(strong);
  painter->setPen(colours.text);
  QRect line(text.left(), text.top(), text.width(), 18);
  const bool running = session_.hasRun() && session_.run()->footage == take.footage;
  const QString mark = running ? tr("running") : take.stale ? tr("changed") : QString();
  const int markWidth = mark.isEmpty() ? 0 : QFontMetrics(option.font).horizontalAdvance(mark) + 8;
  painter->drawText(line, Qt::AlignVCenter,
                    QFontMetrics(strong).elidedText(take.name, Qt::ElideRight, line.width() - markWidth));
  painter->setFont(option.font);
  painter->setPen(running ? colours.good : colours.warning);
  painter->drawText(line, Qt::AlignVCenter | Qt::AlignRight, mark);
  painter->setPen(colours.dimText);
  for (const QString& below : {lengthOf(take), originOf(take)}) {
    line.translate(0, 19);
    painter->drawText(line, Qt::AlignVCenter,
                      QFontMetrics(option.font).elidedText(below, Qt::ElideRight, line.width()));
  }
  painter->restore();
}

}  // namespace ui
