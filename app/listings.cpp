// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/listings.h"

#include <fmt/ranges.h>

#include "compare/measures/study_measures.h"
#include "compare/methods/methods.h"
#include "compare/pictures/metrics.h"
#include "compare/results/columns.h"
#include "compare/study/study.h"
#include "core/options/parameters_json.h"
#include "fields/analytic/catalogue.h"
#include "fields/levels/derived_scalar.h"
#include "fields/levels/level_field.h"
#include "fields/readers/file_field.h"
#include "geometry/files/mesh_formats.h"
#include "integrators/lines/integrate_lines.h"
#include "integrators/paths/butcher_tableau.h"
#include "integrators/sheets/integrate_sheet.h"
#include "integrators/surfaces/integrate_surface.h"
#include "oit/gl/egl_devices.h"
#include "scene/appearance/colormap.h"
#include "scene/datasets/dataset.h"

namespace pellucid::app {
namespace {

nlohmann::ordered_json list_methods() {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const scene::MethodRow& row : compare::callable_methods())
    rows.push_back(
        {{"name", row.name},
         {"title", row.title},
         {"citation", row.citation},
         {"equations", row.equations},
         {"checked against", row.checked_against},
         {"bytes per pixel", row.bytes_per_pixel},
         {"sweep", row.sweep},
         {"exact", row.promises.exact},
         {"exact without isosurfaces", row.promises.exact_without_isosurfaces},
         {"exact without importance", row.promises.exact_without_importance},
         {"exact unless set", row.promises.exact_unless},
         {"exact without lines and integrated surfaces", row.promises.exact_without_lines},
         {"exact up to", row.promises.exact_layers},
         {"order-independent", row.promises.order_independent},
         {"order spread", row.promises.order_spread},
         {"convex hull", row.promises.convex_hull},
         {"fixed memory", row.promises.fixed_memory},
         {"parts add up", row.promises.adds_up},
         {"in double", row.promises.in_double},
         {"optimizes opacity", row.promises.optimizes_opacity},
         {"optimizes vertices", row.promises.optimizes_vertices},
         {"random", row.promises.random},
         {"one layer unless", row.promises.one_layer_unless},
         {"edge shift [pixels]", row.promises.edge_shift},
         {"parameters", parameters_json(row.parameters)}});
  return rows;
}

nlohmann::ordered_json list_integrators() {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  const auto add = [&](const auto& table) {
    for (const auto& row : table)
      rows.push_back({{"name", row.name},
                      {"title", row.title},
                      {"citation", row.citation},
                      {"parameters", parameters_json(row.parameters)}});
  };
  add(integrators::integrators());
  add(integrators::sheet_integrators());
  add(integrators::line_integrators());
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
                    {"parameters", parameters_json(row.parameters)}});
  return rows;
}

nlohmann::ordered_json list_datasets() {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const scene::DatasetRow& row : scene::datasets())
    rows.push_back({{"name", row.name},
                    {"title", row.title},
                    {"citation", row.citation},
                    {"scene key", row.on_levels ? "isosurface.dataset" : "dataset"},
                    {"parameters", parameters_json(row.parameters)}});
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

nlohmann::ordered_json list_columns() {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const compare::Column& column : compare::columns())
    rows.push_back({{"name", column.name},
                    {"title", heading(column)},
                    {"unit of the value", column.unit},
                    {"better", compare::name_of(column.better)}});
  return rows;
}

/// The rows of a table whose rows have a name, a title and a citation.
template <class Table>
nlohmann::ordered_json named_rows(const Table& table) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const auto& row : table)
    rows.push_back({{"name", row.name}, {"title", row.title}, {"citation", row.citation}});
  return rows;
}

nlohmann::ordered_json list_steppers() {
  nlohmann::ordered_json rows = named_rows(integrators::steppers());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i]["order"] = integrators::steppers()[i].order;
    rows[i]["adaptive"] = integrators::steppers()[i].adaptive;
  }
  return rows;
}

nlohmann::ordered_json list_scalars() { return named_rows(fields::derived_scalars()); }

