// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// OpenEXR's reader of deep pictures: for the process that pellucid-read-picture is, and no others.

#include <filesystem>

#include "core/files/blocks.h"

namespace pellucid::readers {

/// Parses what a deep picture says of itself and writes it as deep_file.h says. Throws InputError
/// for what is no deep picture of ours, and what OpenEXR does.
void parse_deep_head(const std::filesystem::path& path, BlockWriter& out);

/// Parses the rows first … end - 1 of a deep picture and writes them as deep_file.h says. Throws as
/// parse_deep_head() does, and InputError for rows that it does not have.
void parse_deep_rows(const std::filesystem::path& path, int first, int end, BlockWriter& out);

}  // namespace pellucid::readers
