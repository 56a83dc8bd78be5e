// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/renderers/renderers_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <nlohmann/json.hpp>

#include "compare/conform/conform_json.h"
#include "compare/pictures/image_file.h"
#include "compare/report/base64.h"
#include "compare/report/html_text.h"
#include "compare/report/markdown_text.h"
#include "core/files/json_text.h"
#include "core/files/output_file.h"
#include "renderers_files.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using Results = std::span<const RendererResult>;

std::string element_of(const Image& image, std::string_view what) {
  return fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">", html_escaped(what),
                     base64(encode_png({}, image, {})));
}

/// How a verdict is shown: passed, right to what 8 bits hold, or a fault.
std::string_view kind_of(const Verdict& verdict) {
  return verdict.passed ? "passed" : is_right_to_two_steps(verdict) ? "near" : "fault";
}

std::string text_of(const Verdict& verdict) {
  if (verdict.passed) return "passed";
  if (verdict.fault == Fault::no_picture) return std::string(verdict.fault);
  return fmt::format("{} {:.2g}", verdict.fault, verdict.max_error);
}

std::vector<const RendererResult*> that_drew(Results results) {
  std::vector<const RendererResult*> drew;
  for (const RendererResult& result : results)
    if (result.nothing_drawn().empty()) drew.push_back(&result);
  return drew;
}

std::string summary_rows(Results results) {
  std::string rows;
  for (const RendererResult& result : results) {
    rows += fmt::format("<tr><th scope=\"row\">{}</th>", html_escaped(result.renderer.name));
    if (const std::string why = result.nothing_drawn(); !why.empty()) {
      rows += fmt::format("<td colspan=\"3\" class=\"note\">drew nothing: {}</td></tr>\n",
                          html_escaped(why));
      continue;
    }
    std::string failing;
    for (const FamilySummary& family : summarize(result.cases))
      if (family.first_failed && !is_right_to_two_steps(family.first_failed->verdict))
        failing += fmt::format("{}{}", failing.empty() ? "" : ", ", family.first_failed->name);
    rows += fmt::format("<td>{} of {}</td><td>{}</td><td class=\"note\">{}</td></tr>\n",
                        result.passed(), result.cases.size(), result.right_to_two_steps(), failing);
  }
  return rows;
}

std::string head_cells(const std::vector<const RendererResult*>& drew) {
  std::string cells;
  for (const RendererResult* result : drew)
    cells += fmt::format("<th scope=\"col\">{}</th>", html_escaped(result->renderer.name));
  return cells;
}

std::string cell_of(const CaseResult& result) {
  const Verdict& v = result.verdict;
  return fmt::format(
      "<td class=\"{}\" title=\"{}\">{}<span>{}</span></td>", kind_of(v),
      html_escaped(v.passed ? fmt::format("off by {:.1e}", v.max_error) : v.explanation),
      result.picture ? element_of(*result.picture, "drawn") : "", html_escaped(text_of(v)));
}

std::string case_rows(const std::vector<const RendererResult*>& drew) {
  std::map<std::string, Image> right;
  for (const ConformanceCase& c : conformance_cases()) right[c.name] = expected_picture(c);
  std::string rows, family;
  const std::size_t cases = drew.empty() ? 0 : drew.front()->cases.size();
  for (std::size_t i = 0; i < cases; ++i) {
    const CaseResult& c = drew.front()->cases[i];
    if (c.family != family)
      rows += fmt::format("<tr><th colspan=\"{}\" class=\"family\">{}</th></tr>\n", drew.size() + 2,
                          html_escaped(family = c.family));
    rows +=
        fmt::format("<tr><th scope=\"row\">{}<span>{}</span></th><td>{}</td>", html_escaped(c.name),
                    html_escaped(c.what), element_of(right.at(c.name), "right"));
    for (const RendererResult* result : drew) rows += cell_of(result->cases[i]);
    rows += "</tr>\n";
  }
  return rows;
}

/// What a renderer's pictures look like, and which do, in the order of the cases.
std::vector<std::pair<std::string, std::vector<std::string>>> faults_of(
    const RendererResult& result) {
  std::vector<std::pair<std::string, std::vector<std::string>>> faults;
  for (const CaseResult& c : result.cases) {
    if (is_right_to_two_steps(c.verdict)) continue;
    const std::string text = fmt::format("{}: {}", c.verdict.fault, c.verdict.explanation);
    auto at = std::ranges::find(faults, text, [](const auto& fault) { return fault.first; });
    if (at == faults.end()) at = faults.insert(at, {text, {}});
    at->second.push_back(c.name);
  }
  return faults;
}

std::string fault_lists(const std::vector<const RendererResult*>& drew) {
  std::string lists;
  for (const RendererResult* result : drew) {
    lists += fmt::format("<h3>{}</h3>\n", html_escaped(result->renderer.name));
    const auto faults = faults_of(*result);
    if (faults.empty()) lists += "<p>Every picture is right to what it holds.</p>\n";
    for (const auto& [fault, cases] : faults)
      lists += fmt::format("<p><b>{}</b> {}</p>\n", html_escaped(fault),
                           html_escaped(fmt::format("{}", fmt::join(cases, ", "))));
  }
  return lists;
}

std::string page_of(const RenderersHead& head, Results results) {
  const auto drew = that_drew(results);
  return filled(renderers_files::renderers_html(),
                {{"title", html_escaped(head.title)},
                 {"tolerance", fmt::format("{:g}", head.tolerance)},
                 {"css", std::string(renderers_files::renderers_css())},
                 {"summary", summary_rows(results)},
                 {"renderers", head_cells(drew)},
                 {"cases", case_rows(drew)},
                 {"faults", fault_lists(drew)}});
}

std::string markdown_of(const std::string& title, Results results) {
  const auto drew = that_drew(results);
  std::vector<std::string> titles{"case"};
  for (const RendererResult* result : drew) titles.push_back(result->renderer.name);
  std::string text = markdown_heading("#", title) + '\n' + markdown_head(titles, titles.size());
  const std::size_t cases = drew.empty() ? 0 : drew.front()->cases.size();
  for (std::size_t i = 0; i < cases; ++i) {
    std::vector<std::string> cells{drew.front()->cases[i].name};
    for (const RendererResult* result : drew) cells.push_back(text_of(result->cases[i].verdict));
    text += markdown_cells(cells);
  }
  for (const RendererResult& result : results)
    if (const std::string why = result.nothing_drawn(); !why.empty())
      text += fmt::format("\n{} drew nothing: {}\n", markdown_escaped(result.renderer.name),
                          markdown_escaped(why));
  return text;
}

}  // namespace

nlohmann::ordered_json renderers_json(const RenderersHead& head, Results results) {
  nlohmann::ordered_json renderers = nlohmann::ordered_json::array();
  for (const RendererResult& result : results) {
    nlohmann::ordered_json one{{"name", result.renderer.name}};
    if (const std::string why = result.nothing_drawn(); !why.empty()) one["drew_nothing"] = why;
    one.update(json_of(result.cases));
    renderers.push_back(std::move(one));
  }
  return {{"format", "pellucid-conformance-results"},
          {"version", 1},
          {"title", head.title},
          {"judged", "rgb"},
          {"tolerance", head.tolerance},
          {"renderers", std::move(renderers)}};
}

void write_renderers_report(const fs::path& folder, const RenderersHead& head, Results results) {
  write_text(folder / "report.html", page_of(head, results));
  write_text(folder / "table.md", markdown_of(head.title, results));
  write_text(folder / "results.json", json_text(renderers_json(head, results)) + '\n');
}

}  // namespace pellucid::compare