nlohmann::ordered_json list_reconstructions() {
  nlohmann::ordered_json rows = named_rows(fields::reconstructions);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i]["continuous"] = fields::reconstructions[i].continuous;
    rows[i]["linear-preserving"] = fields::reconstructions[i].linear_preserving;
  }
  return rows;
}

/// What a format of geometry can be read as and written from: "mesh, lines".
template <class Mesh, class Lines, class Points>
std::string kinds(const geometry::FormatRow& row, Mesh mesh, Lines lines, Points points) {
  std::vector<std::string_view> kinds;
  if (row.*mesh) kinds.emplace_back("mesh");
  if (row.*lines) kinds.emplace_back("lines");
  if (row.*points) kinds.emplace_back("points");
  return fmt::format("{}", fmt::join(kinds, ", "));
}

/// What is to know of a file's geometry, and of its field.
std::string joined(std::string_view a, std::string_view b) {
  return fmt::format("{}{}{}", a, a.empty() || b.empty() ? "" : "; ", b);
}

/// Files of geometry and of fields; some hold either.
nlohmann::ordered_json list_formats() {
  using Row = geometry::FormatRow;
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Row& row : geometry::mesh_formats()) {
    std::string read = kinds(row, &Row::read_mesh, &Row::read_lines, &Row::read_points);
    const fields::FileFormatRow* field = fields::file_format(row.ending);
    if (field) read += ", field";
    rows.push_back(
        {{"name", row.ending},
         {"title", row.title},
         {"read as", read},
         {"written", kinds(row, &Row::write_mesh, &Row::write_lines, &Row::write_points)},
         {"to know", joined(row.traps, field ? field->traps : "")}});
  }
  for (const fields::FileFormatRow& row : fields::field_formats())
    if (!geometry::mesh_format("file" + std::string(row.ending)))
      rows.push_back({{"name", row.ending},
                      {"title", row.title},
                      {"read as", "field"},
                      {"written", ""},
                      {"to know", row.traps}});
  return rows;
}

nlohmann::ordered_json list_colormaps() {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const scene::ColormapRow& row : scene::colormaps())
    rows.push_back({{"name", row.name},
                    {"title", fmt::format("{} colours", row.count)},
                    {"citation", row.citation}});
  return rows;
}

nlohmann::ordered_json list_measures() {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const compare::StudyMeasure& row : compare::study_measures())
    rows.push_back({{"name", row.name}, {"title", row.title}});
  return rows;
}

nlohmann::ordered_json list_all_studies() {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const compare::StudySummary& study : compare::list_studies())
    rows.push_back({{"name", study.name}, {"title", study.title}, {"source", study.source}});
  return rows;
}

nlohmann::ordered_json list_gl() {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  const char* software = oit::has_osmesa() ? "Mesa's llvmpipe, without EGL"
                                           : "Mesa's llvmpipe, by EGL: this system has no OSMesa";
  rows.push_back({{"name", "osmesa"}, {"title", software}, {"software", true}});
  const std::vector<oit::EglDevice> devices = oit::egl_devices();
  for (std::size_t i = 0; i < devices.size(); ++i)
    rows.push_back({{"name", fmt::format("egl:{}", i)},
                    {"title", devices[i].name},
                    {"software", devices[i].software}});
  return rows;
}

constexpr Listing table[] = {{"methods", "method", list_methods},
                             {"integrators", "integrator", list_integrators},
                             {"steppers", "stepper", list_steppers},
                             {"fields", "field", list_fields},
                             {"scalars", "scalar", list_scalars},
                             {"reconstructions", "reconstruction", list_reconstructions},
                             {"datasets", "data set", list_datasets},
                             {"formats", "file format", list_formats},
                             {"colormaps", "colour map", list_colormaps},
                             {"metrics", "metric", list_metrics},
                             {"measures", "measure", list_measures},
                             {"columns", "column", list_columns},
                             {"studies", "study", list_all_studies},
                             {"gl", "place where OpenGL runs", list_gl}};

}  // namespace

std::span<const Listing> listings() { return table; }

}  // namespace pellucid::app
