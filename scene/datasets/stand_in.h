// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the stand-ins share: data sets that take the place of data that were never published.

#include "core/parallel.h"
#include "scene/datasets/dataset.h"
#include "scene/datasets/indexed_random.h"

namespace pellucid::scene {

/// Which values of a quantity are unimportant, and which are important: shares of the vertices that
/// lie below, so that a stand-in has the paper's balance whatever the quantity's unit.
struct ImportantShares {
  double none = 0.5;   // up to here the importance is 0 …
  double full = 0.98;  // … and from here on it is 1; linear in the quantity between
};

/// Keeps `values` (one a vertex) as the scalar `name`, scaled to [0, 1] by `shares`, as the
/// importance, and as colours from blue (0) to red (1).
void set_importance(std::string_view name, std::vector<double> values,
                    const ImportantShares& shares, geometry::Vertices& vertices);

constexpr ParameterSpec count_parameter(std::string_view count, std::string_view unit) {
  return {.name = "count",
          .kind = ParameterSpec::Kind::integer,
          .default_value = count,
          .min = 1,
          .max = 1e8,
          .unit = unit,
          .help = "the same picture in any number"};
}

inline constexpr ParameterSpec seed_parameter = {.name = "seed",
                                                 .kind = ParameterSpec::Kind::integer,
                                                 .default_value = "1",
                                                 .min = 0,
                                                 .max = 1e9,
                                                 .help = "of the random numbers"};

inline std::uint64_t seed_of(const Parameters& values) {
  return std::uint64_t(values.integer("seed"));
}
inline std::size_t count_of(const Parameters& values) {
  return std::size_t(values.integer("count"));
}

/// make(random numbers of element i) for i < n, in parallel; the channels are the caller's.
template <class Make>
auto make_elements(std::size_t n, std::uint64_t seed, const Make& make) {
  std::vector<decltype(make(IndexedRandom(0, 0)))> elements(n);
  parallel_for(std::size_t(0), n,
               [&](std::size_t i) { elements[i] = make(IndexedRandom(seed, i)); });
  return elements;
}

}  // namespace pellucid::scene
