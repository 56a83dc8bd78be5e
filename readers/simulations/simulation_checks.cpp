// SPDX-License-Identifier: GPL-3.0-or-later
// EnSight: User Manual for Version 10, Ch. 9.2 and 9.3. CGNS: Standard Interface Data Structures,
// Annex A, "Data-Name Identifiers", Coordinate Systems. OpenFOAM: User Guide, 3.4, running
// applications in parallel.

#include "readers/simulations/simulation_checks.h"

#include <fmt/format.h>
#include <vtk_netcdf.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <vector>

#include "core/error.h"

namespace pellucid::readers {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream words(line);
  return {std::istream_iterator<std::string>(words), {}};
}

/// The words behind a key of the case, "type:", in the first line that begins with it.
std::vector<std::string> words_behind(const fs::path& path, const std::string& key) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::vector<std::string> words = words_of(line);
    if (words.empty() || words.front() != key) continue;
    words.erase(words.begin());
    return words;
  }
  return {};
}

bool is_whole_number(const std::string& word) {
  return std::ranges::all_of(word, [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// Says whether a file is named by a pattern, in which stars stand for digits.
bool is_named_by(const std::string& name, const std::string& pattern) {
  return std::ranges::equal(name, pattern, [](unsigned char c, char wanted) {
    return wanted == '*' ? std::isdigit(c) != 0 : c == static_cast<unsigned char>(wanted);
  });
}

/// The geometry of the first time; an empty path where there is none, of which VTK complains.
fs::path geometry_of(const fs::path& path) {
  const auto words = words_behind(path, "model:");
  const auto named = std::ranges::find_if_not(words, is_whole_number);  // before it: its time set
  if (named == words.end()) return {};
  const fs::path wanted = path.parent_path() / *named;
  std::error_code code;
  for (fs::directory_iterator entry(fs::absolute(wanted).parent_path(), code), end; entry != end;
       entry.increment(code))
    if (is_named_by(entry->path().filename().string(), wanted.filename().string()))
      return entry->path();
  return {};
}

bool has_blocks(const fs::path& geometry) {
  std::ifstream file(geometry);
  std::string line;
  std::getline(file, line);
  if (line.find("Binary") != std::string::npos) return false;
  while (std::getline(file, line))
    if (const auto words = words_of(line); !words.empty() && words.front() == "block") return true;
  return false;
}

/// Folders named by a number.
std::set<std::string> times_in(const fs::path& folder) {
  std::set<std::string> times;
  std::error_code code;
  for (fs::directory_iterator entry(folder, code), end; entry != end; entry.increment(code)) {
    const std::string name = entry->path().filename().string();
    if (entry->is_directory(code) && !name.empty() &&
        name.find_first_not_of("0123456789.eE+-") == std::string::npos)
      times.insert(name);
  }
  return times;
}

}  // namespace

void refuse_ensight6_blocks(const fs::path& path) {
  const auto type = words_behind(path, "type:");
  if (type.size() != 1 || type.front() != "ensight") return;
  if (const fs::path geometry = geometry_of(path); !geometry.empty() && has_blocks(geometry))
    throw InputError(
        fmt::format("{}: structured blocks of EnSight 6, whose values VTK shifts by a "
                    "line; accepted: EnSight Gold, unstructured parts",
                    path.string()));
}

void refuse_curved_cgns(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  constexpr std::size_t step = 1 << 20, longest = 32;
  std::string window, more(step, '\0');
  while (file.read(more.data(), step) || file.gcount() > 0) {
    window = window.substr(window.size() - std::min(window.size(), longest)) +
             more.substr(0, std::size_t(file.gcount()));
    for (const char* name : {"CoordinateTheta", "CoordinatePhi"})
      if (window.find(name) != std::string::npos)
        throw InputError(fmt::format(
            "{}: it has {}; accepted: CoordinateX, CoordinateY, CoordinateZ", path.string(), name));
  }
}

void refuse_divided_foam(const fs::path& path) {
  const fs::path folder = fs::absolute(path).parent_path();
  const std::set<std::string> times = times_in(folder);
  std::error_code code;
  for (fs::directory_iterator entry(folder, code), end; entry != end; entry.increment(code)) {
    const std::string name = entry->path().filename().string();  // "processor0", "processors4"
    if (!name.starts_with("processor")) continue;
    for (const std::string& time : times_in(entry->path()))
      if (!times.contains(time))
        throw InputError(
            fmt::format("{}: {} has the time {}, which the case itself lacks; "
                        "accepted: a case of which reconstructPar has made one",
                        path.string(), name, time));
  }
}

// Schoof, Yarberry, EXODUS II (SAND92-2137), and ex_large_model() of the library: the attribute
// file_size is 1 where each variable at nodes is one of the file's own.
void refuse_unread_exodus(const fs::path& path) {
  int file = 0, id = 0, is_large = 0;
  std::size_t count = 0;
  if (nc_open(path.c_str(), NC_NOWRITE, &file) != NC_NOERR) return;  // VTK complains of it
  if (nc_inq_dimid(file, "num_nod_var", &id) == NC_NOERR) nc_inq_dimlen(file, id, &count);
  nc_get_att_int(file, NC_GLOBAL, "file_size", &is_large);
  const char* const wanted = is_large == 1 ? "vals_nod_var1" : "vals_nod_var";
  const bool is_there = count == 0 || nc_inq_varid(file, wanted, &id) == NC_NOERR;
  nc_close(file);
  if (!is_there)
    throw InputError(
        fmt::format("{}: its file_size is {}, but {}, where the values at nodes are "
                    "by that, is not there; accepted: vals_nod_var1, … where "
                    "file_size is 1, else vals_nod_var",
                    path.string(), is_large, wanted));
}

}  // namespace pellucid::readers
