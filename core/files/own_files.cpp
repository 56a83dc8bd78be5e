// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/own_files.h"

#include <dlfcn.h>
#include <link.h>

#include <vector>

namespace pellucid {
namespace {

namespace fs = std::filesystem;

/// The deepest place that looks for its files is Python's module in an installation:
/// lib/python3/dist-packages/pellucid.
constexpr int most_levels = 4;

fs::path find_own_file() {
  Dl_info info;
  link_map* map = nullptr;
  const void* here = reinterpret_cast<const void*>(&own_file);
  const bool known =
      ::dladdr1(here, &info, reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP) != 0 && map;
  std::error_code code;
  const bool is_library = known && map->l_name && *map->l_name;
  return is_library ? fs::canonical(map->l_name, code) : fs::read_symlink("/proc/self/exe", code);
}

/// The folder of own_file() and those around it, from the inside.
std::vector<fs::path> folders_around() {
  std::vector<fs::path> folders{own_file().parent_path()};
  for (int level = 0; level < most_levels && folders.back().has_relative_path(); ++level)
    folders.push_back(folders.back().parent_path());
  return folders;
}

bool is_build_folder(const fs::path& folder) {
  std::error_code code;
  return fs::exists(folder / "CMakeCache.txt", code);
}

}  // namespace

const fs::path& own_file() {
  static const fs::path file = find_own_file();
  return file;
}

fs::path helper_program(std::string_view name) {
  std::error_code code;
  const fs::path beside = own_file().parent_path() / name;
  if (fs::exists(beside, code)) return beside;
  for (const fs::path& folder : folders_around())
    for (const fs::path& place : {folder / "libexec/pellucid" / name, folder / name})
      if ((place.parent_path() != folder || is_build_folder(folder)) && fs::exists(place, code))
        return place;
  return beside;
}

fs::path data_folder(std::string_view name) {
  std::error_code code;
  for (const fs::path& folder : folders_around()) {
    const fs::path installed = folder / "share/pellucid" / name;
    if (fs::is_directory(installed, code)) return installed;
    if (!is_build_folder(folder)) continue;
    const fs::path source = (folder / PELLUCID_SOURCES_FROM_BUILD / name).lexically_normal();
    if (fs::is_directory(source, code)) return source;
  }
  return {};
}

}  // namespace pellucid
