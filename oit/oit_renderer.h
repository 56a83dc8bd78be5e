#pragma once

#include <functional>
#include <memory>

#include "core/stopwatch.h"
#include "oit/stage.h"
#include "scene/renderer.h"

namespace pellucid {

/// One picture being made.
class Frame {
 public:
  Frame(const Stage& stage, const Framebuffer& picture) : stage_(stage), picture_(picture) {}

  /// The final picture, RGBA: the method's last pass writes colour over the background and
  /// A = 1 - transmittance into it.
  const Framebuffer& picture() const { return picture_; }
  RenderStats& stats() { return stats_; }

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
  const Framebuffer& picture_;
  RenderStats stats_;
};

/// The part that differs between methods.
class OitMethod {
 public:
  virtual ~OitMethod() = default;
  virtual void draw(Frame& frame) = 0;
  /// What the method modelled for this scene; a line each.
  virtual std::vector<std::string> explain() const { return {}; }
};

using MakeOitMethod = std::function<std::unique_ptr<OitMethod>(Stage&, const Parameters&)>;

std::unique_ptr<Renderer> make_oit_renderer(const Scene& scene, const Parameters& parameters,
                                            const RenderContext& context,
                                            const MakeOitMethod& make_method);

/// MethodRow::make for a Method that is constructed from (Stage&, const Parameters&).
template <class Method>
std::unique_ptr<Renderer> make_oit(const Scene& scene, const Parameters& parameters,
                                   const RenderContext& context) {
  return make_oit_renderer(scene, parameters, context, [](Stage& stage, const Parameters& p) {
    return std::make_unique<Method>(stage, p);
  });
}

}  // namespace pellucid
