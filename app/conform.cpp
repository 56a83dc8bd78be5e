// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>

#include "app/commands.h"
#include "compare/conform/conform.h"
#include "compare/conform/conform_json.h"
#include "compare/methods/given_method.h"
#include "compare/methods/methods.h"
#include "compare/renderers/renderers_report.h"
#include "core/error.h"
#include "core/files/json_text.h"
#include "core/files/output_folder.h"
#include "core/machine/program_run.h"

namespace pellucid::app {
namespace {

namespace fs = std::filesystem;

struct ConformArguments {
  std::string command, method, only, output = "exr";
  fs::path pictures, make, renderers, report;
  double timeout = 600;  // seconds
  double tolerance = compare::conformance_tolerance;
  bool all = false;
};

/// A program that is not there is told before the cases are made.
std::vector<std::string> words_of_command(const std::string& command) {
  std::vector<std::string> words = split_command(command);
  if (!words.empty() && find_program(words.front(), fs::current_path()).empty())
    throw InputError(fmt::format("--command: '{}': no program that may be run", words.front()));
  return words;
}

compare::MethodCall call_of(const ConformArguments& arguments) {
  if (!arguments.command.empty())
    return compare::external_call({.name = "command",
                                   .words = words_of_command(arguments.command),
                                   .timeout = arguments.timeout,
                                   .ending = '.' + arguments.output,
                                   .base = fs::current_path()});
  return compare::parse_call(arguments.method);
}

std::string name_of_renderer(const ConformArguments& arguments) {
  return !arguments.command.empty()  ? arguments.command
         : !arguments.method.empty() ? arguments.method
                                     : arguments.pictures.string();
}

void print_case(const compare::CaseResult& result) {
  const compare::Verdict& v = result.verdict;
  if (v.passed)
    fmt::print("{:22} passed   {:8.1e}  {}\n", result.name, v.max_error, result.what);
  else
    fmt::print("{:22} {:8} {:8.1e}  {}\n", result.name, v.fault, v.max_error, v.explanation);
}

/// Where a family is no longer right.
void print_family(const compare::FamilySummary& family) {
  fmt::print("{:12} {:2} of {:2}", family.family, family.passed, family.cases);
  if (const compare::CaseResult* failed = family.first_failed)
    fmt::print("  first fails: {:20} {}: {}", failed->name, failed->verdict.fault,
               failed->verdict.explanation);
  fmt::print("\n");
}

void print(const nlohmann::ordered_json& json) {
  fmt::print("{}\n", json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

void print_json(const std::vector<compare::CaseResult>& results) {
  nlohmann::ordered_json json{{"judged", "rgb"}};
  json.update(compare::json_of(results));
  print(json);
}

void make_scenes(const ConformArguments& arguments, const GlobalOptions& globals) {
  OutputFolder out(arguments.make);
  out.fill([&](const fs::path& to) { compare::make_conformance_scenes(to, arguments.only); });
  out.commit();
  if (!globals.json && !globals.quiet)
    fmt::print("scenes, right pictures and a list of them: {}\n",
               (arguments.make / "cases.json").string());
}

compare::ConformRequest request_of(const ConformArguments& arguments,
                                   const GlobalOptions& globals) {
  return {.call = {},
          .pictures = arguments.pictures,
          .only = arguments.only,
          .tolerance = arguments.tolerance,
          .context = {.gl = globals.gl},
          .on_case = {}};
}

/// The report appears whole, or not at all; its place is refused before anything is drawn.
class ConformReport {
 public:
  explicit ConformReport(const fs::path& folder) {
    if (!folder.empty()) folder_.emplace(folder);
  }
  void write(const compare::RenderersHead& head, std::span<const compare::RendererResult> results) {
    if (!folder_) return;
    folder_->fill([&](const fs::path& to) { compare::write_renderers_report(to, head, results); });
    folder_->commit();
  }

 private:
  std::optional<OutputFolder> folder_;
};

void print_one(const ConformArguments& arguments, const std::vector<compare::CaseResult>& results) {
  for (const compare::CaseResult& result : results)
    if (arguments.all || !result.verdict.passed) print_case(result);
  fmt::print("\n");
  for (const auto& family : compare::summarize(results)) print_family(family);
  fmt::print("judged: red, green and blue, over the background; not A\n");
}

/// Throws WorkError where a case failed.
void end_with(std::size_t failed, std::size_t cases) {
  std::fflush(stdout);
  if (failed > 0) throw WorkError(fmt::format("{} of {} cases failed", failed, cases));
}

void judge(const ConformArguments& arguments, const GlobalOptions& globals) {
  compare::ConformRequest request = request_of(arguments, globals);
  if (arguments.pictures.empty()) request.call = call_of(arguments);
  if (!request.pictures.empty() && !fs::is_directory(request.pictures))
    throw InputError(
        fmt::format("--pictures {}: no folder; accepted: one that holds NAME.exr or "
                    "NAME.png of the cases",
                    request.pictures.string()));
  ConformReport report_folder(arguments.report);
  const Progress progress = console_progress(globals);
  request.on_case = [&](double done, const compare::CaseResult& result) {
    report(progress, done, result.name);
  };
  const compare::RendererResult result{{.name = name_of_renderer(arguments)},
                                       compare::conform(request)};
  report_folder.write({"What does it draw?", arguments.tolerance}, {&result, 1});
  if (globals.json)
    print_json(result.cases);
  else
    print_one(arguments, result.cases);
  end_with(result.cases.size() - result.passed(), result.cases.size());
}

void print_renderer(const compare::RendererResult& result) {
  if (const std::string why = result.nothing_drawn(); !why.empty())
    fmt::print("{:28} drew nothing: {}\n", result.renderer.name, why);
  else
    fmt::print("{:28} {:2} of {} pass, {:2} are right to two steps of 8 bits\n",
               result.renderer.name, result.passed(), result.cases.size(),
               result.right_to_two_steps());
}

void judge_all(const ConformArguments& arguments, const GlobalOptions& globals) {
  const compare::RendererList list = compare::read_renderer_list(arguments.renderers);
  ConformReport report_folder(arguments.report);
  compare::ConformRequest request = request_of(arguments, globals);
  const Progress progress = console_progress(globals);
  request.on_case = [&](double done, const compare::CaseResult& result) {
    report(progress, done, result.name);
  };
  const auto results = compare::conform_all(list, request);
  const compare::RenderersHead head{list.title, arguments.tolerance};
  report_folder.write(head, results);
  if (globals.json) print(compare::renderers_json(head, results));
  std::size_t failed = 0, cases = 0;
  for (const compare::RendererResult& result : results) {
    if (!globals.quiet && !globals.json) print_renderer(result);
    cases += result.cases.size();
    failed += result.cases.size() - result.passed();
  }
  if (!globals.quiet && !globals.json)
    fmt::print("report: {}\n", (arguments.report / "report.html").string());
  end_with(failed, cases);
}

void run(const ConformArguments& arguments, const GlobalOptions& globals) {
  const int ways = !arguments.command.empty() + !arguments.method.empty() +
                   !arguments.pictures.empty() + !arguments.renderers.empty();
  if (ways > 1 || (ways == 0 && arguments.make.empty()))
    throw InputError(
        "conform: accepted: one of --command, --pictures, --method and --renderers, or --make "
        "alone");
  if (!arguments.renderers.empty() && arguments.report.empty())
    throw InputError("--renderers: accepted: with --report FOLDER");
  if (!arguments.report.empty() && ways == 0)
    throw InputError("--report: accepted: with what is to be judged");
  if (!arguments.make.empty()) make_scenes(arguments, globals);
  if (!arguments.renderers.empty())
    judge_all(arguments, globals);
  else if (ways == 1)
    judge(arguments, globals);
}

}  // namespace

void add_conform_command(CLI::App& app, GlobalOptions& globals) {
  CLI::App* command = app.add_subcommand(
      "conform", "Hold any renderer to scenes of transparency with answers in closed form");
  const auto arguments = std::make_shared<ConformArguments>();
  command->add_option("--command", arguments->command,
                      "Program and arguments that draw a case, in which {scene}, {camera} and "
                      "{output} stand for files; no shell sees it");
  command->add_option("--pictures", arguments->pictures,
                      "Folder with a picture NAME.exr or NAME.png of each case");
  command->add_option("-m,--method", arguments->method,
                      "A method of this program: NAME[:key=value,...]");
  command->add_option("--renderers", arguments->renderers,
                      "A list of programs, methods and folders of pictures to ask, see "
                      "docs/conformance.md; takes --report");
  command->add_option("--report", arguments->report,
                      "Folder for a page with all pictures, report.html, results.json and "
                      "table.md; it appears whole or not at all");
  command->add_option("--make", arguments->make,
                      "Write the scenes, as 'export' does, and the right pictures to this folder");
  command->add_option("--only", arguments->only,
                      "The cases whose name fits this pattern: 'edges-*'");
  command
      ->add_option("--timeout", arguments->timeout, "Seconds that the command may take for a case")
      ->check(finite_number() & CLI::Range(1e-3, 1e6))
      ->capture_default_str();
  command->add_option("--output", arguments->output, "Kind of picture that the command writes")
      ->check(CLI::IsMember({"exr", "png"}))
      ->capture_default_str();
  command
      ->add_option("--tolerance", arguments->tolerance,
                   "Largest error of a channel that passes; of pictures of 8 bits half a step more")
      ->check(finite_number() & CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command->add_flag("--all", arguments->all, "Print the cases that pass, too");
  command->footer(
      "Example: pellucid conform --command './mine {scene} {output}'\n"
      "Exit code: 0 every case passes; 1 one does not; 2 wrong input.");
  add_gl_option(*command, globals);
  add_global_options(*command, globals);
  command->callback([arguments, &globals] { run(*arguments, globals); });
}

}  // namespace pellucid::app
