// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// VTK's readers: for the processes that pellucid-read-vtk and pellucid-read-simulation are, and no
// other.

#include <vtkAlgorithm.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

class vtkDataSet;

namespace pellucid::readers {

/// A VtkRequest says what of a file is wanted: blocks by name (chosen_blocks()), which of its times
/// (chosen_time()), and arrays by name with commas between; of each all when it is empty.
struct VtkRequest {
  std::string block, time, arrays;
};

/// A ParsedTime is what a file holds at one time.
struct ParsedTime {
  vtkSmartPointer<vtkDataSet> data;
  std::vector<std::string> blocks;    // names of those in `data`, when they are parts of more
  std::vector<std::string> left_out;  // arrays that do not fit those in `data`
  bool is_last = false;               // the reader is not asked again
};

/// FileTimes are the times that were read, and all that there are: none of a file without.
struct FileTimes {
  std::vector<double> read, all;
};

/// One reader of VTK: made for a file, whose name and options it has.
struct VtkReader {
  std::string_view ending;  // of a row of vtk_formats()
  vtkSmartPointer<vtkAlgorithm> (*make)(const std::filesystem::path& path);
  /// Where arrays of a file may not fit one grid: picks those that fit the wanted ones, and returns
  /// the names of all others.
  std::vector<std::string> (*pick_arrays)(vtkAlgorithm& reader,
                                          const std::string& wanted) = nullptr;
  /// Words of warnings after which what is read is whole; other messages refuse the file.
  std::span<const std::string_view> harmless = {};
};

/// VTK's own formats.
std::span<const VtkReader> plain_readers();
/// The formats of simulations and of images of other programs.
std::span<const VtkReader> simulation_readers();

/// Parses a file with the reader that its ending names, which a wrong file may crash, gives what it
/// holds at each wanted time to `take`, one after another, and returns these times. Throws
/// InputError for a file without points, a truncated one, and whatever else VTK would print about
/// it.
FileTimes parse_vtk_file(const std::filesystem::path& path, std::span<const VtkReader> readers,
                         const VtkRequest& request,
                         const std::function<void(const ParsedTime&)>& take);

}  // namespace pellucid::readers
