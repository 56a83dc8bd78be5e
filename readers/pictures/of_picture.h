// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <filesystem>

#include "core/error.h"
#include "core/files/blocks.h"

namespace pellucid::readers {

/// Runs `read`, and says what blocks say wrongly of the picture that they are of: throws InputError
/// for a BlockError.
template <class Read>
auto of_picture(const std::filesystem::path& path, const Read& read) {
  try {
    return read();
  } catch (const BlockError& error) {
    throw InputError(fmt::format("{}: cannot read the picture: {}", path.string(), error.what()));
  }
}

}  // namespace pellucid::readers
