#include "ui/files/recent_files.h"

#include <QCryptographicHash>
#include <QDir>
#include <QSettings>
#include <QStandardPaths>
#include <algorithm>

#include "ui/files/saved_picture.h"

namespace ui {
namespace {

const QString kKey = QStringLiteral("recentFiles");

QString pictureFile(const std::filesystem::path& file) {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/pictures";
  QDir().mkpath(folder);
  const QByteArray name = QByteArray::fromStdString(file.string());
  const QByteArray hash = QCryptographicHash::hash(name, QCryptographicHash::Sha1).toHex();
  return folder + "/" + QString::fromLatin1(hash) + ".png";
}

std::filesystem::path wholePath(const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::path whole = std::filesystem::weakly_canonical(file, error);
  return error ? file : whole;
}

}  // namespace

RecentFiles::RecentFiles(QObject* parent) : QObject(parent) {
  const QStringList stored = QSettings().value(kKey).toStringList();
  for (const QString& file : stored) files_.emplace_back(file.toStdString());
}

std::vector<std::filesystem::path> RecentFiles::files() const {
  std::vector<std::filesystem::path> present;
  std::error_code error;
  std::copy_if(files_.begin(), files_.end(), std::back_inserter(present),
               [&](const std::filesystem::path& file) { return std::filesystem::exists(file, error); });
  return present;
}

void RecentFiles::add(const std::filesystem::path& file) {
  const std::filesystem::path whole = wholePath(file);
  std::erase(files_, whole);
  files_.insert(files_.begin(), whole);
  if (files_.size() > kMost) files_.resize(kMost);
  store();
  emit changed();
}

void RecentFiles::remove(const std::filesystem::path& file) {
  std::erase(files_, wholePath(file));
  store();
  emit changed();
}

void RecentFiles::clear() {
  files_.clear();
  store();
  emit changed();
}

QImage RecentFiles::picture(const std::filesystem::path& file) const {
  return QImage(pictureFile(wholePath(file)));
}

void RecentFiles::setPicture(const std::filesystem::path& file, const QImage& picture) {
  // A picture less in the gallery is nothing to tell of.
  static_cast<void>(savePicture(picture, pictureFile(wholePath(file)).toStdString()));
  emit changed();
}

void RecentFiles::store() const {
  QStringList list;
  for (const std::filesystem::path& file : files_) list.append(QString::fromStdString(file.string()));
  QSettings().setValue(kKey, list);
}

}  // namespace ui
