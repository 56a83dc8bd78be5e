// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "compare/methods/methods.h"
#include "compare/methods/optimize_opacities.h"
#include "compare/methods/sweep.h"
#include "compare/run/tune.h"
#include "core/error.h"
#include "core/files/json_text.h"
#include "core/options/names.h"

namespace pellucid::app {
namespace {

struct TuneArguments {
  std::filesystem::path scene;
  compare::ErrorBound bound;
  std::string cost = "seconds", opacities;
  int repeats = 3;
  scene::ViewRequest view;
};

/// Every method but the reference, which has no error to bound.
compare::TuneRequest request_of(const TuneArguments& arguments, const GlobalOptions& globals) {
  const scene::MethodRow& reference = compare::methods().front();
  return {.scene = arguments.scene,
          .view = arguments.view,
          .reference = {&reference, Parameters(reference.name, reference.parameters, {})},
          .candidates = compare::every_method(compare::methods().subspan(1)),
          .bound = arguments.bound,
          .cost = arguments.cost == "bytes" ? compare::Cost::bytes : compare::Cost::seconds,
          .repeats = arguments.repeats,
          .opacities = compare::parse_opacities(arguments.opacities),
          .context = {.gl = globals.gl},
          .progress = console_progress(globals),
          .on_row = {}};
}

std::string call_text(const compare::ResultRow& row) {
  return row.parameters.empty() ? row.method : row.method + ":" + row.parameters;
}

/// The options that ask for the view.
std::string view_text(const scene::ViewRequest& view) {
  std::string text;
  if (!view.camera.empty()) text += " --camera " + view.camera;
  if (!view.view.empty()) text += " --view " + view.view;
  if (const auto& size = view.resolution)
    text += fmt::format(" --resolution {}x{}", (*size)[0], (*size)[1]);
  if (view.samples) text += fmt::format(" --samples {}", *view.samples);
  return text;
}

void print_table(const compare::TuneOutcome& outcome) {
  fmt::print("{:28} {:>10} {:>9} {:>10} {:>8}\n", "", "ms", "MB", "RMSE", "SSIM");
  for (std::size_t i = 0; i < outcome.rows.size(); ++i) {
    const compare::ResultRow& row = outcome.rows[i];
    if (!row.error.empty()) {
      fmt::print("{:28} failed: {}\n", call_text(row), row.error);
      continue;
    }
    const compare::Metrics& m = row.metrics.linear;
    const std::optional<double> ssim = m.of("ssim");
    fmt::print("{:28} {:10.1f} {:9.1f} {:10.3e} {:>8}  {}\n", call_text(row),
               1e3 * row.seconds.median, 1e-6 * double(row.total_bytes()),
               m.of("rmse").value_or(NAN), ssim ? fmt::format("{:.4f}", *ssim) : "none",
               outcome.within_bound[i] ? "within the bound" : "");
  }
}

nlohmann::ordered_json to_json(const compare::TuneOutcome& outcome) {
  nlohmann::ordered_json json;
  const compare::ResultRow* best = outcome.best();
  json["cheapest"] = best ? nlohmann::ordered_json(call_text(*best)) : nlohmann::ordered_json();
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
  const compare::ResultRow* best = outcome.best();
  if (globals.json) {
    std::cout << json_text(to_json(outcome), 2) << '\n';
  } else {
    print_table(outcome);
    if (best)
      fmt::print("\nthe cheapest in {}: {}\n    pellucid render {} -m {}{}{} -o picture.exr\n",
                 arguments.cost, call_text(*best), arguments.scene.string(), call_text(*best),
                 arguments.opacities.empty() ? "" : " --opacities " + arguments.opacities,
                 view_text(arguments.view));
  }
  std::cout.flush();
  if (!best) throw WorkError("no method is within the bound");
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
  command->add_option("--max-bytes", arguments->bound.max_bytes,
                      "Largest memory beyond the scene and the picture, bytes");
  command->add_option("--cost", arguments->cost, "What cheap means: seconds or bytes")
      ->check(CLI::IsMember({"seconds", "bytes"}))
      ->capture_default_str();
  command->add_option("--repeats", arguments->repeats, "Timed pictures of each; the median counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  add_view_options(*command, arguments->view);
  add_opacities_option(*command, arguments->opacities);
  command->footer(
      "Example:\n  pellucid tune scene.json --max-rmse 0.01 --resolution 500x500\n"
      "Exit code: 0 done; 1 no method is within the bound; 2 wrong input.");
  add_gl_option(*command, globals);
  add_global_options(*command, globals);
  command->callback([arguments, &globals] { run(*arguments, globals); });
}

}  // namespace pellucid::app
