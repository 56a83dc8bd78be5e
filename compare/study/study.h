// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/methods/method_call.h"
#include "compare/methods/surface_methods.h"
#include "compare/study/claims.h"
#include "compare/study/costs.h"
#include "compare/study/growth.h"
#include "compare/study/ladders.h"
#include "compare/study/needs.h"
#include "compare/study/screen_rule.h"
#include "compare/timing/timing_rule.h"
#include "scene/renderer.h"

namespace pellucid::compare {

/// In its column and row, from the top left.
struct Pixel {
  int x = 0, y = 0;
};

/// A part of a picture, in pixels from the top left.
struct Crop {
  int x = 0, y = 0, width = 0, height = 0;
};

/// Views are the cameras from which each of a study's scenes is seen; none of the three: its own.
struct Views {
  int orbit = 0;                       // so many at equal angles around the camera's target
  std::vector<scene::Camera> cameras;  // these
  bool path = false;                   // the scene's camera path

  /// Returns whether there are any but the scene's own.
  bool any() const { return orbit > 0 || path || !cameras.empty(); }
};

/// The stages of an error budget, in the order of budget_stages().
inline constexpr std::array<std::string_view, 8> budget_stage_names{
    "field", "integration", "mesh", "samples", "opacities", "compositing", "arithmetic", "display"};

/// What claims and tables call the part of an error that is no single stage's.
inline constexpr std::string_view interaction_name = "interaction";

/// BudgetOptions say how much finer the stages of an error budget are made; see docs/evaluation.md.
struct BudgetOptions {
  std::string field;  // the formula that a sampled field was sampled from; empty: not known
  int samples = 4;    // per axis of a pixel, 2 … 16
  double factor = 4;  // by which the lengths of meshes and lines become shorter, 2 … 64
};

/// A study file: scenes × methods × parameters against one reference.
struct Study {
  std::string name;  // the file's stem
  std::string title;
  std::string source;              // the figure or table that it reproduces
  std::vector<std::string> notes;  // what a reader of its results has to know, a paragraph each
  std::filesystem::path file;
  std::vector<std::filesystem::path> scenes;
  std::vector<LeftOutScene> left_out;  // not among the scenes, since their data are missing
  MethodCall reference;
  /// All calls composite the opacities of least energy that this one finds; see
  /// optimize_opacities().
  std::optional<MethodCall> opacities;
  /// The reference draws these in place of the scenes of these names: of lines that stand for a
  /// surface, the surface.
  std::map<std::string, std::filesystem::path> reference_scenes;
  std::vector<MethodCall> methods;  // sweeps expanded; without the reference; integrators first
  int repeats = 3;
  std::optional<TimingRule> timing;  // in place of the repeats; cells of a scene are interleaved
  std::optional<ScreenRule> screen;  // which calls are not drawn in full
  Views views;
  std::map<std::string, Crop> crops;                 // by scene
  std::vector<Claim> claims;                         // of the source
  std::vector<Ladder> ladders;                       // where does each method break?
  std::vector<Growth> growth;                        // how do its costs grow?
  std::vector<std::string> measures;                 // names of StudyMeasure, for each picture
  std::map<std::string, std::vector<Pixel>> probes;  // by scene: rays to look along
  std::optional<BudgetOptions> budget;               // of each picture's error
  std::optional<PublishedCosts> published;           // times and bytes that the source printed
};

/// Returns how often each cell is timed: by its `timing`, or `repeats` times.
TimingRule timing_of(const Study& study);

/// Reads a study file ("pellucid-study", version 1) and expands its sweeps. A method is
/// "NAME[:key=value,…]", {"method": NAME, key: value or [values], …}, or "*": every method in all
/// the settings of its row; or a picture from elsewhere, see read_given(). The entries of
/// "integrators" are written alike, of the other table, and come before the methods. Scenes are
/// relative to the file. Throws InputError that names file, key and accepted values, also for
/// scenes that are not there.
Study load_study(const std::filesystem::path& file, std::span<const scene::MethodRow> methods,
                 std::span<const scene::MethodRow> integrators = surface_methods());

/// A scene's name in cells, tables and paths: its file's stem.
std::string scene_name(const std::filesystem::path& scene);

/// The file of a study given by its path, or by its name in ./studies, in the current folder or
/// among those that come with the program. Throws InputError with the nearest names.
std::filesystem::path find_study(std::string_view name_or_file);

/// The names of its scenes, in their order.
std::vector<std::string> scene_names(const Study& study);

/// A StudySummary is what `list studies` tells of a study.
struct StudySummary {
  std::string name, title, source;
  std::filesystem::path file;
};

/// The studies that come with the program, by name.
std::vector<StudySummary> list_studies();

}  // namespace pellucid::compare
