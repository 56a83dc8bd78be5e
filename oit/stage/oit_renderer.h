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

/// One picture being made.
class Frame {
 public:
  /// `picture` is what `target` draws into.
  Frame(const Stage& stage, const Texture& picture, const Framebuffer& target)
      : stage_(stage), texture_(picture), picture_(target) {}

  /// Which of the pixel's samples is being drawn: a method that draws random numbers wants others
  /// for each.
  std::uint32_t sample() const { return sample_; }
  void next_sample() { ++sample_; }

  /// The final picture, RGBA: the method's last pass writes colour over the background and
  /// A = 1 - transmittance into it.
  const Framebuffer& picture() const { return picture_; }
  Image read_picture() const;
  scene::RenderStats& stats() { return stats_; }

  /// Runs one step and times it until OpenGL has finished it. Steps of one name are summed.
  template <class Pass>
  void step(std::string_view name, Pass&& pass) {
    const Stopwatch watch;
    pass();
    finish(name, watch);
  }

 private:
  void finish(std::string_view name, const Stopwatch& watch);

  const Stage& stage_;
  const Texture& texture_;
  const Framebuffer& picture_;
  std::uint32_t sample_ = 0;
  scene::RenderStats stats_;
};

/// The part that differs between methods.
class OitMethod {
 public:
  virtual ~OitMethod() = default;
  virtual void draw(Frame& frame) = 0;
  /// The layers per pixel that the last picture was made of, where the method makes layers of its
  /// own; otherwise they are the geometry's crossings.
  virtual std::optional<CountImage> count_layers() { return std::nullopt; }
  /// Of the geometry's crossings per pixel, which of them the method keeps apart or loses: fills
  /// `stored` and `truncated`.
  virtual void account(const CountImage& /*crossings*/, scene::RenderStats& /*stats*/) const {}
  /// See Renderer.
  virtual std::optional<scene::OpticalDepth> optical_depth(int /*x*/, int /*y*/,
                                                           std::span<const double> /*d*/) const {
    return std::nullopt;
  }
  /// What the method modelled for this scene; a line each.
  virtual std::vector<std::string> explain() const { return {}; }
};

using MakeOitMethod = std::function<std::unique_ptr<OitMethod>(Stage&)>;

std::unique_ptr<scene::Renderer> make_oit_renderer(const scene::Scene& scene,
                                                   const scene::RenderContext& context,
                                                   const MakeOitMethod& make_method);

/// MethodRow::make for a Method that is constructed from (Stage&, const Options&); `table` is a
/// function that returns the OptionTable<Options>.
template <class Method, auto table>
std::unique_ptr<scene::Renderer> make_oit(const scene::Scene& scene, const Parameters& parameters,
                                          const scene::RenderContext& context) {
  return make_oit_renderer(scene, context, [&](Stage& stage) {
    return std::make_unique<Method>(stage, table().read(parameters));
  });
}

/// The same for a Method without options, which is constructed from (Stage&).
template <class Method>
std::unique_ptr<scene::Renderer> make_oit(const scene::Scene& scene, const Parameters&,
                                          const scene::RenderContext& context) {
  return make_oit_renderer(scene, context,
                           [](Stage& stage) { return std::make_unique<Method>(stage); });
}

}  // namespace pellucid::oit
