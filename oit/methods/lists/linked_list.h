// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/stage/oit_renderer.h"

namespace pellucid::oit {

/// Per-pixel linked lists (Yang, Hensley, Gruen and Thibieroz 2010, "Real-time concurrent linked
/// list construction on the GPU", CGF 29(4)): every fragment is stored, sorted and composited.
///
/// Beyond the paper: the fragments are counted first, so that the pool has a place for each of them
/// and none is ever dropped; depth and colour are float, not packed into 8 bits; equal depths are
/// ordered by object, then by triangle; sorting has no limit on the layers of a pixel.
///
/// Accuracy: the exact composite up to coverage and float rounding.
const scene::MethodRow& linked_list_method();

/// The method as the last steps of another one, of fragments with these opacities.
std::unique_ptr<OitMethod> make_linked_list(Stage& stage, const FragmentOpacity& opacity);

}  // namespace pellucid::oit
