// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/methods/decoupled.h"

#include <fmt/format.h>

#include <optional>

#include "core/machine/stopwatch.h"
#include "core/parallel.h"
#include "groundtruth/sums/fourier_sum.h"
#include "groundtruth/sums/picture_sums.h"
#include "groundtruth/sums/ray_sums.h"

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
    for (int y = 0; y < scene_.height; ++y) result.stats.fragments += draw_row(y, result);
    result.stats.steps = {{"trace and optimize", watch.seconds()}};
    result.stats.bytes = {{"hierarchy", probe_.bytes()}};
    for (const std::uint32_t count : result.layers.pixels)
      result.stats.max_layers = std::max(result.stats.max_layers, count);
    return result;
  }

  std::vector<std::string> explain() const override {
    return {fmt::format("opacities: of least energy, p={} q={} r={} lambda={}", weights_.p,
                        weights_.q, weights_.r, weights_.lambda),
            bands_ ? fmt::format("importance: a Fourier series of {} bands", bands_)
                   : "importance: exact sums"};
  }

 private:
  std::uint64_t draw_row(int y, scene::Rendering& result) const {
    const std::vector<RaySums> rays = row_sums(scene_, probe_, y);
    return parallel_sum(
        tbb::blocked_range<int>(0, scene_.width), std::uint64_t(0),
        [&](const tbb::blocked_range<int>& columns, std::uint64_t fragments) {
          for (int x = columns.begin(); x < columns.end(); ++x)
            fragments += draw_pixel(rays[std::size_t(x)], x, y, result);
          return fragments;
        },
        std::plus<>());
  }

  std::uint64_t draw_pixel(const RaySums& ray, int x, int y, scene::Rendering& result) const {
    const ImportanceSums sums(ray, bands_);
    Vec3 color(0);
    double transmittance = 1;
    for (const RayLayer& layer : ray.layers) {
      const double alpha = opacity(layer, sums);
      color += transmittance * alpha * layer.color;
      transmittance *= 1 - alpha;
    }
    color += transmittance * scene_.background;
    result.image.at(x, y) = Rgba(color, 1 - transmittance);
    if (!result.layers.pixels.empty()) result.layers.at(x, y) = std::uint32_t(ray.layers.size());
    return ray.layers.size();
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
      .promises = {.order_independent = true, .convex_hull = true},
      .bytes_per_pixel = "0; 112 per crossing of a row, and the hierarchy",
      .optimizes_opacity = true,
      .make = make};
  return row;
}

}  // namespace pellucid::groundtruth
