// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/stage/oit_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "oit/stage/part_sums.h"
#include "oit_glsl.h"
#include "scene/view/pixel_samples.h"

namespace pellucid::oit {
namespace {

std::string describe_lighting(const scene::Scene& scene) {
  return scene::is_lit(scene) ? "lighting: from the eye; normals are uploaded"
                              : "lighting: left out, nothing is lit; no normals are uploaded";
}

std::string describe_samples(const scene::Scene& scene) {
  const std::string samples = scene::describe(scene.samples);
  if (scene.samples.is_center()) return "antialiasing: left out, " + samples;
  return fmt::format("antialiasing: the picture is drawn {} times, {}",
                     scene::pixel_samples(scene.samples).size(), samples);
}

std::string describe_context(const scene::Scene& scene) {
  return std::ranges::any_of(scene.objects, &scene::SceneObject::opaque)
             ? "opaque context: a pass of its own before the method's"
             : "opaque context: left out, no object is opaque";
}

const Vec2 pixel_centre(0.5);

/// What counts layers: in float, exact up to 2^24 of them.
struct LayerCounter {
  explicit LayerCounter(Stage& stage)
      : counts(stage.gl(), GL_R32F, stage.width(), stage.height()),
        target(stage.gl(), {{counts}}),
        program(stage.geometry_program(oit_glsl::count_layers_frag_glsl())) {}

  Texture counts;
  Framebuffer target;
  GeometryProgram program;
};

class OitRenderer final : public scene::Renderer {
 public:
  OitRenderer(const scene::Scene& scene, const scene::RenderContext& context,
              const MakeOitMethod& make_method)
      : scene_(scene),
        stage_(scene, context),
        picture_(stage_.gl(), GL_RGBA32F, stage_.width(), stage_.height()),
        picture_target_(stage_.gl(), {{picture_}}),
        method_(make_method(stage_)) {
    stage_.context().check("preparing the method");
  }
  // Deleting OpenGL objects needs their own context, whichever is current.
  ~OitRenderer() override { stage_.make_current(); }

  scene::Rendering render(const scene::RenderRequest& request) override;
  std::vector<std::string> explain() const override;
  std::map<std::string, std::string> facts() const override {
    return {{"driver", stage_.context().driver()}};
  }
  scene::Findings findings() override {
    stage_.make_current();
    return method_->findings();
  }
  std::optional<scene::RaySeries> ray_series(scene::RaySum sum, int x, int y,
                                             std::span<const double> d) override {
    stage_.make_current();
    return method_->ray_series(sum, x, y, d);
  }
  std::optional<scene::OptimizedOpacities> optimized_opacities() override {
    stage_.make_current();
    return method_->optimized_opacities();
  }
  scene::PartialSums* partial_sums() override {
    auto* const method = dynamic_cast<SummingMethod*>(method_.get());
    if (method && !partial_sums_) partial_sums_.emplace(stage_, *method, picture_, picture_target_);
    return partial_sums_ ? &*partial_sums_ : nullptr;
  }

 private:
  /// Draws the picture once for each of a pixel's samples and averages.
  void draw_samples(Frame& frame, Image& mean);
  enum class Counted { all, opaque };
  CountImage count_layers(const Vec2& sample, Counted counted = Counted::all);
  /// Of all of a pixel's samples, as they are all drawn.
  std::uint64_t count_fragments(const CountImage& at_centre);
  /// A method that makes layers of its own knows nothing of what is opaque behind them.
  void add_opaque(scene::Rendering& rendering);

