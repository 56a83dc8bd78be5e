// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "compare/methods/methods.h"
#include "compare/report/tables.h"
#include "compare/results/provenance.h"
#include "compare/run/run_study.h"
#include "compare/study/study.h"
#include "core/error.h"

namespace pellucid::app {
namespace {

struct StudyArguments {
  std::string name_or_file;
  std::filesystem::path folder;
  bool resume = false;
  std::string only;
  std::string report = "auto";
};

const std::map<std::string, compare::ReportForm::Kind> report_kinds = {
    {"auto", compare::ReportForm::Kind::automatic},
    {"file", compare::ReportForm::Kind::file},
    {"folder", compare::ReportForm::Kind::folder}};

compare::ReportForm report_form(const StudyArguments& arguments, const GlobalOptions& globals) {
  return {.kind = report_kinds.at(arguments.report), .command = globals.command_line};
}

std::string milliseconds_and_memory(const compare::ResultRow& row) {
  if (!row.given.empty())
    return row.steps.empty() ? "given" : fmt::format("{:9.1f} ms, given", row.seconds.median * 1e3);
  return fmt::format("{:9.1f} ms {:9.1f} MB", row.seconds.median * 1e3,
                     double(row.total_bytes()) / 1e6);
}

/// On a terminal the line of the progress stands where the row goes.
void clear_progress_line() {
  if (::isatty(STDOUT_FILENO) != 0 && ::isatty(STDERR_FILENO) != 0) fmt::print("\r\x1b[K");
}

void print_row(const compare::ResultRow& row) {
  clear_progress_line();
  const std::string name = row.parameters.empty()
                               ? fmt::format("{}/{}", row.scene, row.method)
                               : fmt::format("{}/{}:{}", row.scene, row.method, row.parameters);
  if (!row.error.empty()) return fmt::print("{:40} failed: {}\n", name, row.error);
  for (const std::string& fault : row.given_faults)
    fmt::print("{:40} the picture {}\n", name, fault);
  const compare::Metrics& m = row.metrics.linear;
  const std::optional<double> ssim = m.of("ssim");
  fmt::print("{:40} RMSE {:9.3e}  SSIM {}  {}\n", name, m.of("rmse").value_or(NAN),
             ssim ? fmt::format("{:.4f}", *ssim) : "none  ", milliseconds_and_memory(row));
  std::fflush(stdout);
}

void check_failures(const compare::StudyOutcome& outcome, const std::filesystem::path& folder) {
  const auto failed = [](const compare::ResultRow& row) { return !row.error.empty(); };
  const auto count = std::count_if(outcome.rows.begin(), outcome.rows.end(), failed);
  if (count == 0) return;
  const auto first = std::find_if(outcome.rows.begin(), outcome.rows.end(), failed);
  throw WorkError(fmt::format("{} of {} cells failed, the first: {}/{}: {} (all: {})", count,
                              outcome.rows.size(), first->scene, first->method, first->error,
                              (folder / "results.csv").string()));
}

void run(const StudyArguments& arguments, const GlobalOptions& globals) {
  const compare::Study study =
      compare::load_study(compare::find_study(arguments.name_or_file), compare::callable_methods());
  compare::StudyOptions options;
  options.folder = arguments.folder;
  if (options.folder.empty()) options.folder = std::filesystem::path("results") / study.name;
  options.resume = arguments.resume;
  options.only = arguments.only;
  options.report = report_form(arguments, globals);
  options.context.gl = globals.gl;
  options.progress = console_progress(globals);
  if (!globals.json && !globals.quiet) options.on_row = print_row;
  for (const compare::LeftOutScene& scene : study.left_out)
    std::cerr << "pellucid: " << scene.text() << '\n';
  const compare::StudyOutcome outcome = compare::run_study(study, options);
  if (globals.json)
    fmt::print("{}", compare::results_json(study, outcome.rows));
  else if (!globals.quiet)
    fmt::print("{} cells computed, {} kept; report: {}\n", outcome.computed, outcome.kept,
               (options.folder / "report.html").string());
  for (const std::string& warning : compare::provenance_warnings(outcome.rows))
    std::cerr << "pellucid: " << warning << '\n';
  check_failures(outcome, options.folder);
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
  command->add_flag("--resume", arguments->resume, "Keep the cells that are finished");
  command->add_option("--only", arguments->only,
                      "Run the cells whose SCENE, METHOD or SCENE/METHOD:PARAMETERS fits this "
                      "pattern, such as 'abc/*'; the others' rows are kept");
  command
      ->add_option("--report", arguments->report,
                   "The report as one file, or as a folder whose page loads pictures when they are "
                   "looked at; auto: one file up to 60 MB")
      ->check(CLI::IsMember(report_kinds))
      ->capture_default_str();
  command->footer(
      "Example: pellucid study quickstart -o first --resume --report folder\n"
      "Exit code: 0 done; 1 a cell failed; 2 wrong input.");
  add_global_options(*command, globals);
  add_gl_option(*command, globals);
  command->callback([arguments, &globals] { run(*arguments, globals); });
}

}  // namespace pellucid::app
