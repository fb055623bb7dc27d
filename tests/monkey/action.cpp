#include "tests/monkey/action.h"

namespace monkey {

std::string Action::line() const {
  QStringList all{QString::number(wait), verb};
  return (all + words).join(u'\t').toStdString();
}

std::optional<Action> Action::read(const QString& line) {
  const QStringList all = line.split(u'\t');
  bool isNumber = false;
  const int wait = all.front().toInt(&isNumber);
  if (!isNumber || all.size() < 2) return std::nullopt;
  return Action{wait, all[1], all.mid(2)};
}

}  // namespace monkey
