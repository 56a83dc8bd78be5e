// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "compare/results/result_row.h"

namespace pellucid::compare {

/// ViewRows are the rows of one cell from each of a study's views, in order, and become its one
/// row.
class ViewRows {
 public:
  /// With `path` the views follow one another as frames do, and flicker is measured.
  explicit ViewRows(bool path) : path_(path) {}

  /// Takes the row of the next view, and both pictures, of which the error is the difference.
  void add(ResultRow row, const Image& reference, const Image& test);

  /// Returns the row over all views; of one view its own. Metrics, times, intervals' ends, counts
  /// and measures are means over the views, the least and longest time and the number of layers the
  /// least and the most of any, the memory that of the view with the most. Curves, pictures and
  /// explanation are the first view's. Beside them there are
  ///
  /// - the measure `views`, how many there are;
  /// - for each metric that has a better way a measure such as `rmse_worst`, the worst of any view;
  /// - with `path`, `flicker`: the root mean square, over RGB, of the change of the signed error
  /// from
  ///   view to view, as a mean over neighbours. It is what a method changes from frame to frame
  ///   beyond what the exact picture does: 0 for an error that stays;
  /// - curves over the views of the metrics that pictures are captioned with, and of the flicker.
  ResultRow row() const;

 private:
  bool path_;
  std::vector<ResultRow> rows_;
  std::vector<double> flicker_;  // from each view to the next
  Image error_;                  // signed, of the last view
};

}  // namespace pellucid::compare
