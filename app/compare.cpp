// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/commands.h"
#include "compare/pictures/error_map.h"
#include "compare/pictures/image_file.h"
#include "compare/pictures/metrics.h"
#include "compare/results/result_row.h"
#include "core/error.h"

namespace pellucid::app {
namespace {

struct CompareArguments {
  std::filesystem::path reference, test, diff;
  std::optional<double> fail_rmse, fail_ssim, fail_max_error;
};

std::string ssim_text(const compare::Metrics& m) {
  return m.ssim ? fmt::format("{:.6f}", *m.ssim) : "none: a side is below 11 pixels";
}

void print_metrics(std::string_view title, const compare::Metrics& m) {
  fmt::print("{}\n  RMSE       {:.6g}\n  SSIM       {}\n  PSNR       {:.2f} dB\n", title, m.rmse,
             ssim_text(m), m.psnr);
  fmt::print("  max error  {:.6g} at ({}, {})\n", m.max_error.value, m.max_error.x, m.max_error.y);
}

void print_comparison(const compare::Comparison& comparison, bool as_json) {
  if (as_json) return fmt::print("{}\n", compare::to_json(comparison).dump(1));
  print_metrics("float values", comparison.linear);
  print_metrics("8-bit values, as a screen shows them", comparison.displayed);
}

/// Like idiff: beyond a threshold the pictures count as different, and the command as failed.
void check_thresholds(const CompareArguments& arguments, const compare::Metrics& m) {
  if (arguments.fail_rmse && m.rmse > *arguments.fail_rmse)
    throw WorkError(
        fmt::format("RMSE {:.6g} is above --fail-rmse {}", m.rmse, *arguments.fail_rmse));
  if (arguments.fail_max_error && m.max_error.value > *arguments.fail_max_error)
    throw WorkError(fmt::format("max error {:.6g} is above --fail-max-error {}", m.max_error.value,
                                *arguments.fail_max_error));
  if (!arguments.fail_ssim) return;
  if (!m.ssim) throw InputError("--fail-ssim: accepted: pictures of at least 11×11 pixels");
  if (*m.ssim < *arguments.fail_ssim)
    throw WorkError(
        fmt::format("SSIM {:.6g} is below --fail-ssim {}", *m.ssim, *arguments.fail_ssim));
}

void run(const CompareArguments& arguments, const GlobalOptions& globals) {
  const Image reference = compare::read_image(arguments.reference);
  const Image test = compare::read_image(arguments.test);
  const compare::Comparison comparison = compare::compare_images(reference, test);
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
  command->add_option("--fail-rmse", arguments->fail_rmse, "Exit 1 when the RMSE is above this");
  command->add_option("--fail-max-error", arguments->fail_max_error,
                      "Exit 1 when any value differs by more than this");
  command->add_option("--fail-ssim", arguments->fail_ssim, "Exit 1 when the SSIM is below this");
  command->footer("Exit code: 0 compared, within the thresholds; 1 beyond one; 2 wrong input.");
  add_global_options(*command, globals);
  command->callback([arguments, &globals] { run(*arguments, globals); });
}

}  // namespace pellucid::app
