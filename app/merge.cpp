// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "compare/parts/deep_outputs.h"
#include "compare/parts/merge.h"
#include "core/files/files_read.h"
#include "core/files/json_text.h"

namespace pellucid::app {
namespace {

struct MergeArguments {
  std::vector<std::filesystem::path> files;
  std::string output, deep;
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

void run(const MergeArguments& arguments, const GlobalOptions& globals) {
  if (arguments.output.empty() && arguments.deep.empty())
    throw CLI::RequiredError("-o,--output or --deep");
  const ProtectedInputs inputs;
  const compare::DeepParts parts(arguments.files);
  compare::DeepOutputs outputs(parts.whole(), arguments.output, arguments.deep);
  const Progress progress = console_progress(globals);
  parts.merge([&](int y, const compare::DeepRow& row) { outputs.take(y, row); }, progress);
  report(progress, 1, "merged");
  outputs.commit();
  if (globals.json || !globals.quiet) print_merged(arguments, outputs, globals.json);
}

}  // namespace

void add_merge_command(CLI::App& app, GlobalOptions& globals) {
  const auto arguments = std::make_shared<MergeArguments>();
  CLI::App* command = app.add_subcommand(
      "merge", "Composite the deep pictures of a scene's parts, exactly, row by row");
  command
      ->add_option("FILE", arguments->files,
                   "Deep pictures (.exr) of all parts of a scene: render --part I/N --deep FILE")
      ->required();
  command->add_option("-o,--output", arguments->output, "Picture: .exr (32-bit float) or .png")
      ->check(ending_among({".exr", ".png"}));
  command
      ->add_option("--deep", arguments->deep,
                   "Write every crossing of every pixel: a deep .exr, or .npz for NumPy")
      ->check(ending_among({".exr", ".npz"}));
  command->footer(
      "The picture is, bit for bit, the one that raytrace makes of the whole scene.\n"
      "Example:\n  pellucid merge part-1.exr part-2.exr part-3.exr -o picture.exr\n"
      "Exit code: 0 merged; 2 a file is damaged, or no part of the same picture, or one is "
      "missing.");
  add_global_options(*command, globals);
  command->callback([arguments, &globals] { run(*arguments, globals); });
}

}  // namespace pellucid::app
