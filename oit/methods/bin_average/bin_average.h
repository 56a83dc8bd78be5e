// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/options/option_table.h"
#include "scene/renderer.h"

namespace pellucid::oit {

/// BinAverageOptions are those of the method `bin-average`.
struct BinAverageOptions {
  int bins = 200;          // equal parts of the depth range
  int bins_per_pass = 25;  // kept at once; what a picture's memory grows with

  bool operator==(const BinAverageOptions&) const = default;
};
/// Returns the table of BinAverageOptions.
const OptionTable<BinAverageOptions>& bin_average_options();

/// Averages of bins (Tian and Guenther, "Progressive Rendering of Transparent Integral Surfaces",
/// additional material, section 2.2 and Fig. 5d, after Bavoil, Callahan, Lefohn, Comba and Silva
/// 2007, "Multi-fragment effects on the GPU using the k-buffer", I3D): the depth range is cut into
/// equal bins, the fragments of each are averaged to one layer, and the layers are composited from
/// front to back. So many samples of one surface are one layer as long as they share a bin.
///
///   C_bin = sum alpha_i C_i / sum alpha_i,  alpha_bin = sum alpha_i / n
///
/// That is the plain mean of premultiplied colours: a fragment of opacity 0 has no colour to give.
/// The paper leaves open which mean it takes.
///
/// 200 bins of 20 bytes are 4 GB of a picture of 1000 x 1000. A pass over the scene keeps some of
/// them, from front to back, and what is composited of them makes room for the next: memory is that
/// of `bins_per_pass`, time grows with the passes, and the picture is that of one pass but for
/// roundings.
///
/// `binning` is another method: its bins hold optical depth, which sums up.
///
/// Accuracy: exact where no bin of a pixel has more than one fragment, and for fragments of one
/// colour and opacity that are samples of one layer within a bin; no bound otherwise. Where a
/// surface crosses from bin to bin within a pixel it counts twice: lines along the bins' edges.
const scene::MethodRow& bin_average_method();

}  // namespace pellucid::oit
