// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "scene/renderer.h"

namespace pellucid::compare {

/// Returns the surface integrators as methods: a scene's integrated surface is swept again by
/// another integrator and ray-traced, so that studies compare integrators as they compare
/// everything else. There is one row for each of integrators(), with its parameters. A scene has to
/// have exactly one object that was integrated; its other objects stay as they are.
std::span<const scene::MethodRow> surface_methods();

}  // namespace pellucid::compare
