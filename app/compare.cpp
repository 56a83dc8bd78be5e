// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/commands.h"
#include "app/compare_inputs.h"
#include "app/compare_runs.h"
#include "compare/changes/past_run.h"
#include "compare/pictures/error_map.h"
#include "compare/pictures/faults/given_faults.h"
#include "compare/pictures/flip.h"
#include "compare/pictures/image_file.h"
#include "compare/pictures/metrics.h"
#include "compare/results/result_row.h"
#include "core/error.h"
#include "core/files/ending.h"
#include "core/files/files_read.h"
#include "core/files/json_text.h"
#include "core/options/names.h"

namespace pellucid::app {
namespace {

using compare::MetricRow;
using compare::Region;

struct CompareArguments {
  CompareFiles files;
  std::filesystem::path diff, flip_map;
  std::vector<std::string> metrics;                        // empty: all but those on request
  std::map<std::string_view, std::optional<double>> fail;  // by metric: its threshold
  CompareRunsOptions runs;
};

/// "--fail-max-error".
std::string threshold_option(const MetricRow& metric) {
  std::string name(metric.name);
  std::ranges::replace(name, '_', '-');
  return "--fail-" + name;
}

/// Those that were asked for, and those that have a threshold.
std::vector<std::string> chosen_names(const CompareArguments& arguments) {
  std::vector<std::string> names = arguments.metrics;
  for (const MetricRow& metric : compare::metrics()) {
    const bool wanted = arguments.fail.at(metric.name) && (!names.empty() || metric.on_request);
    if (wanted && std::ranges::find(names, metric.name) == names.end()) {
      if (names.empty())
        for (const MetricRow& row : compare::metrics())
          if (!row.on_request) names.emplace_back(row.name);
      names.emplace_back(metric.name);
    }
  }
  return names;
}

/// What is missing for a number that is there for other pictures; empty if nothing is.
std::string missing_for(const MetricRow& metric, const CompareInputs& inputs) {
  if (metric.region != Region::all && !inputs.layers)
    return "the reference's layers are not known; accepted: --layers FILE.exr, or REFERENCE's "
           "name with .layers.exr beside it";
  if (metric.region == Region::equal && !inputs.test_layers)
    return "the test's layers are not known; accepted: --test-layers FILE.exr, or TEST's name with "
           ".layers.exr beside it";
  return "";
}

/// Says why a number that was asked for is not there.
std::string why_none(const MetricRow& metric, const CompareInputs& inputs) {
  if (std::string missing = missing_for(metric, inputs); !missing.empty()) return missing;
  if (metric.region != Region::all) return "no pixel of the reference is among them";
  if (inputs.mask) return "the mask leaves too little; accepted: no mask, or one of larger parts";
  return "the pictures have none; accepted: larger ones";
}

/// A metric that is named and cannot be had for want of a file is an error, before any is measured.
void check_metrics(const CompareArguments& arguments, const CompareInputs& inputs) {
  for (const std::string& name : arguments.metrics) {
    const MetricRow& metric = find_row("metric", name, compare::metrics());
    if (std::string missing = missing_for(metric, inputs); !missing.empty())
      throw InputError(fmt::format("--metric {}: {}", name, missing));
  }
}

bool is_asked(const MetricRow& metric, const std::vector<std::string>& names) {
  if (names.empty()) return !metric.on_request;
  return std::ranges::find(names, metric.name) != names.end();
}

void print_metrics(std::string_view title, const compare::Metrics& m, bool displayed,
                   const std::vector<std::string>& names) {
  fmt::print("{}\n", title);
  for (std::size_t i = 0; i < compare::metrics().size(); ++i) {
    const MetricRow& metric = compare::metrics()[i];
    if (!is_asked(metric, names) || metric.displayed < displayed) continue;
    if (!m[i] && metric.region != Region::all) continue;
    fmt::print("  {:22} {}\n", heading(metric),
               m[i] ? fmt::format("{:.6g}", *m[i]) : "none for pictures so small, or masked");
    if (metric.name == "max_error")
      fmt::print("  {:22} ({}, {})\n", "its pixel", m.max_error_x, m.max_error_y);
  }
  if (m.covered && !displayed) fmt::print("  {:22} {:.6g}\n", "Covered share", *m.covered);
}

/// Takes away what was not asked for, and tells what was, but is not there, by null.
void keep_asked(nlohmann::json& json, const std::vector<std::string>& names, bool displayed) {
  if (names.empty()) return;
  for (const MetricRow& metric : compare::metrics()) {
    const std::string name(metric.name);
    if (!is_asked(metric, names))
      json.erase(name);
    else if (!json.contains(name) && metric.displayed >= displayed)
      json[name] = nullptr;
  }
  if (!is_asked(find_row("metric", "max_error", compare::metrics()), names))
    json.erase("max_error_pixel");
}

/// Of pictures without opacities none is known.
std::optional<double> alpha_error(const CompareInputs& inputs) {
  if (!inputs.have_alpha) return std::nullopt;
  return compare::max_alpha_error(inputs.reference, inputs.test);
}

/// What looks wrong with either as a whole. Who asks for some numbers, or of some pixels, gets
/// these alone, and whether their colours are of one kind.
compare::PairFaults faults_of(const CompareInputs& inputs, const std::vector<std::string>& names) {
  compare::PairFaults faults =
      compare::pair_faults(inputs.reference, inputs.test, inputs.have_alpha);
  if (inputs.mask || !names.empty()) {
    faults.of_reference.clear();
    faults.of_test.clear();
  }
  return faults;
}

void print_faults(const compare::PairFaults& faults) {
  if (faults.straight) fmt::print("note: {}\n", *faults.straight);
  for (const std::string& fault : faults.of_reference) fmt::print("note: REFERENCE {}\n", fault);
  for (const std::string& fault : faults.of_test) fmt::print("note: TEST {}\n", fault);
}

void print_comparison(const compare::Comparison& comparison, const CompareInputs& inputs,
                      const std::vector<std::string>& names, bool as_json) {
  const std::optional<double> alpha_error = app::alpha_error(inputs);
  const compare::PairFaults faults = faults_of(inputs, names);
  if (as_json) {
    nlohmann::json json = compare::to_json(comparison);
    if (names.empty()) {
      json["faults"] = faults.of_test;
      json["reference_faults"] = faults.of_reference;
      json["max_alpha_error"] = alpha_error ? nlohmann::json(*alpha_error) : nlohmann::json();
    }
    keep_asked(json["displayed"], names, true);
    keep_asked(json, names, false);
    if (faults.straight) json["note"] = *faults.straight;
    return fmt::print("{}\n", json_text(json, 1));
  }
  print_metrics("float values", comparison.linear, false, names);
  print_metrics("8-bit values, as a screen shows them", comparison.displayed, true, names);
  if (alpha_error.value_or(0) > 0 && names.empty())
    fmt::print("opacity, which no number above counts\n  {:22} {:.6g}\n", "Max error",
               *alpha_error);
  print_faults(faults);
}

/// Of a signed error the magnitude counts. NaN is within no threshold.
bool is_within(const MetricRow& metric, double value, double threshold) {
  if (metric.better == compare::Better::higher) return value >= threshold;
  return (metric.better == compare::Better::neither ? std::abs(value) : value) <= threshold;
}

void check_threshold(const MetricRow& metric, double threshold, const std::optional<double>& value,
                     const CompareInputs& inputs) {
  if (!value)
    throw InputError(fmt::format("{}: the pictures have no {}: {}", threshold_option(metric),
                                 heading(metric), why_none(metric, inputs)));
  if (!is_within(metric, *value, threshold))
    throw WorkError(fmt::format("{} {:.6g} is {} {} {}", heading(metric), *value,
                                metric.better == compare::Better::higher ? "below" : "above",
                                threshold_option(metric), threshold));
}

/// As idiff does: beyond a threshold the pictures count as different, and the command as failed.
void check_thresholds(const CompareArguments& arguments, const compare::Metrics& m,
                      const CompareInputs& inputs) {
  for (const MetricRow& metric : compare::metrics())
    if (const std::optional<double>& threshold = arguments.fail.at(metric.name))
      check_threshold(metric, *threshold, m.of(metric.name), inputs);
}

/// What is wrong with one of two pictures is said with both files' names.
compare::PicturePair pair_of(const CompareArguments& arguments, const CompareInputs& inputs) {
  try {
    return {inputs.reference, inputs.test, inputs.regions()};
  } catch (const InputError& error) {
    throw InputError(fmt::format("{} against {}: {}", arguments.files.test.string(),
                                 arguments.files.reference.string(), error.what()));
  }
}

/// A picture is for the eye; an .exr holds the numbers.
Image flip_image(const Raster<float>& map, const std::filesystem::path& file) {
  if (small_ending(file) != ".exr") return compare::flip_picture(map);
  Image values(map.width, map.height);
  std::ranges::transform(map.pixels, values.pixels.begin(),
                         [](float v) { return Rgba(glm::vec3(v), 1.f); });
  return values;
}

/// Of two folders the options that are of pictures mean nothing.
void refuse_picture_options(const CompareArguments& arguments) {
  const CompareFiles& files = arguments.files;
  const bool any_threshold =
      std::ranges::any_of(arguments.fail, [](const auto& item) { return item.second.has_value(); });
  if (any_threshold || !arguments.metrics.empty() || !arguments.diff.empty() ||
      !arguments.flip_map.empty() || !files.mask.empty() || !files.crop.empty() ||
      !files.layers.empty() || !files.test_layers.empty())
    throw InputError(
        fmt::format("compare: {} {}: a folder is a run of a study, which takes no option of "
                    "pictures; accepted: --output, --ignore-times, --json",
                    files.reference.string(), files.test.string()));
}

void refuse_run_options(const CompareArguments& arguments) {
  if (!arguments.runs.output.empty() || arguments.runs.ignore_times)
    throw InputError(
        "compare: --output and --ignore-times are of two runs of a study; accepted: two folders, "
        "or pictures without them");
}

void run(const CompareArguments& arguments, const GlobalOptions& globals) {
  if (compare::is_run_folder(arguments.files.reference) ||
      compare::is_run_folder(arguments.files.test)) {
    refuse_picture_options(arguments);
    return compare_run_folders(arguments.files.reference, arguments.files.test, arguments.runs,
                               globals);
  }
  refuse_run_options(arguments);
  const ProtectedInputs protected_inputs;
  for (const std::string& name : arguments.metrics) find_row("metric", name, compare::metrics());
  const CompareInputs inputs = read_inputs(arguments.files);
  check_metrics(arguments, inputs);
  const compare::PicturePair pair = pair_of(arguments, inputs);
  const std::vector<std::string> names = chosen_names(arguments);
  const compare::Comparison comparison = compare::compare_pair(pair, names);
  if (!arguments.diff.empty())
    compare::write_image(arguments.diff, compare::error_map(inputs.reference, inputs.test),
                         compare::form_of_error_map());
  if (!arguments.flip_map.empty())
    compare::write_image(arguments.flip_map, flip_image(pair.flip(), arguments.flip_map),
                         compare::form_of_flip());
  print_comparison(comparison, inputs, names, globals.json);
  check_thresholds(arguments, comparison.linear, inputs);
}

std::string threshold_help(const MetricRow& metric) {
  if (metric.better == compare::Better::neither)
    return fmt::format("Exit 1 when the magnitude of the {} is above this", heading(metric));
  return fmt::format("Exit 1 when the {} is {} this", heading(metric),
                     metric.better == compare::Better::higher ? "below" : "above");
}

void add_inputs(CLI::App& command, CompareFiles& files) {
  command
      .add_option("REFERENCE", files.reference, "The picture that is right, or a study's results")
      ->required();
  command.add_option("TEST", files.test, "The picture to be judged, or results of the same study")
      ->required();
  command.add_option("--mask", files.mask,
                     "Only pixels count that are white here: red, green or blue of 0.5 or more");
  command
      .add_option("--crop", files.crop,
                  "Only this part counts: X,Y,WIDTH,HEIGHT in pixels from the top left")
      ->delimiter(',')
      ->expected(4);
  command.add_option("--layers", files.layers,
                     "The reference's layers (render --layers FILE.exr), for numbers over covered "
                     "pixels; by default REFERENCE's name with .layers.exr, if it is there");
  command.add_option("--test-layers", files.test_layers,
                     "The test's layers, for numbers over pixels with equal layers");
}

void add_outputs(CLI::App& command, CompareArguments& arguments) {
  command.add_option(
      "--diff", arguments.diff,
      "Write the error map (.png, .exr): largest RGB error, logarithmic from 0.001 to 1");
  command.add_option("--flip-map", arguments.flip_map,
                     "Write FLIP's map: .png in colours from 0 to 1, .exr its values");
  command
      .add_option("--metric", arguments.metrics,
                  "Only these numbers, among them some that are measured on request (list metrics)")
      ->delimiter(',');
  for (const MetricRow& metric : compare::metrics())
    command
        .add_option(threshold_option(metric), arguments.fail[metric.name], threshold_help(metric))
        ->check(finite_number())
        ->group("Thresholds");
}

}  // namespace

void add_compare_command(CLI::App& app, GlobalOptions& globals) {
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command =
      app.add_subcommand("compare", "Say how far apart two pictures, or two runs of a study, are");
  add_inputs(*command, arguments->files);
  add_outputs(*command, *arguments);
  add_run_options(*command, arguments->runs);
  command->footer(
      "Example: pellucid compare truth.exr test.exr --mask object.png --flip-map flip.png "
      "--fail-flip 0.05\n"
      "         pellucid compare results/before results/after --output changes\n"
      "Exit code: 0 compared, within the thresholds, or the runs are the same; 1 beyond one, or a "
      "cell differs beyond its spread; 2 wrong input.");
  add_global_options(*command, globals);
  command->callback([arguments, &globals] { run(*arguments, globals); });
}

}  // namespace pellucid::app
