// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/results/probe_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "groundtruth/sums/ray_sums.h"

namespace pellucid::compare {
namespace {

nlohmann::json to_json(const Vec3& x) { return {x.x, x.y, x.z}; }

nlohmann::json to_json(const groundtruth::RayLayer& layer) {
  return {{"depth", layer.depth},
          {"d", layer.d},
          {"object", layer.object},
          {"primitive", layer.primitive},
          {"color", to_json(layer.color)},
          {"opacity", layer.opacity},
          {"importance", layer.importance},
          {"transmittance", layer.transmittance},
          {"importance_sum", layer.importance_sum},
          {"optical_depth", layer.optical_depth}};
}

nlohmann::json pixel_json(const groundtruth::RayProbe& probe, int x, int y) {
  const groundtruth::RaySums sums = probe.at(x + 0.5, y + 0.5);
  nlohmann::json json{{"x", x},
                      {"y", y},
                      {"color", to_json(sums.color)},
                      {"transmittance", sums.transmittance},
                      {"layers", nlohmann::json::array()}};
  for (const groundtruth::RayLayer& layer : sums.layers) json["layers"].push_back(to_json(layer));
  return json;
}

}  // namespace

nlohmann::json probe_json(const scene::Scene& scene, const std::vector<int>& pixels) {
  const groundtruth::RayProbe probe(scene);
  nlohmann::json json{{"depth", {{"near", probe.depths().near}, {"far", probe.depths().far}}},
                      {"pixels", nlohmann::json::array()}};
  for (std::size_t i = 0; i + 1 < pixels.size(); i += 2) {
    const int x = pixels[i], y = pixels[i + 1];
    if (x < 0 || x >= scene.width || y < 0 || y >= scene.height)
      throw InputError(fmt::format("--probe {},{}; accepted: pixels from 0,0 to {},{}", x, y,
                                   scene.width - 1, scene.height - 1));
    json["pixels"].push_back(pixel_json(probe, x, y));
  }
  return json;
}

}  // namespace pellucid::compare
