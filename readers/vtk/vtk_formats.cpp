// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/vtk_formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "core/error.h"
#include "core/options/lower_case.h"
#include "readers/vtk/case_files.h"
#include "readers/vtk/xml_tags.h"

namespace pellucid::readers {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view plain = "pellucid-read-vtk", simulation = "pellucid-read-simulation";

constexpr std::string_view pieces = "its pieces are read together";
constexpr std::string_view in_pieces =
    "pieces have the same arrays in one order, and the first cells of a kind in the first piece";
constexpr VtkFormat table[] = {
    {".vti", "VTK image", plain},
    {".vtr", "VTK rectilinear grid", plain},
    {".vts", "VTK structured grid", plain},
    {".vtu", "VTK unstructured grid", plain, Beside::nothing, {}, in_pieces},
    {".vtp", "VTK poly data", plain, Beside::nothing, {}, in_pieces},
    {".vtk", "legacy VTK", plain},
    {".pvti", "VTK image in pieces", plain, Beside::named, {}, pieces},
    {".pvtr", "VTK rectilinear grid in pieces", plain, Beside::named, {}, pieces},
    {".pvts", "VTK structured grid in pieces", plain, Beside::named, {}, pieces},
    {".pvtu", "VTK unstructured grid in pieces", plain, Beside::named, {}, pieces},
    {".pvtp", "VTK poly data in pieces", plain, Beside::named, {}, pieces},
    {".vtm",
     "VTK data in blocks",
     plain,
     Beside::named,
     {},
     "blocks are merged; arrays that one of them lacks are lost; block=NAME chooses"},
    {".vtpd", "VTK partitioned data", plain, Beside::named, {}, "partitions are merged"},
    {".vtpc", "VTK partitioned data in blocks", plain, Beside::named, {}, "as .vtm"},
    {".vtkhdf",
     "VTK HDF",
     simulation,
     Beside::nothing,
     {},
     "images and unstructured grids; VTK 9.1 reads version 1, which knows no times"},
    {".foam",
     "OpenFOAM case",
     simulation,
     Beside::tree,
     {},
     "an empty file in the case's folder; the inner mesh; polyhedra as VTK divides them; cell "
     "data; after reconstructPar: times that only the processors have are refused"},
    {".case",
     "EnSight",
     simulation,
     Beside::folder,
     {},
     "parts are merged; block=PART chooses; structured blocks of Gold, not of EnSight 6"},
    {".encas", "EnSight", simulation, Beside::folder, {}, "as .case"},
    {".ex2",
     "Exodus II",
     simulation,
     Beside::nothing,
     {},
     "element blocks are merged; nodes are moved by vectors named DISP…"},
    {".exo", "Exodus II", simulation, Beside::nothing, {}, "as .ex2"},
    {".e", "Exodus II", simulation, Beside::nothing, {}, "as .ex2"},
    {".cgns",
     "CGNS",
     simulation,
     Beside::nothing,
     {},
     "zones are merged; block=ZONE chooses; Cartesian coordinates alone"},
    {".xyz", "PLOT3D", simulation, Beside::second, ".q",
     "the solution is NAME.q beside it; the velocity is momentum over density"},
    {".p3d", "PLOT3D", simulation, Beside::second, ".q", "as .xyz"},
    {".tec",
     "Tecplot text",
     simulation,
     Beside::nothing,
     {},
     "zones are merged; variables are scalars: array=U,V,W; coordinates are X, Y, Z, "
     "CoordinateX or X [m]; no repeat counts (9*0), no exponents after a D"},
    {".nc",
     "NetCDF, with the CF conventions",
     simulation,
     Beside::nothing,
     {},
     "variables are scalars: array=u,v; those of one set of dimensions are read, whatever their "
     "order but for time, which is the first; times in any order; axes are degrees where the "
     "file's are, depths negative; samples that are missing, filled or not valid are absent"},
    {".cdf", "NetCDF, with the CF conventions", simulation, Beside::nothing, {}, "as .nc"},
    {".nii",
     "NIfTI image",
     simulation,
     Beside::nothing,
     {},
     "scaled by its slope and intercept; one volume; placed by its matrix, sform before qform, in "
     "scanner coordinates (RAS), as .trk and .tck are; vectors are not turned"},
    {".nii.gz", "NIfTI image, compressed", simulation, Beside::nothing, {}, "as .nii"},
    {".nrrd",
     "NRRD image",
     simulation,
     Beside::header,
     {},
     "read by Teem; two or three axes of space, and one of a sample's numbers; anatomical spaces "
     "are brought to RAS, vectors with them, from their measurement frame; no times"},
    {".nhdr", "NRRD header beside its data", simulation, Beside::header, {}, "as .nrrd"},
    {".stl",
     "stereolithography, text or binary",
     simulation,
     Beside::nothing,
     {},
     "corners at one place become one vertex; colours in a facet's spare bytes are left out",
     true},
    {".mrc",
     "MRC image",
     simulation,
     Beside::nothing,
     {},
     "one scalar; of bytes, signed numbers of 16 bits or floats, in either byte order; axes in the "
     "order x, y, z, at right angles"},
    {".rec", "MRC image", simulation, Beside::nothing, {}, "as .mrc"},
};

void keep_files(std::vector<fs::path>& paths, const fs::path& without) {
  std::erase_if(paths, [&](const fs::path& path) {
    std::error_code code;
    return !fs::is_regular_file(path, code) || fs::equivalent(path, without, code);
  });
  std::ranges::sort(paths);
  paths.erase(std::ranges::unique(paths).begin(), paths.end());
}

/// Names in VTK's XML, and in the files that these name.
void add_named(const fs::path& file, std::vector<fs::path>& paths, int depth) {
  constexpr int deepest = 4;  // blocks of pieces of blocks; a file may name itself
  if (depth > deepest) return;
  for (const XmlTag& tag : xml_tags(file))
    for (const char* key : {"file", "Source"})
      if (const auto name = tag.attributes.find(key); name != tag.attributes.end()) {
        const fs::path named = file.parent_path() / name->second;
        paths.push_back(named);
        std::error_code code;
        if (const VtkFormat* format = vtk_format(named);
            format && format->beside == Beside::named && fs::is_regular_file(named, code))
          add_named(named, paths, depth + 1);
      }
}

/// Who opens a pipe waits for what comes out of it.
void refuse_pipes(const std::vector<fs::path>& paths, const fs::path& by) {
  for (const fs::path& path : paths) {
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status))
      throw InputError(fmt::format("{}: it names {}: a pipe or a device; accepted: a file",
                                   by.string(), path.string()));
  }
}

}  // namespace

std::span<const VtkFormat> vtk_formats() { return table; }

const VtkFormat* vtk_format(const fs::path& path) {
  const std::string name = lower_case(path.filename().string());
  const auto found = std::ranges::find_if(
      table, [&](const VtkFormat& format) { return name.ends_with(format.ending); });
  return found == std::end(table) ? nullptr : found;
}

std::vector<fs::path> files_beside(const fs::path& path, const VtkFormat& format) {
  std::vector<fs::path> paths;
  switch (format.beside) {
    case Beside::nothing:
      break;
    case Beside::named:
      add_named(path, paths, 0);
      break;
    case Beside::second:
      paths.push_back(fs::path(path).replace_extension(format.second));
      break;
    case Beside::folder:
      paths = files_of_ensight(path);
      break;
    case Beside::tree:
      paths = files_of_foam(path);
      break;
    case Beside::header:
      paths = files_of_nrrd(path);
      break;
  }
  // Of a case's folders it opens what it knows by name, whatever else lies there.
  if (format.beside != Beside::tree) refuse_pipes(paths, path);
  keep_files(paths, path);
  return paths;
}

}  // namespace pellucid::readers
