// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>
#include <vector>

class vtkDataSet;

namespace pellucid::readers {

/// A VtkTime is what a file holds at one time.
struct VtkTime {
  double time = 0;  // 0 in a file without times
  vtkSmartPointer<vtkDataSet> data;
  std::vector<std::string> blocks;    // names of those merged in it; none of a file of one data set
  std::vector<std::string> left_out;  // arrays, and why: "NAME(x, y): it has other dimensions"
  std::vector<double> of;             // all times of the file
};

/// Reads a file of vtk_formats() by VTK, in a process of its own: the blocks named in `block`, at
/// the time named in `time`; of both all when they are empty (chosen_blocks(), chosen_time()). Of
/// arrays that do not fit one grid it takes those that fit the ones named in `arrays`, with commas
/// between, as pick_vectors() does; when that is empty or names none, those of the most axes. There
/// is one time at least. Every offset, index and number of values in the result has been
/// checked. Throws InputError that names the file for a file without points, a truncated one, what
/// VTK complains of and what it dies over.
std::vector<VtkTime> read_vtk_file(const std::filesystem::path& path, const std::string& block = {},
                                   const std::string& time = {}, const std::string& arrays = {});

/// Reads the data alone, at the first time, all blocks in one.
vtkSmartPointer<vtkDataSet> read_vtk_data_set(const std::filesystem::path& path);

}  // namespace pellucid::readers
