// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/tree/tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "oit/stage/oit_renderer.h"

namespace pellucid::oit {
namespace {

/// The scene with these objects alone.
scene::Scene with_objects(const scene::Scene& scene, std::vector<scene::SceneObject> objects) {
  scene::Scene part;
  static_cast<scene::SceneView&>(part) = scene;
  part.objects = std::move(objects);
  return part;
}

double rms_difference(const Image& a, const Image& b) {
  double squares = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const Vec3 d = Vec3(a.pixels[i]) - Vec3(b.pixels[i]);
    squares += glm::dot(d, d);
  }
  return std::sqrt(squares / (3. * double(a.pixels.size())));
}

/// Is the object drawn line by line, so that its fragments are samples of a surface?
bool has_lines(const scene::SceneObject& object, SampledObjects sampled) {
  return object.source || (sampled != SampledObjects::integrated &&
                           std::holds_alternative<scene::LineObject>(object.shape));
}

class Tree final : public OitMethod {
 public:
  Tree(Stage& stage, const TreeOptions& options)
      : stage_(stage),
        options_(options),
        range_(scene::depth_range(stage.scene())),
        epsilon_(epsilon_of(options.rule, range_)),
        trees_(stage, epsilon_.normalized2, options.rule) {
    const std::vector<PrimitiveRange> places = primitive_ranges(stage.scene());
    std::vector<scene::SceneObject> others;
    std::vector<PrimitiveRange> places_of_others;
    const std::uint64_t surfaces = std::uint64_t(std::ranges::count_if(
        stage.scene().objects,
        [](const scene::SceneObject& object) { return !object.opaque && object.source; }));
    for (std::size_t i = 0; i < places.size(); ++i)
      if (const scene::SceneObject& object = stage.scene().objects[i]; object.opaque) {
        continue;  // the stage draws it
      } else if (has_lines(object, options.sampled)) {
        add_lines(object, places[i], surfaces);
      } else {
        others.push_back(object);
        places_of_others.push_back(places[i]);
      }
    if (!others.empty())
      others_.emplace(stage.gl(), with_objects(stage.scene(), std::move(others)), range_,
                      places_of_others);
  }

  void draw(Frame& frame) override {
    trees_.clear();
    if (others_) {
      frame.step("rasterize",
                 [&] { trees_.rasterize(*others_, options_.sampled != SampledObjects::all); });
      frame.step("insert", [&] { trees_.insert(); });
    }
    if (lines_.empty())
      composite(frame);
    else
      draw_lines(frame);
    frame.stats().fragments += trees_.fragments();  // of every sample of a pixel
    frame.stats().stored = trees_.layers();
  }

  std::optional<CountImage> count_layers() override {
    counts_ = trees_.count();
    return counts_->layers;
  }

  scene::Findings findings() override {
    using Better = scene::Measure::Better;
    return {{{"epsilon2_view", "ε² of view depth", "world units²", epsilon_.view2, Better::neither},
             {"epsilon2_normalized", "ε² of d", "", epsilon_.normalized2, Better::neither}},
            {}};
  }

  std::vector<std::string> explain() const override {
    const bool all = options_.sampled == SampledObjects::all;
    std::vector<std::string> lines = {
        fmt::format("epsilon²: {:.4g} of squared view depth (world units), {:.4g} of d{}",
                    epsilon_.view2, epsilon_.normalized2,
                    options_.rule.epsilon2 ? "" : ", by the depth of what is in the picture"),
        lines_.empty()
            ? "lines: left out, no object has lines or was integrated from a seed curve"
            : fmt::format("lines: of {} objects, at most {}, {} a frame; merged within epsilon",
                          lines_.places().size(), lines_.line_count(),
                          options_.budget.lines_per_frame),
        others_ ? fmt::format("other shapes: {} primitives, inserted once, {}",
                              others_->primitive_count(),
                              all ? "merged within epsilon" : "each crossing a layer of its own")
                : "other shapes: left out, every object has lines"};
    if (counts_)
      lines.push_back(fmt::format(
          "layers: {}, of which {} in {} pixels lie nearer than the layer in front of them",
          trees_.layers(), counts_->out_of_order, counts_->pixels_out_of_order));
    return lines;
  }

 private:
  /// The budget's lines are shared among the integrated surfaces; of lines that the scene holds all
  /// are drawn.
  void add_lines(const scene::SceneObject& object, const PrimitiveRange& place,
                 std::uint64_t surfaces) {
    if (!object.source) return lines_.add_lines(object, place);
    const std::uint64_t bytes = lines_.add_surface(
        object, stage_.scene(), range_,
        std::max<std::uint64_t>(options_.budget.lines / surfaces, 1), options_.strips, place);
    if (bytes > 0) stage_.record("opacities of the mesh", bytes);
  }

