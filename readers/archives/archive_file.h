// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/files/blocks.h"

namespace pellucid::readers {

/// Returns the files of a .zip file, whatever it ends in: a block of bytes for each, by its name.
/// Throws InputError as parse_archive() does.
Blocks read_archive(const std::filesystem::path& path);

}  // namespace pellucid::readers
