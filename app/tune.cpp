// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "compare/methods/given_method.h"
#include "compare/methods/methods.h"
#include "compare/methods/optimize_opacities.h"
#include "compare/run/entrants.h"
#include "compare/run/tune.h"
#include "core/error.h"
#include "core/files/json_text.h"
#include "core/machine/program_run.h"
#include "core/options/names.h"

namespace pellucid::app {
namespace {

struct TuneArguments {
  std::filesystem::path scene;
  compare::ErrorBound bound;
  std::string cost = "seconds", opacities, methods, command, region = "all";
  int repeats = 30;
  std::optional<double> max_seconds;
  scene::ViewRequest view;
};

/// On stderr: what is printed to stdout is the answer.
void print_estimate(const compare::TuneEstimate& estimate) {
  std::cerr << fmt::format("pellucid: {} settings compete, about {:.0f} s\n", estimate.candidates,
                           std::ceil(estimate.seconds));
}

/// The reference is the exact method; it competes, too.
compare::TuneRequest request_of(const TuneArguments& arguments, const GlobalOptions& globals) {
  const scene::MethodRow& reference = compare::methods().front();
  compare::TuneRequest request{
      .scene = arguments.scene,
      .view = arguments.view,
      .reference = {&reference, Parameters(reference.name, reference.parameters, {})},
      .candidates = compare::calls_that_fit(arguments.methods, compare::methods()),
      .bound = arguments.bound,
      .cost = arguments.cost == "bytes" ? compare::Cost::bytes : compare::Cost::seconds,
      .repeats = arguments.repeats,
      .opacities = compare::parse_opacities(arguments.opacities),
      .context = {.gl = globals.gl},
      .progress = console_progress(globals),
      .on_row = {},
      .max_seconds = arguments.max_seconds};
  if (!arguments.command.empty())
    request.candidates.push_back(compare::external_call({.name = "command",
                                                         .words = split_command(arguments.command),
                                                         .base = std::filesystem::current_path()}));
  request.bound.covered = arguments.region == "covered";
  if (!globals.quiet) request.on_estimate = print_estimate;
  return request;
}

/// "cheapest", "tied" or "within the bound".
std::string_view place_of(const compare::TuneOutcome& outcome, std::size_t i) {
  if (outcome.cheapest == i) return "cheapest";
  return outcome.tied[i] ? "tied" : outcome.within_bound[i] ? "within the bound" : "";
}

std::string error_text(const compare::ResultRow& row, std::string_view name, bool covered) {
  const std::optional<double> value =
      row.metrics.linear.of(covered ? fmt::format("{}_covered", name) : std::string(name));
  if (!value) return "none";
  return name == "rmse" ? fmt::format("{:.3e}", *value) : fmt::format("{:.4f}", *value);
}

/// A dash where a program of one's own does not tell.
std::string megabytes_text(const compare::ResultRow& row) {
  if (!row.given.empty() && row.bytes.empty()) return "-";
  return fmt::format("{:.1f}", 1e-6 * double(row.total_bytes()));
}

/// The options that ask for the view.
std::string view_text(const scene::ViewRequest& view) {
  std::string text;
  if (!view.camera.empty()) text += " --camera " + view.camera;
  if (!view.view.empty()) text += " --view " + view.view;
  if (const auto& size = view.resolution)
    text += fmt::format(" --resolution {}x{}", (*size)[0], (*size)[1]);
  if (view.samples) text += fmt::format(" --samples {}", *view.samples);
  if (const auto& b = view.background)
    text += view.without_background
                ? " --background none"
                : fmt::format(" --background '#{:02x}{:02x}{:02x}'", int(std::lround(255 * b->x)),
                              int(std::lround(255 * b->y)), int(std::lround(255 * b->z)));
  return text;
}

void print_rows(const compare::TuneOutcome& outcome, bool covered) {
  fmt::print("{:36} {:>9} {:>19} {:>8} {:>10} {:>8}\n", "", "ms", "95 % of the median", "MB",
             "RMSE", "SSIM");
  for (std::size_t i = 0; i < outcome.rows.size(); ++i) {
    const compare::ResultRow& row = outcome.rows[i];
    if (!row.error.empty()) {
      fmt::print("{:36} failed: {}\n", row.call(), row.error);
      continue;
    }
    for (const std::string& fault : row.given_faults)
      fmt::print("{:36} the picture {}\n", row.call(), fault);
    const auto& interval = row.seconds.interval;
    fmt::print(
        "{:36} {:9.1f} {:>19} {:>8} {:>10} {:>8}  {}\n", row.call(), 1e3 * row.seconds.median,
        interval ? fmt::format("{:.1f} to {:.1f}", 1e3 * interval->low, 1e3 * interval->high) : "",
        megabytes_text(row), error_text(row, "rmse", covered), error_text(row, "ssim", covered),
        place_of(outcome, i));
  }
  for (const compare::LeftOut& out : outcome.left_out)
    fmt::print("{:36} left out: {}\n", out.call, out.why);
}

std::vector<std::string> tied_calls(const compare::TuneOutcome& outcome) {
  std::vector<std::string> calls;
  for (std::size_t i = 0; i < outcome.rows.size(); ++i)
    if (outcome.tied[i]) calls.push_back(outcome.rows[i].call());
  return calls;
}

std::vector<std::string> undecided_calls(const compare::TuneOutcome& outcome) {
  std::vector<std::string> calls;
  for (const compare::LeftOut& out : outcome.left_out)
    if (out.undecided) calls.push_back(out.call);
  return calls;
}

void print_answer(const TuneArguments& arguments, const compare::TuneOutcome& outcome) {
  const std::string best = outcome.best()->call();
  const bool is_given = !outcome.best()->given.empty();
  fmt::print("\nthe cheapest in {}: {}\n", arguments.cost, is_given ? arguments.command : best);
  if (const auto tied = tied_calls(outcome); !tied.empty())
    fmt::print("    tied: {} {}\n",
               arguments.cost == "bytes" ? "as few are needed by" : "time does not tell it from",
               fmt::join(tied, ", "));
  if (const std::size_t n = undecided_calls(outcome).size(); n > 0)
    fmt::print("    undecided: {} settings were not drawn in time and may be cheaper\n", n);
  if (is_given) return;
  fmt::print("    pellucid render {} -m {}{}{} -o picture.exr\n", arguments.scene.string(), best,
             arguments.opacities.empty() ? "" : " --opacities " + arguments.opacities,
             view_text(arguments.view));
}

nlohmann::ordered_json to_json(const compare::TuneOutcome& outcome) {
  nlohmann::ordered_json json;
  const compare::ResultRow* best = outcome.best();
  json["cheapest"] = best ? nlohmann::ordered_json(best->call()) : nlohmann::ordered_json();
  json["tied"] = tied_calls(outcome);
  json["undecided"] = undecided_calls(outcome);
  json["left_out"] = nlohmann::ordered_json::array();
  for (const compare::LeftOut& out : outcome.left_out)
    json["left_out"].push_back({{"call", out.call}, {"why", out.why}});
  json["rows"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < outcome.rows.size(); ++i) {
    nlohmann::ordered_json row = compare::to_json(outcome.rows[i]);
    row["within_bound"] = bool(outcome.within_bound[i]);
    json["rows"].push_back(std::move(row));
  }
  return json;
}

void run(const TuneArguments& arguments, const GlobalOptions& globals) {
  const compare::TuneOutcome outcome = compare::tune(request_of(arguments, globals));
  if (globals.json) {
    std::cout << json_text(to_json(outcome), 2) << '\n';
  } else {
    print_rows(outcome, arguments.region == "covered");
    if (outcome.best()) print_answer(arguments, outcome);
  }
  std::cout.flush();
  if (outcome.best()) return;
  const std::size_t undecided = undecided_calls(outcome).size();
  throw WorkError(undecided == 0
                      ? "no method is within the bound"
                      : fmt::format("no method that was drawn in time is within the bound; {} were "
                                    "not drawn",
                                    undecided));
}

}  // namespace

void add_tune_command(CLI::App& app, GlobalOptions& globals) {
  CLI::App* command =
      app.add_subcommand("tune", "Find the cheapest method within an error bound for a scene");
  const auto arguments = std::make_shared<TuneArguments>();
  command->add_option("SCENE", arguments->scene, "Scene file")->required();
  command->add_option("--max-rmse", arguments->bound.max_rmse, "Largest RMSE against raytrace")
      ->check(finite_number());
  command->add_option("--min-ssim", arguments->bound.min_ssim, "Smallest SSIM against raytrace")
      ->check(finite_number());
  constexpr double most_bytes = 1e15;
  command
      ->add_option("--max-bytes", arguments->bound.max_bytes,
                   "Largest memory beyond the scene and the picture, bytes")
      ->check(finite_number() & CLI::Range(0.0, most_bytes));  // strtoull takes -1 for 2^64 - 1
  command->add_option("--cost", arguments->cost, "What cheap means: seconds or bytes")
      ->check(CLI::IsMember({"seconds", "bytes"}))
      ->capture_default_str();
  command->add_option("--methods", arguments->methods,
                      "Who competes: a pattern of names or calls, or several, such as "
                      "'fourier*,raytrace'; by default all");
  command
      ->add_option("--region", arguments->region,
                   "RMSE and SSIM over all pixels, or those covered by a layer in the reference")
      ->check(CLI::IsMember({"all", "covered"}))
      ->capture_default_str();
  command
      ->add_option(
          "--max-seconds", arguments->max_seconds,
          "Begin no call's picture after so many seconds; who is not told apart by then is "
          "tied, who is not drawn is undecided")
      ->check(finite_number() & CLI::Range(1e-3, 1e9));
  command
      ->add_option("--repeats", arguments->repeats,
                   "Timed pictures of each contender at most; fewer than 5 tell none apart")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--command", arguments->command,
                      "A program of your own as a further candidate: its words, in which {scene}, "
                      "{camera} and {output} stand for files; no shell sees it");
  add_view_options(*command, arguments->view);
  add_opacities_option(*command, arguments->opacities);
  command->footer(
      "All draw a small picture, then the whole one; those within the bound and within twice the "
      "time of the fastest are timed in turn, until the 95 % intervals of their medians part.\n"
      "Example: pellucid tune scenes/tornado.json --min-ssim 0.95 --region covered "
      "--methods 'raytrace*,fourier*,weighted*' --max-seconds 60\n"
      "Exit code: 0 done; 1 no method is within the bound; 2 wrong input.");
  add_gl_option(*command, globals);
  add_global_options(*command, globals);
  command->callback([arguments, &globals] { run(*arguments, globals); });
}

}  // namespace pellucid::app
