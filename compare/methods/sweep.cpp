// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/methods/sweep.h"

#include <algorithm>

#include "core/options/split.h"

namespace pellucid::compare {

std::vector<RawOptions> crossed(const std::vector<RawOptions>& sets, const std::string& key,
                                const std::vector<std::string>& values) {
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
  for (const std::string_view part : split(row.sweep, ',')) {
    const std::size_t equals = part.find('=');
    if (equals == part.npos) continue;  // a row without a sweep
    const auto values = split(part.substr(equals + 1), '|');
    sets = crossed(sets, std::string(part.substr(0, equals)), {values.begin(), values.end()});
  }
  std::vector<MethodCall> calls;
  for (const RawOptions& options : sets)
    calls.push_back({&row, Parameters(row.name, row.parameters, options)});
  return calls;
}

bool needs_file(const scene::MethodRow& row) {
  return std::ranges::find(row.parameters, ParameterSpec::Kind::file, &ParameterSpec::kind) !=
         row.parameters.end();
}

std::vector<MethodCall> every_method(std::span<const scene::MethodRow> table) {
  std::vector<MethodCall> calls;
  for (const scene::MethodRow& row : table)
    if (!row.promises.optimizes_opacity && !needs_file(row))
      for (MethodCall& call : sweep_of(row)) calls.push_back(std::move(call));
  return calls;
}

}  // namespace pellucid::compare
