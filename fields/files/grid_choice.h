// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace pellucid::fields {

/// A GridEntry is what a file of several grids says of one of them.
struct GridEntry {
  std::string name;     // several grids may have one name
  std::string type;     // as the file names it, for messages
  bool vector = false;  // three numbers a sample
};

/// Returns the index of the vector grid of that name, or of the only one when `wanted` is empty. Of
/// several grids of one name NAME is the first, and NAME[I] the one of number I, from 0. Throws
/// InputError, after `file`, with the names of all grids.
std::size_t choose_vector_grid(std::span<const GridEntry> grids, std::string_view wanted,
                               const std::string& file);

/// Returns the indices of three other grids, "A,B,C", each named as above, or nothing where
/// `wanted` names no such three.
std::optional<std::array<std::size_t, 3>> choose_components(std::span<const GridEntry> grids,
                                                            std::string_view wanted);

/// Returns the name of the vector grids that are the velocity: `wanted`, or the only name there is,
/// or the only one that is usual for a velocity (velocity, vel, v, u; in any case of letters).
/// Throws InputError, after `file`, with the names of all grids.
std::string choose_velocity(std::span<const GridEntry> grids, std::string_view wanted,
                            const std::string& file);

/// Returns "NAME (TYPE), …", with [I] behind the names that several grids have; "none" of none.
std::string describe_grids(std::span<const GridEntry> grids);

}  // namespace pellucid::fields
