// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/options/option_table.h"
#include "scene/renderer.h"

namespace pellucid::oit {

/// MlabOptions are those of the method `mlab`.
struct MlabOptions {
  int layers = 4;  // of a pixel, 2 to 64

  bool operator==(const MlabOptions&) const = default;
};
/// Returns the table of MlabOptions.
const OptionTable<MlabOptions>& mlab_options();

/// Multi-layer alpha blending (Salvi and Vaidyanathan 2014, I3D): `layers` layers per pixel in the
/// order of depth. A fragment is inserted where its depth belongs; if that makes one too many, the
/// last two are merged, the farther under the nearer, at the nearer one's depth.
///
/// What differs from the paper: it orders the fragments of a pixel by the hardware (a fragment
/// shader interlock), here a lock per pixel lets one at a time insert. The lock does not order
/// them; llvmpipe, which draws a tile on one thread, keeps the order of submission, and the picture
/// is the same every time. Layers are 32-bit floats. That the merged layer keeps the nearer depth
/// could not be verified against the paper.
///
/// Accuracy: the background's share is exact; exact where a pixel has at most `layers` layers, and
/// for any number that come from front to back. Otherwise no bound but the hull of the colours: a
/// fragment that lies between two merged ones is composited in front of both or behind both. So the
/// picture depends on the order of submission.
const scene::MethodRow& mlab_method();

}  // namespace pellucid::oit
