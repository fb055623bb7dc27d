#include "modeling/exchange/lammps_text.h"

#include <array>
#include <charconv>

namespace modeling {

std::string lammpsNumber(double value) {
  std::array<char, 32> digits;
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

std::string lammpsNumbers(const sim::Vec3& vector) {
  return lammpsNumber(vector.x()) + " " + lammpsNumber(vector.y()) + " " + lammpsNumber(vector.z());
}

LammpsText& LammpsText::line(const std::string& text) {
  text_ += text + "\n";
  return *this;
}

LammpsText& LammpsText::variable(const std::string& name, const std::string& formula) {
  return line("variable " + name + " atom \"" + formula + "\"");
}

LammpsText& LammpsText::either(const std::vector<std::string>& bpm, const std::vector<std::string>& without) {
  const std::string end = "end" + std::to_string(++jumps_);
  const std::string other = "without" + std::to_string(jumps_);
  line("if \"${bpm} == 0\" then \"jump SELF " + other + "\"");
  for (const std::string& command : bpm) line(command);
  line("jump SELF " + end).line("label " + other);
  for (const std::string& command : without) line(command);
  return line("label " + end);
}

}  // namespace modeling
