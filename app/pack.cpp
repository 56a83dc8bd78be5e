// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "compare/methods/methods.h"
#include "compare/pack/pack_run.h"
#include "compare/study/study.h"
#include "core/files/files_read.h"
#include "core/files/json_text.h"

namespace pellucid::app {
namespace {

namespace fs = std::filesystem;

struct PackArguments {
  fs::path results, output;
  std::string study;
};

void print_packed(const compare::PackedRun& packed, const fs::path& output, bool as_json) {
  if (!as_json)
    return fmt::print("{} files, study {}: {}\n", packed.files.size(), packed.study,
                      output.string());
  nlohmann::json files = nlohmann::json::array();
  for (const compare::PackedFile& file : packed.files) files.push_back(file.path);
  fmt::print(
      "{}\n",
      json_text({{"output", output.string()}, {"study", packed.study}, {"files", files}}, 1));
}

void run(const PackArguments& arguments, const GlobalOptions& globals) {
  const ProtectedInputs protected_inputs;
  const compare::PastRun results = compare::read_past_run(arguments.results);
  const fs::path file = arguments.study.empty() ? compare::study_of_run(arguments.results)
                                                : compare::find_study(arguments.study);
  const compare::Study study = compare::load_study(file, compare::callable_methods());
  const compare::PackedRun packed = compare::pack_run(results, study);
  compare::write_package(arguments.output, compare::package_name(arguments.output), packed.files);
  if (globals.json || !globals.quiet) print_packed(packed, arguments.output, globals.json);
}

}  // namespace

void add_pack_command(CLI::App& app, GlobalOptions& globals) {
  auto arguments = std::make_shared<PackArguments>();
  CLI::App* command = app.add_subcommand(
      "pack", "Pack a study's results with all that running it again elsewhere takes");
  command->add_option("RESULTS", arguments->results, "The folder that a study has filled")
      ->required();
  command
      ->add_option("-o,--output", arguments->output,
                   "The package: FILE.tar.gz, FILE.zip, or a folder")
      ->required();
  command->add_option(
      "--study", arguments->study,
      "The study's name or file, where the results do not name it, or it has moved");
  command->footer(
      "Example: pellucid pack results/quickstart -o quickstart.tar.gz; unpacked anywhere, ./run.sh "
      "runs it again and compares.\n"
      "Exit code: 0 packed; 2 an input is missing, or is not what the results were made of.");
  add_global_options(*command, globals);
  command->callback([arguments, &globals] { run(*arguments, globals); });
}

}  // namespace pellucid::app
