// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/options/option_table.h"
#include "scene/renderer.h"

namespace pellucid::oit {

/// KBufferOptions are those of the method `k-buffer`.
struct KBufferOptions {
  int layers = 8;  // kept apart, 1 to 64 (k)

  bool operator==(const KBufferOptions&) const = default;
};
/// Returns the table of KBufferOptions.
const OptionTable<KBufferOptions>& k_buffer_options();

/// k-buffer with a tail: hybrid transparency (Maule, Comba, Torchelsen and Bastos 2013, I3D). The
/// `layers` nearest fragments of a pixel are sorted and composited exactly; those behind them are
/// one layer of their weighted average colour and of their exact opacity.
///
/// What differs from the paper: no fragment shader interlock is needed. A first pass keeps the
/// nearest depths by a cascade of atomic minima; in a second pass a fragment that finds its depth
/// there claims the place for its colour by compare-and-swap, and any other goes to the tail.
/// Coincident fragments each claim a place of their own.
///
/// Accuracy: exact where a pixel has at most `layers` layers; behind them only the order is lost.
const scene::MethodRow& k_buffer_method();

}  // namespace pellucid::oit
