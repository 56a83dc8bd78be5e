// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/machine/stopwatch.h"
#include "core/options/option_table.h"
#include "oit/stage/stage.h"
#include "scene/renderer.h"

namespace pellucid::oit {

/// A Frame is one picture being made.
class Frame {
 public:
  /// Starts a picture, of which `picture` is the texture that `target` draws into. Each of a
  /// pixel's `samples` is as much of the work as the others.
  Frame(const Stage& stage, const Texture& picture, const Framebuffer& target,
        const scene::RenderRequest& request = {}, std::size_t samples = 1)
      : stage_(stage),
        texture_(picture),
        picture_(target),
        progress_(request.progress),
        draw_(request.draw),
        samples_(samples) {}

  /// Returns which of its pictures a method of random numbers draws (RenderRequest::draw).
  std::uint32_t draw() const { return draw_; }

  /// Returns which of the pixel's samples is being drawn, from 0: a method that draws random
  /// numbers wants others for each.
  std::uint32_t sample() const { return sample_; }
  void next_sample() { ++sample_; }

  /// Returns the target of the final picture, RGBA: the method's last pass writes colour over the
  /// background and A = 1 - transmittance into it.
  const Framebuffer& picture() const { return picture_; }
  Image read_picture() const;
  scene::RenderStats& stats() { return stats_; }

  /// Runs one step and times it until OpenGL has finished it, by OpenGL's own clock, too. Steps of
  /// one name are summed. Throws WorkError when OpenGL has reported an error, and what the progress
  /// throws to end the picture.
  template <class Pass>
  void step(std::string_view name, Pass&& pass) {
    report(progress_, double(sample_) / double(samples_), "drawing");
    const Stopwatch watch;
    stage_.clock().start();
    pass();
    stage_.clock().stop();
    finish(name, watch);
  }

 private:
  void finish(std::string_view name, const Stopwatch& watch);

  const Stage& stage_;
  const Texture& texture_;
  const Framebuffer& picture_;
  Progress progress_;
  std::uint32_t draw_;
  std::size_t samples_;
  std::uint32_t sample_ = 0;
  scene::RenderStats stats_;
};

/// An OitMethod is the part that differs between methods.
class OitMethod {
 public:
  virtual ~OitMethod() = default;
  /// Draws one sample of every pixel into Frame::picture().
  virtual void draw(Frame& frame) = 0;
  /// Returns the layers per pixel that the last picture was made of, where the method makes layers
  /// of its own, but for what is opaque behind them, which the renderer adds; otherwise they are
  /// the geometry's crossings.
  virtual std::optional<CountImage> count_layers() { return std::nullopt; }
  /// Counts which of the geometry's crossings per pixel the method keeps apart or loses: fills
  /// `stored` and `truncated`.
  virtual void account(const CountImage& /*crossings*/, scene::RenderStats& /*stats*/) const {}
  /// Returns what Renderer::ray_series() does.
  virtual std::optional<scene::RaySeries> ray_series(scene::RaySum /*sum*/, int /*x*/, int /*y*/,
                                                     std::span<const double> /*d*/) const {
    return std::nullopt;
  }
  /// Returns what Renderer::optimized_opacities() does.
  virtual std::optional<scene::OptimizedOpacities> optimized_opacities() const {
    return std::nullopt;
  }
  /// Returns what Renderer::findings() does.
  virtual scene::Findings findings() { return {}; }
  /// Returns what the method modelled for this scene; a line each.
  virtual std::vector<std::string> explain() const { return {}; }
};

/// A MakeOitMethod makes a method on a stage.
using MakeOitMethod = std::function<std::unique_ptr<OitMethod>(Stage&)>;

/// Makes the renderer of a method over a scene, which has to outlive it. Throws InputError for a
/// scene that OpenGL does not draw, WorkError when the driver or its memory does not suffice.
std::unique_ptr<scene::Renderer> make_oit_renderer(const scene::Scene& scene,
                                                   const scene::RenderContext& context,
                                                   const MakeOitMethod& make_method);

/// Serves as MethodRow::make for a Method that is constructed from (Stage&, const Options&);
/// `table` is a function that returns the OptionTable<Options>. Throws as make_oit_renderer() does.
template <class Method, auto table>
std::unique_ptr<scene::Renderer> make_oit(const scene::Scene& scene, const Parameters& parameters,
                                          const scene::RenderContext& context) {
  return make_oit_renderer(scene, context, [&](Stage& stage) {
    return std::make_unique<Method>(stage, table().read(parameters));
  });
}

/// Serves likewise for a Method without options, which is constructed from (Stage&).
template <class Method>
std::unique_ptr<scene::Renderer> make_oit(const scene::Scene& scene, const Parameters&,
                                          const scene::RenderContext& context) {
  return make_oit_renderer(scene, context,
                           [](Stage& stage) { return std::make_unique<Method>(stage); });
}

}  // namespace pellucid::oit
