// Ground truth: a ray through each of a pixel's samples, all its crossings found in one traversal,
// ordered by depth, object and primitive, and composited front to back in double.

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
#include "groundtruth/crossing_geometry.h"
#include "scene/pixel_samples.h"
#include "scene/view_depth.h"

namespace pellucid {
namespace {

constexpr ParameterSpec parameters[] = {
    {.name = "precision",
     .kind = ParameterSpec::Kind::choice,
     .default_value = "exact",
     .choices = "exact|double|fast",
     .help =
         "exact: signs of exact arithmetic, each crossing once; double: signs as rounded; fast: "
         "meshes as Embree intersects them, in float: shared edges count twice, or not"},
    {.name = "stop-below",
     .kind = ParameterSpec::Kind::real,
     .default_value = "0",
     .min = 0,
     .max = 1,
     .help = "a ray ends where less than this shows: no pixel then errs by more"}};

constexpr int packet_columns = 4, packet_rows = 2;  // pixels whose rays are traced together
constexpr int tile = 16;  // pixels; neighbours share the path through the hierarchy

Precision precision_named(std::string_view name) {
  if (name == "fast") return Precision::fast;
  return name == "double" ? Precision::rounded : Precision::exact;
}

class Raytracer : public Renderer {
 public:
  Raytracer(const Scene& scene, const TraceOptions& options)
      : scene_(scene),
        finder_(scene, options.precision, options.march),
        samples_(pixel_samples(scene.samples)),
        stop_below_(options.stop_below) {}

  Rendering render(const RenderRequest& request) override {
    Rendering result;
    result.image = Image(scene_.width, scene_.height);
    if (request.layers) result.layers = CountImage(scene_.width, scene_.height);
    std::atomic<std::uint64_t> fragments = 0;
    tbb::enumerable_thread_specific<Buffers> crossings;
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
    for (const Buffers& buffers : crossings)
      for (const auto& buffer : buffers) hit_bytes += buffer.capacity() * sizeof(Crossing);
    result.stats.bytes.push_back({"crossings", hit_bytes});
    return result;
  }

  std::vector<std::string> explain() const override {
    std::vector<std::string> lines{
        fmt::format("hierarchy over {}; no GL context", describe_primitives(scene_)),
        scene_.samples == 1
            ? "one sample at each pixel's centre"
            : fmt::format("{0} x {0} samples per pixel, their mean", scene_.samples)};
    if (stop_below_ > 0)
      lines.push_back(
          fmt::format("rays end where less than {} shows: no pixel errs by more", stop_below_));
    lines.push_back(scene_.lighting == Lighting::none ? "no normals: the scene is not lit"
                                                      : "normals: the scene is lit by a headlight");
    return lines;
  }

  std::map<std::string, std::string> facts() const override {
    return {{"embree", RTC_VERSION_STRING}};
  }

 private:
  using Buffers = std::array<std::vector<Crossing>, RayPacket::width>;

  /// Traces the pixels of a tile; returns the number of crossings.
  std::uint64_t trace(const tbb::blocked_range2d<int>& range, Buffers& crossings,
                      Rendering& result) const {
    std::uint64_t count = 0;
    for (int y = range.rows().begin(); y < range.rows().end(); y += packet_rows)
      for (int x = range.cols().begin(); x < range.cols().end(); x += packet_columns)
        count +=
            trace_packet({x, std::min(x + packet_columns, range.cols().end())},
                         {y, std::min(y + packet_rows, range.rows().end())}, crossings, result);
    return count;
  }

  struct Interval {
    int begin, end;
  };

  /// Traces the rays of a few pixels together, sample by sample.
  std::uint64_t trace_packet(const Interval& x, const Interval& y, Buffers& crossings,
                             Rendering& result) const {
    const int columns = x.end - x.begin, rows = y.end - y.begin;
    std::array<PixelSum, RayPacket::width> sums;
    std::vector<PictureRay> rays(static_cast<std::size_t>(columns) * rows);
    for (const Vec2& sample : samples_) {
      for (std::size_t k = 0; k < rays.size(); ++k)
        rays[k] = finder_.frame().ray(x.begin + int(k) % columns + sample.x,
                                      y.begin + int(k) / columns + sample.y);
      finder_.find(rays, std::span(crossings).first(rays.size()));
      for (std::size_t k = 0; k < rays.size(); ++k) add_sample(rays[k], crossings[k], sums[k]);
    }
    std::uint64_t count = 0;
    for (std::size_t k = 0; k < rays.size(); ++k) {
      const int px = x.begin + int(k) % columns, py = y.begin + int(k) / columns;
      result.image.at(px, py) = Rgba(sums[k].rgba / double(samples_.size()));
      if (!result.layers.pixels.empty()) result.layers.at(px, py) = sums[k].layers;
      count += sums[k].crossings;
    }
    return count;
  }

  struct PixelSum {
    glm::dvec4 rgba{0};
    std::uint64_t crossings = 0;
    std::uint32_t layers = 0;  // of the sample that has most
  };

  void add_sample(const PictureRay& ray, std::span<const Crossing> crossings, PixelSum& sum) const {
    const Composite sample = composite(finder_, crossings, scene_.background,
                                       finder_.frame().world_direction(ray), stop_below_);
    sum.rgba += glm::dvec4(sample.color, 1 - sample.transmittance);
    sum.crossings += sample.layers;
    sum.layers = std::max(sum.layers, sample.layers);
  }

  const Scene& scene_;
  CrossingFinder finder_;
  std::vector<Vec2> samples_;
  double stop_below_;
};

std::unique_ptr<Renderer> make(const Scene& scene, const Parameters& values, const RenderContext&) {
  return make_raytracer(scene,
                        {precision_named(values.text("precision")), values.real("stop-below")});
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
    .bytes_per_pixel = "0; 32 per crossing of a packet of 8 rays, and the hierarchy",
    .make = make};

}  // namespace

const MethodRow& raytrace_method() { return row; }

std::unique_ptr<Renderer> make_raytracer(const Scene& scene, const TraceOptions& options) {
  depth_range(scene);  // refuses a scene that lies behind the camera, as every method does
  return std::make_unique<Raytracer>(scene, options);
}

}  // namespace pellucid
