// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/read_calls.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "compare/methods/sweep.h"
#include "core/error.h"
#include "core/files/files_read.h"
#include "core/options/names.h"

namespace pellucid::compare {
namespace {

constexpr std::size_t max_calls = 10000;

/// A parameter's value as it would stand on the command line.
std::string option_text(const JsonNode& node) {
  const nlohmann::json& value = node.value();
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
  if (value.is_number()) return value.dump();
  node.fail(json_text(value) + "; accepted: a number, text, true, false, or an array of these");
}

std::vector<std::string> option_values(const JsonNode& node) {
  if (!node.is_array()) return {option_text(node)};
  std::vector<std::string> values;
  for (const JsonNode& element : node.elements()) values.push_back(option_text(element));
  if (values.empty()) node.fail("[]; accepted: at least one value");
  return values;
}

/// Paths of files start at the catalogue's folder.
void place_files(const scene::MethodRow& row, const std::filesystem::path& folder,
                 Parameters& parameters) {
  for (const ParameterSpec& spec : row.parameters)
    if (spec.kind == ParameterSpec::Kind::file && parameters.is_set(spec.name))
      parameters.place_file(spec.name, without_dots(folder / parameters.text(spec.name)).string());
}

MethodCall make_call(const JsonNode& node, std::string_view name, const RawOptions& options,
                     const Catalogue& catalogue) {
  try {
    const scene::MethodRow& row = find_row(catalogue.kind, name, catalogue.rows);
    Parameters parameters(row.name, row.parameters, options);
    place_files(row, catalogue.folder, parameters);
    return {&row, std::move(parameters)};
  } catch (const InputError& error) {
    node.fail(error.what());
  }
}

std::vector<MethodCall> calls_of_text(const JsonNode& node, const Catalogue& catalogue) {
  NameAndOptions parsed;
  try {
    parsed = parse_name_and_options(node.string());
  } catch (const InputError& error) {
    node.fail(error.what());
  }
  return {make_call(node, parsed.name, parsed.options, catalogue)};
}

/// {"method": "*", "except": [NAME, …]}
std::vector<MethodCall> calls_but(const JsonNode& node, const Catalogue& catalogue) {
  node.accept_keys({catalogue.kind, "except"});
  std::set<std::string_view> except;
  for (const JsonNode& element : node["except"].elements()) {
    const std::string name = element.string();
    except.insert(at_place(element, [&]() -> std::string_view {
      return find_row(catalogue.kind, name, catalogue.rows).name;
    }));
  }
  std::vector<MethodCall> calls = every_method(catalogue.rows);
  std::erase_if(calls, [&](const MethodCall& call) { return except.contains(call.row->name); });
  return calls;
}

std::vector<MethodCall> calls_of_object(const JsonNode& node, const Catalogue& catalogue) {
  if (node[catalogue.kind].string() == "*") return calls_but(node, catalogue);
  std::vector<RawOptions> sets(1);
  for (const auto& item : node.value().items()) {
    if (item.key() == catalogue.kind) continue;
    sets = crossed(sets, item.key(), option_values(node[item.key()]));
    if (sets.size() > max_calls) node.fail(fmt::format("more than {} combinations", max_calls));
  }
  std::vector<MethodCall> calls;
  calls.reserve(sets.size());
  for (const RawOptions& options : sets)
    calls.push_back(make_call(node, node[catalogue.kind].string(), options, catalogue));
  return calls;
}

}  // namespace

std::vector<MethodCall> read_calls(const JsonNode& node, const Catalogue& catalogue) {
  if (node.is_string() && node.string() == "*") return every_method(catalogue.rows);
  if (node.is_string()) return calls_of_text(node, catalogue);
  if (node.is_object()) return calls_of_object(node, catalogue);
  node.fail(
      fmt::format("accepted: \"NAME[:key=value,…]\", \"*\" for every {0} in all its settings, or "
                  "{{\"{0}\": NAME, key: value or [values], …}}",
                  catalogue.kind));
}

MethodCall read_call(const JsonNode& node, const Catalogue& catalogue) {
  std::vector<MethodCall> calls = read_calls(node, catalogue);
  if (calls.size() != 1) node.fail("a sweep; accepted: one method with one set of parameters");
  return calls.front();
}

}  // namespace pellucid::compare
