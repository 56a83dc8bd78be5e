// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/gl/gl_context.h"

namespace pellucid::oit {

/// Draws one pixel by each of the means that the methods rely on beyond plain OpenGL: blending into
/// float targets, atomics and stores into images and buffers. Throws WorkError that names what the
/// driver lacks or gets wrong.
void check_driver(const GlContext& context);

}  // namespace pellucid::oit
