// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/budget/budget_stages.h"

#include <fmt/format.h>

#include <algorithm>

#include "compare/budget/geometry_stages.h"
#include "core/options/split.h"

namespace pellucid::compare {
namespace {

constexpr int most_samples = 16;  // per axis, as in a scene file

StageRefinement refine_samples(const BudgetTools& tools, DrawPlan& plan) {
  const int given = plan.samples.per_axis;
  if (plan.samples.frames > 0) return {"", "the scene's samples are frames"};
  if (given >= most_samples) return {"", "the scene has the most samples that there are"};
  plan.samples.per_axis = std::clamp(2 * given, tools.options.samples, most_samples);
  return {fmt::format("{0} × {0} samples a pixel", plan.samples.per_axis), ""};
}

/// What both methods know by one name, as it was given to the first.
Parameters common_parameters(const MethodCall& from, const scene::MethodRow& to) {
  RawOptions options;
  for (const ParameterSpec& spec : to.parameters)
    if (const auto found = from.parameters.all().find(spec.name);
        found != from.parameters.all().end() && !found->second.empty())
      options.emplace(found->first, found->second);
  return {to.name, to.parameters, options};
}

StageRefinement refine_opacities(const BudgetTools& tools, DrawPlan& plan) {
  if (!plan.opacities) return {"", "the scene's opacities are its own"};
  const scene::MethodRow& exact = *tools.exact_opacities.row;
  if (plan.opacities->row == &exact)
    return {"", fmt::format("{} sums importance exactly", exact.name)};
  plan.opacities = MethodCall{&exact, common_parameters(*plan.opacities, exact)};
  return {plan.opacities->text(), ""};
}

/// Its promise holds but for some parameters at other values than their defaults.
bool is_exact(const MethodCall& call) {
  const auto spoils = [&](const ParameterSpec& spec) {
    const auto names = split(call.row->promises.exact_unless, '|');
    const auto given = call.parameters.all().find(spec.name);
    return std::ranges::find(names, spec.name) != names.end() &&
           given != call.parameters.all().end() && given->second != spec.default_value;
  };
  return call.row->promises.exact && std::ranges::none_of(call.row->parameters, spoils);
}

StageRefinement refine_compositing(const BudgetTools& tools, DrawPlan& plan) {
  if (is_exact(plan.call))
    return {"", fmt::format("{} composites every layer exactly", plan.call.row->name)};
  plan.call = plan.call.row->promises.in_double ? tools.reference : tools.lists;
  return {plan.call.text(), ""};
}

StageRefinement refine_arithmetic(const BudgetTools& tools, DrawPlan& plan) {
  if (plan.call.row == tools.reference.row || plan.call.row->promises.in_double)
    return {"", fmt::format("{} computes in double", plan.call.row->name)};
  plan.call = tools.reference;
  return {fmt::format("{}, in double", plan.call.text()), ""};
}

StageRefinement refine_display(const BudgetTools&, DrawPlan& plan) {
  plan.displayed = false;
  return {"float values", ""};
}

constexpr BudgetStage stages[] = {
    {"field", "Sampling of the field", refine_field},
    {"integration", "Integration", refine_integration},
    {"mesh", "Mesh and lines", refine_mesh},
    {"samples", "Samples of a pixel", refine_samples},
    {"opacities", "Opacities", refine_opacities},
    {"compositing", "Compositing", refine_compositing},
    {"arithmetic", "Float arithmetic and rasterization", refine_arithmetic, "compositing"},
    {"display", "Rounding to 8 bits", refine_display}};

}  // namespace

std::span<const BudgetStage> budget_stages() { return stages; }

std::string title_of_stage(std::string_view name) {
  for (const BudgetStage& stage : stages)
    if (stage.name == name) return std::string(stage.title);
  return std::string(name);
}

}  // namespace pellucid::compare
