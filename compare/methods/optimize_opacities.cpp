// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/methods/optimize_opacities.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>
#include <vector>

#include "compare/methods/methods.h"
#include "core/error.h"

namespace pellucid::compare {
namespace {

std::vector<std::string_view> methods_that_do() {
  std::vector<std::string_view> names;
  for (const scene::MethodRow& row : methods())
    if (row.promises.optimizes_vertices) names.push_back(row.name);
  return names;
}

}  // namespace

MethodCall checked_opacities(MethodCall call) {
  if (!call.row->promises.optimizes_vertices)
    throw InputError(fmt::format("opacities: '{}' finds no opacities of vertices; accepted: {}",
                                 call.row->name, fmt::join(methods_that_do(), ", ")));
  return call;
}

std::optional<MethodCall> parse_opacities(const std::string& text) {
  if (text.empty()) return std::nullopt;
  return checked_opacities(parse_call(text, methods()));
}

void optimize_opacities(const MethodCall& call, const scene::RenderContext& context,
                        scene::Scene& scene) {
  if (!scene::has_importance(scene))
    throw InputError(
        fmt::format("{}: opacities cannot be optimized: nothing in the scene has "
                    "importance above 0",
                    scene.name));
  const scene::PixelSampling samples = std::exchange(scene.samples, {});
  const auto renderer = call.row->make(scene, call.parameters, context);
  renderer->render({});
  const std::optional<scene::OptimizedOpacities> found = renderer->optimized_opacities();
  scene.samples = samples;
  if (!found)
    throw InputError(
        fmt::format("opacities: '{}' finds those of fragments, which no other method "
                    "can composite; accepted: per=element",
                    call.text()));
  scene::apply(*found, call.text(), scene);
}

}  // namespace pellucid::compare