  void draw_lines(Frame& frame) {
    Image before(stage_.width(), stage_.height(), Rgba(Vec3(stage_.scene().background), 0));
    const Stopwatch watch;
    const std::uint64_t all = lines_.line_count();
    for (std::uint64_t lines = 0; lines < all;) {
      scene::FrameStats record;
      const std::uint64_t count = std::min(options_.budget.lines_per_frame, all - lines);
      record.lines = draw_batch(frame, lines, count);
      lines += count;
      Image now;
      frame.step("change", [&] {
        now = frame.read_picture();
        record.change = rms_difference(before, now);
      });
      before = std::move(now);
      record.seconds = watch.seconds();
      record.fragments = trees_.fragments();
      record.layers = trees_.layers();
      record.bytes = stage_.ledger().total();
      frame.stats().frames.push_back(record);
      if (is_done(frame.stats().frames.size(), record)) break;
    }
  }

  bool is_done(std::uint64_t frames, const scene::FrameStats& last) const {
    const TreeBudget& budget = options_.budget;
    return (budget.frames && frames >= *budget.frames) ||
           (budget.seconds && last.seconds >= *budget.seconds) ||
           (budget.change && last.change < *budget.change);
  }

  /// Returns how many lines it drew.
  std::uint64_t draw_batch(Frame& frame, std::uint64_t first, std::uint64_t count) {
    LineSources::LineBatch batch;
    frame.step("lines", [&] { batch = lines_.batch(first, count); });
    const scene::Scene part = with_objects(stage_.scene(), std::move(batch.objects));
    frame.step("rasterize", [&] {
      trees_.rasterize(Geometry(stage_.gl(), part, range_, lines_.places()), false);
    });
    frame.step("insert", [&] { trees_.insert(); });
    composite(frame);
    return batch.lines;
  }

  void composite(Frame& frame) {
    frame.step("composite", [&] { trees_.composite(frame.picture()); });
  }

  Stage& stage_;
  TreeOptions options_;
  scene::DepthRange range_;
  Epsilon epsilon_;
  LayerTrees trees_;
  std::optional<LayerTrees::Counts> counts_;
  std::optional<Geometry> others_;
  LineSources lines_;
};

const OptionTable<TreeBudget>& budget_options() {
  static const OptionTable<TreeBudget> table{
      number("lines", &TreeBudget::lines,
             {.min = 1,
              .max = 1e9,
              .unit = "lines",
              .help = "of integrated surfaces: the picture is done"}),
      number(
          "lines-per-frame", &TreeBudget::lines_per_frame,
          {.min = 1, .max = 1e6, .unit = "lines", .help = "made, rasterized and inserted at once"}),
      number("frames", &TreeBudget::frames,
             {.min = 1,
              .max = 1e9,
              .unit = "frames",
              .help = "done after so many; default: no limit"}),
      number("seconds", &TreeBudget::seconds,
             {.min = 0,
              .unit = "s",
              .help = "done at the end of the frame that reaches this; default: no limit"}),
      number("change", &TreeBudget::change,
             {.min = 0,
              .max = 1,
              .unit = "1",
              .help = "done when a frame changes the picture by less, root mean square; default: "
                      "never"})};
  return table;
}

}  // namespace

const OptionTable<TreeOptions>& tree_options() {
  static const OptionTable<TreeOptions> table{part(&TreeOptions::budget, budget_options()),
                                              part(&TreeOptions::rule, layer_rule_options()),
                                              part(&TreeOptions::strips, strip_options()),
                                              choice("sampled", &TreeOptions::sampled,
                                                     {{"lines", SampledObjects::lines},
                                                      {"all", SampledObjects::all},
                                                      {"integrated", SampledObjects::integrated}},
                                                     "whose fragments are samples of a surface, "
                                                     "merged within epsilon: lines and integrated "
                                                     "surfaces, all objects, or the latter alone")};
  return table;
}

const scene::MethodRow& tree_method() {
  static const scene::MethodRow row{
      .name = "tree",
      .title = "Progressive tree",
      .citation =
          "Tian and Guenther, Progressive Rendering of Transparent Integral Surfaces, additional "
          "material",
      .equations = "Algorithms 1 and 2",
      .checked_against = "the paper's additional material",
      .parameters = tree_options().specs(),
      // Where two surfaces lie within epsilon, whichever fragment comes first makes the layer.
      .promises = {.exact_without_lines = true,
                   .exact_unless = "sampled",
                   .own_layers = true,
                   .order_spread = 1,
                   .convex_hull = true},
      .bytes_per_pixel = "12 + 40 per layer + 32 per fragment of a frame",
      .sweep = "lines=1000|4000",
      .make = make_oit<Tree, tree_options>};
  return row;
}

}  // namespace pellucid::oit
