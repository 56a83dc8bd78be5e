// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/budget/geometry_stages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.h"
#include "core/options/names.h"
#include "core/options/parameters.h"
#include "core/vec.h"
#include "fields/readers/file_field.h"
#include "integrators/lines/integrate_lines.h"
#include "integrators/sheets/integrate_sheet.h"
#include "integrators/sheets/sheet_options.h"
#include "integrators/surfaces/integrate_surface.h"

namespace pellucid::compare {
namespace {

using nlohmann::json;
using Texts = std::set<std::string>;

/// What of a scene's text is integrated: the values of "surface", and of "lines" that are no file.
std::vector<json*> flows_of(json& scene) {
  std::vector<json*> flows;
  for (json& object : scene.at("objects"))
    for (const char* key : {"surface", "lines"})
      if (object.contains(key) && object[key].is_object()) flows.push_back(&object[key]);
  return flows;
}

std::string text_of(const NameAndOptions& call) {
  std::string text = call.name;
  for (const auto& [key, value] : call.options)
    text += fmt::format("{}{}={}", text == call.name ? ':' : ',', key, value);
  return text;
}

/// The file of a sampled field, behind which options may stand; empty for a formula.
std::string file_of(const std::string& field) {
  const std::string name = field.substr(0, field.find(':'));
  return fields::file_format(name) ? name : "";
}

Vec3 vector_of(const json& numbers) { return {numbers.at(0), numbers.at(1), numbers.at(2)}; }

/// The box of the seeds, in world units; empty where they are a file's.
Box3 box_of(const json& seed) {
  Box3 box;
  for (const char* key : {"from", "to"})
    if (seed.contains(key)) box.extend(vector_of(seed[key]));
  for (const char* key : {"points", "spline"})
    if (seed.contains(key))
      for (const json& point : seed[key]) box.extend(vector_of(point));
  if (seed.contains("corner"))
    for (const double a : {0., 1.})
      for (const double b : {0., 1.})
        box.extend(vector_of(seed["corner"]) + a * vector_of(seed["u"]) + b * vector_of(seed["v"]));
  if (seed.contains("radius")) {
    // A circle reaches as far along an axis as its normal is across it, a sphere all the way.
    const Vec3 center = vector_of(seed["center"]);
    Vec3 reach(1);
    if (seed.contains("normal")) {
      const Vec3 n = glm::normalize(vector_of(seed["normal"]));
      reach = glm::sqrt(glm::max(1.0 - n * n, 0.0));
    }
    box.extend(center - seed["radius"].get<double>() * reach);
    box.extend(center + seed["radius"].get<double>() * reach);
  }
  return box;
}

/// The diagonal of the seeds' box, in world units; 1 where it has none, or is not known.
double extent_of(const json& seed) {
  const double extent = box_of(seed).diagonal();
  return extent > 0 && std::isfinite(extent) ? extent : 1;
}

/// Nothing where the option is not given.
std::optional<double> number_of(const NameAndOptions& call, std::string_view key) {
  const auto found = call.options.find(key);
  double value = 0;
  if (found == call.options.end() || !parse_number(found->second, value)) return std::nullopt;
  return value;
}

std::string stepped_finely(const std::string& integrator, const json& seed) {
  constexpr double of_extent = 1e-10, of_given = 1e-3;
  NameAndOptions call = parse_name_and_options(integrator);
  double accuracy = of_extent * extent_of(seed);
  if (const auto given = number_of(call, "accuracy"))
    accuracy = std::min(accuracy, of_given * *given);
  for (const char* key : {"stepper", "dt", "cells"}) call.options.erase(key);
  call.options["accuracy"] = fmt::format("{:.3g}", accuracy);
  return text_of(call);
}

/// The parameter of the integrator that is called, or nullptr where it has none of this name.
const ParameterSpec* parameter_of(const NameAndOptions& call, std::string_view key) {
  const auto find = [&](const auto& rows) -> const ParameterSpec* {
    for (const auto& row : rows)
      for (const ParameterSpec& spec : row.parameters)
        if (row.name == call.name && spec.name == key) return &spec;
    return nullptr;
  };
  const ParameterSpec* found = find(integrators::integrators());
  if (!found) found = find(integrators::sheet_integrators());
  return found ? found : find(integrators::line_integrators());
}

void take_default(NameAndOptions& call, const char* key) {
  call.options.try_emplace(key, parameter_of(call, key)->default_value);
}

/// What is so many becomes so many times more between the same ends.
void multiply(NameAndOptions& call, const char* key, double factor) {
  take_default(call, key);
  const double more = std::floor((*number_of(call, key) - 1) * factor) + 1;
  call.options[key] = fmt::format("{:.0f}", std::min(more, parameter_of(call, key)->max));
}

void divide(NameAndOptions& call, const char* key, double by) {
  if (const auto value = number_of(call, key))
    call.options[key] = fmt::format("{:.6g}", *value / by);
}

/// Of a front that inserts particles, where no tolerance is given.
void take_default_threshold(NameAndOptions& call) {
  if (call.options.contains("tolerance")) return;
  const auto& row = find_row("integrator", call.name, integrators::integrators());
  call.options.try_emplace("threshold", fmt::format("{}", row.default_threshold));
}

/// A mesh's distance to its surface goes with the square of its triangles' sides.
std::string meshed_finely(const std::string& integrator, const json& seed, double factor) {
  NameAndOptions call = parse_name_and_options(integrator);
  divide(call, "step", factor);
  if (parameter_of(call, "rows")) {
    multiply(call, "particles", factor);
    multiply(call, "rows", factor);
  } else if (parameter_of(call, "threshold")) {
    take_default_threshold(call);
    divide(call, "threshold", factor);
    divide(call, "tolerance", factor * factor);
  } else if (parameter_of(call, "turn")) {
    take_default(call, "turn");
    divide(call, "turn", factor);
  } else if (parameter_of(call, "releases")) {
    multiply(call, "releases", factor);
  } else if (parameter_of(call, "tolerance")) {
    const double tolerance = integrators::sheet_tolerance({}, extent_of(seed));
    call.options.try_emplace("tolerance", fmt::format("{}", tolerance));
    divide(call, "tolerance", factor * factor);
    multiply(call, "particles", factor);
  }
  return text_of(call);
}

/// Replaces the integrator of every flow; returns the new texts, each once.
template <class Refine>
Texts refine_integrators(DrawPlan& plan, const Refine& refine) {
  Texts texts;
  for (json* flow : flows_of(plan.scene)) {
    const std::string finer = refine(flow->at("integrator").get<std::string>(), flow->at("seed"));
    (*flow)["integrator"] = finer;
    texts.insert(finer);
  }
  return texts;
}

/// Isosurfaces that the scene draws as meshes.
std::vector<json*> isosurface_meshes(json& scene) {
  std::vector<json*> meshes;
  for (json& object : scene.at("objects"))
    if (object.contains("isosurface") && object["isosurface"].value("mesh", false))
      meshes.push_back(&object["isosurface"]);
  return meshes;
}

/// Many objects are told by the first and their number.
std::string listed(const Texts& texts) {
  if (texts.size() <= 2) return fmt::format("{}", fmt::join(texts, "; "));
  return fmt::format("{} and {} more", *texts.begin(), texts.size() - 1);
}

}  // namespace

StageRefinement refine_field(const BudgetTools& tools, DrawPlan& plan) {
  std::string file;
  for (json* flow : flows_of(plan.scene)) {
    const std::string sampled = file_of(flow->at("field").get<std::string>());
    if (sampled.empty()) continue;
    file = sampled;
    if (!tools.options.field.empty()) (*flow)["field"] = tools.options.field;
  }
  if (file.empty()) return {"", "no field of the scene is sampled"};
  if (tools.options.field.empty())
    return {"", fmt::format("the formula behind {} is not known; \"budget\": {{\"field\": NAME}} "
                            "names it",
                            file)};
  return {tools.options.field, ""};
}

StageRefinement refine_integration(const BudgetTools&, DrawPlan& plan) {
  const Texts finer = refine_integrators(plan, stepped_finely);
  if (finer.empty()) return {"", "nothing of the scene is integrated"};
  return {listed(finer), ""};
}

StageRefinement refine_mesh(const BudgetTools& tools, DrawPlan& plan) {
  Texts finer = refine_integrators(plan, [&](const std::string& integrator, const json& seed) {
    return meshed_finely(integrator, seed, tools.options.factor);
  });
  const std::vector<json*> meshes = isosurface_meshes(plan.scene);
  for (json* mesh : meshes) (*mesh)["mesh"] = false;
  if (!meshes.empty()) finer.insert("the isosurface itself");
  if (finer.empty()) return {"", "the scene's geometry is given, not made from a field"};
  return {listed(finer), ""};
}

}  // namespace pellucid::compare
