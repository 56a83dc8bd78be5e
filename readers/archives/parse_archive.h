// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/files/blocks.h"

namespace pellucid::readers {

/// Unpacks a .zip file and writes the bytes of each of its files as a block of the file's name; of
/// the folders nothing. Throws InputError that names `path` for what is no such file, is encrypted
/// or ends early.
void parse_archive(const std::filesystem::path& path, BlockWriter& out);

}  // namespace pellucid::readers
