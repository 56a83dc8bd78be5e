// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/readers/file_field.h"

#include <fmt/format.h>

#include <new>
#include <stdexcept>

#include "core/error.h"
#include "core/files/files_read.h"
#include "core/files/output_file.h"

namespace pellucid::fields {
namespace {

struct PathAndOptions {
  std::string_view path;
  std::string_view options;  // with the colon
  const FileFormatRow* format = nullptr;
};

/// The options begin at the first colon behind a known ending, so that a path may hold colons.
PathAndOptions split(std::string_view text) {
  PathAndOptions best{text, {}};
  for (const FileFormatRow& row : field_formats())
    for (std::size_t at = text.find(row.ending); at != std::string_view::npos;
         at = text.find(row.ending, at + 1)) {
      const std::size_t end = at + row.ending.size();
      const bool ends_here = end == text.size() || text[end] == ':';
      if (ends_here && (!best.format || end < best.path.size()))
        best = {text.substr(0, end), text.substr(end), &row};
    }
  return best;
}

FileOptions parse_options(const PathAndOptions& parts) {
  const auto given = parse_name_and_options(fmt::format("file{}", parts.options));
  return file_options().read(Parameters(parts.path, file_options().specs(), given.options));
}

}  // namespace

const OptionTable<FileOptions>& file_options() {
  static const OptionTable<FileOptions> table{
      text("array", &FileOptions::array,
           "name of the vectors; by default the active or the only ones"),
      choice("sampler", &FileOptions::interpolation,
             {{"linear", Interpolation::linear}, {"c1", Interpolation::c1}},
             "c1: cubic, continuous with its derivative")};
  return table;
}

std::string file_endings() {
  std::string endings;
  for (const FileFormatRow& row : field_formats())
    endings += (endings.empty() ? "" : ", ") + std::string(row.ending);
  return endings;
}

const FileFormatRow* file_format(std::string_view path) {
  for (const FileFormatRow& row : field_formats())
    if (path.ends_with(row.ending)) return &row;
  return nullptr;
}

std::unique_ptr<VectorField> read_file(const std::filesystem::path& path,
                                       const FileFormatRow& format, const FileOptions& options) {
  require_file(path);
  note_read(path);
  try {
    return format.read(path, options);
  } catch (const std::bad_alloc&) {
    throw InputError(
        fmt::format("{}: claims more data than this machine's memory holds", path.string()));
  } catch (const std::length_error&) {
    throw InputError(fmt::format("{}: claims more data than can be", path.string()));
  }
}

std::unique_ptr<VectorField> read_file_field(std::string_view text,
                                             const std::filesystem::path& base) {
  const PathAndOptions parts = split(text);
  if (!parts.format) return nullptr;
  return read_file(base / parts.path, *parts.format, parse_options(parts));
}

}  // namespace pellucid::fields
