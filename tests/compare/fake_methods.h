// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <csignal>
#include <iterator>
#include <span>

#include "core/error.h"
#include "scene/renderer.h"

namespace pellucid::testing {}

namespace pellucid::compare::testing {

using namespace pellucid::testing;

/// How often any fake method has rendered in this process. When it reaches `kill_at`, the process
/// kills itself, as a power cut would.
struct RenderCounter {
  static inline int renders = 0;
  static inline int kill_at = -1;

  static void count() {
    if (++renders == kill_at) ::raise(SIGKILL);
  }
};

/// A picture that depends on the pixel alone, plus `offset`; it takes ¾ s, `times` over.
class FakeRenderer : public scene::Renderer {
 public:
  FakeRenderer(const scene::Scene& scene, double offset, int times = 1)
      : scene_(scene), offset_(float(offset)), times_(times) {}

  scene::Rendering render(const scene::RenderRequest& request) override {
    RenderCounter::count();
    scene::Rendering rendering;
    rendering.image = Image(scene_.width, scene_.height);
    for (int y = 0; y < scene_.height; ++y)
      for (int x = 0; x < scene_.width; ++x)
        rendering.image.at(x, y) = Rgba(float(x * y % 64) / 128.f + offset_);
    rendering.stats.steps = {{"first", 0.25 * times_}, {"second", 0.5 * times_}};
    rendering.stats.bytes = {{"list", 1000}, {"heads", 24}};
    if (request.layers) count_layers(rendering);
    return rendering;
  }
  std::vector<std::string> explain() const override { return {"a fake"}; }
  std::map<std::string, std::string> facts() const override { return {{"driver", "none"}}; }

 private:
  void count_layers(scene::Rendering& rendering) const {
    rendering.layers = CountImage(scene_.width, scene_.height, 3);
    if (offset_ > 0) rendering.layers.at(1, 0) = 4;
    if (offset_ > 0.7f) rendering.layers.at(2, 0) = 5;
    rendering.stats.fragments = 3u * std::uint64_t(scene_.width) * std::uint64_t(scene_.height);
    rendering.stats.max_layers = 3;
  }

  const scene::Scene& scene_;
  float offset_;
  int times_;
};

/// What the draws of `drawn` are off by; multiples of 1/8, so that RMSE is exactly that.
inline constexpr double drawn_offsets[] = {0.375, 0.125, 0.25, 0.625, 0.5};

/// A method of random numbers: each draw is off by another of drawn_offsets.
class DrawnRenderer final : public scene::Renderer {
 public:
  explicit DrawnRenderer(const scene::Scene& scene) : scene_(scene) {}

  scene::Rendering render(const scene::RenderRequest& request) override {
    const double offset = drawn_offsets[request.draw % std::size(drawn_offsets)];
    return FakeRenderer(scene_, offset).render(request);
  }
  std::vector<std::string> explain() const override { return {"a fake that draws"}; }

 private:
  const scene::Scene& scene_;
};

inline constexpr ParameterSpec shifted_parameters[] = {
    {.name = "by", .kind = ParameterSpec::Kind::real, .default_value = "0.25", .min = 0, .max = 1},
    {.name = "how",
     .kind = ParameterSpec::Kind::choice,
     .default_value = "up",
     .choices = "up|down"},
    {.name = "times",
     .kind = ParameterSpec::Kind::integer,
     .default_value = "1",
     .min = 1,
     .max = 9},
    {.name = "often", .kind = ParameterSpec::Kind::flag, .default_value = "off"}};

inline constexpr ParameterSpec filed_parameters[] = {
    {.name = "file", .kind = ParameterSpec::Kind::file}};

using Made = std::unique_ptr<scene::Renderer>;

inline scene::MethodRow fake_row(std::string_view name, bool exact,
                                 decltype(scene::MethodRow::make) make,
                                 std::span<const ParameterSpec> parameters = {}) {
  scene::MethodRow row{};
  row.name = row.title = name;
  row.promises.exact = exact;
  row.parameters = parameters;
  row.make = make;
  return row;
}

/// A row whose pictures are `thousandths` brighter than the truth.
template <int thousandths>
Made make_fake(const scene::Scene& scene, const Parameters&, const scene::RenderContext&) {
  return std::make_unique<FakeRenderer>(scene, thousandths / 1000.0);
}

inline Made make_shifted(const scene::Scene& scene, const Parameters& p,
                         const scene::RenderContext&) {
  return std::make_unique<FakeRenderer>(scene, p.real("by"), int(p.integer("times")));
}

/// Knows more than its picture.
class MeasuringRenderer final : public FakeRenderer {
 public:
  using FakeRenderer::FakeRenderer;
  scene::Findings findings() override {
    return {{{"nodes", "Nodes_made", "", 12, scene::Measure::Better::lower},
             {"spread", "Spread", "m", 0.12345678, scene::Measure::Better::neither}},
            {{"depth", "Depth [m]", 0.01, 10, Image(24, 16)}}};
  }
};

inline Made make_measuring(const scene::Scene& scene, const Parameters&,
                           const scene::RenderContext&) {
  return std::make_unique<MeasuringRenderer>(scene, 0.25);
}

inline Made make_broken(const scene::Scene&, const Parameters&, const scene::RenderContext&) {
  throw WorkError("the driver lacks \"everything\", and <more>");
}

inline Made make_not_a_number(const scene::Scene& scene, const Parameters&,
                              const scene::RenderContext&) {
  return std::make_unique<FakeRenderer>(scene, std::nan(""));
}

inline scene::MethodRow drawn_row() {
  const auto make = [](const scene::Scene& scene, const Parameters&,
                       const scene::RenderContext&) -> Made {
    return std::make_unique<DrawnRenderer>(scene);
  };
  scene::MethodRow row = fake_row("drawn", false, make);
  row.promises.random = true;
  return row;
}

inline scene::MethodRow layering_row() {
  scene::MethodRow row = fake_row("layering", false, make_fake<750>);
  row.promises.own_layers = true;
  return row;
}

/// `shifted` adds `by`; `exact-shifted` claims to be exact, `layering` to make its own layers.
inline std::span<const scene::MethodRow> fake_methods() {
  static const scene::MethodRow rows[] = {
      fake_row("truth", true, make_fake<0>),
      fake_row("shifted", false, make_shifted, shifted_parameters),
      fake_row("exact-shifted", true, make_fake<125>),
      fake_row("measuring", false, make_measuring),
      layering_row(),
      drawn_row(),
      fake_row("filed", false, make_fake<250>, filed_parameters),
      fake_row("broken", false, make_broken),
      fake_row("not-a-number", false, make_not_a_number)};
  return rows;
}

}  // namespace pellucid::compare::testing
