// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "fields/field.h"

namespace pellucid::fields {

struct FileOptions;

/// A time series of files, linear in time between them and `outside` before the first and after the
/// last. The description is the JSON that ParaView writes:
///   {"file-series-version": "1.0", "files": [{"name": "a.vti", "time": 0}, …]}
/// with two or more files, times ascending, names relative to the description. The options hold for
/// every file. All files are read at once.
std::unique_ptr<VectorField> read_series_field(const std::filesystem::path& path,
                                               const FileOptions& options);

}  // namespace pellucid::fields
