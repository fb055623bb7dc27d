#include "ui/panels/file_field.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QPointer>
#include <QToolButton>

#include "ui/document/stored_path.h"
#include "ui/panels/plain_fields.h"
#include "ui/theme/theme.h"

namespace ui {

FileField::FileField(const QString& patterns, QWidget* parent) : QWidget(parent), patterns_(patterns) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2);
  text_ = new TextField(this);
  row->addWidget(text_, 1);
  button_ = new QToolButton(this);
  button_->setObjectName(QStringLiteral("choose-file"));
  button_->setIcon(Theme::icon(QStringLiteral("folder-open")));
  button_->setToolTip(tr("Choose a file"));
  row->addWidget(button_);
  setFocusProxy(text_);
  connect(text_, &TextField::edited, this, &FileField::edited);
  connect(button_, &QToolButton::clicked, this, &FileField::choose);
}

void FileField::setValue(const QString& path) {
  text_->setValue(path);
}

void FileField::choose() {
  // The form that this is in may be made anew while the question stands.
  const QPointer<FileField> self(this);
  const QString chosen = QFileDialog::getOpenFileName(window(), tr("Choose a File"), folder_,
                                                      tr("Files (%1);;All files (*)").arg(patterns_));
  if (!self || chosen.isEmpty()) return;
  emit edited(QString::fromStdString(storedPath(chosen.toStdString(), folder_.toStdString())));
}

}  // namespace ui
