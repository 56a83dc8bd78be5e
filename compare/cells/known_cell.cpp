// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cells/known_cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/files/json_node.h"
#include "core/files/output_file.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The key of a cell's row under which the hashes of its files are, by their names: a study's
/// folder may be moved.
constexpr const char* files_key = "files";

json hashes_of_made(const CellFiles& files, const ResultRow& row) {
  ContentHashes hashes;  // of what was just written, whatever a run has read there before
  json made = json::object();
  for (const fs::path& path : files.pictures_of(row))
    if (fs::exists(path)) made[path.filename().string()] = hashes.of(path);
  return made;
}

std::string fault_of_file(const fs::path& path, const json* hash, ContentHashes& hashes) {
  const std::string name = path.filename().string();
  std::error_code code;
  if (!fs::exists(path, code)) return name + " is gone";
  if (fs::is_empty(path, code)) return name + " is empty";
  if (hash && hashes.of(path) != hash->get<std::string>()) return name + " is not as it was made";
  return "";
}

/// Why a row's files are not those that the cell has made; empty where they are. Builds before this
/// one kept a list of their names alone, and others before them none.
std::string fault_of_files(const CellFiles& files, const json& made, ContentHashes& hashes) {
  for (const fs::path& path : {files.picture(), files.preview()})
    if (std::string fault = fault_of_file(path, nullptr, hashes); !fault.empty()) return fault;
  for (const auto& [key, value] : made.items()) {
    const std::string name = made.is_array() ? value.get<std::string>() : key;
    const json* hash = made.is_array() ? nullptr : &value;
    std::string fault = fault_of_file(files.picture().parent_path() / name, hash, hashes);
    if (!fault.empty()) return fault;
  }
  return "";
}

bool are_unchanged(const std::map<std::string, std::string>& files, ContentHashes& hashes) {
  return std::ranges::all_of(
      files, [&](const auto& file) { return hashes.of(file.first) == file.second; });
}

KnownCell checked(ResultRow row, const json& made, const CellFiles& files,
                  const std::string& fingerprint, ContentHashes& hashes) {
  if (row.fingerprint != fingerprint || !are_unchanged(row.files_read, hashes))
    return {.fault = "of other inputs"};
  if (row.error.empty())
    if (std::string fault = fault_of_files(files, made, hashes); !fault.empty())
      return {.fault = std::move(fault)};
  return {.row = std::move(row)};
}

}  // namespace

KnownCell known_cell(const CellFiles& files, const std::string& fingerprint,
                     ContentHashes& hashes) {
  if (!fs::exists(files.row())) return {};
  const std::string name = files.row().filename().string();
  try {
    const json text = read_json(files.row());
    return checked(row_from_json(text), text.value(files_key, json()), files, fingerprint, hashes);
  } catch (const json::exception&) {
    return {.fault = name + " is a row of another version"};
  } catch (const InputError&) {  // a kill or a full disk has left less than a row
    return {.fault = name + " is no whole row"};
  }
}

std::optional<ResultRow> read_row(const CellFiles& files, const std::string& fingerprint,
                                  ContentHashes& hashes) {
  return known_cell(files, fingerprint, hashes).row;
}

std::optional<ResultRow> read_finished(const CellFiles& files, const std::string& fingerprint,
                                       ContentHashes& hashes) {
  std::optional<ResultRow> row = read_row(files, fingerprint, hashes);
  return row && row->error.empty() ? std::move(row) : std::nullopt;
}

bool is_of_build(const ResultRow& row, const std::string& build) {
  const auto known = row.machine.find("build");
  return known != row.machine.end() && known->second == build;
}

void write_row(const CellFiles& files, const ResultRow& row) {
  json text = to_json(row);
  text[files_key] = hashes_of_made(files, row);
  write_text(files.row(), json_text(text, 1) + "\n");
}

}  // namespace pellucid::compare
