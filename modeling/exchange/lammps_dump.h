#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "modeling/import/lammps_box.h"
#include "modeling/text/line_tokens.h"
#include "modeling/text/packed_text.h"
#include "sim/base/result.h"

namespace modeling {

/// One moment of a LAMMPS text dump (`dump custom` or `dump local`): a table whose columns have names.
struct LammpsDumpFrame {
  std::uint64_t step = 0;
  std::optional<double> time;  ///< where the dump states it (dump_modify time yes)
  std::string units;           ///< LAMMPS' name of them, where the dump states it (dump_modify units yes)
  std::optional<LammpsBox> box;
  std::vector<std::string> columns;  ///< of those that were asked for
  std::vector<double> numbers;       ///< row by row
  std::uint32_t line = 0;            ///< of the file, of the first row

  std::size_t rows() const { return columns.empty() ? 0 : numbers.size() / columns.size(); }
  /// Of the column of this name; nothing where there is none.
  std::optional<std::size_t> column(std::string_view name) const;
};

/// Reads a dump, which may be packed by gzip, moment by moment. Columns that nobody asked for are passed
/// over, whatever stands in them. Memory grows with what one moment holds, and with no more than `mostRows`
/// rows of it; a line of more than kLongestLine letters is a Problem, and so is anything that is not as
/// LAMMPS writes it. A Problem's place is FILE:LINE:COLUMN.
class LammpsDumpReader {
 public:
  static constexpr std::size_t kLongestLine = 4096;
  static constexpr std::size_t kMostColumns = 64;

  /// `wanted`: names of columns; none: all of them.
  LammpsDumpReader(const std::filesystem::path& file, std::size_t mostRows,
                   std::vector<std::string> wanted = {});

  /// The next moment, nothing at the end of the file.
  sim::Result<std::optional<LammpsDumpFrame>> next();

 private:
  PackedText::Line readLine();
  sim::Problem problem(std::string what, std::uint32_t column = 1) const;
  sim::Status readHead(LammpsDumpFrame& frame, std::uint64_t& rows);
  sim::Status readSection(LammpsDumpFrame& frame, std::uint64_t& rows, bool& table);
  sim::Status readBox(LammpsDumpFrame& frame);
  sim::Status readColumns(LammpsDumpFrame& frame);
  sim::Status readRow(LammpsDumpFrame& frame);
  sim::Status needLine();

  std::string name_;
  PackedText source_;
  std::size_t mostRows_;
  std::vector<std::string> wanted_;
  std::vector<bool> isWanted_;  ///< of the columns of the moment that is read
  std::string units_;           ///< LAMMPS states them once, at the head of a file
  std::string text_;
  std::uint32_t line_ = 0;
};

}  // namespace modeling
