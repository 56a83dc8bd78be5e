// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/options/names.h"
#include "oit/registry.h"
#include "tests/support/pictures.h"
#include "tests/support/scenes.h"

namespace pellucid::oit::testing {

using namespace pellucid::testing;

inline const scene::MethodRow& method(std::string_view name) {
  return find_row("method", name, oit_methods());
}

}  // namespace pellucid::oit::testing
