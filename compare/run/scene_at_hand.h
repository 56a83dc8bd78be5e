// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compare/cells/cell.h"
#include "compare/measures/ray_facts.h"
#include "scene/elements/frame_memory.h"

namespace pellucid::compare {

/// A SceneAtHand is a scene from one view after another, and its reference, loaded when the first
/// cell asks for them. A scene is read, and its surfaces are integrated, once for all views.
class SceneAtHand {
 public:
  SceneAtHand(std::filesystem::path file, const Study& study, const scene::RenderContext& context)
      : file_(std::move(file)), study_(study), context_(context) {}

  /// Returns the number of views. Throws InputError for a path that the scene has not.
  std::size_t view_count();
  /// Looks from another view, counted from 0; the scene from the last one ends.
  void look_from(std::size_t view);
  std::size_t view() const { return view_; }
  const scene::RenderContext& context() const { return context_; }
  /// Returns the scene from this view, with optimized opacities where the study asks for them.
  /// Those of a camera path keep of those of the views before what their method keeps from frame to
  /// frame, whichever view was looked from last.
  const scene::Scene& scene();

  /// Takes the reference's pictures from its files, so that every run of a cell compares with the
  /// same bits.
  void set_reference(const CellFiles& files) { reference_files_ = files; }
  const Image& reference();
  const CountImage& reference_layers();
  bool has_reference_layers() const;
  /// Returns what the scene's rays tell from this view; asked once.
  const RayFacts& ray_facts();

  /// Counts what the reference was made of for the cells that are compared with it.
  void reads_also(std::map<std::string, std::string> files) {
    files_of_reference_ = std::move(files);
  }
  /// Returns what has been read to draw the scene and its reference, with the hash of its content.
  std::map<std::string, std::string> files_read();

 private:
  scene::Scene& loaded();
  scene::Scene seen_from(std::size_t view);
  void optimize(scene::Scene& scene);
  CellFiles files() const { return reference_files_->from(view_); }

  FilesRead read_;
  ContentHashes hashes_;
  std::map<std::string, std::string> files_of_reference_;
  std::filesystem::path file_;
  const Study& study_;
  const scene::RenderContext& context_;
  std::optional<scene::Scene> loaded_;  // as its file has it; optimized where there is one view
  std::vector<scene::Camera> cameras_;  // of the views; empty: the scene's own
  std::optional<scene::Scene> seen_;    // from this view, where that is not `loaded_`
  std::size_t view_ = 0;
  scene::FrameMemory memory_;   // of the opacities along a camera path
  std::size_t remembered_ = 0;  // so many of its views
  std::optional<CellFiles> reference_files_;
  Image reference_;
  CountImage layers_;
  std::optional<RayFacts> rays_;
};

}  // namespace pellucid::compare
