// SPDX-License-Identifier: GPL-3.0-or-later
// Counted by the query around this pass.
#include "oit/shapes/fragment.glsl"

void main() { fragment(); }
