// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pack/pack_texts.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "compare/cells/cell.h"
#include "compare/pack/sha256.h"
#include "compare/report/url_text.h"
#include "core/files/json_text.h"
#include "core/machine/build_info.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Every fact of the machines and builds that the rows come from, each value once.
json versions(const PastRun& run) {
  std::map<std::string, std::set<std::string>> facts;
  for (const ResultRow& row : run.rows)
    for (const auto& [name, value] : row.machine) facts[name].insert(value);
  return {{"packed_by", {{"version", build_version}, {"commit", build_commit}}}, {"run_on", facts}};
}

std::string first_fact(const PastRun& run, const std::string& name) {
  for (const ResultRow& row : run.rows)
    if (const auto found = row.machine.find(name); found != row.machine.end()) return found->second;
  return "unknown";
}

/// A word between single quotes.
std::string shell_word(std::string_view word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + '\'';
}

/// Where a run has not all cells of its study, since others were asked for or screened out, the
/// words that ask for its own: as patterns that fit nothing else.
std::string only_its_cells(const PastRun& run, const Study& study) {
  if (run.rows.size() == expand_cells(study).size()) return {};
  std::string words;
  for (const ResultRow& row : run.rows) {
    std::string pattern;
    for (const char c : cell_name(row)) {
      if (std::string_view("*?[\\").find(c) != std::string_view::npos) pattern += '\\';
      pattern += c;
    }
    words += fmt::format(" \\\n  --only {}", shell_word(pattern));
  }
  return words;
}

/// Nothing in it depends on who packs, so that it is one text but for names.
std::string run_script(const PastRun& run, const Study& study, const PackedRun& packed) {
  return fmt::format(R"sh(#!/bin/sh
# Runs the study again into again/, and says where its pictures are not those of results/ to the last
# bit, and which times differ beyond their spread. Ends with 0 where all but times is the same.
# PELLUCID names the program where it is not on the PATH; it was {}, commit {}.
set -u
pellucid=${{PELLUCID:-pellucid}}
case $pellucid in
  /*) ;;
  */*) pellucid=$PWD/$pellucid ;;
esac
cd "$(dirname "$0")" || exit 2
if ! command -v "$pellucid" >/dev/null; then
  echo "run.sh: $pellucid: no such program; accepted: pellucid on the PATH, or PELLUCID=FILE" >&2
  exit 2
fi
sha256sum --check --quiet manifest.sha256 || exit 2
"$pellucid" study {} -o again --gl {} --quiet{} || exit
exec "$pellucid" compare results again --ignore-times --output again/changes
)sh",
                     first_fact(run, "version"), first_fact(run, "commit"),
                     shell_word("./" + packed.study), gl_of(run.rows.front()),
                     only_its_cells(run, study));
}

std::string readme(const PastRun& run, const Study& study) {
  return fmt::format(
      "# {}\n\n{}A study by Pellucid: `results/report.html` shows it, `inputs/` has all that it "
      "was "
      "made of.\n\n`./run.sh` runs it again and says where pictures are not the same to the last "
      "bit, and which times differ.\nIt needs `pellucid` ({}, commit {}), on the PATH or as "
      "`PELLUCID=FILE ./run.sh`; `versions.json` has the\nrest. `manifest.sha256` has every file's "
      "hash, `ro-crate-metadata.json` says the same to programs.\n",
      study.title, study.source.empty() ? "" : study.source + "\n\n", first_fact(run, "version"),
      first_fact(run, "commit"));
}

/// A text between double quotes is YAML as it is JSON.
std::string citation(const Study& study) {
  return fmt::format(
      "cff-version: 1.2.0\nmessage: If you use these results, please cite them, Pellucid, and the "
      "papers of the methods.\ntype: dataset\ntitle: {}\nauthors:\n  - name: Who ran the study\n"
      "references:\n  - type: software\n    title: Pellucid\n    authors:\n      - name: The "
      "Pellucid authors\n    version: {}\n    license: GPL-3.0-or-later\n",
      json_text(study.title), build_version);
}

std::string date_of(const PastRun& run) {
  const auto written = fs::last_write_time(run.folder / "results.json");
  const auto seconds =
      std::chrono::time_point_cast<std::chrono::seconds>(std::chrono::file_clock::to_sys(written));
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::chrono::system_clock::to_time_t(seconds)));
}

std::string_view media_type(const fs::path& path) {
  constexpr std::pair<std::string_view, std::string_view> types[] = {
      {".json", "application/json"}, {".csv", "text/csv"},       {".html", "text/html"},
      {".png", "image/png"},         {".exr", "image/aces"},     {".md", "text/markdown"},
      {".tex", "application/x-tex"}, {".sh", "application/x-sh"}};
  for (const auto& [ending, type] : types)
    if (path.extension() == ending) return type;
  return "application/octet-stream";
}

