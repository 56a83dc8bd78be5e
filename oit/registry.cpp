// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/registry.h"

#include <array>

#include "oit/methods/bin_average/bin_average.h"
#include "oit/methods/binning/binning.h"
#include "oit/methods/fourier/fourier.h"
#include "oit/methods/fourier/fourier_opacity.h"
#include "oit/methods/k_buffer/k_buffer.h"
#include "oit/methods/lists/decoupled_lists.h"
#include "oit/methods/lists/linked_list.h"
#include "oit/methods/mlab/mlab.h"
#include "oit/methods/moment/moment.h"
#include "oit/methods/peeling/depth_peeling.h"
#include "oit/methods/peeling/dual_depth_peeling.h"
#include "oit/methods/stochastic/stochastic.h"
#include "oit/methods/tree/tree.h"
#include "oit/methods/weighted/weighted_average.h"
#include "oit/methods/weighted/weighted_blended.h"
#include "oit/methods/weighted/weighted_sum.h"

namespace pellucid::oit {

std::span<const scene::MethodRow> oit_methods() {
  static const std::array rows = {linked_list_method(),
                                  depth_peeling_method(),
                                  dual_depth_peeling_method(),
                                  weighted_sum_method(),
                                  weighted_average_method(),
                                  weighted_blended_method(),
                                  binning_method(),
                                  bin_average_method(),
                                  fourier_method(),
                                  fourier_opacity_method(),
                                  decoupled_lists_method(),
                                  moment_method(),
                                  k_buffer_method(),
                                  mlab_method(),
                                  stochastic_method(),
                                  tree_method()};
  return rows;
}

}  // namespace pellucid::oit
