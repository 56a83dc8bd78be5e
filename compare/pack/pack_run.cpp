// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pack/pack_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "compare/cells/cell.h"
#include "compare/pack/pack_texts.h"
#include "core/error.h"
#include "core/files/files_read.h"
#include "core/files/json_node.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

/// Every file that a cell has read, with its content's hash. What was not there, such as an .obj's
/// materials, has none, and is no file of the package.
std::map<fs::path, std::string> all_inputs(const PastRun& run) {
  std::map<fs::path, std::string> inputs;
  for (const ResultRow& row : run.rows)
    for (const auto& [path, hash] : inputs_of(row))
      if (!hash.empty()) inputs.emplace(path, hash);
  return inputs;
}

void check_inputs(const std::map<fs::path, std::string>& inputs) {
  ContentHashes hashes;
  for (const auto& [path, hash] : inputs) {
    if (!fs::is_regular_file(path))
      throw InputError(
          fmt::format("{}: is missing, and the results were made of it; accepted: "
                      "results whose inputs are still there",
                      path.string()));
    if (hashes.of(path) != hash)
      throw InputError(
          fmt::format("{}: has other content than what the results were made of; "
                      "accepted: results of the files as they are (study --resume)",
                      path.string()));
  }
}

bool is_asked_alike(const Cell& cell, const Study& study, const ResultRow& row) {
  return cell_fingerprint(cell, study.reference, timing_of(study), {.gl = gl_of(row)}) ==
         row.fingerprint;
}

void check_picture(const PastRun& run, const ResultRow& row) {
  const fs::path picture = CellFiles(run.folder, row).picture();
  if (row.error.empty() && !holds_something(picture))
    throw InputError(
        fmt::format("{}: is missing or empty; accepted: results with their pictures "
                    "(study --resume)",
                    picture.string()));
}

void check_cells(const PastRun& run, const Study& study) {
  const std::vector<Cell> cells = expand_cells(study);
  for (const ResultRow& row : run.rows) {
    const std::string name = cell_name(row);
    if (!row.given.empty())
      throw InputError(
          fmt::format("{}: {} is a {} from elsewhere, which cannot be run again; "
                      "accepted: studies of the program's own methods",
                      run.folder.string(), name, row.given));
    const auto cell = std::ranges::find(cells, name, &Cell::name);
    if (cell == cells.end() || !is_asked_alike(*cell, study, row))
      throw InputError(
          fmt::format("{}: cell {} is not what {} asks for now; accepted: results of "
                      "the study as it is (study --resume)",
                      run.folder.string(), name, study.file.string()));
    check_picture(run, row);
  }
}

/// A path within a text that begins at the root would not lead into the package.
void check_relative(const nlohmann::json& text, const fs::path& of,
                    const std::map<fs::path, std::string>& inputs) {
  for (const auto& value : text.flatten()) {
    if (!value.is_string() || !value.get<std::string>().starts_with('/')) continue;
    const std::string named = value.get<std::string>();
    for (const auto& [path, hash] : inputs)
      if (named.starts_with(path.string()))
        throw InputError(
            fmt::format("{}: names {} by an absolute path; accepted: a path relative "
                        "to the file, so that the package can be moved",
                        of.string(), path.string()));
  }
}

/// The folder that holds all of the files.
fs::path common_folder(const std::set<fs::path>& files) {
  fs::path common = files.begin()->parent_path();
  for (const fs::path& file : files)
    while (file.lexically_relative(common).begin()->string() == "..") common = common.parent_path();
  return common;
}

void add_results(const fs::path& folder, std::vector<PackedFile>& files) {
  std::set<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) found.insert(entry.path());
  for (const fs::path& file : found)
    files.push_back({"results/" + file.lexically_relative(folder).generic_string(), file});
}

}  // namespace

fs::path study_of_run(const fs::path& folder) {
  const fs::path file = folder / "results.json";
  const nlohmann::json json = read_json(file);
  const auto study = json.value("study", nlohmann::json::object());
  if (!study.is_object() || !study.value("file", nlohmann::json()).is_string())
    throw InputError(
        fmt::format("{}: does not say where its study is; accepted: results of this "
                    "version, or --study FILE",
                    file.string()));
  return study["file"].get<std::string>();
}

PackedRun pack_run(const PastRun& run, const Study& study) {
  const std::map<fs::path, std::string> inputs = all_inputs(run);
  check_inputs(inputs);
  check_cells(run, study);
  const auto place_of = [](const fs::path& file) { return without_dots(fs::absolute(file)); };
  const fs::path study_file = place_of(study.file);
  std::set<fs::path> texts{study_file};  // JSON, whatever their names end in
  for (const fs::path& scene : study.scenes) texts.insert(place_of(scene));
  for (const auto& [scene, file] : study.reference_scenes) texts.insert(place_of(file));
  for (const LeftOutScene& scene : study.left_out)  // which the study's text names all the same
    texts.insert(place_of(scene.file));
  std::set<fs::path> all = texts;
  for (const auto& [path, hash] : inputs) all.insert(path);
  for (const fs::path& file : all)
    if (texts.contains(file) || file.extension() == ".json")
      check_relative(read_json(file), file, inputs);
  const fs::path root = common_folder(all);
  PackedRun packed;
  packed.study = "inputs/" + study_file.lexically_relative(root).generic_string();
  for (const fs::path& file : all)
    packed.files.push_back({"inputs/" + file.lexically_relative(root).generic_string(), file});
  add_results(run.folder, packed.files);
  std::ranges::move(pack_texts(run, study, packed), std::back_inserter(packed.files));
  return packed;
}

}  // namespace pellucid::compare
