// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/sums.h"
#include "compare/parts/deep_outputs.h"
#include "compare/parts/merge.h"
#include "core/error.h"
#include "core/files/ending.h"
#include "core/files/files_read.h"
#include "core/files/json_text.h"

namespace pellucid::app {
namespace {

struct MergeArguments {
  std::vector<std::filesystem::path> files;
  std::string output, deep, partial, totals;
};

void print_merged(const MergeArguments& arguments, const compare::DeepOutputs& outputs,
                  bool as_json) {
  const std::string& file = arguments.output.empty() ? arguments.deep : arguments.output;
  if (!as_json)
    return fmt::print("{}: {} parts, {} crossings, at most {} layers\n", file,
                      arguments.files.size(), outputs.crossings(), outputs.max_layers());
  fmt::print("{}\n", json_text({{"output", arguments.output},
                                {"deep", arguments.deep},
                                {"parts", arguments.files.size()},
                                {"fragments", outputs.crossings()},
                                {"max_layers", outputs.max_layers()}},
                               2));
}

void merge_deep(const MergeArguments& arguments, const GlobalOptions& globals) {
  const compare::DeepParts parts(arguments.files);
  compare::DeepOutputs outputs(parts.whole(), arguments.output, arguments.deep);
  const Progress progress = console_progress(globals);
  parts.merge([&](int y, const compare::DeepRow& row) { outputs.take(y, row); }, progress);
  report(progress, 1, "merged");
  outputs.commit();
  if (globals.json || !globals.quiet) print_merged(arguments, outputs, globals.json);
}

/// What --deep writes for NumPy is read by NumPy alone.
void check_endings(const std::vector<std::filesystem::path>& files) {
  for (const std::filesystem::path& file : files)
    if (small_ending(file) == ".npz")
      throw InputError(fmt::format("{}: .npz is not merged; accepted: .exr", file.string()));
}

void run(const MergeArguments& arguments, const GlobalOptions& globals) {
  if (arguments.output.empty() && arguments.deep.empty() && arguments.partial.empty())
    throw CLI::RequiredError("-o,--output, --deep or --partial");
  check_endings(arguments.files);
  const ProtectedInputs inputs;
  const bool deep = readers::is_deep_picture(arguments.files.front());
  if (deep && !(arguments.partial.empty() && arguments.totals.empty()))
    throw InputError(fmt::format("{}: is a deep picture; accepted with --partial or --totals: sums",
                                 arguments.files.front().string()));
  if (deep || !arguments.deep.empty()) return merge_deep(arguments, globals);
  merge_sums({arguments.files, arguments.totals, arguments.output, arguments.partial}, globals);
}

}  // namespace

void add_merge_command(CLI::App& app, GlobalOptions& globals) {
  const auto arguments = std::make_shared<MergeArguments>();
  CLI::App* command = app.add_subcommand(
      "merge",
      "Composite deep pictures of a scene's parts exactly, or sums of them by their method");
  command
      ->add_option(
          "FILE", arguments->files,
          "Deep pictures (.exr), or sums, of all parts of a scene: render --part I/N --deep "
          "FILE, or --partial FILE")
      ->required();
  command->add_option("-o,--output", arguments->output, "Picture: .exr (32-bit float) or .png")
      ->check(ending_among({".exr", ".png"}));
  command
      ->add_option("--deep", arguments->deep,
                   "Write every crossing of every pixel: a deep .exr, or .npz for NumPy")
      ->check(ending_among({".exr", ".npz"}));
  command
      ->add_option("--partial", arguments->partial,
                   "Write what the parts' sums add up to, for 'render --totals'")
      ->check(ending_among({".exr"}));
  command->add_option("--totals", arguments->totals,
                      "The first phase's totals, where the sums are of a method's second phase");
  command->footer(
      "Of deep pictures it is, bit for bit, what raytrace makes of the whole scene; of sums what\n"
      "their method makes of it, up to float rounding. Of a method of two phases (fourier, "
      "moment,\n"
      "binning) whose first is given the second is drawn here, part by part.\n"
      "Examples:\n  pellucid merge part-1.exr part-2.exr part-3.exr -o picture.exr\n"
      "  pellucid merge sums-1.exr sums-2.exr --partial totals.exr\n"
      "  pellucid merge second-1.exr second-2.exr --totals totals.exr -o picture.exr\n"
      "Exit code: 0 merged; 2 a file is damaged, or no part of the same picture, or one is "
      "missing.");
  add_gl_option(*command, globals);
  add_global_options(*command, globals);
  command->callback([arguments, &globals] { run(*arguments, globals); });
}

}  // namespace pellucid::app
