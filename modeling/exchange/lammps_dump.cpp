#include "modeling/exchange/lammps_dump.h"

#include <algorithm>
#include <utility>

namespace modeling {

namespace {

std::vector<Token> wordsOf(std::string_view text) {
  LineTokens tokens(text, LammpsDumpReader::kMostColumns + 3);
  if (!tokens.next()) return {};
  return tokens.words();
}

bool isItem(std::string_view text, std::string_view name) {
  return text.starts_with("ITEM: ") && text.substr(6).starts_with(name);
}

}  // namespace

std::optional<std::size_t> LammpsDumpFrame::column(std::string_view name) const {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns.begin());
}

LammpsDumpReader::LammpsDumpReader(const std::filesystem::path& file, std::size_t mostRows,
                                   std::vector<std::string> wanted)
    : name_(file.string()), source_(file), mostRows_(mostRows), wanted_(std::move(wanted)) {}

sim::Problem LammpsDumpReader::problem(std::string what, std::uint32_t column) const {
  return {name_ + ":" + std::to_string(line_) + ":" + std::to_string(column), std::move(what),
          "let LAMMPS write it anew, by the input that was exported"};
}

PackedText::Line LammpsDumpReader::readLine() {
  const PackedText::Line read = source_.next(text_, kLongestLine);
  if (read != PackedText::Line::end) ++line_;
  if (!text_.empty() && text_.back() == '\r') text_.pop_back();
  return read;
}

sim::Status LammpsDumpReader::needLine() {
  switch (readLine()) {
    case PackedText::Line::read:
      return sim::Done{};
    case PackedText::Line::end:
      return problem("the file ends in the middle of a moment");
    case PackedText::Line::damaged:
      return problem("what is packed in this file is damaged or cut off");
    case PackedText::Line::tooLong:
      break;
  }
  return problem("this line is too long for a dump");
}

sim::Status LammpsDumpReader::readRow(LammpsDumpFrame& frame) {
  if (auto status = needLine(); !status) return status;
  const auto words = wordsOf(text_);
  if (words.size() != isWanted_.size()) {
    return problem("this row has " + std::to_string(words.size()) + " words, not " +
                   std::to_string(isWanted_.size()));
  }
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!isWanted_[i]) continue;
    const auto number = words[i].number();
    if (!number) return problem("this is no finite number", words[i].column);
    frame.numbers.push_back(*number);
  }
  return sim::Done{};
}

/// "ITEM: BOX BOUNDS", with "xy xz yz" of a tilted box or "abc origin" of one of any edges, and where its
/// faces are periodic.
sim::Status LammpsDumpReader::readBox(LammpsDumpFrame& frame) {
  const std::string title = text_;
  const bool general = title.find("abc origin") != std::string::npos;
  const bool tilted = title.find("xy xz yz") != std::string::npos;
  const std::size_t count = general ? 4 : tilted ? 3 : 2;
  Eigen::Matrix<double, 3, 4> numbers = Eigen::Matrix<double, 3, 4>::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    if (auto status = needLine(); !status) return status;
    const auto words = wordsOf(text_);
    if (words.size() < count)
      return problem("a line of the box should have " + std::to_string(count) + " numbers");
    for (std::size_t i = 0; i < count; ++i) {
      const auto number = words[i].number();
      if (!number) return problem("this is no finite number", words[i].column);
      numbers(axis, static_cast<Eigen::Index>(i)) = *number;
    }
  }
  LammpsBox box;
  if (general) {
    box.edges = numbers.leftCols<3>().transpose();
    box.origin = numbers.col(3);
  } else {
    box = LammpsBox::ofOuterBounds(numbers.col(0), numbers.col(1), numbers.col(2));
  }
  const auto words = wordsOf(title);
  for (std::size_t axis = 0; axis < 3 && words.size() >= 3; ++axis)
    box.periodic[axis] = words[words.size() - 3 + axis].text == "pp";
  if (box.hasVolume()) frame.box = box;
  return sim::Done{};
}

/// The title of the rows.
sim::Status LammpsDumpReader::readColumns(LammpsDumpFrame& frame) {
  const auto words = wordsOf(text_);
  if (words.size() < 3 || words.size() - 2 > kMostColumns)
    return problem("this names too few or too many columns");
  isWanted_.clear();
  for (std::size_t i = 2; i < words.size(); ++i) {
    const std::string name(words[i].text);
    isWanted_.push_back(wanted_.empty() || std::find(wanted_.begin(), wanted_.end(), name) != wanted_.end());
    if (isWanted_.back()) frame.columns.push_back(name);
  }
  return sim::Done{};
}

/// A section of the head, whose title is in text_; `table` is set when it is the title of the rows.
sim::Status LammpsDumpReader::readSection(LammpsDumpFrame& frame, std::uint64_t& rows, bool& table) {
  table = isItem(text_, "ATOMS") || isItem(text_, "ENTRIES");
  if (table) return readColumns(frame);
  if (isItem(text_, "BOX BOUNDS")) return readBox(frame);
  const bool step = isItem(text_, "TIMESTEP");
  const bool time = !step && isItem(text_, "TIME");
  const bool count = isItem(text_, "NUMBER OF");
  const bool units = isItem(text_, "UNITS");
  if (!text_.starts_with("ITEM: "))
    return problem("this is no dump of LAMMPS: a section begins with \"ITEM: \"");
  if (auto status = needLine(); !status) return status;
  const auto words = wordsOf(text_);
  if (units && !words.empty()) units_ = words[0].text;
  if (!step && !time && !count) return sim::Done{};
  const auto whole = words.empty() ? std::nullopt : words[0].integer();
  const auto number = words.empty() ? std::nullopt : words[0].number();
  if (time ? !number : !whole || *whole < 0) return problem("this should be a number");
  if (time) frame.time = number;
  if (step) frame.step = static_cast<std::uint64_t>(*whole);
  if (count) rows = static_cast<std::uint64_t>(*whole);
  return sim::Done{};
}

sim::Status LammpsDumpReader::readHead(LammpsDumpFrame& frame, std::uint64_t& rows) {
  bool table = false;
  while (true) {
    if (auto status = readSection(frame, rows, table); !status) return status;
    if (table) break;
    if (auto status = needLine(); !status) return status;
  }
  frame.line = line_ + 1;
  frame.units = units_;
  if (rows > mostRows_) {
    return problem("there are " + std::to_string(rows) + " rows, more than the " + std::to_string(mostRows_) +
                   " that the scene can have");
  }
  return sim::Done{};
}

sim::Result<std::optional<LammpsDumpFrame>> LammpsDumpReader::next() {
  if (!source_.isOpen()) return sim::Problem{name_, "cannot read this file", "look at its name and place"};
  const PackedText::Line first = readLine();
  if (first == PackedText::Line::end) return std::optional<LammpsDumpFrame>();
  if (first == PackedText::Line::damaged) return problem("what is packed in this file is damaged or cut off");
  if (first == PackedText::Line::tooLong) return problem("this line is too long for a dump");
  if (const auto packer = unknownPacker(text_); !packer.empty() && line_ == 1)
    return sim::Problem{name_ + ":1:1", "this file is packed by " + std::string(packer),
                        "unpack it, or pack it by gzip"};
  LammpsDumpFrame frame;
  std::uint64_t rows = 0;
  if (auto status = readHead(frame, rows); !status) return status.problem();
  for (std::uint64_t row = 0; row < rows; ++row) {
    if (auto status = readRow(frame); !status) return status.problem();
  }
  return std::optional<LammpsDumpFrame>(std::move(frame));
}

}  // namespace modeling
