#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <string>

/// What the monkey does, one thing at a time, as a line of its log: so that a log can be played again.
namespace monkey {

/// A verb and its words, such as "press 520 311 left shift"; Performer lists the verbs.
struct Action {
  int wait = 0;  ///< ms before it
  QString verb;
  QStringList words;

  /// The wait, the verb and the words, parted by tabs.
  std::string line() const;
  static std::optional<Action> read(const QString& line);
};

}  // namespace monkey
