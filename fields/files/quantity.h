// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pellucid::fields {

/// A Quantity says what is sampled: a velocity, which on a plane loses its part across it; or a
/// scalar, which is the first of the three numbers of a sample, the others being 0.
enum class Quantity { velocity, scalar };

}  // namespace pellucid::fields
