// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/options/parameters.h"
#include "fields/field.h"

namespace pellucid::fields {

/// A field whose components are formulas over x, y, z and t ("u=-y,v=x,w=0.2"), read by muParser:
/// + - * / ^, comparisons, && || ?:, sin cos tan asin acos atan atan2 sinh cosh tanh exp ln log2
/// log10 sqrt cbrt abs sign rint min max, and the constants pi and e. Throws InputError naming the
/// component, the column (from 1) and the reason. Its Jacobian is differenced to fourth order.
std::unique_ptr<VectorField> make_formula_field(const RawOptions& components);

}  // namespace pellucid::fields
