#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "modeling/text/line_tokens.h"
#include "sim/base/result.h"

namespace modeling {

/// One moment of a LAMMPS text dump (`dump custom` or `dump local`): a table whose columns have names.
struct LammpsDumpFrame {
  std::uint64_t step = 0;
  std::optional<double> time;  ///< where the dump states it (dump_modify time yes)
  std::vector<std::string> columns;
  std::vector<double> numbers;  ///< row by row
  std::uint32_t line = 0;       ///< of the file, of the first row

  std::size_t rows() const { return columns.empty() ? 0 : numbers.size() / columns.size(); }
  /// Of the column of this name; nothing where there is none.
  std::optional<std::size_t> column(std::string_view name) const;
};

/// Reads a dump moment by moment. Memory grows with what one moment holds, and with no more than
/// `mostRows` rows of it; a line of more than kLongestLine letters is a Problem, and so is anything that is
/// not as LAMMPS writes it. A Problem's place is FILE:LINE:COLUMN.
class LammpsDumpReader {
 public:
  static constexpr std::size_t kLongestLine = 4096;
  static constexpr std::size_t kMostColumns = 64;

  LammpsDumpReader(const std::filesystem::path& file, std::size_t mostRows);

  /// The next moment, nothing at the end of the file.
  sim::Result<std::optional<LammpsDumpFrame>> next();

 private:
  enum class Line { read, end, tooLong };
  Line readLine();
  sim::Problem problem(std::string what, std::uint32_t column = 1) const;
  sim::Status readHead(LammpsDumpFrame& frame, std::uint64_t& rows);
  sim::Status readSection(LammpsDumpFrame& frame, std::uint64_t& rows, bool& table);
  sim::Status readRow(LammpsDumpFrame& frame);
  sim::Status needLine();

  std::string name_;
  std::ifstream stream_;
  std::size_t mostRows_;
  std::string text_;
  std::uint32_t line_ = 0;
};

}  // namespace modeling