json id(std::string_view of) { return {{"@id", of}}; }

/// An identifier of RO-Crate is a URI (RO-Crate 1.1, "Encoding file paths").
json file_id(const PackedFile& file) { return id(url_of(file.path)); }

json ids(const std::vector<PackedFile>& files, std::string_view folder) {
  json list = json::array();
  for (const PackedFile& file : files)
    if (file.path.starts_with(folder)) list.push_back(file_id(file));
  return list;
}

/// A Digest is what is said of a file's content.
struct Digest {
  std::size_t size;
  std::string sha256;
};

Digest digest_of(const PackedFile& file) {
  const std::string content = file.content();
  return {content.size(), sha256(content)};
}

json file_entity(const PackedFile& file, const Digest& digest) {
  return {{"@id", url_of(file.path)},
          {"@type", "File"},
          {"name", fs::path(file.path).filename().string()},
          {"encodingFormat", media_type(file.path)},
          {"contentSize", std::to_string(digest.size)},
          {"sha256", digest.sha256}};
}

json crate(const PastRun& run, const Study& study, const std::vector<PackedFile>& files,
           const std::vector<Digest>& digests) {
  const json graph_head = {
      {{"@id", "ro-crate-metadata.json"},
       {"@type", "CreativeWork"},
       {"conformsTo", id("https://w3id.org/ro/crate/1.1")},
       {"about", id("./")}},
      {{"@id", "./"},
       {"@type", "Dataset"},
       {"name", study.title},
       {"description", "A study by Pellucid with its inputs and results; run.sh runs it again."},
       {"datePublished", date_of(run)},
       {"license", "not stated by who packed it"},
       {"hasPart", ids(files, "")},
       {"mentions", id("#run")}},
      {{"@id", "#pellucid"},
       {"@type", "SoftwareApplication"},
       {"name", "Pellucid"},
       {"softwareVersion",
        fmt::format("{} ({})", first_fact(run, "version"), first_fact(run, "commit"))}},
      {{"@id", "#run"},
       {"@type", "CreateAction"},
       {"name", "pellucid study " + study.name},
       {"instrument", id("#pellucid")},
       {"object", ids(files, "inputs/")},
       {"result", ids(files, "results/")}}};
  json graph = graph_head;
  for (std::size_t i = 0; i < files.size(); ++i) graph.push_back(file_entity(files[i], digests[i]));
  return {{"@context",
           {"https://w3id.org/ro/crate/1.1/context", {{"sha256", "https://schema.org/sha256"}}}},
          {"@graph", graph}};
}

/// A line of sha256sum: a name with a line's end in it has that, and every backslash, as an escape,
/// and the line begins with a backslash (GNU coreutils, "md5sum invocation").
std::string manifest_line(const std::string& path, const Digest& digest) {
  if (path.find_first_of("\n\r") == std::string::npos)
    return fmt::format("{}  {}\n", digest.sha256, path);
  std::string escaped;
  for (const char c : path)
    escaped += c == '\n' ? "\\n" : c == '\r' ? "\\r" : c == '\\' ? "\\\\" : std::string(1, c);
  return fmt::format("\\{}  {}\n", digest.sha256, escaped);
}

std::string manifest(const std::vector<PackedFile>& files, const std::vector<Digest>& digests) {
  std::string text;
  for (std::size_t i = 0; i < files.size(); ++i) text += manifest_line(files[i].path, digests[i]);
  return text;
}

}  // namespace

std::vector<PackedFile> pack_texts(const PastRun& run, const Study& study,
                                   const PackedRun& packed) {
  std::vector<PackedFile> texts{
      {.path = "run.sh", .text = run_script(run, study, packed), .executable = true},
      {.path = "README.md", .text = readme(run, study)},
      {.path = "CITATION.cff", .text = citation(study)},
      {.path = "versions.json", .text = json_text(versions(run), 1) + "\n"}};
  std::vector<PackedFile> all = packed.files;
  all.insert(all.end(), texts.begin(), texts.end());
  std::vector<Digest> digests;
  std::ranges::transform(all, std::back_inserter(digests), digest_of);
  texts.push_back({.path = "manifest.sha256", .text = manifest(all, digests)});
  all.push_back(texts.back());
  digests.push_back(digest_of(all.back()));
  texts.push_back({.path = "ro-crate-metadata.json",
                   .text = json_text(crate(run, study, all, digests), 1) + "\n"});
  return texts;
}

}  // namespace pellucid::compare
