// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/study/print_rows.h"
#include "app/study/study_cells.h"
#include "compare/methods/methods.h"
#include "compare/report/tables.h"
#include "compare/run/run_study.h"
#include "compare/study/study.h"

namespace pellucid::app {
namespace {

struct StudyArguments {
  std::string name_or_file;
  std::filesystem::path folder;
  bool resume = false;
  std::vector<std::string> only;
  std::string report = "auto";
  bool plan = false, collect = false;
  std::string cell;
};

const std::map<std::string, compare::ReportForm::Kind> report_kinds = {
    {"auto", compare::ReportForm::Kind::automatic},
    {"file", compare::ReportForm::Kind::file},
    {"folder", compare::ReportForm::Kind::folder}};

compare::ReportForm report_form(const StudyArguments& arguments, const GlobalOptions& globals) {
  return {.kind = report_kinds.at(arguments.report), .command = globals.command_line};
}

compare::StudyOptions study_options(const StudyArguments& arguments, const GlobalOptions& globals,
                                    const compare::Study& study) {
  compare::StudyOptions options;
  options.folder = arguments.folder;
  if (options.folder.empty()) options.folder = std::filesystem::path("results") / study.name;
  options.resume = arguments.resume;
  options.only = arguments.only;
  options.report = report_form(arguments, globals);
  options.context.gl = globals.gl;
  options.progress = console_progress(globals);
  if (!globals.json && !globals.quiet) options.on_row = print_row;
  return options;
}

void run_all(const compare::Study& study, const compare::StudyOptions& options,
             const GlobalOptions& globals) {
  const compare::StudyOutcome outcome = compare::run_study(study, options);
  if (globals.json)
    fmt::print("{}", compare::results_json(study, outcome.rows));
  else if (!globals.quiet)
    fmt::print("{} cells computed, {} kept; report: {}\n", outcome.computed, outcome.kept,
               (options.folder / "report.html").string());
  print_warnings(outcome.rows);
  check_complete(outcome.rows, {}, options.folder);
}

void run(const StudyArguments& arguments, const GlobalOptions& globals) {
  const compare::Study study =
      compare::load_study(compare::find_study(arguments.name_or_file), compare::callable_methods());
  const compare::StudyOptions options = study_options(arguments, globals, study);
  for (const compare::LeftOutScene& scene : study.left_out)
    std::cerr << "pellucid: " << scene.text() << '\n';
  if (arguments.plan) return print_plan(study, options);
  if (!arguments.cell.empty()) return run_cell(study, arguments.cell, options, globals);
  if (arguments.collect) return collect(study, options, globals);
  run_all(study, options, globals);
}

/// The same study cell by cell: one of the three, and no choice of cells by a pattern beside it.
void add_cell_options(CLI::App& command, StudyArguments& arguments, CLI::Option& resume,
                      CLI::Option& only) {
  CLI::Option* plan = command.add_flag(
      "--plan", arguments.plan,
      "Print a line of JSON for each cell: its name, the cells that it needs, an estimate of "
      "seconds and bytes; compute nothing");
  CLI::Option* cell = command.add_option(
      "--cell", arguments.cell,
      "Compute this one cell, SCENE/METHOD:PARAMETERS, and write its own files alone: any number "
      "at once, on any machines that share the folder");
  CLI::Option* collect = command.add_flag(
      "--collect", arguments.collect,
      "Write tables and report of the cells that are there, and say which are missing");
  plan->excludes(cell)->excludes(collect)->excludes(&only)->excludes(&resume);
  cell->excludes(collect)->excludes(&only);
  collect->excludes(&only)->excludes(&resume);
}

}  // namespace

void add_study_command(CLI::App& app, GlobalOptions& globals) {
  auto arguments = std::make_shared<StudyArguments>();
  CLI::App* command =
      app.add_subcommand("study", "Run scenes × methods × parameters and write a report");
  command->add_option("STUDY", arguments->name_or_file, "A study's name (see list) or file")
      ->required();
  command->add_option("-o,--output", arguments->folder,
                      "Folder for the results; by default results/NAME");
  CLI::Option* resume =
      command->add_flag("--resume", arguments->resume, "Keep the cells that are finished");
  CLI::Option* only =
      command
          ->add_option("--only", arguments->only,
                       "Run the cells whose SCENE, METHOD or SCENE/METHOD:PARAMETERS fits this "
                       "pattern, such as 'abc/*', or that of a further --only; the others' rows "
                       "are kept")
          ->allow_extra_args(false);
  command
      ->add_option("--report", arguments->report,
                   "The report as one file, or as a folder whose page loads pictures when they are "
                   "looked at; auto: one file up to 60 MB")
      ->check(CLI::IsMember(report_kinds))
      ->capture_default_str();
  add_cell_options(*command, *arguments, *resume, *only);
  command->footer(
      "Example: pellucid study quickstart -o first --resume --report folder\n"
      "Cell by cell, on any machines: pellucid study quickstart -o first --plan\n"
      "  pellucid study quickstart -o first --cell abc-24-surfaces/raytrace\n"
      "  pellucid study quickstart -o first --collect\n"
      "Exit code: 0 done; 1 a cell failed or is missing; 2 wrong input.");
  add_global_options(*command, globals);
  add_gl_option(*command, globals);
  command->callback([arguments, &globals] { run(*arguments, globals); });
}

}  // namespace pellucid::app
