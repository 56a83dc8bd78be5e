// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "compare/methods/methods.h"
#include "compare/pictures/metrics.h"
#include "compare/study/study.h"
#include "core/options/names.h"
#include "fields/analytic/catalogue.h"
#include "integrators/lines/integrate_lines.h"
#include "integrators/surfaces/integrate_surface.h"
#include "scene/datasets/dataset.h"

namespace pellucid::app {
namespace {

nlohmann::ordered_json to_json(std::span<const ParameterSpec> parameters) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const ParameterSpec& spec : parameters)
    rows.push_back({{"name", spec.name},
                    {"default", spec.default_value},
                    {"accepted", spec.accepted()},
                    {"unit", spec.unit},
                    {"help", spec.help}});
  return rows;
}

nlohmann::ordered_json list_methods() {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const scene::MethodRow& row : compare::methods())
    rows.push_back({{"name", row.name},
                    {"title", row.title},
                    {"citation", row.citation},
                    {"equations", row.equations},
                    {"bytes per pixel", row.bytes_per_pixel},
                    {"sweep", row.sweep},
                    {"exact", row.promises.exact},
                    {"exact without isosurfaces", row.promises.exact_without_isosurfaces},
                    {"exact without importance", row.promises.exact_without_importance},
                    {"exact unless set", row.promises.exact_unless},
                    {"exact with", row.promises.exact_with},
                    {"exact up to", row.promises.exact_layers},
                    {"order-independent", row.promises.order_independent},
                    {"order spread", row.promises.order_spread},
                    {"convex hull", row.promises.convex_hull},
                    {"fixed memory", row.promises.fixed_memory},
                    {"draws isosurfaces", row.promises.draws_isosurfaces},
                    {"optimizes opacity", row.promises.optimizes_opacity},
                    {"random", row.promises.random},
                    {"one layer unless", row.promises.one_layer_unless},
                    {"edge shift [pixels]", row.promises.edge_shift},
                    {"parameters", to_json(row.parameters)}});
  return rows;
}

nlohmann::ordered_json list_integrators() {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const integrators::IntegratorRow& row : integrators::integrators())
    rows.push_back({{"name", row.name},
                    {"title", row.title},
                    {"citation", row.citation},
                    {"parameters", to_json(row.parameters)}});
  for (const integrators::LineIntegratorRow& row : integrators::line_integrators())
    rows.push_back({{"name", row.name},
                    {"title", row.title},
                    {"citation", row.citation},
                    {"parameters", to_json(row.parameters)}});
  return rows;
}

nlohmann::ordered_json list_fields() {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const fields::FieldRow& row : fields::analytic_fields())
    rows.push_back({{"name", row.name},
                    {"title", row.title},
                    {"citation", row.citation},
                    {"formula", row.formula},
                    {"steady", row.steady},
                    {"parameters", to_json(row.parameters)}});
  return rows;
}

nlohmann::ordered_json list_datasets() {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const scene::DatasetRow& row : scene::datasets())
    rows.push_back({{"name", row.name},
                    {"title", row.title},
                    {"citation", row.citation},
                    {"scene key", row.on_levels ? "isosurface.dataset" : "dataset"},
                    {"parameters", to_json(row.parameters)}});
  return rows;
}

nlohmann::ordered_json list_metrics() {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const compare::MetricRow& row : compare::metrics())
    rows.push_back({{"name", row.name},
                    {"title", row.title},
                    {"definition", row.definition},
                    {"citation", row.citation},
                    {"unit", row.unit}});
  return rows;
}

nlohmann::ordered_json list_all_studies() {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const compare::StudySummary& study : compare::list_studies())
    rows.push_back({{"name", study.name}, {"title", study.title}, {"source", study.source}});
  return rows;
}

struct Listing {
  std::string_view name;
  nlohmann::ordered_json (*make)();
};

constexpr Listing listings[] = {{"methods", list_methods}, {"integrators", list_integrators},
                                {"fields", list_fields},   {"datasets", list_datasets},
                                {"metrics", list_metrics}, {"studies", list_all_studies}};

std::string text_of(const nlohmann::ordered_json& value) {
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

void print_parameter(const nlohmann::ordered_json& parameter) {
  std::string line = "      " + text_of(parameter["name"]);
  if (!text_of(parameter["default"]).empty()) line += "=" + text_of(parameter["default"]);
  line += fmt::format("   [{}]", text_of(parameter["accepted"]));
  if (!text_of(parameter["unit"]).empty()) line += "  " + text_of(parameter["unit"]);
  std::cout << line << "   " << text_of(parameter["help"]) << '\n';
}

void print(const nlohmann::ordered_json& rows) {
  for (const nlohmann::ordered_json& row : rows) {
    std::cout << text_of(row["name"]) << "   " << text_of(row["title"]) << '\n';
    for (const auto& [key, value] : row.items())
      if (key != "name" && key != "title" && key != "parameters" && !text_of(value).empty())
        std::cout << "   " << key << ": " << text_of(value) << '\n';
    if (row.contains("parameters") && !row["parameters"].empty()) {
      std::cout << "   parameters:\n";
      for (const nlohmann::ordered_json& parameter : row["parameters"]) print_parameter(parameter);
    }
    std::cout << '\n';
  }
}

/// The columns that are short enough for a table: name, title, citation.
void print_markdown(const nlohmann::ordered_json& rows) {
  std::cout << "| name | what it is | source |\n|---|---|---|\n";
  for (const nlohmann::ordered_json& row : rows)
    std::cout << fmt::format("| `{}` | {} | {} |\n", text_of(row["name"]), text_of(row["title"]),
                             text_of(row.contains("citation") ? row["citation"] : row["source"]));
}

}  // namespace

void add_list_command(CLI::App& app, GlobalOptions& globals) {
  std::string names;
  for (const Listing& listing : listings)
    names += (names.empty() ? "" : ", ") + std::string(listing.name);
  CLI::App* command = app.add_subcommand("list", "List " + names);
  const auto what = std::make_shared<std::string>();
  command->add_option("WHAT", *what, names)->required();
  const auto markdown = std::make_shared<bool>(false);
  command->add_flag("--markdown", *markdown, "Print a Markdown table of names and sources");
  add_global_options(*command, globals);
  command->callback([what, markdown, &globals] {
    const nlohmann::ordered_json rows = find_row("listing", *what, listings).make();
    if (globals.json)
      std::cout << rows.dump(2) << '\n';
    else if (*markdown)
      print_markdown(rows);
    else
      print(rows);
  });
}

}  // namespace pellucid::app
