// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "fields/field.h"

namespace pellucid::fields {

/// Builds a field from "NAME[:k=v,…]" of the catalogue, "formula:u=…,v=…,w=…", or the path of a
/// sampled field (relative paths start at `base`). Throws InputError that names the field or file,
/// the key and the accepted values.
std::unique_ptr<VectorField> make_field(std::string_view text,
                                        const std::filesystem::path& base = {});

}  // namespace pellucid::fields
