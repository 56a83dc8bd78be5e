// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cells/cell.h"

#include <fmt/format.h>

#include "compare/methods/optimize_opacities.h"
#include "compare/results/measure_columns.h"
#include "core/error.h"
#include "core/files/output_file.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

/// FNV-1a, 64 bits, over fields that can't run into one another.
class Hash {
 public:
  void add(std::string_view text) {
    for (const char c : text) mix(std::uint8_t(c));
    for (std::uint64_t size = text.size(), i = 0; i < 8; ++i) mix(std::uint8_t(size >> (8 * i)));
  }
  std::string hex() const { return fmt::format("{:016x}", value_); }

 private:
  void mix(std::uint8_t byte) { value_ = (value_ ^ byte) * 1099511628211u; }
  std::uint64_t value_ = 14695981039346656037u;
};

void add_call(const MethodCall& call, Hash& hash) {
  hash.add(call.row->name);
  for (const auto& [key, value] : call.parameters.all_as_given()) {
    hash.add(key);
    hash.add(value);
  }
}

std::string vec_text(const Vec3& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }

std::string text_of(const Views& views) {
  std::string text = fmt::format("{} {}", views.orbit, views.path);
  for (const scene::Camera& c : views.cameras)
    text += fmt::format(" {} {} {} {} {} {}", int(c.projection), vec_text(c.eye),
                        vec_text(c.target), vec_text(c.up), c.fov, c.height);
  return text;
}

const fs::path& reference_scene_of(const Study& study, const fs::path& scene) {
  const auto own = study.reference_scenes.find(scene_name(scene));
  return own == study.reference_scenes.end() ? scene : own->second;
}

}  // namespace

bool holds_something(const fs::path& file) {
  std::error_code code;
  return fs::file_size(file, code) > 0 && !code;
}

std::vector<scene::PixelSampling> further_samplings(const Study& study) {
  if (!study.opacities) return {};
  std::vector<MethodCall> calls = study.methods;
  calls.push_back(study.reference);
  return further_samplings(calls);
}

std::vector<Cell> expand_cells(const Study& study) {
  std::vector<Cell> cells;
  for (const fs::path& scene : study.scenes) {
    const std::string name = scene_name(scene);
    const auto probes = study.probes.find(name);
    Cell cell{reference_scene_of(study, scene), name, study.reference, true, study.measures};
    cell.reference_scene = cell.scene_file;
    if (probes != study.probes.end()) cell.probes = probes->second;
    cell.opacities = study.opacities;
    cell.further_samplings = further_samplings(study);
    cell.views = study.views;
    cell.budget = study.budget;
    cells.push_back(cell);
    cell.reference = false;
    cell.scene_file = scene;
    for (const MethodCall& call : study.methods) {
      cell.call = call;
      cells.push_back(cell);
    }
  }
  return cells;
}

CellFiles::CellFiles(fs::path folder, const Cell& cell)
    : folder_(std::move(folder)), scene_(cell.scene), slug_(cell.call.slug()) {}

CellFiles::CellFiles(fs::path folder, const ResultRow& row)
    : folder_(std::move(folder)), scene_(row.scene), slug_(slug_of(row.call())) {}

fs::path CellFiles::image(std::string_view ending) const {
  return folder_ / "images" / scene_ / fmt::format("{}{}{}", slug_, view_, ending);
}

fs::path CellFiles::further(std::string_view name) const {
  return image(fmt::format(".{}.png", name));
}

std::vector<fs::path> CellFiles::pictures_of(const ResultRow& row) const {
  std::vector<fs::path> paths;
  const auto views = std::size_t(measure_of(row, "views").value_or(1));
  for (std::size_t view = 0; view < views; ++view) {
    const CellFiles files = from(view);
    for (const fs::path& path :
         {files.picture(), files.preview(), files.layers(), files.error_map(), files.flip_map()})
      paths.push_back(path);
    for (const RowPicture& picture : row.pictures) paths.push_back(files.further(picture.name));
  }
  return paths;
}

CellFiles CellFiles::from(std::size_t view) const {
  CellFiles files = *this;
  if (view > 0) files.view_ = fmt::format(".view-{}", view + 1);
  return files;
}

fs::path CellFiles::row() const { return folder_ / "cells" / scene_ / (slug_ + ".json"); }

fs::path CellFiles::lock() const {
  return folder_ / "cells" / scene_ / fmt::format(".{}.lock", slug_);
}

void CellFiles::make_folders() const {
  for (const fs::path& path : {picture().parent_path(), row().parent_path()}) {
    std::error_code code;
    fs::create_directories(path, code);
    if (code)
      throw InputError(
          fmt::format("{}: cannot make the folder: {}", path.string(), code.message()));
  }
}

ResultRow identity_row(const Cell& cell) {
  ResultRow row;
  row.scene = cell.scene;
  row.method = cell.call.row->name;
  row.parameters = cell.call.parameters.given();
  row.parameter_values = cell.call.parameters.all_as_given();
  row.reference = cell.reference;
  if (cell.call.given) row.given = cell.call.given->kind();
  return row;
}

std::string cell_fingerprint(const Cell& cell, const MethodCall& reference,
                             const TimingRule& timing, const scene::RenderContext& context) {
  Hash hash;
  for (const fs::path& file : {cell.scene_file, cell.reference_scene}) hash.add(read_text(file));
  add_call(cell.call, hash);
  if (cell.call.given) hash.add(cell.call.given->fingerprint(cell.scene, cell.place.view));
  add_call(reference, hash);
  if (cell.opacities) add_call(*cell.opacities, hash);
  for (const scene::PixelSampling& sampling : cell.further_samplings)
    hash.add(scene::describe(sampling));
  hash.add(fmt::format("{} {} {}", timing.min, timing.max, timing.relative.value_or(0)));
  if (timing.seconds) hash.add(fmt::format("seconds {}", *timing.seconds));
  hash.add(context.gl);
  for (const std::string& measure : cell.measures) hash.add(measure);
  hash.add(text_of(cell.views));
  for (const Pixel& pixel : cell.probes) hash.add(fmt::format("{} {}", pixel.x, pixel.y));
  if (const auto& b = cell.budget)
    hash.add(fmt::format("budget {} {} {}", b->field, b->samples, b->factor));
  return hash.hex();
}

}  // namespace pellucid::compare
