// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/files/blocks.h"

namespace pellucid::readers {

/// Reads the particles of a snapshot by HDF5, in a process of its own; see parse_snapshot().
Blocks read_snapshot_blocks(const std::filesystem::path& path);

}  // namespace pellucid::readers
