// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/manual/completion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/listings.h"
#include "app/manual/command_tree.h"
#include "compare/methods/optimize_opacities.h"
#include "completion_files.h"
#include "core/error.h"
#include "core/options/names.h"

namespace pellucid::app {
namespace {

/// A Place is where names of a table stand: after an option, or first after a command.
struct Place {
  std::string_view after;
  std::string_view listing;  // empty: methods that find opacities
};
constexpr Place places[] = {{"--method", "methods"}, {"-m", "methods"},
                            {"--opacities", ""},     {"--integrator", "integrators"},
                            {"--field", "fields"},   {"--against", "integrators"},
                            {"--metric", "metrics"}, {"study", "studies"}};

std::string names_in(std::string_view listing) {
  if (listing.empty()) return fmt::format("{}", fmt::join(compare::opacity_methods(), " "));
  std::vector<std::string> names;
  for (const auto& row : find_row("listing", listing, listings()).make())
    names.push_back(row["name"]);
  return fmt::format("{}", fmt::join(names, " "));
}

std::string listing_names() {
  std::vector<std::string_view> names;
  for (const Listing& listing : listings()) names.push_back(listing.name);
  return fmt::format("{}", fmt::join(names, " "));
}

std::string options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    std::ranges::copy(names_of(*option), std::back_inserter(names));
  return fmt::format("{}", fmt::join(names, " "));
}

/// The branches of a `case`, in either shell, over the word before.
std::string after_options() {
  std::string text;
  for (const Place& place : places)
    if (place.after.starts_with('-'))
      text += fmt::format("    {}) candidates='{}' ;;\n", place.after, names_in(place.listing));
  return text;
}

std::string first_words(const CLI::App& command) {
  if (command.get_name() == "list") return listing_names();
  for (const Place& place : places)
    if (place.after == command.get_name()) return names_in(place.listing);
  return {};
}

/// The branches of a `case`, in either shell, over the command.
std::string of_commands(const CLI::App& program) {
  std::string text;
  for (const CLI::App* command : commands_of(program))
    text += fmt::format("    {}) options='{}'; first='{}' ;;\n", command->get_name(),
                        options_of(*command), first_words(*command));
  return text;
}

void fill(std::string& script, const std::string& mark, const std::string& text) {
  for (auto at = script.find(mark); at != std::string::npos;
       at = script.find(mark, at + text.size()))
    script.replace(at, mark.size(), text);
}

std::string script_of(const std::string& shell) {
  if (shell == "bash") return std::string(completion_files::completion_bash());
  if (shell == "zsh") return std::string(completion_files::completion_zsh());
  throw InputError(unknown_name("shell", shell, std::vector<std::string_view>{"bash", "zsh"}));
}

}  // namespace

std::string completion(const CLI::App& program, const std::string& shell) {
  std::string script = script_of(shell);
  fill(script, "@commands@", fmt::format("{}", fmt::join(command_names(program), " ")));
  fill(script, "@options@", options_of(program));
  fill(script, "@after_options@", after_options());
  fill(script, "@of_commands@", of_commands(program));
  return script;
}

}  // namespace pellucid::app
