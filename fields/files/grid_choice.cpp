// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/files/grid_choice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "core/error.h"
#include "core/options/lower_case.h"
#include "core/options/split.h"

namespace pellucid::fields {
namespace {

constexpr std::array<std::string_view, 4> usual_names{"velocity", "vel", "v", "u"};

bool is_usual(std::string_view name) {
  return std::ranges::find(usual_names, lower_case(name)) != usual_names.end();
}

std::size_t count(std::span<const GridEntry> grids, std::string_view name) {
  return std::size_t(
      std::ranges::count_if(grids, [&](const GridEntry& grid) { return grid.name == name; }));
}

/// NAME, or NAME[I] where several grids have it.
std::string label(std::span<const GridEntry> grids, std::size_t index) {
  const std::string& name = grids[index].name;
  if (count(grids, name) == 1) return name;
  return fmt::format("{}[{}]", name, count(grids.first(index), name));
}

bool is_called(std::span<const GridEntry> grids, std::size_t i, std::string_view wanted) {
  return grids[i].name == wanted || label(grids, i) == wanted;
}

std::vector<std::size_t> vectors(std::span<const GridEntry> grids) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < grids.size(); ++i)
    if (grids[i].vector) found.push_back(i);
  return found;
}

/// "vector grids: a, b; others: c (float)".
std::string what_there_is(std::span<const GridEntry> grids) {
  std::vector<std::string> vector_names;
  std::vector<GridEntry> others;
  for (std::size_t i = 0; i < grids.size(); ++i)
    if (grids[i].vector)
      vector_names.push_back(label(grids, i));
    else
      others.push_back(grids[i]);
  std::string text =
      fmt::format("vector grids: {}",
                  vector_names.empty() ? "none" : fmt::format("{}", fmt::join(vector_names, ", ")));
  if (!others.empty()) text += fmt::format("; others: {}", describe_grids(others));
  if (others.size() >= 3) text += "; array=A,B,C takes three of float or double together";
  return text;
}

}  // namespace

std::string describe_grids(std::span<const GridEntry> grids) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < grids.size(); ++i)
    parts.push_back(fmt::format("{} ({})", label(grids, i), grids[i].type));
  return parts.empty() ? "none" : fmt::format("{}", fmt::join(parts, ", "));
}

std::size_t choose_vector_grid(std::span<const GridEntry> grids, std::string_view wanted,
                               const std::string& file) {
  const std::vector<std::size_t> found = vectors(grids);
  for (const std::size_t i : found)
    if (is_called(grids, i, wanted)) return i;
  if (wanted.empty() && found.size() == 1) return found.front();
  if (wanted.empty())
    throw InputError(fmt::format("{}: which grid? array=NAME; {}", file, what_there_is(grids)));
  throw InputError(
      fmt::format("{}: array={}: no such grid; {}", file, wanted, what_there_is(grids)));
}

std::optional<std::array<std::size_t, 3>> choose_components(std::span<const GridEntry> grids,
                                                            std::string_view wanted) {
  const auto names = split(wanted, ',');
  if (names.size() != 3) return std::nullopt;
  std::array<std::size_t, 3> chosen{};
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t i = 0;
    while (i < grids.size() && (grids[i].vector || !is_called(grids, i, names[k]))) ++i;
    if (i == grids.size()) return std::nullopt;
    chosen[k] = i;
  }
  return chosen;
}

std::string choose_velocity(std::span<const GridEntry> grids, std::string_view wanted,
                            const std::string& file) {
  std::set<std::string> names, usual;
  for (const std::size_t i : vectors(grids)) {
    names.insert(grids[i].name);
    if (is_usual(grids[i].name)) usual.insert(grids[i].name);
  }
  if (!wanted.empty()) {
    if (names.contains(std::string(wanted))) return std::string(wanted);
    throw InputError(
        fmt::format("{}: velocity '{}': no such grid; {}", file, wanted, what_there_is(grids)));
  }
  if (names.size() == 1) return *names.begin();
  if (usual.size() == 1) return *usual.begin();
  throw InputError(fmt::format("{}: which grid is the velocity? Name it by the key velocity; {}",
                               file, what_there_is(grids)));
}

}  // namespace pellucid::fields
