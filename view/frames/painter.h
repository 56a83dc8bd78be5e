// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "compare/methods/method_call.h"
#include "core/progress.h"
#include "groundtruth/methods/raytracer.h"
#include "scene/renderer.h"
#include "view/scenes/viewed_scene.h"

namespace pellucid::view {

/// A FrameRequest asks for the pictures of a view by one method or by two.
struct FrameRequest {
  ViewState view;
  std::vector<compare::MethodCall> methods;
  std::vector<std::string> metrics;  // of the second picture against the first; empty: none
};

/// Reads the state_keys, "methods": calls as on the command line, one or two, and "metrics": names
/// of compare::metrics(). Throws InputError.
FrameRequest read_frame_request(const JsonNode& node);

/// A ProbeRequest asks what the ray of a pixel crosses, and what a method makes of it.
struct ProbeRequest {
  ViewState view;
  int x = 0, y = 0;  // row 0 is the top
  compare::MethodCall method;
};

/// Reads the state_keys, "pixel": [x, y] and "method". Samples are left out: a probe's ray runs
/// through the pixel's centre. Throws InputError.
ProbeRequest read_probe_request(const JsonNode& node);

/// A Painter draws a scene. It keeps what it drew last, so that another method beside it costs that
/// method alone. It is of one thread.
class Painter {
 public:
  Painter(ViewedScene& scene, std::string gl) : scene_(scene), gl_(std::move(gl)) {}

  /// Returns a header of JSON and the pictures: the header's length in bytes (32 bits, least
  /// first), the header, blanks up to a multiple of 4, then of each method the floats of all red
  /// values, all green and all blue ones, row 0 first. The header has "size", "samples",
  /// "pictures": [{"method", "seconds"}] and "metrics": {NAME: number or null}.
  std::string frame(const FrameRequest& request, const Progress& progress);

  /// Returns {"exact": as probe_json() has it, "names" of the objects, "d": depths, "curves":
  /// [{"title", "symbol", "exact": values, "method": values or null}]}.
  nlohmann::json probe(const ProbeRequest& request, const Progress& progress);

  /// Returns the camera that sees all of the scene from the side of that name, in the state's
  /// picture and with its camera's projection. Throws InputError for an unknown name.
  scene::Camera fitted(const ViewState& state, std::string_view direction);

 private:
  /// A Drawn is a method's renderer and its picture of the view, once it is drawn.
  struct Drawn {
    std::unique_ptr<scene::Renderer> renderer;
    groundtruth::TurningRaytracer* turning = nullptr;  // the renderer, where it is one
    std::optional<scene::Rendering> rendering = std::nullopt;
  };

  void look(const ViewState& state, const std::vector<const compare::MethodCall*>& wanted);
  void forget(const ViewState& state);
  const Drawn& draw(const compare::MethodCall& call, const Progress& progress);
  void prepare(const compare::MethodCall& call, Drawn& drawn) const;

  ViewedScene& scene_;
  std::string gl_;
  ViewState state_;
  const scene::Scene* seen_ = nullptr;  // as state_ has it; what was drawn refers to it
  std::map<std::string, Drawn> drawn_;  // by the call's text
};

}  // namespace pellucid::view
