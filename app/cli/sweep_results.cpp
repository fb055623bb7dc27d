#include "app/cli/sweep_results.h"

#include <fstream>

#include <nlohmann/json.hpp>

#include "app/cli/contact_sheet.h"
#include "app/cli/progress.h"
#include "modeling/text/text_output.h"
#include "sim/take/take.h"
#include "ui/picture/take_pictures.h"

namespace app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kPictureWidth = 240;
constexpr int kPictureHeight = 180;
constexpr int kSamples = 16;

/// Of the report, what is compared between runs.
constexpr std::array<const char*, 9> kColumns{"outcome",      "fragments",    "isolated_nodes",
                                              "broken_bonds", "broken_cells", "steps",
                                              "step_s",       "wall_s",       "state_hash"};

Json reportOf(const fs::path& file) {
  std::ifstream stream(file);
  Json report = Json::parse(stream, nullptr, false);
  return report.is_object() ? report : Json::object();
}

Json valueOf(const std::string& text) {
  Json value = Json::parse(text, nullptr, false);
  return value.is_discarded() ? Json(text) : value;
}

Json rowOf(const SweepGrid& grid, std::size_t run, const fs::path& folder) {
  Json row{{"run", run}};
  const auto values = grid.valuesOf(run);
  for (std::size_t v = 0; v < values.size(); ++v) row[grid.variations()[v].path] = valueOf(values[v]);
  const Json report = reportOf(SweepFiles(folder, run).report);
  for (const char* const key : kColumns) row[key] = report.value(key, Json());
  const Json events = report.value("events", Json::object());
  row["first_break_s"] = events.value("first_break_s", Json());
  row["breaks"] = events.value("breaks", Json());
  row["max_rise"] = report.value("energy", Json::object()).value("max_rise", Json());
  if (row["outcome"].is_null())
    row["outcome"] = "no report: see " + SweepFiles(folder, run).log.filename().string();
  return row;
}

/// As spreadsheets read it: in quotes where it holds a comma, a quote or a line's end.
std::string cellOf(const Json& value) {
  if (value.is_null()) return "";
  const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + "\"";
}

sim::Status writeTables(const Json& rows, const fs::path& folder) {
  modeling::TextOutput json(folder / "sweep.json");
  json << rows.dump(1) << "\n";
  if (auto status = json.finish(); !status) return status;
  modeling::TextOutput csv(folder / "sweep.csv");
  bool first = true;
  for (const auto& [key, value] : rows[0].items()) {
    csv << (first ? "" : ",") << cellOf(key);
    first = false;
  }
  for (const Json& row : rows) {
    csv << "\n";
    first = true;
    for (const auto& [key, value] : row.items()) {
      csv << (first ? "" : ",") << cellOf(value);
      first = false;
    }
  }
  csv << "\n";
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
  Json rows = Json::array();
  ContactSheet sheet(kPictureWidth, kPictureHeight, grid.columns(), grid.runs());
  Progress progress("pictures");
  std::size_t failed = 0;
  for (std::size_t run = 0; run < grid.runs(); ++run) {
    rows.push_back(rowOf(grid, run, folder));
    if (rows.back()["outcome"] != "done") ++failed;
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
