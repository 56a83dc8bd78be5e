// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "app/commands.h"
#include "app/info/inspect.h"
#include "app/info/views.h"
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
  const auto views = std::make_shared<ViewsOptions>();
  CLI::Option* cameras =
      command
          ->add_option("--cameras", views->count,
                       "Of a scene: so many views that show most of it, and their "
                       "cameras, to be pasted into its file")
          ->check(CLI::Range(1, 64));
  command->add_option("-o,--output", views->output, "Contact sheet of them: .png, .pdf or .svg")
      ->needs(cameras);
  command->footer(
      "Examples:\n  pellucid info flow.vti\n  pellucid info scene.json --json\n"
      "  pellucid info scene.json --cameras 9 -o views.png");
  add_global_options(*command, globals);
  command->callback([file, views, &globals] {
    views->count > 0 ? tell_views(*file, *views, globals) : info(*file, globals);
  });
}

}  // namespace pellucid::app
