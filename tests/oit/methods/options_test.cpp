// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <set>

#include "oit/lists/list_options.h"
#include "oit/methods/bin_average/bin_average.h"
#include "oit/methods/binning/binning.h"
#include "oit/methods/fourier/fourier_opacity.h"
#include "oit/methods/k_buffer/k_buffer.h"
#include "oit/methods/lists/decoupled_lists.h"
#include "oit/methods/mlab/mlab.h"
#include "oit/methods/moment/moment.h"
#include "oit/methods/peeling/depth_peeling.h"
#include "oit/methods/peeling/dual_depth_peeling.h"
#include "oit/methods/stochastic/stochastic.h"
#include "oit/methods/tree/tree.h"
#include "oit/methods/weighted/weighted_blended.h"
#include "oit/methods/weighted/weighted_sum.h"
#include "oit/registry.h"
#include "tests/support/options.h"

namespace pellucid::oit {
namespace {

TEST(PropertyMethodOptions, EveryOptionOfEveryRowHasAMemberOfItsOwn) {
  std::set<const ParameterSpec*> held;
  const auto hold = [&](const auto& table) {
    expect_members_of_their_own(table);
    held.insert(table.specs().data());
  };
  hold(bin_average_options());
  hold(binning_options());
  hold(decoupled_lists_options());
  hold(depth_peeling_options());
  hold(dual_depth_peeling_options());
  hold(fourier_opacity_options());
  hold(fourier_options());
  hold(k_buffer_options());
  hold(mlab_options());
  hold(list_options());
  hold(moment_options());
  hold(stochastic_options());
  hold(tree_options());
  hold(weighted_blended_options());
  hold(weighted_sum_options());
  for (const scene::MethodRow& row : oit_methods())
    EXPECT_TRUE(row.parameters.empty() || held.contains(row.parameters.data())) << row.name;
}

}  // namespace
}  // namespace pellucid::oit
