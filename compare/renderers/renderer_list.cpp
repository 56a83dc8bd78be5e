// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/renderers/renderer_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "compare/methods/methods.h"
#include "compare/study/read_calls.h"
#include "compare/study/read_given.h"
#include "core/error.h"
#include "core/machine/program_run.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

ListedRenderer read_folder(const JsonNode& node, const fs::path& base) {
  node.accept_keys({"pictures", "name"});
  ListedRenderer renderer{.name = node["name"].string(),
                          .pictures = base / node["pictures"].string()};
  if (!fs::is_directory(renderer.pictures))
    renderer.left_out = fmt::format("{}: no folder", renderer.pictures.string());
  return renderer;
}

ListedRenderer read_external(const JsonNode& node, const fs::path& base, const Catalogue& methods) {
  const std::vector<JsonNode> words = node["command"].elements();
  if (!words.empty() && find_program(words.front().string(), base).empty())
    return {.name = node["external"].string(),
            .left_out = fmt::format("'{}': no program that may be run", words.front().string())};
  MethodCall call = read_given(node, base, methods);
  return {.name = call.text(), .call = std::move(call)};
}

ListedRenderer read_renderer(const JsonNode& node, const fs::path& base, const Catalogue& methods) {
  if (node.is_object() && node.has("pictures")) return read_folder(node, base);
  if (node.is_object() && node.has("external")) {
    if (!node.has("command")) node.fail("lacks \"command\"");
    return read_external(node, base, methods);
  }
  MethodCall call = read_call(node, methods);
  return {.name = call.text(), .call = std::move(call)};
}

bool is_picture_missing(const CaseResult& result) {
  return result.verdict.fault == Fault::no_picture;
}

}  // namespace

RendererList read_renderer_list(const fs::path& file) {
  const nlohmann::json json = read_json(file);
  const JsonNode root(file.string(), json);
  root.accept_keys({"title", "renderers"});
  const fs::path base = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const Catalogue catalogue{"method", methods(), base};
  RendererList list;
  if (root.has("title")) list.title = root["title"].string();
  for (const JsonNode& node : root["renderers"].elements()) {
    ListedRenderer renderer = read_renderer(node, base, catalogue);
    if (std::ranges::find(list.renderers, renderer.name, &ListedRenderer::name) !=
        list.renderers.end())
      node.fail(fmt::format("'{}' is there twice; accepted: names of their own", renderer.name));
    list.renderers.push_back(std::move(renderer));
  }
  if (list.renderers.empty()) root["renderers"].fail("is empty; accepted: one renderer, or more");
  return list;
}

std::size_t RendererResult::passed() const {
  return std::size_t(
      std::ranges::count_if(cases, [](const CaseResult& c) { return c.verdict.passed; }));
}

std::size_t RendererResult::right_to_two_steps() const {
  return std::size_t(std::ranges::count_if(
      cases, [](const CaseResult& c) { return is_right_to_two_steps(c.verdict); }));
}

std::string RendererResult::nothing_drawn() const {
  if (!renderer.left_out.empty()) return renderer.left_out;
  if (!cases.empty() && std::ranges::all_of(cases, is_picture_missing))
    return cases.front().verdict.explanation;
  return {};
}

std::vector<RendererResult> conform_all(const RendererList& list, const ConformRequest& request) {
  std::vector<RendererResult> results;
  const auto all = double(list.renderers.size());
  for (const ListedRenderer& renderer : list.renderers) {
    ConformRequest of_one = request;
    of_one.call = renderer.call;
    of_one.pictures = renderer.pictures;
    const auto before = double(results.size());
    of_one.on_case = [&](double done, const CaseResult& result) {
      if (request.on_case) request.on_case((before + done) / all, result);
    };
    results.push_back({renderer});
    if (renderer.left_out.empty()) results.back().cases = conform(of_one);
  }
  return results;
}

}  // namespace pellucid::compare
