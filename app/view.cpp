// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/commands.h"
#include "compare/changes/past_run.h"
#include "core/files/json_text.h"
#include "core/files/output_file.h"
#include "view/scenes/saved_camera.h"
#include "view/site/gate.h"
#include "view/site/http_server.h"
#include "view/site/results_files.h"
#include "view/site/site.h"
#include "view/site/terminal_end.h"

namespace pellucid::app {
namespace {

struct ViewArguments {
  std::filesystem::path what, study;
  int port = 0;
};

view::SiteContent content_of(const ViewArguments& arguments) {
  view::SiteContent content = compare::is_run_folder(arguments.what)
                                  ? view::results_content(arguments.what)
                                  : view::SiteContent{{{arguments.what, true}}};
  if (arguments.study.empty()) return content;
  view::with_view(arguments.study.string(), read_text(arguments.study), {});  // throws if it can't
  content.study = arguments.study;
  return content;
}

void print_line(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

/// Serves until the terminal ends it. What runs is cancelled, so that no thread waits.
void serve(view::HttpServer& server, view::Site& site, const view::TerminalEnd& end) {
  std::thread listening([&] { server.serve(); });
  end.wait();
  site.end();
  server.stop();
  listening.join();
}

void run(const ViewArguments& arguments, const GlobalOptions& globals) {
  view::SiteContent content = content_of(arguments);
  const bool is_scene = !content.results;
  view::Site site(std::move(content), globals.gl, [&](const std::string& line) {
    if (!globals.quiet) print_line(line);
  });
  if (is_scene) site.load(0, console_progress(globals));
  const view::TerminalEnd end;  // until here a signal ends the program as it does any other command
  std::unique_ptr<view::Gate> gate;
  view::HttpServer server(
      arguments.port,
      [&](const view::Question& question) {
        auto refusal = gate->refuse(question);
        return refusal ? std::make_unique<view::Answer>(std::move(*refusal)) : nullptr;
      },
      [&](const view::Question& question) {
        return site.answer(question, gate->inner_path(question));
      });
  gate = std::make_unique<view::Gate>(view::random_token(), server.port());
  if (globals.json)
    print_line(json_text({{"address", gate->address()}}));
  else
    print_line(gate->address());
  serve(server, site, end);
}

}  // namespace

void add_view_command(CLI::App& app, GlobalOptions& globals) {
  CLI::App* command = app.add_subcommand(
      "view", "Serve a page on this machine: turn a scene, compare methods, probe pixels");
  const auto arguments = std::make_shared<ViewArguments>();
  command
      ->add_option("SCENE|RESULTS", arguments->what,
                   "Scene file, or the folder that a study has filled")
      ->required();
  command->add_option("--port", arguments->port, "Port of 127.0.0.1; 0: any free one")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  command->add_option("--study", arguments->study,
                      "Study file to whose views the page's 'add to study' adds a camera");
  command->footer(
      "Prints the page's address, whose random part lets in who has it, and serves until Ctrl-C, "
      "or until\nthe terminal or the standard input ends. Only a scene, and a study, that are "
      "named here are\nwritten to, and only by the page's 'save camera' and 'add to study'.\n"
      "Examples:\n  pellucid view scenes/tornado.json\n"
      "  pellucid view scenes/tornado.json --study mine.json");
  add_gl_option(*command, globals);
  add_global_options(*command, globals);
  command->callback([arguments, &globals] { run(*arguments, globals); });
}

}  // namespace pellucid::app
