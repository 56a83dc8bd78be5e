// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/commands.h"
#include "compare/pictures/error_map.h"
#include "compare/pictures/image_file.h"
#include "compare/pictures/metrics.h"
#include "compare/results/result_row.h"
#include "core/error.h"
#include "core/files/files_read.h"
#include "core/files/json_text.h"

namespace pellucid::app {
namespace {

struct CompareArguments {
  std::filesystem::path reference, test, diff;
  std::map<std::string_view, std::optional<double>> fail;  // by metric: its threshold
};

/// "--fail-max-error".
std::string threshold_option(const compare::MetricRow& metric) {
  std::string name(metric.name);
  std::ranges::replace(name, '_', '-');
  return "--fail-" + name;
}

void print_metrics(std::string_view title, const compare::Metrics& m) {
  fmt::print("{}\n", title);
  for (std::size_t row = 0; row < compare::metrics().size(); ++row) {
    const compare::MetricRow& metric = compare::metrics()[row];
    fmt::print("  {:10} {}\n", heading(metric),
               m[row] ? fmt::format("{:.6g}", *m[row]) : "none for pictures so small");
  }
  fmt::print("  its pixel  ({}, {})\n", m.max_error_x, m.max_error_y);
}

void print_comparison(const compare::Comparison& comparison, bool as_json) {
  if (as_json) return fmt::print("{}\n", json_text(compare::to_json(comparison), 1));
  print_metrics("float values", comparison.linear);
  print_metrics("8-bit values, as a screen shows them", comparison.displayed);
}

void check_threshold(const compare::MetricRow& metric, double threshold,
                     const std::optional<double>& value) {
  const bool higher = metric.better == compare::Better::higher;
  if (!value)
    throw InputError(fmt::format("{}: the pictures have no {}; accepted: larger ones",
                                 threshold_option(metric), heading(metric)));
  const bool within = higher ? *value >= threshold : *value <= threshold;  // NaN is not
  if (!within)
    throw WorkError(fmt::format("{} {:.6g} is {} {} {}", heading(metric), *value,
                                higher ? "below" : "above", threshold_option(metric), threshold));
}

/// As idiff does: beyond a threshold the pictures count as different, and the command as failed.
void check_thresholds(const CompareArguments& arguments, const compare::Metrics& m) {
  for (const compare::MetricRow& metric : compare::metrics())
    if (const std::optional<double>& threshold = arguments.fail.at(metric.name))
      check_threshold(metric, *threshold, m.of(metric.name));
}

/// What is wrong with one of two pictures is said with both files' names.
compare::Comparison comparison_of(const CompareArguments& arguments, const Image& reference,
                                  const Image& test) {
  try {
    return compare::compare_images(reference, test);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{} against {}: {}", arguments.test.string(),
                                 arguments.reference.string(), error.what()));
  }
}

void run(const CompareArguments& arguments, const GlobalOptions& globals) {
  const ProtectedInputs inputs;
  const Image reference = compare::read_image(arguments.reference);
  const Image test = compare::read_image(arguments.test);
  const compare::Comparison comparison = comparison_of(arguments, reference, test);
  if (!arguments.diff.empty())
    compare::write_image(arguments.diff, compare::error_map(reference, test));
  print_comparison(comparison, globals.json);
  check_thresholds(arguments, comparison.linear);
}

}  // namespace

void add_compare_command(CLI::App& app, GlobalOptions& globals) {
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command = app.add_subcommand("compare", "Say how far apart two pictures are");
  command->add_option("REFERENCE", arguments->reference, "The picture that is right")->required();
  command->add_option("TEST", arguments->test, "The picture to be judged")->required();
  command->add_option(
      "--diff", arguments->diff,
      "Write the error map (.png, .exr): largest RGB error, logarithmic from 0.001 to 1");
  for (const compare::MetricRow& metric : compare::metrics())
    command
        ->add_option(threshold_option(metric), arguments->fail[metric.name],
                     fmt::format("Exit 1 when the {} is {} this", heading(metric),
                                 metric.better == compare::Better::higher ? "below" : "above"))
        ->check(finite_number());
  command->footer("Exit code: 0 compared, within the thresholds; 1 beyond one; 2 wrong input.");
  add_global_options(*command, globals);
  command->callback([arguments, &globals] { run(*arguments, globals); });
}

}  // namespace pellucid::app
