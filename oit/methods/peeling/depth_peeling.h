// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/options/option_table.h"
#include "scene/renderer.h"

namespace pellucid::oit {

/// DepthPeelingOptions are those of the method `depth-peeling`.
struct DepthPeelingOptions {
  std::optional<int> peels;  // most layers, at least 1; not set: all of them

  bool operator==(const DepthPeelingOptions&) const = default;
};
/// Returns the table of DepthPeelingOptions.
const OptionTable<DepthPeelingOptions>& depth_peeling_options();

/// Depth peeling (Everitt 2001, "Interactive order-independent transparency", NVIDIA): the layers
/// of all pixels one after the other, each by passes over the whole scene, composited from front
/// to back.
///
/// Unlike the original, fragments of equal depth are all kept: a peel takes the fragment that
/// follows the last one in the order of depth and, at equal depth, of submission. It takes two
/// depth tests in turn, the first for the depth, the second for the place in the order.
///
/// `peels` is a budget; without it the peeling ends when nothing is left. What a budget leaves is
/// counted as dropped.
///
/// Accuracy: without a budget the exact composite up to coverage and float rounding.
const scene::MethodRow& depth_peeling_method();

}  // namespace pellucid::oit
