// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/options/option_table.h"
#include "scene/renderer.h"

namespace pellucid::oit {

/// ColorFilterOptions are those of the method color-filter.
struct ColorFilterOptions {
  double strength = 1;  // of each layer's colour as a filter, in [0, 1]

  bool operator==(const ColorFilterOptions&) const = default;
};
const OptionTable<ColorFilterOptions>& color_filter_options();

/// Layers as filters of the light that the background sends, as panes of stained glass: they absorb
/// and send out nothing. No paper; a toy that shows what a method is made of.
///
///   C = C_bg Π (1 - s α_i (1 - C_i)),  A = 1 - Π (1 - α_i)
///
/// Accuracy: products commute, so that the order of fragments changes roundings alone. It is not
/// the exact composite, not even of one layer.
const scene::MethodRow& color_filter_method();

}  // namespace pellucid::oit
