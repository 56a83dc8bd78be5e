// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/simulations/netcdf_choice.h"

#include <fmt/format.h>

#include <utility>

#include "core/error.h"
#include "core/options/split.h"

namespace pellucid::readers {
namespace {

const NetcdfChoice* find(const std::vector<NetcdfChoice>& choices, std::string_view name) {
  for (const std::string_view prefix : {"point:", "cell:"})
    if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
  const auto found = std::ranges::find(choices, name, &NetcdfChoice::name);
  return found == choices.end() ? nullptr : &*found;
}

void refuse_unread(const NetcdfChoice& choice, const std::string& file) {
  if (!choice.unread.empty())
    throw InputError(fmt::format("{}: '{}' {}", file, choice.name, choice.unread));
}

/// The dimensions of those that are wanted, which have to be the same; "" where there are none.
std::string wanted_dimensions(const std::vector<NetcdfChoice>& choices, const std::string& wanted,
                              const std::string& file) {
  const auto find_loaded = [&](std::string_view name) {
    const NetcdfChoice* one = find(choices, name);
    if (one) refuse_unread(*one, file);
    return one;
  };
  if (const NetcdfChoice* whole = find_loaded(wanted)) return whole->dimensions;
  const NetcdfChoice* first = nullptr;
  for (const std::string_view name : split(wanted, ',')) {
    const NetcdfChoice* one = find_loaded(name);
    if (!first) first = one;
    if (one && one->dimensions != first->dimensions)
      throw InputError(
          fmt::format("{}: array={}: '{}' has the dimensions {} and '{}' {}; accepted: "
                      "variables of the same",
                      file, wanted, first->name, first->dimensions, one->name, one->dimensions));
  }
  return first ? first->dimensions : std::string();
}

/// Those of three axes before those of two, of several the ones of the most variables.
std::string usual_dimensions(const std::vector<NetcdfChoice>& choices) {
  constexpr std::ptrdiff_t most_axes = 3;
  std::pair<std::ptrdiff_t, std::ptrdiff_t> best{0, 0};
  std::string dimensions;
  for (const NetcdfChoice& choice : choices) {
    if (!choice.is_grid()) continue;
    const std::pair rank{choice.axes() <= most_axes ? choice.axes() : 0,
                         std::ranges::count(choices, choice.dimensions, &NetcdfChoice::dimensions)};
    if (rank > best) best = rank, dimensions = choice.dimensions;
  }
  return dimensions;
}

}  // namespace

std::string chosen_dimensions(const std::vector<NetcdfChoice>& choices, const std::string& wanted,
                              const std::string& file) {
  std::string dimensions = wanted_dimensions(choices, wanted, file);
  if (dimensions.empty()) dimensions = usual_dimensions(choices);
  if (dimensions.empty())
    for (const NetcdfChoice& choice : choices) refuse_unread(choice, file);
  return dimensions;
}

}  // namespace pellucid::readers
