// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace pellucid::fields {

/// A CollectedFile is one file of a .pvd collection.
struct CollectedFile {
  std::string name;  // for block=…: its name, group or part
  std::filesystem::path file;
};

/// A Collection has the files of each time.
using Collection = std::map<double, std::vector<CollectedFile>>;

/// Reads ParaView's list of VTK files over time. Throws InputError, naming `path`, for what is
/// none.
Collection pvd_collection(const std::filesystem::path& path);

}  // namespace pellucid::fields
