#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/describe.h"
#include "modeling/text/printable.h"

namespace app {
namespace {

struct InfoOptions {
  std::string file;
  bool json = false;
};

constexpr int kLabelWidth = 26;

std::string plainText(const Json& value) {
  if (const auto* const words = value.get<std::string>()) return modeling::printable(*words);
  if (const auto* const number = value.get<double>()) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.6g", *number);
    return digits;
  }
  const auto* const items = value.get<Json::Array>();
  if (items == nullptr) return modeling::printable(dumped(value));
  std::string text;
  for (const Json& item : *items) text += (text.empty() ? "" : "  ") + plainText(item);
  return text;
}

/// Objects are indented below their name; a list of them repeats the name.
void print(const Json::Object& object, int indent) {
  for (const auto& [key, value] : object) {
    std::string label(static_cast<std::size_t>(indent), ' ');
    label += modeling::printable(key);
    std::replace(label.begin(), label.end(), '_', ' ');
    const auto* const inner = value.get<Json::Object>();
    const auto* const items = value.get<Json::Array>();
    if (inner != nullptr) {
      std::cout << label << '\n';
      print(*inner, indent + 2);
    } else if (items != nullptr && !items->empty() && items->front().get<Json::Object>() != nullptr) {
      for (const Json& item : *items) {
        std::cout << label << '\n';
        print(*item.get<Json::Object>(), indent + 2);
      }
    } else if (items != nullptr && !items->empty() && items->front().get<std::string>() != nullptr) {
      for (const Json& item : *items) std::cout << label << ": " << plainText(item) << '\n';
    } else if (items == nullptr || !items->empty()) {
      label.resize(std::max<std::size_t>(label.size() + 1, kLabelWidth), ' ');
      std::cout << label << plainText(value) << '\n';
    }
  }
}

ExitStatus inform(const InfoOptions& options) {
  const sim::Result<Json> info = describe(options.file);
  if (!info) return complain(info.problem());
  if (options.json) {
    std::cout << readable(*info);
  } else {
    print(*info->get<Json::Object>(), 0);
  }
  return ExitStatus::done;
}

}  // namespace

Command infoCommand() {
  const auto options = std::make_shared<InfoOptions>();
  return {.name = "info",
          .help = "Say what is in a scene, a take or a network file",
          .options = {{.name = "file", .target = &options->file, .help = "The file", .required = true},
                      {"--json", &options->json, "As JSON"}},
          .run = [options] { return inform(*options); }};
}

}  // namespace app
