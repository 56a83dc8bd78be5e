// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/info/inspect.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.h"
#include "core/files/ending.h"
#include "core/files/output_file.h"
#include "fields/readers/file_field.h"
#include "fields/readers/file_lists.h"
#include "geometry/files/mesh_formats.h"
#include "readers/vtk/vtk_formats.h"

namespace pellucid::app {
namespace {

constexpr std::string_view picture_endings[] = {".exr",  ".png", ".jpg", ".jpeg", ".tif",
                                                ".tiff", ".hdr", ".bmp", ".tga",  ".webp",
                                                ".ppm",  ".pgm", ".pfm"};

bool is_among(std::string_view ending, std::span<const std::string_view> known) {
  return std::ranges::find(known, ending) != known.end();
}

/// ".ply, .obj, …": all endings but those of pictures, each once.
std::string known_endings() {
  std::vector<std::string_view> all{".json (scenes)"};
  for (const geometry::FormatRow& row : geometry::mesh_formats()) all.push_back(row.ending);
  for (const fields::FileFormatRow& row : fields::field_formats())
    if (!is_among(row.ending, all)) all.push_back(row.ending);
  return fmt::format("{}, and pictures", fmt::join(all, ", "));
}

}  // namespace

FileContents inspect(const std::filesystem::path& path, const Progress& progress) {
  const std::string ending = small_ending(path);
  require_file(path);
  if (ending == ".json") return inspect_scene(path, progress);
  if (readers::vtk_format(path)) return inspect_vtk(path);
  if (ending == ".mhd" || ending == ".mha") return inspect_meta_image(path);
  if (ending == ".vdb") return inspect_vdb(path);
  if (is_among(ending, picture_endings)) return inspect_picture(path);
  if (geometry::mesh_format(path)) return inspect_geometry(path);
  if (fields::is_file_list(path)) return inspect_list(path, progress);
  throw InputError(fmt::format("{}: unknown kind of file '{}'; accepted: {}", path.string(), ending,
                               known_endings()));
}

}  // namespace pellucid::app
