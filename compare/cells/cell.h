// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compare/results/result_row.h"
#include "compare/study/study.h"

namespace pellucid::compare {

/// One scene × one method × one set of parameters.
struct Cell {
  std::filesystem::path scene_file;
  std::string scene;
  MethodCall call;
  bool reference = false;
  std::vector<std::string> measures = {};  // names of FurtherMeasure
  std::vector<Pixel> probes = {};          // rays to look along

  /// "abc/fourier:bands=5", for messages and for --only.
  std::string name() const { return scene + "/" + call.text(); }
};

/// Scene by scene, in each the reference first.
std::vector<Cell> expand_cells(const Study& study);

/// Where a cell leaves what it made, below a study's folder. Cells share no file.
class CellFiles {
 public:
  CellFiles(std::filesystem::path folder, const Cell& cell);

  std::filesystem::path picture() const { return image(".exr"); }  // 32-bit float
  std::filesystem::path preview() const { return image(".png"); }
  std::filesystem::path error_map() const { return image(".error.png"); }
  /// One of the method's further pictures.
  std::filesystem::path further(std::string_view name) const;
  std::filesystem::path layers() const { return image(".layers.exr"); }
  /// Written last: where it is, all the others are.
  std::filesystem::path row() const;

  void make_folders() const;

 private:
  std::filesystem::path image(std::string_view ending) const;

  std::filesystem::path folder_;
  std::string scene_, slug_;
};

/// The row of a cell that nothing is known of yet: its names and parameters.
ResultRow identity_row(const Cell& cell);

/// A hash of the scene's file and of all files that it names.
std::string scene_fingerprint(const std::filesystem::path& scene_file);

/// A hash of all that the cell's row depends on, times aside: the scene, the method and the
/// reference with all their parameters, and where OpenGL runs.
std::string cell_fingerprint(const std::string& scene_fingerprint, const Cell& cell,
                             const MethodCall& reference, const scene::RenderContext& context);

/// The row of a cell that was finished, by whichever run, for the same fingerprint.
std::optional<ResultRow> read_finished(const CellFiles& files, const std::string& fingerprint);

void write_row(const CellFiles& files, const ResultRow& row);

}  // namespace pellucid::compare
