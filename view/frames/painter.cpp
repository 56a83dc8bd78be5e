// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/frames/painter.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "compare/cells/ray_functions.h"
#include "compare/methods/methods.h"
#include "compare/pictures/metrics.h"
#include "compare/results/probe_json.h"
#include "core/error.h"
#include "core/files/json_text.h"
#include "core/options/names.h"
#include "groundtruth/methods/raytrace.h"
#include "groundtruth/sums/ray_sums.h"
#include "scene/scene_fit.h"

namespace pellucid::view {
namespace {

using nlohmann::json;

compare::MethodCall read_call(const JsonNode& node) {
  return at_place(node, [&] { return compare::parse_call(node.string(), compare::methods()); });
}

void accept(const JsonNode& node, std::initializer_list<std::string_view> others) {
  std::vector<std::string_view> keys(std::begin(state_keys), std::end(state_keys));
  keys.insert(keys.end(), others);
  node.accept_keys(keys);
}

void append_number(std::string& bytes, std::uint32_t number) {
  for (int shift = 0; shift < 32; shift += 8) bytes += char(number >> shift);
}

void append_planes(std::string& bytes, const Image& image) {
  const std::size_t size = image.pixels.size(), start = bytes.size();
  bytes.resize(start + 3 * size * sizeof(float));
  for (int channel = 0; channel < 3; ++channel)
    for (std::size_t i = 0; i < size; ++i)
      std::memcpy(&bytes[start + (channel * size + i) * sizeof(float)], &image.pixels[i][channel],
                  sizeof(float));
}

json metrics_json(const Image& reference, const Image& test,
                  const std::vector<std::string>& names) {
  const compare::Metrics metrics =
      compare::metrics_of(compare::PicturePair(reference, test), names);
  json values = json::object();
  for (const std::string& name : names) {
    const auto& value = metrics.of(name);
    values[name] = value ? json(*value) : json();
  }
  return values;
}

/// By a layer's number of its object: halos are objects, too.
json object_names(const scene::Scene& scene) {
  json names = json::array();
  for (const scene::SceneObject& object : scene.objects) names.push_back(object.name);
  return names;
}

}  // namespace

FrameRequest read_frame_request(const JsonNode& node) {
  accept(node, {"methods", "metrics"});
  FrameRequest request;
  request.view = read_view_state(node);
  for (const JsonNode& method : node["methods"].elements())
    request.methods.push_back(read_call(method));
  if (request.methods.empty() || request.methods.size() > 2)
    node["methods"].fail("accepted: one call or two");
  if (node.has("metrics"))
    for (const JsonNode& name : node["metrics"].elements()) {
      request.metrics.push_back(name.string());
      at_place(name, [&] { find_row("metric", request.metrics.back(), compare::metrics()); });
    }
  return request;
}

ProbeRequest read_probe_request(const JsonNode& node) {
  accept(node, {"pixel", "method"});
  ProbeRequest request;
  request.view = read_view_state(node);
  request.view.samples = 1;
  const auto pixel = node["pixel"].elements();
  if (pixel.size() != 2) node["pixel"].fail("accepted: two integers, column and row");
  request.x = pixel[0].integer(0, request.view.width - 1);
  request.y = pixel[1].integer(0, request.view.height - 1);
  request.method = read_call(node["method"]);
  return request;
}

/// Of another view nothing that was drawn holds; but who turns with the scene may go on.
void Painter::forget(const ViewState& state) {
  const bool same_objects = seen_ && state.objects == state_.objects;
  seen_ = nullptr;
  std::erase_if(drawn_, [&](const auto& drawn) { return !same_objects || !drawn.second.turning; });
  for (auto& [call, drawn] : drawn_) drawn.rendering.reset();
}

/// Keeps of the same view only what is wanted, beside who turns.
void Painter::look(const ViewState& state, const std::vector<const compare::MethodCall*>& wanted) {
  if (!seen_ || !(state == state_)) {
    forget(state);
    seen_ = &scene_.look(state);
    state_ = state;
  }
  std::erase_if(drawn_, [&](const auto& drawn) {
    return !drawn.second.turning &&
           std::ranges::none_of(wanted, [&](const compare::MethodCall* call) {
             return call->text() == drawn.first;
           });
  });
}

void Painter::prepare(const compare::MethodCall& call, Drawn& drawn) const {
  if (drawn.turning) return drawn.turning->turn();
  if (call.row->name == groundtruth::raytrace_method().name) {
    auto turning = groundtruth::make_turning_raytracer(
        *seen_, groundtruth::raytrace_options().read(call.parameters));
    drawn.turning = turning.get();
    drawn.renderer = std::move(turning);
  } else {
    drawn.renderer = call.row->make(*seen_, call.parameters, {.gl = gl_});
  }
}

/// What has failed, or was ended, half way is made anew by who asks next.
const Painter::Drawn& Painter::draw(const compare::MethodCall& call, const Progress& progress) {
  const std::string text = call.text();
  Drawn& drawn = drawn_[text];
  if (drawn.rendering) return drawn;
  try {
    report(progress, 0, text);
    prepare(call, drawn);
    report(progress, 0, text);
    drawn.rendering = drawn.renderer->render({.progress = progress});
  } catch (...) {
    drawn_.erase(text);
    throw;
  }
  return drawn;
}

std::string Painter::frame(const FrameRequest& request, const Progress& progress) {
  std::vector<const compare::MethodCall*> wanted;
  for (const compare::MethodCall& call : request.methods) wanted.push_back(&call);
  look(request.view, wanted);
  json header{{"size", {request.view.width, request.view.height}},
              {"samples", request.view.samples},
              {"pictures", json::array()},
              {"metrics", json::object()}};
  std::vector<const Image*> images;
  for (const compare::MethodCall& call : request.methods) {
    const Drawn& drawn = draw(call, progress);
    images.push_back(&drawn.rendering->image);
    header["pictures"].push_back(
        {{"method", call.text()}, {"seconds", drawn.rendering->stats.seconds()}});
  }
  if (images.size() == 2 && !request.metrics.empty())
    header["metrics"] = metrics_json(*images[0], *images[1], request.metrics);
  std::string text = json_text(header);
  text.append((4 - text.size() % 4) % 4, ' ');
  std::string bytes;
  append_number(bytes, std::uint32_t(text.size()));
  bytes += text;
  for (const Image* image : images) append_planes(bytes, *image);
  return bytes;
}

json Painter::probe(const ProbeRequest& request, const Progress& progress) {
  look(request.view, {&request.method});
  json answer{{"exact", compare::probe_json(*seen_, {request.x, request.y})},
              {"names", object_names(*seen_)},
              {"d", compare::curve_depths()},
              {"curves", json::array()}};
  const Drawn& drawn = draw(request.method, progress);
  const groundtruth::RaySums ray =
      groundtruth::RayProbe(*seen_).at(request.x + 0.5, request.y + 0.5);
  for (const compare::RayFunction& function : compare::ray_functions()) {
    if (function.sum == scene::RaySum::importance && !scene::has_importance(*seen_)) continue;
    const auto series =
        drawn.renderer->ray_series(function.sum, request.x, request.y, compare::curve_depths());
    answer["curves"].push_back({{"title", function.title},
                                {"symbol", function.symbol},
                                {"exact", compare::exact_curve(function, ray)},
                                {"method", series ? json(series->values) : json()}});
  }
  return answer;
}

scene::Camera Painter::fitted(const ViewState& state, std::string_view direction) {
  const auto& row = find_row("view", direction, scene::view_directions());
  look(state, {});
  return scene::fitted_camera(*seen_, row);
}

}  // namespace pellucid::view
