// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/results/render_json.h"

#include <nlohmann/json.hpp>

#include "compare/results/number_json.h"
#include "core/machine/machine.h"
#include "scene/files/camera_file.h"

namespace pellucid::compare {
namespace {

nlohmann::json to_json(const scene::FrameStats& frame) {
  return {{"seconds", frame.seconds}, {"lines", frame.lines}, {"fragments", frame.fragments},
          {"layers", frame.layers},   {"bytes", frame.bytes}, {"change", frame.change}};
}

/// From where the scene was seen, as a scene file has it.
nlohmann::json view_json(const scene::Scene& scene) {
  return {{"camera", scene::camera_json(scene.camera)},
          {"camera_found", scene.provenance.at("camera")},
          {"resolution", {scene.width, scene.height}},
          {"samples", scene::samples_json(scene.samples)}};
}

}  // namespace

nlohmann::json render_json(const MethodCall& call, const std::optional<MethodCall>& opacities,
                           const scene::Scene& scene, const scene::RenderStats& stats,
                           scene::Renderer& renderer) {
  nlohmann::json json;
  json["method"] = call.row->name;
  json["parameters"] = call.parameters.all();
  if (opacities) json["opacities"] = opacities->text();
  json["seconds"]["total"] = stats.seconds();
  for (const scene::StepTime& step : stats.steps)
    json["seconds"]["steps"][step.name] = step.seconds;
  if (const auto by_gl = stats.gl_seconds()) json["seconds"]["gl"] = *by_gl;
  json["bytes"]["total"] = stats.total_bytes();
  for (const scene::NamedBytes& part : stats.bytes) json["bytes"][part.name] = part.bytes;
  json["fragments"] = stats.fragments;
  json["stored"] = stats.stored;
  json["dropped"] = stats.dropped;
  json["truncated_pixels"] = stats.truncated;
  json["max_layers"] = stats.max_layers;
  for (const scene::FrameStats& frame : stats.frames) json["frames"].push_back(to_json(frame));
  for (const scene::Measure& measure : renderer.findings().measures)
    json["measures"][measure.name] = number_json(measure.value);
  json["machine"] = machine_facts();
  json["machine"].update(nlohmann::json(renderer.facts()));
  json["view"] = view_json(scene);
  return json;
}

}  // namespace pellucid::compare
