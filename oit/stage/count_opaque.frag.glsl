// SPDX-License-Identifier: GPL-3.0-or-later
// The opaque fragment that ends a pixel's layers is one of them.
#include "oit/stage/composite.glsl"

void main() { picture = vec4(behind().a); }
