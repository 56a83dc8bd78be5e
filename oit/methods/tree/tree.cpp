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
  part.width = scene.width;
  part.height = scene.height;
  part.camera = scene.camera;
  part.lighting = scene.lighting;
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

class Tree final : public OitMethod {
 public:
  Tree(Stage& stage, const TreeOptions& options)
      : stage_(stage),
        budget_(options.budget),
        range_(scene::depth_range(stage.scene())),
        trees_(stage, options.rule) {
    const std::vector<PrimitiveRange> places = primitive_ranges(stage.scene());
    std::vector<scene::SceneObject> meshes;
    std::vector<PrimitiveRange> mesh_places;
    std::vector<const scene::FlowSource*> sources;
    for (std::size_t i = 0; i < places.size(); ++i)
      if (const scene::SceneObject& object = stage.scene().objects[i]; object.opaque) {
        continue;  // the stage draws it
      } else if (object.source) {
        sources.push_back(&*object.source);
        strip_places_.push_back(places[i]);
      } else {
        meshes.push_back(object);
        mesh_places.push_back(places[i]);
      }
    for (const scene::FlowSource* source : sources)
      strips_.push_back(std::make_unique<SurfaceStrips>(
          *source, stage.scene(), range_,
          std::max<std::uint64_t>(budget_.lines / sources.size(), 1), options.strips));
    if (!meshes.empty())
      meshes_.emplace(stage.gl(), with_objects(stage.scene(), std::move(meshes)), range_,
                      mesh_places);
  }

  void draw(Frame& frame) override {
    trees_.clear();
    if (meshes_) {
      frame.step("rasterize", [&] { trees_.rasterize(*meshes_, true); });
      frame.step("insert", [&] { trees_.insert(); });
    }
    if (strips_.empty())
      composite(frame);
    else
      draw_lines(frame);
    frame.stats().fragments = trees_.fragments();
    frame.stats().stored = trees_.layers();
  }

  std::optional<CountImage> count_layers() override {
    counts_ = trees_.count();
    return counts_->layers;
  }

  std::vector<std::string> explain() const override {
    std::vector<std::string> lines = {
        strips_.empty() ? "lines: left out, no object was integrated from a seed curve"
                        : fmt::format("lines: of {} surfaces, at most {}, {} a frame",
                                      strips_.size(), budget_.lines, budget_.lines_per_frame),
        meshes_
            ? fmt::format("other shapes: {} primitives, inserted once", meshes_->primitive_count())
            : "other shapes: left out, every object has lines"};
    if (counts_)
      lines.push_back(fmt::format(
          "layers: {}, of which {} in {} pixels lie nearer than the layer in front of them",
          trees_.layers(), counts_->out_of_order, counts_->pixels_out_of_order));
    return lines;
  }

 private:
  void draw_lines(Frame& frame) {
    Image before(stage_.width(), stage_.height(), Rgba(Vec3(stage_.scene().background), 0));
    const Stopwatch watch;
    for (std::uint64_t lines = 0; lines < budget_.lines;) {
      scene::FrameStats record;
      record.lines = std::min(budget_.lines_per_frame, budget_.lines - lines);
      draw_batch(frame, lines, record.lines);
      lines += record.lines;
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
    return (budget_.frames && frames >= *budget_.frames) ||
           (budget_.seconds && last.seconds >= *budget_.seconds) ||
           (budget_.change && last.change < *budget_.change);
  }

  /// Line n of all is line n / k of surface n mod k.
  void draw_batch(Frame& frame, std::uint64_t first, std::uint64_t count) {
    scene::Scene batch = with_objects(stage_.scene(), {});
    frame.step("integrate", [&] {
      for (std::uint64_t k = 0; k < strips_.size(); ++k) {
        const auto before = [&](std::uint64_t n) {
          return (n + strips_.size() - 1 - k) / strips_.size();
        };
        scene::SceneObject object;
        object.shape = strips_[k]->lines(before(first), before(first + count) - before(first));
        batch.objects.push_back(std::move(object));
      }
    });
    frame.step("rasterize", [&] {
      trees_.rasterize(Geometry(stage_.gl(), batch, range_, strip_places_), false);
    });
    frame.step("insert", [&] { trees_.insert(); });
    composite(frame);
  }

  void composite(Frame& frame) {
    frame.step("composite", [&] { trees_.composite(frame.picture()); });
  }

  Stage& stage_;
  TreeBudget budget_;
  scene::DepthRange range_;
  LayerTrees trees_;
  std::optional<LayerTrees::Counts> counts_;
  std::optional<Geometry> meshes_;
  std::vector<std::unique_ptr<SurfaceStrips>> strips_;
  std::vector<PrimitiveRange> strip_places_;  // of the surfaces, in the order of the scene
};

const OptionTable<TreeBudget>& budget_options() {
  static const OptionTable<TreeBudget> table{
      number("lines", &TreeBudget::lines,
             {.min = 1, .max = 1e9, .unit = "lines", .help = "the picture is done"}),
      number("lines-per-frame", &TreeBudget::lines_per_frame,
             {.min = 1,
              .max = 1e6,
              .unit = "lines",
              .help = "integrated, rasterized and inserted at once"}),
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
                                              part(&TreeOptions::strips, strip_options())};
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
      .promises = {.exact_without_sources = true,
                   .own_layers = true,
                   .order_spread = 1,
                   .convex_hull = true},
      .bytes_per_pixel = "12 + 40 per layer + 32 per fragment of a frame",
      .sweep = "lines=1000|4000",
      .make = make_oit<Tree, tree_options>};
  return row;
}

}  // namespace pellucid::oit
