// SPDX-License-Identifier: GPL-3.0-or-later
// Files written as a folder or as an archive, the same bytes for the same files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pellucid::compare {

/// A PackedFile is a file of a package: its content is `text`, or that of the file `source`.
struct PackedFile {
  std::string path;  // within the package, with '/'
  std::filesystem::path source = {};
  std::string text = {};
  bool executable = false;

  std::string content() const;
};

/// Writes the files below a folder named `name`: by the path's ending as .tar.gz, .tgz or .zip,
/// else as a folder itself, which may be replaced if it was made the same way. No time of any file
/// is kept. Throws as OutputFile and OutputFolder do, and WorkError where writing fails.
void write_package(const std::filesystem::path& to, const std::string& name,
                   const std::vector<PackedFile>& files);

/// Returns the name of the folder that unpacking makes: the path's own without such an ending.
std::string package_name(const std::filesystem::path& to);

}  // namespace pellucid::compare
