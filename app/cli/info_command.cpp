#include "app/cli/info_command.h"

#include <cstdio>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/cli/describe.h"
#include "modeling/text/json_text.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

struct InfoOptions {
  std::string file;
  bool json = false;
};

constexpr int kLabelWidth = 26;

std::string plainText(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.6g", value.get<double>());
    return digits;
  }
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const Json& item : value) text += (text.empty() ? "" : "  ") + plainText(item);
  return text;
}

/// Objects are indented below their name; a list of them repeats the name.
void print(const Json& object, int indent) {
  for (const auto& [key, value] : object.items()) {
    std::string label(static_cast<std::size_t>(indent), ' ');
    for (const char letter : key) label += letter == '_' ? ' ' : letter;
    if (value.is_object()) {
      std::cout << label << '\n';
      print(value, indent + 2);
    } else if (value.is_array() && !value.empty() && value[0].is_object()) {
      for (const Json& item : value) {
        std::cout << label << '\n';
        print(item, indent + 2);
      }
    } else if (value.is_array() && !value.empty() && value[0].is_string()) {
      for (const Json& item : value) std::cout << label << ": " << plainText(item) << '\n';
    } else if (!value.is_array() || !value.empty()) {
      label.resize(std::max<std::size_t>(label.size() + 1, kLabelWidth), ' ');
      std::cout << label << plainText(value) << '\n';
    }
  }
}

ExitStatus inform(const InfoOptions& options) {
  const sim::Result<Json> info = describe(options.file);
  if (!info) return complain(info.problem());
  if (options.json) {
    std::cout << modeling::jsonText(*info);
  } else {
    print(*info, 0);
  }
  return ExitStatus::done;
}

}  // namespace

void addInfoCommand(CLI::App& program, ExitStatus& status) {
  CLI::App* command = program.add_subcommand("info", "Say what is in a scene, a take or a network file");
  const auto options = std::make_shared<InfoOptions>();
  command->add_option("file", options->file, "The file")->required();
  command->add_flag("--json", options->json, "As JSON");
  command->callback([options, &status] { status = inform(*options); });
}

}  // namespace app
