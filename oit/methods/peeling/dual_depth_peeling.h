// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/options/option_table.h"
#include "scene/renderer.h"

namespace pellucid::oit {

/// DualDepthPeelingOptions are those of the method `dual-depth-peeling`.
struct DualDepthPeelingOptions {
  std::optional<int> peels;  // most passes, at least 1, two layers each; not set: all layers

  bool operator==(const DualDepthPeelingOptions&) const = default;
};
/// Returns the table of DualDepthPeelingOptions.
const OptionTable<DualDepthPeelingOptions>& dual_depth_peeling_options();

/// Dual depth peeling (Bavoil and Myers 2008, "Order independent transparency with dual depth
/// peeling", NVIDIA): each pass over the scene peels the nearest and the farthest layer that are
/// left; the first are composited from front to back, the others from back to front.
///
/// What differs from the paper: its maximum blending compares depths alone and so takes coincident
/// fragments for one. Here a fragment's key is its depth and its place in the order of submission,
/// 64 bits that no blending compares; a fragment that is nearer or farther than those found writes
/// its key and colour itself, one at a time by a lock per pixel. Since key and colour are found
/// together, the colours need no pass of their own.
///
/// `peels` is a budget of passes, two layers each; what it leaves lies in the middle and is counted
/// as dropped.
///
/// Accuracy: without a budget the exact composite up to coverage and float rounding.
const scene::MethodRow& dual_depth_peeling_method();

}  // namespace pellucid::oit
