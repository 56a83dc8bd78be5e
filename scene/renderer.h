// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/options/parameters.h"
#include "core/progress.h"
#include "core/raster.h"
#include "scene/elements/optimized_opacities.h"
#include "scene/parts/partial_sums.h"
#include "scene/parts/scene_part.h"
#include "scene/scene.h"
#include "scene/view_depth.h"

namespace pellucid::scene {

struct FrameMemory;

/// A StepTime is how long one step of a method took.
struct StepTime {
  std::string name;
  double seconds = 0;  // wall clock, GL work finished
  /// By the driver's own clock; nothing where it has none, or the step is not OpenGL's.
  std::optional<double> gl_seconds = std::nullopt;

  /// Adds the times of the same step.
  StepTime& operator+=(const StepTime& other);
};

/// A NamedBytes is the size of one thing that a method allocated.
struct NamedBytes {
  std::string name;
  std::uint64_t bytes = 0;
};

/// A FrameStats says where a progressive method stands after one of its frames; sums are from the
/// first frame on.
struct FrameStats {
  double seconds = 0;           // sum, wall clock
  std::uint64_t lines = 0;      // of this frame
  std::uint64_t fragments = 0;  // sum
  std::uint64_t layers = 0;     // sum, of all pixels
  std::uint64_t bytes = 0;      // allocated by now
  double change = 0;            // of the picture by this frame: root mean square over RGB
};

/// RenderStats say what a picture took. Bytes are those a method allocates beyond the scene's own
/// geometry and the final picture, counted at the allocation.
struct RenderStats {
  std::vector<StepTime> steps;
  std::vector<NamedBytes> bytes;
  std::uint64_t fragments = 0;     // crossings seen
  std::uint64_t stored = 0;        // of them kept apart by depth; the others were summed up
  std::uint64_t dropped = 0;       // of them that did not reach the picture
  std::uint64_t truncated = 0;     // pixels that lost some of theirs
  std::uint32_t max_layers = 0;    // crossings in one pixel
  std::vector<FrameStats> frames;  // of a progressive method

  /// Returns the sum of all steps, in seconds.
  double seconds() const;
  /// Returns the sum of the steps that are OpenGL's by the driver's own clock, in seconds; nothing
  /// where there is none.
  std::optional<double> gl_seconds() const;
  std::uint64_t total_bytes() const;
};

/// A Rendering is a picture and what it took; row 0 of both rasters is the top.
struct Rendering {
  Image image;
  RenderStats stats;
  CountImage layers;  // crossings per pixel; empty unless asked for
};

/// A RenderRequest says what a renderer makes beside the picture.
struct RenderRequest {
  /// Asks for Rendering::layers and for all of the stats that is counted; none of it is timed.
  bool layers = false;
  /// Says which of its pictures a method of random numbers draws, each by others; those of all
  /// other methods are the same picture.
  std::uint32_t draw = 0;
  /// Is told how far the picture is, and may end it by what it throws: a renderer can make another
  /// one after that.
  Progress progress = {};
};

/// A Measure is a number that only some methods have, such as the triangles of a surface: a column
/// of a study's tables.
struct Measure {
  /// Better says which of two values is to be preferred.
  enum class Better { lower, higher, neither };

