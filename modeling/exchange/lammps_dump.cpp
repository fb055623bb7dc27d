#include "modeling/exchange/lammps_dump.h"

#include <algorithm>
#include <utility>

namespace modeling {

namespace {

std::vector<Token> wordsOf(std::string_view text) {
  LineTokens tokens(text);
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

LammpsDumpReader::LammpsDumpReader(const std::filesystem::path& file, std::size_t mostRows)
    : name_(file.string()), stream_(file, std::ios::binary), mostRows_(mostRows) {}

sim::Problem LammpsDumpReader::problem(std::string what, std::uint32_t column) const {
  return {name_ + ":" + std::to_string(line_) + ":" + std::to_string(column), std::move(what),
          "let LAMMPS write it anew, by the input that was exported"};
}

LammpsDumpReader::Line LammpsDumpReader::readLine() {
  text_.clear();
  if (stream_.peek() == std::ifstream::traits_type::eof()) return Line::end;
  ++line_;
  for (int letter = stream_.get(); letter != std::ifstream::traits_type::eof() && letter != '\n';
       letter = stream_.get()) {
    if (text_.size() == kLongestLine) return Line::tooLong;
    text_ += static_cast<char>(letter);
  }
  return Line::read;
}

sim::Status LammpsDumpReader::needLine() {
  switch (readLine()) {
    case Line::read:
      return sim::Done{};
    case Line::end:
      return problem("the file ends in the middle of a moment");
    case Line::tooLong:
      break;
  }
  return problem("this line is too long for a dump");
}

sim::Status LammpsDumpReader::readRow(LammpsDumpFrame& frame) {
  if (auto status = needLine(); !status) return status;
  const auto words = wordsOf(text_);
  if (words.size() != frame.columns.size()) {
    return problem("this row has " + std::to_string(words.size()) + " numbers, not " +
                   std::to_string(frame.columns.size()));
  }
  for (const Token& word : words) {
    const auto number = word.number();
    if (!number) return problem("this is no finite number", word.column);
    frame.numbers.push_back(*number);
  }
  return sim::Done{};
}

/// A section of the head, whose title is in text_; `table` is set when it is the title of the rows.
sim::Status LammpsDumpReader::readSection(LammpsDumpFrame& frame, std::uint64_t& rows, bool& table) {
  if (isItem(text_, "ATOMS") || isItem(text_, "ENTRIES")) {
    const auto words = wordsOf(text_);
    if (words.size() < 3 || words.size() - 2 > kMostColumns)
      return problem("this names too few or too many columns");
    for (std::size_t i = 2; i < words.size(); ++i) frame.columns.emplace_back(words[i].text);
    table = true;
    return sim::Done{};
  }
  if (isItem(text_, "BOX BOUNDS")) {
    for (int axis = 0; axis < 3; ++axis) {
      if (auto status = needLine(); !status) return status;
    }
    return sim::Done{};
  }
  const bool step = isItem(text_, "TIMESTEP");
  const bool time = !step && isItem(text_, "TIME");
  const bool count = isItem(text_, "NUMBER OF");
  if (!text_.starts_with("ITEM: "))
    return problem("this is no dump of LAMMPS: a section begins with \"ITEM: \"");
  if (auto status = needLine(); !status) return status;
  const auto words = wordsOf(text_);
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
  if (rows > mostRows_) {
    return problem("there are " + std::to_string(rows) + " rows, more than the " + std::to_string(mostRows_) +
                   " that the scene can have");
  }
  return sim::Done{};
}

sim::Result<std::optional<LammpsDumpFrame>> LammpsDumpReader::next() {
  if (!stream_.is_open()) return sim::Problem{name_, "cannot read this file", "look at its name and place"};
  const Line first = readLine();
  if (first == Line::end) return std::optional<LammpsDumpFrame>();
  if (first == Line::tooLong) return problem("this line is too long for a dump");
  LammpsDumpFrame frame;
  std::uint64_t rows = 0;
  if (auto status = readHead(frame, rows); !status) return status.problem();
  for (std::uint64_t row = 0; row < rows; ++row) {
    if (auto status = readRow(frame); !status) return status.problem();
  }
  return std::optional<LammpsDumpFrame>(std::move(frame));
}

}  // namespace modeling
