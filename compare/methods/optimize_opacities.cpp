// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/methods/optimize_opacities.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "compare/methods/methods.h"
#include "core/error.h"
#include "scene/elements/frame_memory.h"

namespace pellucid::compare {

std::vector<std::string_view> opacity_methods() {
  std::vector<std::string_view> names;
  for (const scene::MethodRow& row : methods())
    if (row.promises.optimizes_vertices) names.push_back(row.name);
  return names;
}

MethodCall checked_opacities(MethodCall call) {
  if (!call.row->promises.optimizes_vertices)
    throw InputError(fmt::format("opacities: '{}' finds no opacities of vertices; accepted: {}",
                                 call.row->name, fmt::join(opacity_methods(), ", ")));
  return call;
}

std::optional<MethodCall> parse_opacities(const std::string& text) {
  if (text.empty()) return std::nullopt;
  return checked_opacities(parse_call(text, methods()));
}

std::vector<scene::PixelSampling> further_samplings(std::span<const MethodCall> calls) {
  std::set<int> per_axis;
  for (const MethodCall& call : calls)
    if (std::ranges::find(call.row->parameters, "adaptive", &ParameterSpec::name) !=
        call.row->parameters.end())
      per_axis.insert(int(call.parameters.real("adaptive")));
  per_axis.erase(1);  // not adaptive: the scene's own samples alone
  std::vector<scene::PixelSampling> samplings;
  for (const int n : per_axis) samplings.push_back({.per_axis = n});
  return samplings;
}

void optimize_opacities(const MethodCall& call, const scene::RenderContext& context,
                        scene::Scene& scene, std::span<const scene::PixelSampling> further) {
  if (!scene::has_importance(scene))
    throw InputError(
        fmt::format("{}opacities cannot be optimized: nothing in the scene has importance above 0",
                    scene.name.empty() ? "" : scene.name + ": "));
  scene::FrameMemory of_this_alone;
  scene::RenderContext gathering = context;
  if (!gathering.memory) gathering.memory = &of_this_alone;
  gathering.memory->one_for_all_samples = true;
  const auto renderer = call.row->make(scene, call.parameters, gathering);
  renderer->render({});
  const scene::PixelSampling own = scene.samples;
  for (const scene::PixelSampling& sampling : further) {
    if (sampling == own) continue;
    scene.samples = sampling;  // the renderer takes it as it is now
    renderer->render({});
  }
  scene.samples = own;
  const std::optional<scene::OptimizedOpacities> found = renderer->optimized_opacities();
  if (!found)
    throw InputError(
        fmt::format("opacities: '{}' finds those of fragments, which no other method "
                    "can composite; accepted: per=element",
                    call.text()));
  scene::apply(*found, call.text(), scene);
}

}  // namespace pellucid::compare
