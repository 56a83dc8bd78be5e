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
#include "fields/files/periods.h"
#include "fields/files/vector_array.h"
#include "fields/sampled/dense_field.h"

namespace pellucid::fields {

/// FileOptions are what may be asked of a sampled field: "FILE:array=NAME,sampler=c1".
struct FileOptions {
  std::string array;  // as pick_vectors() takes it; empty: the active vectors or the only ones
  Interpolation interpolation = Interpolation::linear;
  CellValues cells = CellValues::averaged;
  std::string periodic;                    // as parse_periods() takes it
  std::string block;                       // as readers::chosen_blocks() takes it; empty: all
  std::string time;                        // as chosen_time() takes it; empty: all
  bool average_faces = false;              // of staggered grids; they are refused otherwise
  Quantity quantity = Quantity::velocity;  // a scalar is the one that `array` names
  /// In a field of several files or times: which vectors the first has when `array` is empty, ""
  /// until it is read. The others have to have the same.
  std::shared_ptr<std::string> common_array{};
  /// The same of periods that samples tell.
  std::shared_ptr<ToldPeriods> told_periods{};
};

/// Returns options for each of several files or times: what the first takes by default all take.
FileOptions in_common(FileOptions options);
/// Returns what is asked for of periods. Throws InputError that names `file`.
Periods periods_of(const FileOptions& options, const std::string& file);
/// Returns the array that is asked for, or was taken before; "" for the default.
const std::string& wanted_array(const FileOptions& options);
/// Keeps the name of the vectors that were taken for those that follow; "" where they have none.
void keep_array(const FileOptions& options, const std::string& name);

/// Returns the table of what may stand behind a file's name.
const OptionTable<FileOptions>& file_options();

/// One kind of file that holds a sampled field.
struct FileFormatRow {
  std::string_view ending;  // ".vti"
  std::string_view title;
  std::unique_ptr<VectorField> (*read)(const std::filesystem::path&, const FileOptions&);
  std::string_view traps = {};  // what to know of it, for the documents
};

/// Returns all formats of sampled fields; field_formats.cpp lists them.
std::span<const FileFormatRow> field_formats();

/// ".vti, .vtr, …", for messages.
std::string file_endings();

/// The format that a path ends as, or nothing.
const FileFormatRow* file_format(std::string_view path);

/// Throws InputError where options ask for what only grids along axes have: cells=constant,
/// periodic=….
void refuse_grid_options(const FileOptions& options, const std::filesystem::path& path);

/// Throws InputError for a file that cannot be read or trusted.
std::unique_ptr<VectorField> read_file(const std::filesystem::path& path,
                                       const FileFormatRow& format, const FileOptions& options);

/// Returns whether `text` is "FILE[:key=value,…]" and FILE ends as one of the formats does.
bool names_file(std::string_view text);

/// Reads "FILE[:key=value,…]" (relative paths start at `base`) when names_file(); nothing when not.
std::unique_ptr<VectorField> read_file_field(std::string_view text,
                                             const std::filesystem::path& base);

/// Reads a scalar of the same files, on the same samples: it is the first component of what the
/// field's samplers give, which is no velocity. `name` is one array's (or grid's), or "point:NAME",
/// "cell:NAME". Throws InputError for what is no file, and where there is no such scalar.
std::unique_ptr<VectorField> read_file_scalar(std::string_view text,
                                              const std::filesystem::path& base,
                                              const std::string& name);

}  // namespace pellucid::fields