  const scene::Scene& scene_;
  Stage stage_;
  Texture picture_;
  Framebuffer picture_target_;
  std::unique_ptr<OitMethod> method_;
  std::optional<PartSums> partial_sums_;
  std::optional<LayerCounter> counter_;  // once layers were asked for
};

scene::Rendering OitRenderer::render(const scene::RenderRequest& request) {
  stage_.make_current();
  Frame frame(stage_, picture_, picture_target_, request,
              scene::pixel_samples(scene_.samples).size());
  scene::Rendering rendering;
  rendering.image = Image(stage_.width(), stage_.height());
  draw_samples(frame, rendering.image);
  rendering.stats = frame.stats();
  rendering.stats.bytes = stage_.ledger().parts();
  if (!request.layers) return rendering;
  const std::optional<CountImage> of_method = method_->count_layers();
  rendering.layers = of_method ? *of_method : count_layers(pixel_centre);
  const auto& counts = rendering.layers.pixels;
  if (!of_method) {
    rendering.stats.fragments = count_fragments(rendering.layers);
    method_->account(rendering.layers, rendering.stats);
  } else if (stage_.has_opaque_context()) {
    add_opaque(rendering);
  }
  rendering.stats.max_layers = *std::max_element(counts.begin(), counts.end());
  return rendering;
}

void OitRenderer::draw_samples(Frame& frame, Image& mean) {
  const std::vector<Vec2> samples = scene::pixel_samples(scene_.samples);
  for (const Vec2& sample : samples) {
    stage_.sample_at(sample);
    if (stage_.has_opaque_context())
      frame.step("opaque context", [&] { stage_.draw_opaque_context(); });
    method_->draw(frame);
    frame.next_sample();
    const Image one = frame.read_picture();
    for (std::size_t i = 0; i < one.pixels.size(); ++i)
      mean.pixels[i] += one.pixels[i] / float(samples.size());
  }
}

std::uint64_t sum(const CountImage& counts) {
  return std::accumulate(counts.pixels.begin(), counts.pixels.end(), std::uint64_t(0));
}

std::uint64_t OitRenderer::count_fragments(const CountImage& at_centre) {
  const std::vector<Vec2> samples = scene::pixel_samples(scene_.samples);
  if (samples.size() == 1) return sum(at_centre);
  std::uint64_t fragments = 0;
  for (const Vec2& sample : samples) fragments += sum(count_layers(sample));
  return fragments;
}

// The method's layers are those of the last sample.
void OitRenderer::add_opaque(scene::Rendering& rendering) {
  CountImage last;
  for (const Vec2& sample : scene::pixel_samples(scene_.samples)) {
    last = count_layers(sample, Counted::opaque);
    rendering.stats.fragments += sum(last);
  }
  for (std::size_t i = 0; i < last.pixels.size(); ++i) rendering.layers.pixels[i] += last.pixels[i];
}

CountImage OitRenderer::count_layers(const Vec2& sample, Counted counted) {
  if (!counter_) counter_.emplace(stage_);
  stage_.sample_at(sample);
  stage_.draw_opaque_context();
  counter_->target.clear_all(0);
  const Pass pass(counter_->target, {Blend::add});
  if (counted == Counted::all) stage_.draw_geometry(pass, counter_->program);
  if (stage_.has_opaque_context())
    stage_.draw_screen(pass, stage_.screen_program(oit_glsl::count_opaque_frag_glsl()));
  std::vector<float> floats(stage_.pixel_count());
  counter_->counts.read(GL_RED, GL_FLOAT, floats.size() * sizeof(float), floats.data());
  stage_.context().check("counting layers");
  CountImage layers(stage_.width(), stage_.height());
  std::copy(floats.begin(), floats.end(), layers.pixels.begin());
  return layers;
}

std::vector<std::string> OitRenderer::explain() const {
  std::vector<std::string> lines = {
      fmt::format("context: {}", stage_.context().driver()),
      fmt::format("geometry: {} of {} objects", scene::describe_primitives(scene_),
                  scene_.objects.size()),
      describe_lighting(scene_), describe_samples(scene_), describe_context(scene_)};
  for (std::string& line : method_->explain()) lines.push_back(std::move(line));
  for (const scene::NamedBytes& part : stage_.ledger().parts())
    lines.push_back(fmt::format("memory: {}, {} bytes", part.name, part.bytes));
  return lines;
}

}  // namespace

Image Frame::read_picture() const {
  Image image(stage_.width(), stage_.height());
  texture_.read(GL_RGBA, GL_FLOAT, image.pixels.size() * sizeof image.pixels[0],
                image.pixels.data());
  return image;
}

void Frame::finish(std::string_view name, const Stopwatch& watch) {
  stage_.gl().Finish();
  const scene::StepTime took{std::string(name), watch.seconds(), stage_.clock().seconds()};
  stage_.context().check(name);
  const auto found = std::find_if(stats_.steps.begin(), stats_.steps.end(),
                                  [&](const scene::StepTime& step) { return step.name == name; });
  if (found != stats_.steps.end())
    *found += took;
  else
    stats_.steps.push_back(took);
}

std::unique_ptr<scene::Renderer> make_oit_renderer(const scene::Scene& scene,
                                                   const scene::RenderContext& context,
                                                   const MakeOitMethod& make_method) {
  try {
    return std::make_unique<OitRenderer>(scene, context, make_method);
  } catch (const InputError& error) {
    scene::fail_at(scene, error);
  }
}

}  // namespace pellucid::oit
