// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fields/readers/pvd_collection.h"

namespace pellucid::fields {

/// Says whether a file lists others over time, by its ending: .pvd or .series.
bool is_file_list(const std::filesystem::path& path);

/// Returns the files of each time that such a file lists, one at least. Throws InputError, naming
/// `path`, for what is no such list.
Collection listed_files(const std::filesystem::path& path);

}  // namespace pellucid::fields
