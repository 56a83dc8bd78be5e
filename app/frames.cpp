// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "compare/methods/methods.h"
#include "compare/methods/optimize_opacities.h"
#include "compare/pictures/image_file.h"
#include "compare/run/frame_sequence.h"
#include "core/error.h"
#include "core/files/files_read.h"
#include "core/files/json_text.h"
#include "core/files/output_file.h"
#include "core/options/names.h"
#include "scene/files/scene_file.h"

namespace pellucid::app {
namespace {

namespace fs = std::filesystem;

struct FramesOptions {
  std::string scene, method, opacities, output;
  std::optional<double> orbit;
  int frames = 30;
  scene::ViewRequest view;
};

/// Rows of frames.csv, and the same as JSON.
class FrameTable {
 public:
  void add(const compare::SequenceFrame& frame) {
    text_ += fmt::format(
        "{},{:.6g},{:.6g},{},{},{},{:.6g}\n", frame.index, frame.motion.degrees,
        frame.motion.distance, cell(frame.opacity ? &frame.opacity->mean : nullptr),
        cell(frame.opacity ? &frame.opacity->largest : nullptr),
        cell(frame.picture ? &*frame.picture : nullptr), frame.rendering.stats.seconds());
    nlohmann::ordered_json json{{"frame", frame.index},
                                {"degrees", frame.motion.degrees},
                                {"distance", frame.motion.distance},
                                {"seconds", frame.rendering.stats.seconds()}};
    if (frame.opacity)
      json["opacity_change"] = {{"mean", frame.opacity->mean}, {"max", frame.opacity->largest}};
    if (frame.picture) json["picture_change"] = *frame.picture;
    json_.push_back(std::move(json));
    if (frame.opacity) largest_ = std::max(largest_, frame.opacity->largest);
  }

  const std::string& csv() const { return text_; }
  const nlohmann::ordered_json& json() const { return json_; }
  double largest_change() const { return largest_; }

 private:
  static std::string cell(const double* value) {
    return value ? fmt::format("{:.6g}", *value) : std::string();
  }

  std::string text_ =
      "frame,degrees,distance,opacity_change_mean,opacity_change_max,picture_change,seconds\n";
  nlohmann::ordered_json json_ = nlohmann::ordered_json::array();
  double largest_ = 0;
};

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(fmt::format("{}: {}", folder.string(), error.message()));
}

void frames(const FramesOptions& options, const GlobalOptions& globals) {
  const ProtectedInputs inputs;
  const NameAndOptions named = parse_name_and_options(options.method);
  const scene::MethodRow& row = find_row("method", named.name, compare::methods());
  const compare::MethodCall method{&row, Parameters(row.name, row.parameters, named.options)};
  const std::optional<compare::MethodCall> opacities = compare::parse_opacities(options.opacities);
  const Progress progress = console_progress(globals);
  scene::Scene scene = scene::load_scene(options.scene, progress, options.view);
  if (options.orbit) scene.camera_path = scene::orbit(scene.camera, *options.orbit, options.frames);
  if (scene.camera_path.empty())
    throw InputError(options.scene + ": it has no camera_path; accepted: one, or --orbit DEGREES");
  const fs::path folder = options.output;
  make_folder(folder);
  FrameTable table;
  const auto count = double(scene.camera_path.size());
  compare::render_sequence(
      scene, method, opacities, {.gl = globals.gl}, [&](const compare::SequenceFrame& frame) {
        compare::write_image(folder / fmt::format("{:04}.png", frame.index), frame.rendering.image);
        table.add(frame);
        write_text(folder / "frames.csv", table.csv());
        report(progress, (frame.index + 1) / count, fmt::format("frame {}", frame.index));
      });
  if (globals.json)
    std::cout << json_text(table.json(), 2) << '\n';
  else if (!globals.quiet)
    std::cout << fmt::format("{}: {} frames; largest change of an element's opacity {:.3g}\n",
                             folder.string(), scene.camera_path.size(), table.largest_change());
}

}  // namespace

void add_frames_command(CLI::App& app, GlobalOptions& globals) {
  CLI::App* command = app.add_subcommand(
      "frames", "Render a scene along a camera path; says how opacities and pictures change");
  const auto options = std::make_shared<FramesOptions>();
  command->add_option("SCENE", options->scene, "Scene file; its camera_path is followed")
      ->required();
  command->add_option("-m,--method", options->method, "NAME[:key=value,...]; see 'list methods'")
      ->required();
  command
      ->add_option("-o,--output", options->output,
                   "Folder for the pictures 0000.png, ... and frames.csv")
      ->required();
  add_view_options(*command, options->view);
  add_opacities_option(*command, options->opacities);
  CLI::Option* around = command
                            ->add_option("--orbit", options->orbit,
                                         "Instead: go so many degrees around the camera's target")
                            ->check(finite_number());
  command->add_option("--frames", options->frames, "Of the orbit")
      ->needs(around)
      ->check(CLI::Range(2, 100000))
      ->capture_default_str();
  command->footer(
      "Example:\n  pellucid frames scene.json -m raytrace --view iso --orbit 360 --frames 60 -o "
      "turn");
  add_gl_option(*command, globals);
  add_global_options(*command, globals);
  command->callback([options, &globals] { frames(*options, globals); });
}

}  // namespace pellucid::app
