// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "app/commands.h"
#include "app/info/inspect.h"
#include "core/files/json_text.h"

namespace pellucid::app {
namespace {

void info(const std::string& file, const GlobalOptions& globals) {
  const FileContents contents = inspect(file, console_progress(globals));
  if (globals.json)
    std::cout << json_text(to_json(contents), 2) << '\n';
  else
    print(contents);
}

}  // namespace

void add_info_command(CLI::App& app, GlobalOptions& globals) {
  CLI::App* command = app.add_subcommand("info", "Tell what a file or a scene holds");
  const auto file = std::make_shared<std::string>();
  command
      ->add_option("FILE", *file,
                   "Geometry, a field, a picture, a time series or a scene; see 'list formats'")
      ->required();
  command->footer("Examples:\n  pellucid info flow.vti\n  pellucid info scene.json --json");
  add_global_options(*command, globals);
  command->callback([file, &globals] { info(*file, globals); });
}

}  // namespace pellucid::app
