// SPDX-License-Identifier: GPL-3.0-or-later
// A ray through each of a pixel's samples, all its crossings found in one traversal, ordered by
// depth, object and primitive, and composited front to back in double.

#include "groundtruth/methods/raytracer.h"

#include <fmt/format.h>
#include <tbb/blocked_range2d.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/task_arena.h>

#include <atomic>

#include "core/error.h"
#include "core/machine/stopwatch.h"
#include "core/parallel.h"
#include "groundtruth/shapes/crossing_geometry.h"
#include "groundtruth/sums/composite.h"
#include "groundtruth/sums/pixel_contrast.h"
#include "groundtruth/traversal/crossing_finder.h"
#include "groundtruth/traversal/embree.h"
#include "scene/view/pixel_samples.h"
#include "scene/view_depth.h"

namespace pellucid::groundtruth {
namespace {

constexpr int packet_columns = 4, packet_rows = 4;  // pixels whose rays are traced together
constexpr int tile = 16;  // pixels; neighbours share the path through the hierarchy

void check_adaptive(const scene::Scene& scene, const RaytraceOptions& options) {
  const std::size_t everywhere = scene::pixel_samples(scene.samples).size();
  if (options.adaptive > 1 && std::size_t(options.adaptive) * options.adaptive <= everywhere)
    throw InputError(fmt::format(
        "adaptive={}: the scene takes {} samples a pixel everywhere; accepted: more of them",
        options.adaptive, everywhere));
}

class Raytracer : public TurningRaytracer {
 public:
  Raytracer(const scene::Scene& scene, const RaytraceOptions& options, CrossingFinder finder)
      : scene_(scene),
        finder_(std::move(finder)),
        options_(options),
        samples_(scene::pixel_samples(scene.samples)),
        more_samples_(scene::pixel_samples({.per_axis = options.adaptive})) {}

  scene::Rendering render(const scene::RenderRequest& request) override {
    tbb::enumerable_thread_specific<Buffers> crossings;
    scene::Rendering result = draw({0, scene_.height}, request.layers, crossings, request.progress);
    if (options_.adaptive > 1) {
      const Stopwatch again;
      result.stats.fragments += refine(crossings, result);
      result.stats.stored = result.stats.fragments;
      result.stats.steps.push_back({"refine", again.seconds()});
    }
    result.stats.bytes = bytes(crossings);
    return result;
  }

  scene::RenderStats render_rows(int rows, const TakeRows& take,
                                 const Progress& progress) override {
    if (options_.adaptive > 1)
      throw InputError("adaptive: looks at all of a picture; accepted: adaptive=1");
    tbb::enumerable_thread_specific<Buffers> crossings;
    scene::RenderStats stats;
    double seconds = 0;
    for (int first = 0; first < scene_.height; first += rows) {
      const int end = std::min(first + rows, scene_.height);
      const double height = scene_.height;
      scene::Rendering drawn = draw({first, end}, true, crossings,
                                    part_of(progress, first / height, end / height, "tracing"));
      seconds += drawn.stats.seconds();
      stats.fragments += drawn.stats.fragments;
      stats.max_layers = std::max(stats.max_layers, drawn.stats.max_layers);
      take(first, drawn.image);
    }
    stats.stored = stats.fragments;
    stats.steps = {{"trace", seconds}};
    stats.bytes = bytes(crossings);
    return stats;
  }

  void turn() override {
    check_adaptive(scene_, options_);
    finder_.turn();
    samples_ = scene::pixel_samples(scene_.samples);
  }

  std::vector<std::string> explain() const override {
    std::vector<std::string> lines{
        fmt::format("hierarchy over {}; no GL context", scene::describe_primitives(scene_)),
        scene::describe(scene_.samples)};
    if (options_.adaptive > 1)
      lines.push_back(fmt::format(
          "{0} x {0} samples where pixels differ from a neighbour by more than {1}: {2} of {3}",
          options_.adaptive, options_.contrast, refined_, scene_.width * scene_.height));
    if (options_.stop_below > 0)
      lines.push_back(fmt::format("rays end where less than {} shows: no pixel errs by more",
                                  options_.stop_below));
    lines.push_back(scene::is_lit(scene_) ? "normals: objects are lit from the eye"
                                          : "no normals: nothing is lit");
    return lines;
  }

