// SPDX-License-Identifier: GPL-3.0-or-later
// Which files belong to a case that is kept in several, by their names: what else lies in its
// folder, a picture or a run's output, is no part of it.

#include "readers/vtk/case_files.h"

#include <glob.h>

#include <fstream>
#include <string>
#include <utility>

#include "core/options/lower_case.h"
#include "core/options/parameters.h"

namespace pellucid::readers {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<fs::path>;

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// As glob(3) takes it: each asterisk is a digit, and nothing else stands for more than itself.
std::string pattern_of(const fs::path& name) {
  std::string pattern;
  for (const char c : name.string()) {
    if (c == '*')
      pattern += "[0-9]";
    else if (c == '?' || c == '[' || c == '\\')
      pattern += {'\\', c};
    else
      pattern += c;
  }
  return pattern;
}

void add_matching(const fs::path& name, Paths& paths) {
  glob_t found{};
  if (::glob(pattern_of(name).c_str(), 0, nullptr, &found) == 0)
    paths.insert(paths.end(), found.gl_pathv, found.gl_pathv + found.gl_pathc);
  ::globfree(&found);
}

std::string unquoted(const std::string& word) {
  const bool is_quoted = word.size() >= 2 && word.front() == '"' && word.back() == '"';
  return is_quoted ? word.substr(1, word.size() - 2) : word;
}

template <class Iterator>
Paths entries_of(const fs::path& folder) {
  std::error_code code;
  Paths paths;
  const auto options = fs::directory_options::skip_permission_denied;
  for (auto entry = Iterator(folder, options, code); !code && entry != Iterator();
       entry.increment(code))
    paths.push_back(entry->path());
  return paths;
}

bool is_of_case(const std::string& folder) {
  double time = 0;
  return folder == "constant" || folder == "system" || parse_number(folder, time);
}

void add_case(const fs::path& folder, Paths& paths) {
  for (const fs::path& entry : entries_of<fs::directory_iterator>(folder)) {
    if (!is_of_case(entry.filename().string())) continue;
    const Paths below = entries_of<fs::recursive_directory_iterator>(entry);
    paths.insert(paths.end(), below.begin(), below.end());
  }
}

/// What follows "data file:" in an NRRD header, and the lines behind it, where a LIST has its
/// names; the header ends at an empty line.
std::pair<std::string, Paths> data_files_of_nrrd(const fs::path& file) {
  constexpr std::size_t longest = 4096;  // what is longer is no header's line
  std::ifstream text(file, std::ios::binary);
  for (std::string line; std::getline(text, line) && !line.empty() && line.size() < longest;) {
    const std::size_t colon = line.find(": ");
    const std::string key = lower_case(line.substr(0, colon));
    if (colon == line.npos || (key != "data file" && key != "datafile")) continue;
    std::string value = line.substr(colon + 2);
    value.erase(value.find_last_not_of(" \t\r") + 1);
    Paths names;
    while (std::getline(text, line) && !line.empty() && line.size() < longest)
      names.emplace_back(line.substr(0, line.find_last_not_of(" \t\r") + 1));
    return {value, names};
  }
  return {};
}

bool is_list(const std::string& value) { return value.substr(0, value.find(' ')) == "LIST"; }

}  // namespace

std::vector<fs::path> files_of_ensight(const fs::path& file) {
  Paths paths;
  std::ifstream text(file);
  for (std::string word; text >> word;) add_matching(folder_of(file) / unquoted(word), paths);
  return paths;
}

std::vector<fs::path> files_of_foam(const fs::path& file) {
  Paths paths;
  const fs::path folder = folder_of(file);
  add_case(folder, paths);
  for (const fs::path& entry : entries_of<fs::directory_iterator>(folder))
    if (entry.filename().string().starts_with("processor")) add_case(entry, paths);
  return paths;
}

std::vector<fs::path> files_of_nrrd(const fs::path& file) {
  const auto [value, names] = data_files_of_nrrd(file);
  if (value.empty()) return {};
  Paths paths = is_list(value) ? names : Paths{value};
  for (fs::path& path : paths) path = folder_of(file) / path;
  return paths;
}

std::string numbered_files_of_nrrd(const fs::path& file) {
  const std::string value = data_files_of_nrrd(file).first;
  return value.find('%') == value.npos || is_list(value) ? "" : value;
}

}  // namespace pellucid::readers
