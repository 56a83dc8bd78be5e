// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The program's commands as manual pages and completions walk them.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace pellucid::app {

/// Returns the subcommands of the program, in the order of --help.
inline std::vector<const CLI::App*> commands_of(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App*) { return true; });
}

/// Returns their names.
inline std::vector<std::string> command_names(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : commands_of(program)) names.push_back(command->get_name());
  return names;
}

/// Returns the names of an option as they are typed, short ones first: "-m", "--method".
inline std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back('-' + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

}  // namespace pellucid::app
