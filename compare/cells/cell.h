// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compare/methods/given_method.h"
#include "compare/results/result_row.h"
#include "compare/study/study.h"
#include "core/files/files_read.h"

namespace pellucid::compare {

/// A Cell is one scene × one method × one set of parameters.
struct Cell {
  std::filesystem::path scene_file;
  std::string scene;
  MethodCall call;
  bool reference = false;
  std::vector<std::string> measures = {};              // names of StudyMeasure
  std::vector<Pixel> probes = {};                      // rays to look along
  std::optional<MethodCall> opacities = std::nullopt;  // see Study
  /// Where there are such: those of all calls of the study, see further_samplings().
  std::vector<scene::PixelSampling> further_samplings = {};
  GivenPlace place = {};  // of a picture from elsewhere
  Views views = {};
  std::optional<BudgetOptions> budget = std::nullopt;
  std::filesystem::path reference_scene = {};  // that the reference draws; `scene_file` mostly

  /// Returns "abc/fourier:bands=5", for messages and for --only.
  std::string name() const { return scene + "/" + call.text(); }
};

/// Returns further_samplings() of all calls of a study that composite optimized opacities; of
/// another study none.
std::vector<scene::PixelSampling> further_samplings(const Study& study);

/// Returns the cells of a study, scene by scene, in each the reference first.
std::vector<Cell> expand_cells(const Study& study);

/// CellFiles say where a cell leaves what it made, below a study's folder. Cells share no file.
class CellFiles {
 public:
  CellFiles(std::filesystem::path folder, const Cell& cell);
  /// Stands for the cell of a row that some run has left in its folder.
  CellFiles(std::filesystem::path folder, const ResultRow& row);

  std::filesystem::path picture() const { return image(".exr"); }  // 32-bit float
  std::filesystem::path preview() const { return image(".png"); }
  std::filesystem::path error_map() const { return image(".error.png"); }
  std::filesystem::path flip_map() const { return image(".flip.png"); }
  /// Returns the path of one of the method's further pictures.
  std::filesystem::path further(std::string_view name) const;
  std::filesystem::path layers() const { return image(".layers.exr"); }
  /// Returns the folder in which an external command runs and leaves what it prints.
  std::filesystem::path given() const { return folder_ / "given" / scene_ / slug_; }
  /// Returns the files of the pictures from one of the study's views, counted from 0: that of the
  /// first has no number in its names.
  CellFiles from(std::size_t view) const;
  /// Returns the paths of all pictures that the cell of this row may have made, in every view.
  std::vector<std::filesystem::path> pictures_of(const ResultRow& row) const;
  /// Returns the path of the row, which is written last and lists the others: where it is they are.
  std::filesystem::path row() const;
  /// Returns the path of a FileLock for who computes the cell alone.
  std::filesystem::path lock() const;

  /// Makes the folders of all these files. Throws InputError when they cannot be made.
  void make_folders() const;

 private:
  std::filesystem::path image(std::string_view ending) const;

  std::filesystem::path folder_;
  std::string scene_, slug_, view_;
};

/// Returns whether the file is there and holds something: a disk that was full has left others.
bool holds_something(const std::filesystem::path& file);

/// Returns the row of a cell that nothing is known of yet: its names and parameters.
ResultRow identity_row(const Cell& cell);

/// Returns a hash of what a cell is asked to do: the texts of its scene and of the reference's, the
/// method and the reference with all their parameters, what optimizes opacities and for which
/// samples, its measures and probes, its views, how often it is timed, and where OpenGL runs. What
/// it reads beside the scenes' files, its row lists. Throws InputError when one of them cannot be
/// read.
std::string cell_fingerprint(const Cell& cell, const MethodCall& reference,
                             const TimingRule& timing, const scene::RenderContext& context);

/// Reads the row of a cell, finished or failed, by whichever run, for the same fingerprint and from
/// files whose content is as it was; nothing when there is none or a finished one has lost one of
/// its files.
std::optional<ResultRow> read_row(const CellFiles& files, const std::string& fingerprint,
                                  ContentHashes& hashes);

/// Reads the row of a cell as read_row() does, but of one that was finished without an error.
std::optional<ResultRow> read_finished(const CellFiles& files, const std::string& fingerprint,
                                       ContentHashes& hashes);

/// Writes the row as JSON, with the names of the files that the cell has made, whole or not at all.
/// Throws as OutputFile does.
void write_row(const CellFiles& files, const ResultRow& row);

}  // namespace pellucid::compare
