// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/methods/sweep.h"

#include <sstream>

namespace pellucid::compare {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

}  // namespace

std::vector<RawOptions> crossed(const std::vector<RawOptions>& sets, const std::string& key,
                                std::span<const std::string> values) {
  std::vector<RawOptions> combined;
  for (const RawOptions& set : sets)
    for (const std::string& value : values) {
      combined.push_back(set);
      combined.back()[key] = value;
    }
  return combined;
}

std::vector<MethodCall> sweep_of(const scene::MethodRow& row) {
  std::vector<RawOptions> sets(1);
  for (const std::string& part : split(std::string(row.sweep), ',')) {
    const std::size_t equals = part.find('=');
    sets = crossed(sets, part.substr(0, equals), split(part.substr(equals + 1), '|'));
  }
  std::vector<MethodCall> calls;
  for (const RawOptions& options : sets)
    calls.push_back({&row, Parameters(row.name, row.parameters, options)});
  return calls;
}

std::vector<MethodCall> every_method(std::span<const scene::MethodRow> table) {
  std::vector<MethodCall> calls;
  for (const scene::MethodRow& row : table)
    if (!row.promises.optimizes_opacity)
      for (MethodCall& call : sweep_of(row)) calls.push_back(std::move(call));
  return calls;
}

}  // namespace pellucid::compare
