// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/methods/decoupled.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/machine/stopwatch.h"
#include "core/parallel.h"
#include "groundtruth/sums/fourier_sum.h"
#include "groundtruth/sums/front_to_back.h"
#include "groundtruth/sums/picture_sums.h"
#include "groundtruth/sums/ray_sums.h"
#include "groundtruth/traversal/embree.h"
#include "scene/view/pixel_samples.h"

namespace pellucid::groundtruth {
namespace {

/// G before and behind each fragment of a ray.
class ImportanceSums {
 public:
  ImportanceSums(const RaySums& ray, int bands) : total_(ray.importance_sum(1)) {
    if (bands == 0) return;
    series_.emplace(bands);
    for (const RayLayer& layer : ray.layers) series_->add(square(layer.importance), layer.d);
  }

  /// Σ g_j² of the fragment itself and of those before it.
  double with(const RayLayer& layer) const {
    return series_ ? series_->up_to(layer.d) : layer.importance_sum;
  }
  double before(const RayLayer& layer) const { return with(layer) - square(layer.importance); }
  double behind(const RayLayer& layer) const { return total_ - with(layer); }

 private:
  static double square(double g) { return g * g; }

  double total_;
  std::optional<FourierSum> series_;  // G(1) is exact in the series, too (Eq. 7)
};

/// The sum of what a pixel's samples show, and the layers of the sample that has most.
struct PixelSum {
  glm::dvec4 rgba{0};
  std::uint32_t layers = 0;
};

std::uint64_t layer_count(std::span<const RaySums> rays) {
  std::uint64_t count = 0;
  for (const RaySums& ray : rays) count += ray.layers.size();
  return count;
}

std::uint64_t layer_bytes(std::span<const RaySums> rays) {
  std::uint64_t bytes = rays.size_bytes();
  for (const RaySums& ray : rays) bytes += ray.layers.capacity() * sizeof(RayLayer);
  return bytes;
}

class Decoupled final : public scene::Renderer {
 public:
  Decoupled(const scene::Scene& scene, const DecoupledOptions& options)
      : scene_(scene),
        weights_(scene::energy_weights(options.energy, scene.energy)),
        bands_(options.bands),
        probe_(scene) {}

  scene::Rendering render(const scene::RenderRequest& request) override {
    scene::Rendering result;
    result.image = Image(scene_.width, scene_.height);
    if (request.layers) result.layers = CountImage(scene_.width, scene_.height);
    const Stopwatch watch;
    row_bytes_ = 0;
    for (int y = 0; y < scene_.height; ++y) {
      result.stats.fragments += draw_row(y, result);
      report(request.progress, (y + 1.) / scene_.height, "tracing");
    }
    result.stats.steps = {{"trace and optimize", watch.seconds()}};
    result.stats.stored = result.stats.fragments;
    result.stats.bytes = {{"hierarchy", probe_.bytes()}, {"crossings of a row", row_bytes_}};
    for (const std::uint32_t count : result.layers.pixels)
      result.stats.max_layers = std::max(result.stats.max_layers, count);
    return result;
  }

  std::map<std::string, std::string> facts() const override {
    return {{"embree", RTC_VERSION_STRING}};
  }

  std::vector<std::string> explain() const override {
    return {fmt::format("opacities: of least energy, p={} q={} r={} lambda={}", weights_.p,
                        weights_.q, weights_.r, weights_.lambda),
            bands_ ? fmt::format("importance: a Fourier series of {} bands", bands_)
                   : "importance: exact sums",
            scene::describe(scene_.samples)};
  }

 private:
  /// Returns the number of crossings.
  std::uint64_t draw_row(int y, scene::Rendering& result) {
    std::vector<PixelSum> sums(std::size_t(scene_.width));
    std::uint64_t crossings = 0;
    for (const Vec2& sample : samples_) {
      const std::vector<RaySums> rays = row_sums(scene_, probe_, y, sample);
      parallel_for(std::size_t(0), rays.size(),
                   [&](std::size_t x) { add_sample(rays[x], sums[x]); });
      crossings += layer_count(rays);
      row_bytes_ = std::max(row_bytes_, layer_bytes(rays));
    }
    for (int x = 0; x < scene_.width; ++x) {
      const PixelSum& sum = sums[std::size_t(x)];
      result.image.at(x, y) = Rgba(sum.rgba / double(samples_.size()));
      if (!result.layers.pixels.empty()) result.layers.at(x, y) = sum.layers;
    }
    return crossings;
  }

  void add_sample(const RaySums& ray, PixelSum& sum) const {
    const ImportanceSums sums(ray, bands_);
    FrontToBack composite;
    for (const RayLayer& layer : ray.layers) composite.add(layer.color, opacity(layer, sums));
    sum.rgba += glm::dvec4(composite.over(scene_.background), 1 - composite.transmittance);
    sum.layers = std::max(sum.layers, std::uint32_t(ray.layers.size()));
  }

  double opacity(const RayLayer& layer, const ImportanceSums& sums) const {
    if (scene_.objects[layer.object].opaque) return layer.opacity;
    return layer.opacity * scene::optimal_opacity(weights_, layer.importance, sums.before(layer),
                                                  sums.behind(layer));
  }

  const scene::Scene& scene_;
  scene::EnergyWeights weights_;
  int bands_;
  RayProbe probe_;
  std::vector<Vec2> samples_ = scene::pixel_samples(scene_.samples);
  std::uint64_t row_bytes_ = 0;  // most that the crossings of a row of samples took
};

std::unique_ptr<scene::Renderer> make(const scene::Scene& scene, const Parameters& values,
                                      const scene::RenderContext&) {
  return std::make_unique<Decoupled>(scene, decoupled_options().read(values));
}

}  // namespace

const OptionTable<DecoupledOptions>& decoupled_options() {
  static const OptionTable<DecoupledOptions> table{
      part(&DecoupledOptions::energy, scene::energy_options()),
      number("bands", &DecoupledOptions::bands,
             {.min = 0,
              .max = 64,
              .unit = "bands",
              .help = "of the Fourier series that gives G(d); 0: the exact sums"})};
  return table;
}

const scene::MethodRow& decoupled_method() {
  static const scene::MethodRow row{
      .name = "decoupled",
      .title = "Decoupled opacity optimization (ray tracing)",
      .citation =
          "Guenther, Theisel and Gross 2017, Decoupled opacity optimization for points, lines and "
          "surfaces, CGF 36(2)",
      .equations = "Baeza Rojo et al. 2019, Eqs. 2, 10, 11, 12",
      .checked_against =
          "Baeza Rojo et al. 2019, who restate the method; not the paper of 2017 itself",
      .parameters = decoupled_options().specs(),
      .promises = {.exact_without_importance = true,
                   .order_independent = true,
                   .convex_hull = true,
                   .in_double = true,
                   .optimizes_opacity = true,
                   .edge_shift = 0},
      .bytes_per_pixel = "0; 112 per crossing of a row, and the hierarchy",
      .make = make};
  return row;
}

}  // namespace pellucid::groundtruth
