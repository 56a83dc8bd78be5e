// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which channels a deep picture of Pellucid's has in OpenEXR, for who writes and who parses it. R,
// G, B, A and Z are what other programs look for, in 32-bit float. OpenEXR has no doubles: of those
// that an exact composite takes, the bits are in two channels of 32-bit integers each.

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace pellucid::readers {

/// The attribute of the header that says, as a text, what the picture is of.
constexpr const char* deep_attribute = "pellucid";

/// The doubles: view depth (world units), the straight colour, the opacity.
constexpr std::array<std::string_view, 5> deep_doubles{"exact.depth", "exact.red", "exact.green",
                                                       "exact.blue", "exact.alpha"};
/// What follows a double's name in that of the channel of its upper and of its lower half.
constexpr std::array<std::string_view, 2> deep_halves{".high", ".low"};

/// Returns the name of the channel of one half, 0 (upper) or 1, of a double.
inline std::string deep_channel(std::size_t number, std::size_t half) {
  return std::string(deep_doubles[number]).append(deep_halves[half]);
}

/// Returns one half, 0 (upper) or 1, of a double's bits.
inline std::uint32_t half_of(double value, std::size_t half) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return std::uint32_t(half == 0 ? bits >> 32 : bits);
}

/// Returns the double of two such halves.
inline double double_of(std::uint32_t high, std::uint32_t low) {
  return std::bit_cast<double>(std::uint64_t(high) << 32 | low);
}

/// Returns where OpenEXR, which counts rows from the picture's top, has to start so that it finds
/// row `first` at `data`; `row` is the size of a row in bytes.
template <class T>
char* before_row(T* data, int first, std::size_t row) {
  return reinterpret_cast<char*>(reinterpret_cast<std::uintptr_t>(data) -
                                 std::uintptr_t(first) * row);
}

}  // namespace pellucid::readers
