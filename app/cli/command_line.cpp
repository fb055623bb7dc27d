#include "app/cli/command_line.h"

#include <cmath>
#include <type_traits>

#include <CLI/CLI.hpp>

namespace app {
namespace {

/// Whole numbers are checked as such, so that help and errors show no decimal point.
template <class Value>
void addRange(CLI::Option& added, const Range& range, const Value*) {
  added.check(CLI::Range(range.least, range.most));
}
void addRange(CLI::Option& added, const Range& range, const int*) {
  added.check(CLI::Range(static_cast<int>(range.least), static_cast<int>(range.most)));
}
void addRange(CLI::Option& added, const Range& range, const std::uint64_t*) {
  addRange(added, range, static_cast<const int*>(nullptr));
}
void addRange(CLI::Option& added, const Range& range, const std::vector<int>*) {
  addRange(added, range, static_cast<const int*>(nullptr));
}

/// NaN compares with nothing, so that a range lets it through.
const CLI::Validator kFinite(
    [](std::string& text) {
      double number = 0.0;
      const bool finite = !CLI::detail::lexical_cast(text, number) || std::isfinite(number);
      return finite ? std::string() : "not a finite number: " + text;
    },
    "");

template <class Value>
constexpr bool isOfFloats() {
  if constexpr (std::is_floating_point_v<Value>) return true;
  if constexpr (requires { typename Value::value_type; })
    return std::is_floating_point_v<typename Value::value_type>;
  return false;
}

CLI::Option* addTo(CLI::App& command, const Option& option) {
  return std::visit(
      [&](auto* target) {
        if constexpr (std::is_same_v<decltype(target), bool*>) {
          return command.add_flag(option.name, *target, option.help);
        } else {
          CLI::Option* const added = command.add_option(option.name, *target, option.help);
          if constexpr (isOfFloats<std::remove_pointer_t<decltype(target)>>()) added->check(kFinite);
          if (option.range) addRange(*added, *option.range, target);
          return added;
        }
      },
      option.target);
}

void add(CLI::App& command, const Option& option) {
  CLI::Option* const added = addTo(command, option);
  if (option.required) added->required();
  if (option.oneAtATime) added->allow_extra_args(false);
  if (option.positive) added->check(CLI::PositiveNumber);
  if (!option.oneOf.empty()) added->check(CLI::IsMember(option.oneOf));
  if (!option.excludes.empty()) added->excludes(command.get_option(option.excludes));
  if (!option.shownDefault.empty()) added->default_str(option.shownDefault);
}

/// `chosen` becomes the command that the line names.
void add(CLI::App& parent, const Command& command, const Command*& chosen) {
  CLI::App* const added = parent.add_subcommand(command.name, command.help);
  for (const Option& option : command.options) add(*added, option);
  if (command.run) added->callback([&] { chosen = &command; });
  if (!command.commands.empty()) added->require_subcommand(1);
  for (const Command& part : command.commands) add(*added, part, chosen);
}

}  // namespace

ExitStatus runCommandLine(const Command& program, const std::string& version, int argc, char** argv) {
  CLI::App line(program.help, program.name);
  line.require_subcommand(1);
  line.set_version_flag("--version", version);
  const Command* chosen = nullptr;
  for (const Command& command : program.commands) add(line, command, chosen);
  try {
    line.parse(argc, argv);
  } catch (const CLI::Success& wish) {
    line.exit(wish);
    return ExitStatus::done;
  } catch (const CLI::ParseError& error) {
    return complain({"command line", error.what(), "see smithereens-cli --help"});
  }
  return chosen->run();
}

}  // namespace app
