// Ground truth: one ray through every pixel's centre, all its crossings found in one traversal,
// ordered by depth, object and triangle, and composited front to back in double.

#include "groundtruth/raytrace.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <tbb/blocked_range2d.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <atomic>

#include "core/stopwatch.h"
#include "groundtruth/composite.h"
#include "groundtruth/crossing_finder.h"
#include "scene/view_depth.h"

namespace pellucid {
namespace {

constexpr ParameterSpec parameters[] = {
    {.name = "precision",
     .kind = ParameterSpec::Kind::choice,
     .default_value = "exact",
     .choices = "exact|double",
     .help = "exact: signs of exact arithmetic, each crossing once; double: signs as rounded"}};

constexpr int tile = 16;  // pixels; neighbours share the path through the hierarchy

class Raytracer : public Renderer {
 public:
  Raytracer(const Scene& scene, const Parameters& values)
      : scene_(scene),
        finder_(scene,
                values.text("precision") == "exact" ? Precision::exact : Precision::rounded) {}

  Rendering render(const RenderRequest& request) override {
    Rendering result;
    result.image = Image(scene_.width, scene_.height);
    if (request.layers) result.layers = CountImage(scene_.width, scene_.height);
    std::atomic<std::uint64_t> fragments = 0;
    tbb::enumerable_thread_specific<std::vector<Crossing>> crossings;
    const Stopwatch watch;
    tbb::parallel_for(tbb::blocked_range2d<int>(0, scene_.height, tile, 0, scene_.width, tile),
                      [&](const tbb::blocked_range2d<int>& range) {
                        fragments += trace(range, crossings.local(), result);
                      });
    result.stats.steps = {{"trace", watch.seconds()}};
    for (const std::uint32_t count : result.layers.pixels)
      result.stats.max_layers = std::max(result.stats.max_layers, count);
    result.stats.fragments = fragments;
    result.stats.bytes = {{"hierarchy", finder_.bytes()}};
    std::uint64_t hit_bytes = 0;
    for (const auto& buffer : crossings) hit_bytes += buffer.capacity() * sizeof(Crossing);
    result.stats.bytes.push_back({"crossings", hit_bytes});
    return result;
  }

  std::vector<std::string> explain() const override {
    std::vector<std::string> lines{
        fmt::format("hierarchy over {}; no GL context", describe_primitives(scene_)),
        "one sample at each pixel's centre"};
    lines.push_back(scene_.lighting == Lighting::none ? "no normals: the scene is not lit"
                                                      : "normals: the scene is lit by a headlight");
    return lines;
  }

  std::map<std::string, std::string> facts() const override {
    return {{"embree", RTC_VERSION_STRING}};
  }

 private:
  /// Traces the pixels of a tile; returns the number of crossings.
  std::uint64_t trace(const tbb::blocked_range2d<int>& range, std::vector<Crossing>& crossings,
                      Rendering& result) const {
    std::uint64_t count = 0;
    for (int y = range.rows().begin(); y < range.rows().end(); ++y)
      for (int x = range.cols().begin(); x < range.cols().end(); ++x) {
        const PictureRay ray = finder_.frame().ray(x + 0.5, y + 0.5);
        finder_.find(ray, crossings);
        const Composite pixel =
            composite(finder_, crossings, scene_.background, finder_.frame().world_direction(ray));
        result.image.at(x, y) = Rgba(pixel.color, 1 - pixel.transmittance);
        if (!result.layers.pixels.empty())
          result.layers.at(x, y) = static_cast<std::uint32_t>(crossings.size());
        count += crossings.size();
      }
    return count;
  }

  const Scene& scene_;
  CrossingFinder finder_;
};

std::unique_ptr<Renderer> make(const Scene& scene, const Parameters& values, const RenderContext&) {
  depth_range(scene);  // refuses a scene that lies behind the camera, as every method does
  return std::make_unique<Raytracer>(scene, values);
}

constexpr MethodRow row{
    .name = "raytrace",
    .title = "Exact composite (ray tracing)",
    .citation =
        "Wald et al., Embree: a kernel framework for efficient CPU ray tracing, "
        "SIGGRAPH 2014; crossings decided by Pellucid",
    .equations = "Baeza Rojo et al. 2019, Eq. 12",
    .parameters = parameters,
    .promises = {.exact = true, .order_independent = true, .convex_hull = true},
    .bytes_per_pixel = "0; 32 per crossing of one ray, and the hierarchy",
    .make = make};

}  // namespace

const MethodRow& raytrace_method() { return row; }

}  // namespace pellucid
