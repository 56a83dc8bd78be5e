// SPDX-License-Identifier: GPL-3.0-or-later
// EnSight: User Manual for Version 10, Ch. 9.2 and 9.3. CGNS: Standard Interface Data Structures,
// Annex A, "Data-Name Identifiers", Coordinate Systems. OpenFOAM: User Guide, 3.4, running
// applications in parallel.

#include "readers/simulations/simulation_checks.h"

#include <fmt/format.h>

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

}  // namespace pellucid::readers
