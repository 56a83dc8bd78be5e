// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/readers/file_field.h"

namespace pellucid::fields {

// Each is defined where its formats are read.
std::vector<FileFormatRow> vtk_formats();
std::vector<FileFormatRow> meta_image_formats();
std::vector<FileFormatRow> vdb_formats();
std::vector<FileFormatRow> series_formats();
std::vector<FileFormatRow> pvd_formats();

std::span<const FileFormatRow> field_formats() {
  static const std::vector<FileFormatRow> rows = [] {
    std::vector<FileFormatRow> all;
    for (const auto& formats :
         {vtk_formats(), meta_image_formats(), vdb_formats(), series_formats(), pvd_formats()})
      all.insert(all.end(), formats.begin(), formats.end());
    return all;
  }();
  return rows;
}

}  // namespace pellucid::fields
