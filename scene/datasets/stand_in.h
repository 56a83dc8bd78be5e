// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the stand-ins share: data sets that take the place of data that were never published.

#include "core/indexed_random.h"
#include "core/options/option_table.h"
#include "core/parallel.h"
#include "scene/datasets/dataset.h"

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

/// The table of a stand-in's options: a struct with the members `count`, of elements that its
/// constant `unit` names, and `seed`, of the random numbers.
template <class Options>
const OptionTable<Options>& stand_in_options() {
  static const OptionTable<Options> table{
      number(
          "count", &Options::count,
          {.min = 1, .max = 1e8, .unit = Options::unit, .help = "the same picture in any number"}),
      number("seed", &Options::seed, {.min = 0, .max = 1e9, .help = "of the random numbers"})};
  return table;
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
