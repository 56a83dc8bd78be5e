// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/read_source.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "core/options/names.h"

namespace pellucid::compare {
namespace {

/// The text of a call that the study has.
std::string read_known_call(const JsonNode& node, const Study& study) {
  std::vector<std::string> texts{study.reference.text()};
  for (const MethodCall& call : study.methods) texts.push_back(call.text());
  std::string text = node.string();
  if (std::find(texts.begin(), texts.end(), text) == texts.end())
    node.fail(
        unknown_name("call", text, std::vector<std::string_view>(texts.begin(), texts.end())));
  return text;
}

/// What is named twice would be held against itself, or count twice in a mean.
void refuse_second(const JsonNode& node, const std::string& name,
                   std::span<const std::string> before) {
  if (std::ranges::find(before, name) != before.end())
    node.fail(fmt::format("a second '{}'; accepted: each once", name));
}

std::vector<std::string> read_group(const JsonNode& node, const Study& study) {
  if (!node.is_array()) return {read_known_call(node, study)};
  std::vector<std::string> group;
  for (const JsonNode& element : node.elements()) {
    std::string call = read_known_call(element, study);
    refuse_second(element, call, group);
    group.push_back(std::move(call));
  }
  if (group.empty()) node.fail("[]; accepted: at least one call");
  return group;
}

PublishedCost read_cost(const JsonNode& node, const Study& study,
                        std::span<const std::string> steps) {
  node.accept_keys({"scene", "method", "ms", "bytes", "steps"});
  const std::vector<std::string> scenes = scene_names(study);
  PublishedCost cost{node["scene"].string(), read_known_call(node["method"], study), 0, {}, {}};
  if (std::find(scenes.begin(), scenes.end(), cost.scene) == scenes.end())
    node["scene"].fail(unknown_name("scene", cost.scene,
                                    std::vector<std::string_view>(scenes.begin(), scenes.end())));
  constexpr double most = 1e15;
  cost.milliseconds = node["ms"].number(1e-6, most);
  if (node.has("bytes")) cost.bytes = node["bytes"].number(0, most);
  if (!node.has("steps")) return cost;
  for (const JsonNode& step : node["steps"].elements()) cost.steps.push_back(step.number(0, most));
  if (cost.steps.size() != steps.size())
    node["steps"].fail(fmt::format("{} times; accepted: one for each of the {} steps",
                                   cost.steps.size(), steps.size()));
  return cost;
}

/// A key that would say nothing beside another one is an error.
void refuse_beside(const JsonNode& node, std::string_view key,
                   std::initializer_list<std::string_view> others) {
  for (const std::string_view other : others)
    if (node.has(key) && node.has(other))
      node[other].fail(fmt::format("beside '{}'; accepted: one of the two", key));
}

std::vector<std::string_view> columns_with_better() {
  std::vector<std::string_view> names;
  for (const Column& column : columns())
    if (column.better != Better::neither) names.push_back(column.name);
  return names;
}

/// What has a share in an error: its stages, and what no single one accounts for.
std::vector<std::string_view> names_of_shares() {
  std::vector<std::string_view> names(budget_stage_names.begin(), budget_stage_names.end());
  names.push_back(interaction_name);
  return names;
}

ClaimedNumber read_number(const JsonNode& node) {
  refuse_beside(node, "by", {"measure", "stage", "better"});
  refuse_beside(node, "measure", {"stage"});
  if (node.has("measure") || node.has("stage")) {
    ClaimedNumber number;
    if (node.has("measure")) number.measure = node["measure"].string();
    if (node.has("stage")) number.stage = node["stage"].one_of(names_of_shares());
    if (node.has("better"))
      number.better = better_of_name(node["better"].one_of({"lower", "higher"}));
    return number;
  }
  const std::string by = node["by"].string();
  const Column& column =
      at_place(node["by"], [&]() -> const Column& { return find_row("number", by, columns()); });
  if (column.better == Better::neither)
    node["by"].fail(fmt::format("'{}': no way is better; accepted: {}", column.name,
                                fmt::join(columns_with_better(), ", ")));
  return {&column, {}, column.better};
}

std::vector<std::string> read_claimed_scenes(const JsonNode& node, const Study& study) {
  const std::vector<std::string> known = scene_names(study);
  std::vector<std::string> scenes;
  for (const JsonNode& element : node.elements()) {
    const std::string name = element.string();
    if (std::ranges::find(known, name) == known.end())
      element.fail(
          unknown_name("scene", name, std::vector<std::string_view>(known.begin(), known.end())));
    refuse_second(element, name, scenes);
    scenes.push_back(name);
  }
  return scenes;
}

void read_order(const JsonNode& node, const Study& study, Claim& claim) {
  constexpr double most = 1e9;
  std::vector<std::string> before;
  for (const JsonNode& element : node["order"].elements()) {
    claim.order.push_back(read_group(element, study));
    for (const std::string& call : claim.order.back()) {
      refuse_second(element, call, before);
      before.push_back(call);
    }
  }
  if (claim.order.size() < 2) node["order"].fail("accepted: at least two calls, the best first");
  if (node.has("factor")) claim.factor = node["factor"].number(1, most);
}

void read_scene_order(const JsonNode& node, const Study& study, Claim& claim) {
  claim.scenes = read_claimed_scenes(node, study);
  claim.orders_scenes = true;
  if (claim.scenes.size() < 2) node.fail("accepted: at least two scenes, the best first");
}

/// The calls of a group, or with "*" all but the reference.
std::vector<std::string> read_bounded(const JsonNode& node, const Study& study) {
  if (!node.is_string() || node.string() != "*") return read_group(node, study);
  std::vector<std::string> calls;
  for (const MethodCall& call : study.methods) calls.push_back(call.text());
  if (calls.empty()) node.fail("\"*\", and no methods; accepted: a call of the study");
  return calls;
}

/// The calls of a group, or of the method that it names; one call alone has no order.
std::vector<std::string> read_calls_of(const JsonNode& node, const Study& study) {
  std::vector<std::string> calls;
  if (node.is_string())
    for (const MethodCall& call : study.methods)
      if (call.row->name == node.string()) calls.push_back(call.text());
  return calls.empty() ? read_group(node, study) : calls;
}

/// The number that a call of the study gives to one of its parameters.
double parameter_of(const std::string& text, const JsonNode& parameter, const Study& study) {
  const auto call = std::ranges::find_if(
      study.methods, [&](const MethodCall& method) { return method.text() == text; });
  const RawOptions values =
      (call == study.methods.end() ? study.reference : *call).parameters.all();
  const auto found = values.find(parameter.string());
  double number = 0;
  if (found == values.end() || !parse_number(found->second, number))
    parameter.fail(
        fmt::format("'{}': '{}' has no such number; accepted: a parameter that is a "
                    "number in each of the calls",
                    parameter.string(), text));
  return number;
}

/// Each call is better, or worse, than those with a smaller number: an order of them.
void read_monotony(const JsonNode& node, std::string_view key, const Study& study, Claim& claim) {
  std::map<double, std::string> calls;
  for (const std::string& call : read_calls_of(node["of"], study))
    if (!calls.emplace(parameter_of(call, node[key], study), call).second)
      node[key].fail(
          fmt::format("'{}': the same in two calls; accepted: a parameter in which all "
                      "calls differ",
                      node[key].string()));
  if (calls.size() < 2)
    node["of"].fail(
        fmt::format("{}: one call has no order; accepted: at least two calls, or a "
                    "method that has them",
                    calls.begin()->second));
  claim.monotone = true;
  for (const auto& [value, call] : calls) claim.order.push_back({call});
  if (key == "improves_with") std::ranges::reverse(claim.order);
}

void read_same(const JsonNode& node, const Study& study, Claim& claim) {
  constexpr double most = 1000;
  claim.same = true;
  claim.order = {read_group(node["same"], study)};
  if (claim.order[0].size() < 2) node["same"].fail("accepted: at least two calls");
  if (node.has("within"))
    claim.within = node["within"].number(0, most);
  else if (!claim.by.column || !is_time(*claim.by.column) || !claim.by.column->interval)
    node["same"].fail(
        fmt::format("'{}' has no interval; accepted: beside 'within', how far the "
                    "ratio of two may be from 1",
                    claim.by.heading()));
}

/// A number that the source printed, give or take half a unit of its last digit.
void read_printed(const JsonNode& node, Claim& claim) {
  constexpr double most = 1e15;
  claim.same = true;
  claim.bound = node["equals"].number(-most, most);
  claim.within = node["within"].number(0, most);
}

/// "at_most" of what is better when it is lower, "at_least" of the rest: a bound is on the worse
/// side.
void read_bound(const JsonNode& node, Claim& claim) {
  constexpr double most = 1e15;
  const bool lower = claim.by.better == Better::lower;
  const std::string_view key = lower ? "at_most" : "at_least";
  const std::string_view other = lower ? "at_least" : "at_most";
  if (node.has(other))
    node[other].fail(fmt::format("'{}' is better when it is {}; accepted: {}", claim.by.heading(),
                                 name_of(claim.by.better), key));
  claim.bound = node[key].number(-most, most);
}

}  // namespace

Claim read_claim(const JsonNode& node, const Study& study) {
  node.accept_keys({"claim", "by", "measure", "stage", "better", "order", "factor", "of", "at_most",
                    "at_least", "same", "within", "improves_with", "worsens_with", "scenes",
                    "scene_order", "somewhere", "equals"});
  for (const std::string_view key :
       {"order", "same", "at_most", "at_least", "improves_with", "worsens_with", "scene_order"})
    refuse_beside(node, "equals", {key});
  refuse_beside(node, "order", {"of", "at_most", "at_least", "same", "within", "scene_order"});
  refuse_beside(node, "of", {"factor", "same"});
  if (!node.has("equals")) refuse_beside(node, "of", {"within"});
  refuse_beside(node, "same", {"factor", "at_most", "at_least", "scene_order"});
  refuse_beside(node, "scene_order", {"at_most", "at_least", "scenes", "somewhere"});
  for (const std::string_view key : {"improves_with", "worsens_with"})
    refuse_beside(node, key, {"order", "same", "at_most", "at_least", "scene_order"});
  refuse_beside(node, "improves_with", {"worsens_with"});
  Claim claim{node["claim"].string(), read_number(node), {}};
  if (node.has("order")) {
    read_order(node, study, claim);
  } else if (node.has("same")) {
    read_same(node, study, claim);
  } else if (node.has("improves_with")) {
    read_monotony(node, "improves_with", study, claim);
  } else if (node.has("worsens_with")) {
    read_monotony(node, "worsens_with", study, claim);
  } else {
    claim.order = {read_bounded(node["of"], study)};
    if (node.has("equals"))
      read_printed(node, claim);
    else if (node.has("scene_order"))
      read_scene_order(node["scene_order"], study, claim);
    else
      read_bound(node, claim);
  }
  if (node.has("scenes")) claim.scenes = read_claimed_scenes(node["scenes"], study);
  if (node.has("scenes") && claim.scenes.empty())  // which would stand for all of them
    node["scenes"].fail("[]; accepted: names of the study's scenes");
  if (node.has("somewhere")) claim.somewhere = node["somewhere"].boolean();
  return claim;
}

Ladder read_ladder(const JsonNode& node, const Study& study) {
  node.accept_keys({"title", "by", "measure", "stage", "better", "bound", "scenes"});
  constexpr double most = 1e300;
  Ladder ladder{node["title"].string(), read_number(node), node["bound"].number(-most, most),
                read_claimed_scenes(node["scenes"], study)};
  if (ladder.scenes.empty()) node["scenes"].fail("[]; accepted: names of the study's scenes");
  return ladder;
}

Growth read_growth(const JsonNode& node, const Study& study) {
  node.accept_keys({"title", "by", "scenes"});
  Growth growth{node["title"].string(), {}, {}};
  const auto add = [&](const JsonNode& name) {
    const std::string column = name.string();
    growth.by.push_back(at_place(name, [&] { return &find_row("column", column, columns()); }));
  };
  if (node.has("by")) {
    for (const JsonNode& name : node["by"].elements()) add(name);
    if (growth.by.empty()) node["by"].fail("[]; accepted: names of columns, such as \"seconds\"");
  } else {
    for (const char* name : {"seconds", "bytes"})
      growth.by.push_back(&find_row("column", name, columns()));
  }
  constexpr double least = 1e-300, most = 1e300;
  const std::vector<std::string> known = scene_names(study);
  for (const std::string& scene : node["scenes"].keys()) {
    const JsonNode size = node["scenes"][scene];
    if (std::ranges::find(known, scene) == known.end())
      size.fail(
          unknown_name("scene", scene, std::vector<std::string_view>(known.begin(), known.end())));
    growth.scenes.emplace_back(scene, size.number(least, most));
  }
  if (growth.scenes.size() < 2)
    node["scenes"].fail("accepted: two of the study's scenes or more, each with its size");
  return growth;
}

PublishedCosts read_published(const JsonNode& node, const Study& study) {
  node.accept_keys({"machine", "steps", "rows"});
  PublishedCosts costs{node["machine"].string(), {}, {}};
  if (node.has("steps"))
    for (const JsonNode& step : node["steps"].elements()) costs.steps.push_back(step.string());
  for (const JsonNode& row : node["rows"].elements()) {
    PublishedCost cost = read_cost(row, study, costs.steps);
    for (const PublishedCost& other : costs.rows)
      if (other.scene == cost.scene && other.call == cost.call)
        row.fail(
            fmt::format("a second cost of '{}' on '{}'; accepted: one", cost.call, cost.scene));
    costs.rows.push_back(std::move(cost));
  }
  return costs;
}

}  // namespace pellucid::compare
