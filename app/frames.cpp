// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "compare/methods/methods.h"
#include "compare/methods/optimize_opacities.h"
#include "compare/pictures/image_file.h"
#include "compare/results/number_json.h"
#include "compare/run/frame_sequence.h"
#include "core/error.h"
#include "core/files/files_read.h"
#include "core/files/json_text.h"
#include "core/files/output_file.h"
#include "core/files/output_folder.h"
#include "scene/files/scene_file.h"

namespace pellucid::app {
namespace {

struct FramesOptions {
  std::string scene, method, opacities, reference, output;
  std::optional<double> orbit;
  int frames = 30;
  scene::ViewRequest view;
};

/// The metrics that a frame's row has: those that pictures are captioned with.
std::vector<const compare::MetricRow*> shown_metrics() {
  std::vector<const compare::MetricRow*> shown;
  for (const compare::MetricRow& metric : compare::metrics())
    if (metric.shown.card) shown.push_back(&metric);
  return shown;
}

/// Rows of frames.csv, and the same as JSON.
class FrameTable {
 public:
  explicit FrameTable(bool has_reference) {
    if (has_reference) {
      for (const compare::MetricRow* metric : shown_metrics())
        text_ += fmt::format(",{}", metric->name);
      text_ += ",flicker";
    }
    text_ += '\n';
  }

  void add(const compare::SequenceFrame& frame) {
    text_ += fmt::format(
        "{},{:.6g},{:.6g},{},{},{},{:.6g}", frame.index, frame.motion.degrees,
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
    if (frame.error) add_error(*frame.error, json);
    text_ += '\n';
    json_.push_back(std::move(json));
    if (frame.opacity) largest_ = std::max(largest_, frame.opacity->largest);
  }

  const std::string& csv() const { return text_; }
  const nlohmann::ordered_json& json() const { return json_; }
  /// What is said of all frames.
  std::string summary() const {
    std::string text = fmt::format("largest change of an element's opacity {:.3g}", largest_);
    if (errors_ == 0) return text;
    text += fmt::format("; RMSE {:.3g} on average, {:.3g} at worst", rmse_ / errors_, worst_);
    return errors_ > 1 ? text + fmt::format("; flicker {:.3g}", flicker_ / (errors_ - 1)) : text;
  }

 private:
  static std::string cell(const double* value) {
    return value ? fmt::format("{:.6g}", *value) : std::string();
  }

  void add_error(const compare::FrameError& error, nlohmann::ordered_json& json) {
    for (const compare::MetricRow* metric : shown_metrics()) {
      const std::optional<double>& value = error.metrics.linear.of(metric->name);
      text_ += fmt::format(",{}", cell(value ? &*value : nullptr));
      json[std::string(metric->name)] = compare::number_json(value);
    }
    text_ += fmt::format(",{}", cell(error.flicker ? &*error.flicker : nullptr));
    if (error.flicker) json["flicker"] = *error.flicker;
    const double rmse = error.metrics.linear.of("rmse").value_or(0);
    ++errors_;
    rmse_ += rmse;
    worst_ = std::max(worst_, rmse);
    flicker_ += error.flicker.value_or(0);
  }

  std::string text_ =
      "frame,degrees,distance,opacity_change_mean,opacity_change_max,picture_change,seconds";
  nlohmann::ordered_json json_ = nlohmann::ordered_json::array();
  double largest_ = 0;
  int errors_ = 0;
  double rmse_ = 0, worst_ = 0, flicker_ = 0;  // sums; the worst
};

/// A method that chooses opacities itself differs from the exact picture on purpose.
void check_reference(const FramesOptions& options, const compare::MethodCall& method) {
  if (!options.reference.empty() && method.row->promises.optimizes_opacity)
    throw InputError(fmt::format(
        "--reference beside -m {}: it chooses opacities itself, so that its pictures are meant to "
        "differ; accepted: --opacities with a method that composites them",
        method.row->name));
}

void frames(const FramesOptions& options, const GlobalOptions& globals) {
  const ProtectedInputs inputs;
  const compare::MethodCall method = compare::parse_call(options.method);
  check_reference(options, method);
  std::optional<compare::MethodCall> reference;
  if (!options.reference.empty()) reference = compare::parse_call(options.reference);
  const std::optional<compare::MethodCall> opacities = compare::parse_opacities(options.opacities);
  const Progress progress = console_progress(globals);
  scene::ViewRequest view = options.view;
  view.along_path = !options.orbit;
  scene::Scene scene = scene::load_scene(options.scene, progress, view);
  if (options.orbit) scene.camera_path = scene::orbit(scene.camera, *options.orbit, options.frames);
  if (scene.camera_path.empty())
    throw InputError(options.scene + ": it has no camera_path; accepted: one, or --orbit DEGREES");
  OutputFolder folder(options.output);
  FrameTable table(reference.has_value());
  const auto count = double(scene.camera_path.size());
  const auto write_frames = [&](const std::filesystem::path& to) {
    compare::render_sequence(
        scene, method, opacities, {.gl = globals.gl},
        [&](const compare::SequenceFrame& frame) {
          compare::write_image(
              to / fmt::format("{:04}.png", frame.index), frame.rendering.image,
              compare::form_of_picture(scene, {method.text(), opacities ? opacities->text() : "",
                                               options.view.without_background}));
          table.add(frame);
          report(progress, (frame.index + 1) / count, fmt::format("frame {}", frame.index));
        },
        reference);
    write_text(to / "frames.csv", table.csv());
  };
  folder.fill(write_frames);
  folder.commit();
  if (globals.json)
    std::cout << json_text(table.json(), 2) << '\n';
  else if (!globals.quiet)
    std::cout << fmt::format("{}: {} frames; {}\n", options.output, scene.camera_path.size(),
                             table.summary());
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
                   "Folder for the pictures 0000.png, ... and frames.csv; it appears whole or not "
                   "at all")
      ->required();
  add_view_options(*command, options->view);
  add_opacities_option(*command, options->opacities);
  command->add_option(
      "--reference", options->reference,
      "Draw each frame by this method, too, such as raytrace: frames.csv has how far "
      "the method is from it, and how its error flickers");
  CLI::Option* around = command
                            ->add_option("--orbit", options->orbit,
                                         "Instead: go so many degrees around the camera's target")
                            ->check(finite_number());
  command->add_option("--frames", options->frames, "Of the orbit")
      ->needs(around)
      ->check(CLI::Range(2, 100000))
      ->capture_default_str();
  command->footer(
      "Examples:\n"
      "  pellucid frames scene.json -m raytrace --view iso --orbit 360 --frames 60 -o turn\n"
      "  pellucid frames scenes/tornado.json -m fourier:bands=5 --reference raytrace \\\n"
      "      --orbit 90 --frames 24 -o frames");
  add_gl_option(*command, globals);
  add_global_options(*command, globals);
  command->callback([options, &globals] { frames(*options, globals); });
}

}  // namespace pellucid::app
