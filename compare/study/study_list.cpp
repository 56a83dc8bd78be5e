// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "compare/study/study.h"
#include "core/error.h"
#include "core/files/json_node.h"
#include "core/files/own_files.h"
#include "core/options/names.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> study_files() {
  std::vector<fs::path> files;
  std::error_code missing;
  for (const fs::directory_entry& entry : fs::directory_iterator(data_folder("studies"), missing))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<StudySummary> list_studies() {
  std::vector<StudySummary> summaries;
  for (const fs::path& file : study_files()) {
    const nlohmann::json json = read_json(file);
    const JsonNode root(file.string(), json);
    const auto text = [&](std::string_view key) {
      return root.has(key) ? root[key].string() : std::string();
    };
    summaries.push_back({file.stem().string(), text("title"), text("source"), file});
  }
  return summaries;
}

fs::path find_study(std::string_view name_or_file) {
  const fs::path given(name_or_file);
  const std::string name = given.string() + ".json";
  for (const fs::path& path : {given, "studies" / fs::path(name), fs::path(name)})
    if (fs::is_regular_file(path)) return path;
  std::vector<std::string> names;
  for (const fs::path& file : study_files()) {
    if (file.filename() == name) return file;
    names.push_back(file.stem().string());
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  throw InputError(unknown_name("study", name_or_file, known) + ", or the path of a study file");
}

}  // namespace pellucid::compare
