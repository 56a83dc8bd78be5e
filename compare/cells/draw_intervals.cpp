// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cells/draw_intervals.h"

#include <vector>

namespace pellucid::compare {

std::map<std::string, Interval> intervals_over_draws(const Image& reference,
                                                     const CellMeasurement& measured,
                                                     const PairRegions& regions) {
  std::map<std::string, Interval> intervals;
  if (measured.draws.empty()) return intervals;
  std::vector<Metrics> of_draws{measured.row.metrics.linear};
  for (const Image& draw : measured.draws)
    of_draws.push_back(compare_pair(PicturePair(reference, draw, regions)).linear);
  for (std::size_t m = 0; m < metrics().size(); ++m) {
    std::vector<double> values;
    for (const Metrics& of_draw : of_draws)
      if (of_draw[m]) values.push_back(*of_draw[m]);
    if (const auto interval = median_interval(values); interval && values.size() == of_draws.size())
      intervals[std::string(metrics()[m].name)] = *interval;
  }
  return intervals;
}

}  // namespace pellucid::compare
