// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pellucid {

/// Returns the known names, the most similar to `name` first (Levenshtein distance to its first 100
/// characters, ties in given order).
std::vector<std::string_view> nearest_first(std::string_view name,
                                            std::span<const std::string_view> known);

/// Returns the message of an InputError: "unknown method 'furier'; known: fourier, raytrace, …".
std::string unknown_name(std::string_view kind, std::string_view name,
                         std::span<const std::string_view> known);

/// Returns the row of `table` whose `.name` is `name`. Throws InputError that lists the known
/// names, the nearest first; `kind` says there what is named ("method").
template <class Table>
const auto& find_row(std::string_view kind, std::string_view name, const Table& table);

}  // namespace pellucid

#include "core/error.h"

namespace pellucid {

template <class Table>
const auto& find_row(std::string_view kind, std::string_view name, const Table& table) {
  for (const auto& row : table)
    if (row.name == name) return row;
  std::vector<std::string_view> known;
  for (const auto& row : table) known.push_back(row.name);
  throw InputError(unknown_name(kind, name, known));
}

}  // namespace pellucid
