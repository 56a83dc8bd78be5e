// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "app/commands.h"
#include "compare/export/export_scene.h"
#include "compare/methods/optimize_opacities.h"
#include "core/files/files_read.h"
#include "core/files/json_text.h"
#include "core/files/output_folder.h"
#include "scene/files/scene_file.h"

namespace pellucid::app {
namespace {

namespace fs = std::filesystem;

struct ExportArguments {
  fs::path scene, folder;
  std::string opacities;
};

void print_summary(const fs::path& folder, const nlohmann::json& json) {
  for (const nlohmann::json& object : json["objects"])
    fmt::print("{:16} {} {}{}\n", object["file"].get<std::string>(),
               object["count"].get<std::size_t>(), object["kind"].get<std::string>(),
               object["lit"].get<bool>() ? "" : ", unlit: the light depends on the fragment");
  if (const double rounding = json["rounding"]; rounding > 0)
    fmt::print("positions were rounded to floats, by {:.2g} world units at most\n", rounding);
  fmt::print("{}\n", (folder / compare::exported_scene_name).string());
}

void run(const ExportArguments& arguments, const GlobalOptions& globals) {
  const ProtectedInputs inputs;
  const auto opacities = compare::parse_opacities(arguments.opacities);
  OutputFolder out(arguments.folder);
  const Progress progress = console_progress(globals);
  scene::Scene scene = scene::load_scene(arguments.scene, progress);
  if (opacities) compare::optimize_opacities(*opacities, {.gl = globals.gl}, scene);
  out.fill([&](const fs::path& to) { compare::export_scene(scene, to, {.progress = progress}); });
  out.commit();
  report(progress, 1, "exported");
  const nlohmann::json json = read_json(arguments.folder / compare::exported_scene_name);
  if (globals.json)
    fmt::print("{}\n", json_text(json, 1));
  else if (!globals.quiet)
    print_summary(arguments.folder, json);
}

}  // namespace

void add_export_command(CLI::App& app, GlobalOptions& globals) {
  CLI::App* command = app.add_subcommand(
      "export",
      "Write what is drawn for other renderers: geometry, colours, camera, exact picture");
  const auto arguments = std::make_shared<ExportArguments>();
  command->add_option("SCENE", arguments->scene, "Scene file")->required();
  command
      ->add_option("-o,--output", arguments->folder,
                   "Folder for scene.json, PLY files, scene.glb and reference.exr; it appears "
                   "whole or not at all")
      ->required();
  add_opacities_option(*command, arguments->opacities);
  command->footer("Example: pellucid export scenes/tornado.json -o tornado");
  add_gl_option(*command, globals);
  add_global_options(*command, globals);
  command->callback([arguments, &globals] { run(*arguments, globals); });
}

}  // namespace pellucid::app
