// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace pellucid::fields {

/// Lengths that samples told, one per axis.
using ToldPeriods = std::array<std::optional<double>, 3>;

/// Periods say along which axes a grid repeats itself, and after which length, in world units.
struct Periods {
  /// One per axis: none, 0 (the samples tell), or the length.
  std::array<std::optional<double>, 3> along;
  /// False when nothing was said: then an axis that goes once around in degrees is a longitude.
  bool given = false;
  /// Of a field of several times or arrays, which have one grid: what the first told. May be null.
  std::shared_ptr<ToldPeriods> told{};

  bool any() const { return along[0] || along[1] || along[2]; }
  bool are_told_by_samples() const { return along[0] == 0. || along[1] == 0. || along[2] == 0.; }
};

/// Reads "x,y", "x:360" or "none"; "" is nothing said. Throws InputError that names `file`.
Periods parse_periods(std::string_view text, const std::string& file);

}  // namespace pellucid::fields
