#pragma once

#include <string>
#include <vector>

#include "sim/base/types.h"

namespace modeling {

/// As LAMMPS reads it, to the last digit.
std::string lammpsNumber(double value);
/// Three numbers, separated by blanks.
std::string lammpsNumbers(const sim::Vec3& vector);

/// A script of LAMMPS, written line by line.
class LammpsText {
 public:
  LammpsText& line(const std::string& text);
  /// An atom-style variable.
  LammpsText& variable(const std::string& name, const std::string& formula);
  /// What is done by builds with the BPM package, and by those without.
  LammpsText& either(const std::vector<std::string>& bpm, const std::vector<std::string>& without);
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  int jumps_ = 0;
};

}  // namespace modeling
