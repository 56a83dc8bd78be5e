// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/entrants.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>

#include "compare/methods/sweep.h"
#include "core/error.h"
#include "core/options/split.h"

namespace pellucid::compare {
namespace {

bool has_isosurface(const scene::Scene& scene) {
  return std::ranges::any_of(scene.objects, [](const scene::SceneObject& object) {
    return std::holds_alternative<scene::Isosurface>(object.shape);
  });
}

bool fits(std::string_view patterns, const MethodCall& call) {
  const auto matches = [](std::string_view pattern, const std::string& text) {
    return ::fnmatch(std::string(pattern).c_str(), text.c_str(), 0) == 0;
  };
  return patterns.empty() || std::ranges::any_of(split(patterns, ','), [&](std::string_view one) {
           return matches(one, call.text()) || matches(one, std::string(call.row->name));
         });
}

}  // namespace

std::optional<std::string> why_left_out(const MethodCall& call, const MethodCall& reference,
                                        const scene::Scene& scene) {
  const scene::Promises &own = call.row->promises, &its = reference.row->promises;
  if (own.optimizes_opacity)
    return fmt::format(
        "it chooses opacities itself, so that its picture is not to be {}'s; with --opacities all "
        "composite those that one method chooses",
        reference.row->name);
  if (call.row != reference.row && own.exact_without_isosurfaces && its.exact &&
      !has_isosurface(scene))
    return fmt::format("without an isosurface it draws as {} does", reference.row->name);
  return std::nullopt;
}

std::vector<MethodCall> calls_that_fit(std::string_view patterns,
                                       std::span<const scene::MethodRow> table) {
  std::vector<MethodCall> calls;
  for (const scene::MethodRow& row : table)
    for (MethodCall& call : sweep_of(row))
      if (fits(patterns, call)) calls.push_back(std::move(call));
  if (calls.empty())
    throw InputError(fmt::format(
        "--methods '{}': fits no method; accepted: patterns of names or calls, such as '{}*,{}'",
        patterns, table.back().name, table.front().name));
  return calls;
}

}  // namespace pellucid::compare
