// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The units of what a pass binds, from the text that the shaders include.
namespace pellucid::oit::bindings {

#include "oit/gl/bindings.glsl"

}  // namespace pellucid::oit::bindings