  std::map<std::string, std::string> facts() const override {
    return {{"embree", RTC_VERSION_STRING}};
  }

 private:
  using Buffers = std::array<std::vector<Crossing>, RayPacket::width>;

  /// Of all threads that may take part, each with lists for the deepest ray: which threads did, and
  /// which rays each met, is chance.
  static std::uint64_t crossing_bytes(const tbb::enumerable_thread_specific<Buffers>& crossings) {
    std::size_t longest = 0;
    for (const Buffers& buffers : crossings)
      for (const auto& buffer : buffers) longest = std::max(longest, buffer.capacity());
    const auto threads = std::uint64_t(tbb::this_task_arena::max_concurrency());
    return threads * RayPacket::width * longest * sizeof(Crossing);
  }

  std::vector<scene::NamedBytes> bytes(
      const tbb::enumerable_thread_specific<Buffers>& crossings) const {
    return {{"hierarchy", finder_.bytes()}, {"crossings", crossing_bytes(crossings)}};
  }

  struct Interval {
    int begin, end;
  };

  struct PixelSum {
    glm::dvec4 rgba{0};
    std::uint64_t crossings = 0;
    std::uint32_t layers = 0;  // of the sample that has most
  };

  /// Traces some of the picture's rows, which are all that the result has.
  scene::Rendering draw(const Interval& rows, bool layers,
                        tbb::enumerable_thread_specific<Buffers>& crossings,
                        const Progress& progress) const {
    scene::Rendering result;
    result.image = Image(scene_.width, rows.end - rows.begin);
    if (layers) result.layers = CountImage(result.image.width, result.image.height);
    std::atomic<std::uint64_t> fragments = 0;
    CountedProgress traced(progress, result.image.pixels.size(), "tracing");
    const Stopwatch watch;
    parallel_ranges(tbb::blocked_range2d<int>(rows.begin, rows.end, tile, 0, scene_.width, tile),
                    [&](const tbb::blocked_range2d<int>& range) {
                      fragments += trace(range, crossings.local(), rows.begin, result);
                      traced.add(range.rows().size() * range.cols().size());
                    });
    result.stats.steps = {{"trace", watch.seconds()}};
    for (const std::uint32_t count : result.layers.pixels)
      result.stats.max_layers = std::max(result.stats.max_layers, count);
    result.stats.fragments = result.stats.stored = fragments;
    return result;
  }

  /// Traces the pixels of a tile; returns the number of crossings. The result begins with row
  /// `top`.
  std::uint64_t trace(const tbb::blocked_range2d<int>& range, Buffers& crossings, int top,
                      scene::Rendering& result) const {
    std::uint64_t count = 0;
    for (int y = range.rows().begin(); y < range.rows().end(); y += packet_rows)
      for (int x = range.cols().begin(); x < range.cols().end(); x += packet_columns)
        count += trace_packet({x, std::min(x + packet_columns, range.cols().end())},
                              {y, std::min(y + packet_rows, range.rows().end())}, crossings, top,
                              result);
    return count;
  }

  /// Traces the rays of a few pixels together, sample by sample.
  std::uint64_t trace_packet(const Interval& x, const Interval& y, Buffers& crossings, int top,
                             scene::Rendering& result) const {
    const int columns = x.end - x.begin, rows = y.end - y.begin;
    std::array<PixelSum, RayPacket::width> sums;
    std::array<PictureRay, RayPacket::width> packet;
    const std::span rays = std::span(packet).first(static_cast<std::size_t>(columns) * rows);
    for (const Vec2& sample : samples_) {
      for (std::size_t k = 0; k < rays.size(); ++k) {
        const int column = int(k) % columns, row = int(k) / columns;
        rays[k] = finder_.frame().ray(x.begin + column + sample.x, y.begin + row + sample.y);
      }
      finder_.find(rays, std::span(crossings).first(rays.size()));
      for (std::size_t k = 0; k < rays.size(); ++k) add_sample(rays[k], crossings[k], sums[k]);
    }
    std::uint64_t count = 0;
    for (std::size_t k = 0; k < rays.size(); ++k) {
      const std::size_t pixel =
          std::size_t(y.begin + int(k) / columns - top) * scene_.width + x.begin + int(k) % columns;
      count += store(sums[k], samples_.size(), pixel, result);
    }
    return count;
  }

