#include "ui/panels/empty_scene.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>

#include "ui/panels/add_actions.h"
#include "ui/panels/dish_picture.h"
#include "ui/session/session.h"
#include "ui/theme/theme.h"

namespace ui {
namespace {

constexpr int kColumns = 3;
constexpr QSize kTile(116, 104);
constexpr QSize kPicture(56, 56);

QToolButton* tile(const QString& text, const QIcon& icon, const QString& help, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  button->setText(text);
  button->setIcon(icon);
  button->setIconSize(kPicture);
  button->setFixedSize(kTile);
  button->setToolTip(help);
  return button;
}

}  // namespace

EmptyScene::EmptyScene(Session& session, AddActions& actions, QWidget* over)
    : QWidget(over), session_(session) {
  setObjectName(QStringLiteral("empty-scene"));
  auto* title = new QLabel(tr("Start with a dish"), this);
  QFont font = title->font();
  font.setPointSizeF(font.pointSizeF() + 4.0);
  font.setWeight(QFont::DemiBold);
  title->setFont(font);
  title->setAlignment(Qt::AlignCenter);
  auto* hint = new QLabel(tr("Raise it, and press Space to let it fall. Shift+A adds more."), this);
  hint->setForegroundRole(QPalette::PlaceholderText);
  hint->setAlignment(Qt::AlignCenter);
  auto* grid = new QGridLayout;
  grid->setSpacing(6);
  int index = 0;
  for (const ProfilePreset preset : kProfilePresets) {
    const NewThing& thing = newThing(nameInScene(preset));
    QToolButton* button = tile(nameOf(preset), dishIcon(preset), thing.help, this);
    button->setObjectName(QStringLiteral("add-") + nameOf(preset).toLower());
    grid->addWidget(button, index / kColumns, index % kColumns);
    connect(button, &QToolButton::clicked, &actions, [&actions, &thing] { actions.add(thing); });
    ++index;
  }
  auto* more = new QPushButton(Theme::icon(QStringLiteral("add")), tr("Something Else…"), this);
  auto* menu = new QMenu(more);
  actions.fill(*menu);
  more->setMenu(menu);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(20, 18, 20, 18);
  column->setSpacing(10);
  column->addWidget(title);
  column->addLayout(grid);
  column->addWidget(more, 0, Qt::AlignHCenter);
  column->addWidget(hint);
  over->installEventFilter(this);
  connect(&session_.document(), &Document::sceneChanged, this, &EmptyScene::showScene);
  connect(&session_, &Session::shownChanged, this, &EmptyScene::showScene);
  connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
  showScene();
}

void EmptyScene::showScene() {
  // A take may be looked at while there is no scene.
  setVisible(session_.document().scene().parts.empty() && !session_.shown().recorded);
  place();
}

void EmptyScene::place() {
  adjustSize();
  const QRect over = parentWidget()->rect();
  move(over.center() - QPoint(width() / 2, height() / 2));
}

bool EmptyScene::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && (event->type() == QEvent::Resize || event->type() == QEvent::Show))
    place();
  return QWidget::eventFilter(watched, event);
}

void EmptyScene::paintEvent(QPaintEvent*) {
  const Colours& colours = Theme::instance().colours();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(colours.line);
  painter.setBrush(colours.panel);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 8.0, 8.0);
}

}  // namespace ui
