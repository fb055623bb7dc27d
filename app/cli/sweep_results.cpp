#include "app/cli/sweep_results.h"

#include <fstream>

#include "app/cli/contact_sheet.h"
#include "app/cli/progress.h"
#include "app/results/json.h"
#include "modeling/text/text_output.h"
#include "sim/take/take.h"
#include "ui/picture/take_pictures.h"

namespace app {

namespace {

namespace fs = std::filesystem;

constexpr int kPictureWidth = 240;
constexpr int kPictureHeight = 180;
constexpr int kSamples = 16;

/// Of the report, what is compared between runs.
constexpr std::array<const char*, 9> kColumns{"outcome",      "fragments",    "isolated_nodes",
                                              "broken_bonds", "broken_cells", "steps",
                                              "step_s",       "wall_s",       "state_hash"};

Json reportOf(const fs::path& file) {
  std::ifstream stream(file);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return parseJson(text).value_or(Json());
}

Json valueOf(const std::string& text) {
  return parseJson(text).value_or(Json(text));
}

/// The member, or null where there is none.
Json memberOf(const Json& object, std::string_view key) {
  const Json* const member = object.find(key);
  return member == nullptr ? Json() : *member;
}

Json rowOf(const SweepGrid& grid, std::size_t run, const fs::path& folder) {
  Json row{{"run", run}};
  const auto values = grid.valuesOf(run);
  for (std::size_t v = 0; v < values.size(); ++v) row[grid.variations()[v].path] = valueOf(values[v]);
  const Json report = reportOf(SweepFiles(folder, run).report);
  for (const char* const key : kColumns) row[key] = memberOf(report, key);
  const Json events = memberOf(report, "events");
  row["first_break_s"] = memberOf(events, "first_break_s");
  row["breaks"] = memberOf(events, "breaks");
  row["max_rise"] = memberOf(memberOf(report, "energy"), "max_rise");
  if (row["outcome"].get<Json::Null>() != nullptr)
    row["outcome"] = "no report: see " + SweepFiles(folder, run).log.filename().string();
  return row;
}

/// As spreadsheets read it: in quotes where it holds a comma, a quote or a line's end.
std::string cellOf(const Json& value) {
  if (value.get<Json::Null>() != nullptr) return "";
  const auto* const words = value.get<std::string>();
  const std::string text = words != nullptr ? *words : dumped(value);
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + "\"";
}

/// The cells, with commas between.
template <class Cell>
std::string lineOf(const Json& row, Cell cell) {
  std::string line;
  for (const JsonMember& member : *row.get<Json::Object>()) line += cell(member) + ",";
  line.back() = '\n';
  return line;
}

sim::Status writeTables(const Json::Array& rows, const fs::path& folder) {
  modeling::TextOutput json(folder / "sweep.json");
  json << dumped(rows, 1) << "\n";
  if (auto status = json.finish(); !status) return status;
  modeling::TextOutput csv(folder / "sweep.csv");
  csv << lineOf(rows.front(), [](const JsonMember& member) { return cellOf(member.key); });
  for (const Json& row : rows)
    csv << lineOf(row, [](const JsonMember& member) { return cellOf(member.value); });
  return csv.finish();
}

/// Of the last frame; nothing where it cannot be drawn.
std::optional<ui::Image> pictureOf(const fs::path& file) {
  const auto take = sim::TakeReader::open(file);
  if (!take || (*take)->frameCount() == 0) return std::nullopt;
  const std::size_t last = (*take)->frameCount() - 1;
  auto frames = ui::framesOf(**take);
  if (!frames) return std::nullopt;
  auto pictures = ui::TakePictures::create(std::move(*frames), last, last,
                                           static_cast<double>(kPictureWidth) / kPictureHeight);
  if (!pictures) return std::nullopt;
  const auto scene = pictures->sceneOf(last);
  if (!scene) return std::nullopt;
  ui::PictureSettings settings;
  settings.width = kPictureWidth;
  settings.height = kPictureHeight;
  settings.samples = kSamples;
  auto image = ui::renderPicture(*scene, settings);
  if (!image) return std::nullopt;
  return std::move(*image);
}

}  // namespace

SweepFiles::SweepFiles(const fs::path& folder, std::size_t run) {
  std::string number = std::to_string(run);
  number.insert(0, 4 - std::min<std::size_t>(4, number.size()), '0');
  take = folder / ("run-" + number + ".take");
  report = folder / ("run-" + number + ".json");
  log = folder / ("run-" + number + ".log");
}

sim::Result<std::size_t> collectResults(const SweepGrid& grid, const fs::path& folder) {
  Json::Array rows;
  ContactSheet sheet(kPictureWidth, kPictureHeight, grid.columns(), grid.runs());
  Progress progress("pictures");
  std::size_t failed = 0;
  for (std::size_t run = 0; run < grid.runs(); ++run) {
    rows.push_back(rowOf(grid, run, folder));
    if (rows.back().textAt("outcome") != "done") ++failed;
    if (const auto picture = pictureOf(SweepFiles(folder, run).take)) {
      sheet.place(run, *picture);
    } else {
      sheet.leave(run);
    }
    progress.show(static_cast<double>(run + 1) / static_cast<double>(grid.runs()));
  }
  if (auto status = writeTables(rows, folder); !status) return status.problem();
  if (auto status = ui::writePng(folder / "sweep.png", sheet.image()); !status) return status.problem();
  return failed;
}

}  // namespace app