  /// Traces again the pixels that differ from a neighbour, those that then differ, and so on.
  /// Returns the number of crossings.
  std::uint64_t refine(tbb::enumerable_thread_specific<Buffers>& crossings,
                       scene::Rendering& result) {
    std::atomic<std::uint64_t> count = 0;
    refined_ = 0;
    std::vector<bool> marked(result.image.pixels.size());
    for (;;) {
      const auto pixels = mark_contrasts(result.image, options_.contrast, marked);
      if (pixels.empty()) return count;
      refined_ += pixels.size();
      parallel_for(std::size_t(0), pixels.size(),
                   [&](std::size_t i) { count += retrace(pixels[i], crossings.local(), result); });
    }
  }

  /// Traces the rays of one pixel's many samples together, some at a time.
  std::uint64_t retrace(std::size_t pixel, Buffers& crossings, scene::Rendering& result) const {
    const std::size_t column = pixel % scene_.width, row = pixel / scene_.width;
    const Vec2 corner{double(column), double(row)};
    PixelSum sum;
    std::vector<PictureRay> rays;
    for (std::size_t first = 0; first < more_samples_.size(); first += RayPacket::width) {
      rays.clear();
      const std::size_t end = std::min(first + RayPacket::width, more_samples_.size());
      for (std::size_t k = first; k < end; ++k) {
        const Vec2 place = corner + more_samples_[k];
        rays.push_back(finder_.frame().ray(place.x, place.y));
      }
      finder_.find(rays, std::span(crossings).first(rays.size()));
      for (std::size_t k = 0; k < rays.size(); ++k) add_sample(rays[k], crossings[k], sum);
    }
    return store(sum, more_samples_.size(), pixel, result);
  }

  /// Returns the number of crossings.
  static std::uint64_t store(const PixelSum& sum, std::size_t samples, std::size_t pixel,
                             scene::Rendering& result) {
    result.image.pixels[pixel] = Rgba(sum.rgba / double(samples));
    if (!result.layers.pixels.empty()) result.layers.pixels[pixel] = sum.layers;
    return sum.crossings;
  }

  void add_sample(const PictureRay& ray, std::span<const Crossing> crossings, PixelSum& sum) const {
    const Composite sample = composite(finder_, crossings, scene_.background,
                                       finder_.frame().world_direction(ray), options_.stop_below);
    sum.rgba += glm::dvec4(sample.color, 1 - sample.transmittance);
    sum.crossings += sample.layers;
    sum.layers = std::max(sum.layers, sample.layers);
  }

  const scene::Scene& scene_;
  CrossingFinder finder_;
  RaytraceOptions options_;
  std::vector<Vec2> samples_, more_samples_;
  std::size_t refined_ = 0;  // pixels of the last picture
};

}  // namespace

std::unique_ptr<RowRaytracer> make_raytracer(const scene::Scene& scene,
                                             const RaytraceOptions& options,
                                             const std::optional<MarchOptions>& march) {
  scene::depth_range(scene);  // refuses a scene that lies behind the camera, as every method does
  check_adaptive(scene, options);
  return std::make_unique<Raytracer>(
      scene, options, CrossingFinder(scene, options.precision, march, options.stop_below));
}

std::unique_ptr<TurningRaytracer> make_turning_raytracer(const scene::Scene& scene,
                                                         const RaytraceOptions& options) {
  check_adaptive(scene, options);
  return std::make_unique<Raytracer>(
      scene, options, CrossingFinder::turning(scene, options.precision, options.stop_below));
}

}  // namespace pellucid::groundtruth
