#pragma once

#include <QString>

#include "sim/base/result.h"

namespace ui {

/// What is wrong and how to mend it, in sentences, without the place: for where the person sees the place.
inline QString textOf(const sim::Problem& problem) {
  const auto sentence = [](const std::string& words) {
    QString text = QString::fromStdString(words);
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text.isEmpty() || text.endsWith(u'.') ? text : text + u'.';
  };
  return (sentence(problem.what) + u' ' + sentence(problem.remedy)).trimmed();
}

}  // namespace ui
