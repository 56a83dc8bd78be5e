// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/options/option_table.h"
#include "fields/field.h"
#include "fields/sampled/dense_field.h"

namespace pellucid::fields {

/// FileOptions are what may be asked of a sampled field: "FILE:array=NAME,sampler=c1".
struct FileOptions {
  std::string array;  // empty: the active vectors, or the only array of three components
  Interpolation interpolation = Interpolation::linear;
};

/// Returns the table of what may stand behind a file's name.
const OptionTable<FileOptions>& file_options();

/// One kind of file that holds a sampled field.
struct FileFormatRow {
  std::string_view ending;  // ".vti"
  std::string_view title;
  std::unique_ptr<VectorField> (*read)(const std::filesystem::path&, const FileOptions&);
};

/// Returns all formats of sampled fields; field_formats.cpp lists them.
std::span<const FileFormatRow> field_formats();

/// ".vti, .vtr, …", for messages.
std::string file_endings();

/// The format that a path ends as, or nothing.
const FileFormatRow* file_format(std::string_view path);

/// Throws InputError for a file that cannot be read or trusted.
std::unique_ptr<VectorField> read_file(const std::filesystem::path& path,
                                       const FileFormatRow& format, const FileOptions& options);

/// Reads "FILE[:key=value,…]" (relative paths start at `base`) when FILE ends as one of the formats
/// does; nothing when it does not.
std::unique_ptr<VectorField> read_file_field(std::string_view text,
                                             const std::filesystem::path& base);

}  // namespace pellucid::fields
