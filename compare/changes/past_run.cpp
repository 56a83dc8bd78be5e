// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/changes/past_run.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/files/json_node.h"
#include "scene/renderer.h"

namespace pellucid::compare {

namespace fs = std::filesystem;

bool is_run_folder(const fs::path& path) {
  std::error_code code;
  return fs::is_directory(path, code);
}

PastRun read_past_run(const fs::path& folder) {
  const fs::path file = folder / "results.json";
  if (!fs::exists(file))
    throw InputError(fmt::format(
        "{}: has no results.json; accepted: a folder that `pellucid study -o` has filled",
        folder.string()));
  const nlohmann::json json = read_json(file);
  const JsonNode root(file.string(), json);
  root["format"].one_of({"pellucid-results"});
  root["version"].integer(1, 1);
  PastRun run{folder, root["study"]["name"].string(), {}};
  if (root["study"].has("title")) run.title = root["study"]["title"].string();
  try {
    for (const nlohmann::json& row : json.at("rows")) run.rows.push_back(row_from_json(row));
  } catch (const nlohmann::json::exception&) {
    root.fail(
        fmt::format("its row {} is of another version of the program; accepted: results of "
                    "this one",
                    run.rows.size() + 1));
  }
  return run;
}

std::string cell_name(const ResultRow& row) { return row.scene + "/" + row.call(); }

const ResultRow* find_row_of(const PastRun& run, const std::string& cell) {
  for (const ResultRow& row : run.rows)
    if (cell_name(row) == cell) return &row;
  return nullptr;
}

std::string gl_of(const ResultRow& row) {
  const auto gl = row.machine.find("gl");
  return gl == row.machine.end() ? scene::RenderContext().gl : gl->second;
}

std::map<std::string, std::string> inputs_of(const ResultRow& row) {
  std::map<std::string, std::string> inputs = row.files_read;
  std::erase_if(inputs, [](const auto& file) {
    return fs::path(file.first).filename().string().starts_with("pellucid-read-");
  });
  return inputs;
}

}  // namespace pellucid::compare