  std::string name;   // of the column: "distance_max"
  std::string title;  // for people: "Largest distance"
  std::string unit;   // empty: a plain number
  double value = 0;   // in `unit`
  Better better = Better::neither;
};

/// A MeasurePicture is a further picture, which colours a number by a logarithmic scale.
struct MeasurePicture {
  std::string name;         // of the file: "distance"
  std::string title;        // for people, unit included
  double min = 0, max = 1;  // the ends of the scale
  Image image;
};

/// Findings are what a method knows of the picture that it made last, beside the picture.
struct Findings {
  std::vector<Measure> measures;
  std::vector<MeasurePicture> pictures;
};

/// A RaySum is a sum over the fragments of a pixel's ray, from the nearest to a depth.
enum class RaySum {
  optical_depth,  // τ(d) = Σ -ln(1 - α_i), Eq. 14 of Baeza Rojo et al. 2019
  importance      // G(d) = Σ g_i², Eq. 11
};

/// A RaySeries is such a sum as a method approximated it for its last picture; without a unit.
struct RaySeries {
  std::vector<double> values;                        // at the depths that were asked for
  std::vector<std::pair<double, double>> harmonics;  // a_k, b_k of a Fourier series, k from 0
};

/// A Renderer is one method over one scene: made once (geometry uploaded, hierarchies built),
/// rendered as often as a timing needs. The scene has to outlive it.
class Renderer {
 public:
  virtual ~Renderer() = default;
  /// Makes the picture. Throws WorkError when it cannot be made.
  virtual Rendering render(const RenderRequest& request) = 0;
  /// Returns what was modelled for this scene, what was left out, and why; a line each.
  virtual std::vector<std::string> explain() const = 0;
  /// Returns facts for the provenance of a result: "driver", "embree", …
  virtual std::map<std::string, std::string> facts() const { return {}; }
  /// Measures the last picture when asked for; this is not timed.
  virtual Findings findings() { return {}; }
  /// Returns the sum at the depths `d` in [0, 1] of the pixel in column x, row y (0 at the top).
  /// Nothing where the method has no such function, or has not rendered yet.
  virtual std::optional<RaySeries> ray_series(RaySum /*sum*/, int /*x*/, int /*y*/,
                                              std::span<const double> /*d*/) {
    return std::nullopt;
  }
  /// Returns the opacities of least energy that it found for its last picture. Nothing where it
  /// finds none, finds one for each fragment, or has not rendered yet.
  virtual std::optional<OptimizedOpacities> optimized_opacities() { return std::nullopt; }
  /// Returns what draws a part of a scene by this method, as long as the renderer lives; null where
  /// its pictures are no sums. Throws InputError for parameters by which they are none.
  virtual PartialSums* partial_sums() { return nullptr; }
};

/// A RenderContext is what a method is given beside its scene.
struct RenderContext {
  std::string gl = "osmesa";      // "osmesa", "egl", "egl:N", "egl:software"
  FrameMemory* memory = nullptr;  // along a camera path; has to outlive the renderer
  /// Of the whole, where the scene is a part of one; has to outlive the renderer, as what follows.
  const DepthRange* depths = nullptr;
  const PartNumber* part = nullptr;  // which: an isosurface stays as it is, see cut_object()
  /// What PartialSums::behind() returned of a part, in the place of opaque objects.
  const Image* behind = nullptr;
};

/// Promises are what a row of the method table promises of the picture by its default settings, and
/// by others where it says so; property tests hold every row to them (tests/compare/methods/).
struct Promises {
  /// The picture equals the exact composite, up to float rounding and `edge_shift`: in every scene,
  /// in scenes without isosurfaces, without importance, or without lines and integrated surfaces.
  bool exact = false;
  bool exact_without_isosurfaces = false;
  bool exact_without_importance = false;
  bool exact_without_lines = false;
  /// Parameters, "a|b", of which any value but the default takes exactness away; no other does.
  std::string_view exact_unless = {};
  /// The parameter that tells how many layers of a pixel are kept apart. A pixel that has no more
  /// of them is exact, and bit-equal for any order of primitives; RenderStats::stored counts them.
  std::string_view exact_layers = {};

  bool own_layers = false;  // Rendering::layers are what it made of the fragments, near the truth
  bool order_independent = false;  // bit-equal for any order of primitives
  /// If not: the largest change of a pixel under shuffled primitives, of up to a thousand layers,
  /// since sums in float take a rounding of 6e-8 for each.
  double order_spread = 0;
  bool convex_hull = false;   // colours stay in the hull of fragment and background colours
  bool fixed_memory = false;  // bytes depend on the picture alone, not on the scene
  bool in_double = false;     // from the crossings to the picture
  /// The method chooses opacities itself where a scene has importance: what it differs by from the
  /// exact composite is meant, no error. Other rows leave importance out.
  bool optimizes_opacity = false;
  /// It chooses one opacity for each vertex, so that other methods can composite the same: where a
  /// scene has importance, Renderer::optimized_opacities() returns them, by default settings.
  bool optimizes_vertices = false;
  /// Its pictures are made of sums over fragments (see PartialSums): parts of a scene add up to the
  /// whole, up to twice `order_spread`.
  bool adds_up = false;
  /// Pictures are made by random numbers, which hang on depths and samples: of the same scene
  /// sampled or placed otherwise only the picture's mean is the same.
  bool random = false;
  /// The setting, "a=b", by which even a single layer is not the truth; by all others it is.
  std::string_view one_layer_unless = {};
  /// A pixel's centre that lies farther from a primitive's edge, in pixels, is covered if and only
  /// if it lies inside. By default what rasterization in 1/256 pixel leaves.
  double edge_shift = 1.0 / 256;
  /// A rounding of the depths to float changes no colour by more, but where it changes an order.
  float change_by_rounding = 1e-3f;
};

/// A MethodRow is one row of the method table.
struct MethodRow {
  std::string_view name;
  std::string_view title;
  std::string_view citation;
  std::string_view equations;  // which of the citation's equations it implements
  /// The method was compared with this in writing it: the paper, or what stood in for the paper.
  std::string_view checked_against = {};
  std::span<const ParameterSpec> parameters;
  Promises promises;
  std::string_view bytes_per_pixel;  // formula, for people
  /// These are the settings between which a user picks by cost and error, all combinations of the
  /// values: "bands=1|2|5,precision=32|16". Empty: the defaults alone.
  std::string_view sweep = {};
  std::unique_ptr<Renderer> (*make)(const Scene&, const Parameters&, const RenderContext&);
};

}  // namespace pellucid::scene
