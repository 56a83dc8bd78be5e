// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/budget/measure_budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>
#include <set>

#include "compare/budget/budget_stages.h"
#include "compare/budget/split_error.h"
#include "compare/methods/methods.h"
#include "compare/methods/optimize_opacities.h"
#include "compare/methods/surface_methods.h"
#include "compare/pictures/error_map.h"
#include "compare/pictures/image_file.h"
#include "core/error.h"
#include "core/files/json_node.h"
#include "core/machine/stopwatch.h"
#include "core/options/names.h"
#include "scene/files/scene_file.h"
#include "scene/halo.h"

namespace pellucid::compare {
namespace {

MethodCall call_of(std::string_view name) {
  const scene::MethodRow& row = find_row("method", name, methods());
  return {&row, Parameters(row.name, row.parameters, {})};
}

/// An ActiveStage is one that applies to the cell.
struct ActiveStage {
  const BudgetStage* stage;
  std::string what;
};

class BudgetDrawing {
 public:
  BudgetDrawing(const Cell& cell, const MethodCall& reference, const scene::Scene& scene,
                const scene::RenderContext& context)
      : cell_(cell),
        drawn_(scene),
        context_(context),
        tools_{*cell.budget, call_of("linked-list"), reference, call_of("decoupled-lists")},
        base_{read_json(cell.scene_file), scene.samples, cell.opacities, cell.call} {
    DrawPlan plan = base_;
    for (const BudgetStage& stage : budget_stages()) {
      const StageRefinement found = stage.refine(tools_, plan);
      lines_.push_back(
          {.stage = std::string(stage.name), .refinement = found.what, .why_not = found.why_not});
      if (found.why_not.empty()) lines_.back().why_not = why_it_cannot(stage);
      if (lines_.back().why_not.empty()) active_.push_back({&stage, found.what});
    }
  }

  SplitError split() {
    const StageOrder order = stage_order();
    const std::set<StageSet> timed = sets_to_time(order);
    for (const StageSet set : sets_to_draw(order)) draw(set, timed.contains(set));
    time_pictures();
    SplitError result = split_error(order, pictures_);
    result.budget.lines = lines_with(result.budget.lines);
    return result;
  }

  const std::vector<ActiveStage>& active() const { return active_; }

 private:
  /// Of a stage whose finer scene is refused, as beyond a limit, why; else nothing.
  std::string why_it_cannot(const BudgetStage& stage) {
    DrawPlan plan = base_;
    const std::string finer = stage.refine(tools_, plan).what;
    try {
      scene_of(plan);
      return {};
    } catch (const InputError& error) {
      return fmt::format("refined to {}: {}", finer, error.what());
    }
  }

  /// Stages that need one that does not apply need none.
  StageOrder stage_order() const {
    StageOrder order;
    for (const ActiveStage& active : active_) {
      const auto upon = std::ranges::find(active_, active.stage->upon,
                                          [](const ActiveStage& a) { return a.stage->name; });
      order.push_back(upon == active_.end() ? std::nullopt
                                            : std::optional(std::size_t(upon - active_.begin())));
    }
    return order;
  }

  DrawPlan plan_of(StageSet set) const {
    DrawPlan plan = base_;
    for (std::size_t i = 0; i < active_.size(); ++i)
      if (set & (1u << i)) active_[i].stage->refine(tools_, plan);
    return plan;
  }

  /// Its first picture warms the renderer up. What is not timed is not kept: renderers are large.
  void draw(StageSet set, bool is_timed) {
    const DrawPlan plan = plan_of(set);
    MadeScene& made = scene_of(plan);
    made.scene.samples = plan.samples;
    Drawing drawing{&made, plan.samples, {}, {}};
    drawing.renderer = plan.call.row->make(made.scene, plan.call.parameters, context_);
    Image image = drawing.renderer->render({}).image;
    if (plan.displayed) image = displayed_values(image);
    pictures_[set].image = std::move(image);
    pictures_[set].scene = made.number;
    if (is_timed) drawings_.emplace(set, std::move(drawing));
  }

  /// As rows are timed: in turn, so that what disturbs the machine for a while disturbs all.
  void time_pictures() {
    for (int round = 0; round < rule.max; ++round)
      for (auto& [set, drawing] : drawings_) drawing.time_once();
    for (auto& [set, drawing] : drawings_) {
      pictures_[set].drawing = spread_of(drawing.seconds, rule);
      pictures_[set].making = time_of_making(plan_of(set));
    }
  }

  Spread time_of_making(const DrawPlan& plan) {
    MadeScene& made = scene_of(plan);
    while (has_time(made.seconds)) {
      const Stopwatch watch;
      load(plan);
      made.seconds.push_back(watch.seconds());
    }
    return spread_of(made.seconds, rule);
  }

  /// As few times as have an interval.
  static constexpr TimingRule rule = {5, 5};
  /// What takes so many seconds is timed no more, and has no interval if it was timed too seldom.
  static constexpr double long_enough = 10;

  static bool has_time(const std::vector<double>& seconds) {
    return int(seconds.size()) < rule.max &&
           std::accumulate(seconds.begin(), seconds.end(), 0.0) < long_enough;
  }

  /// A MadeScene is a scene with the seconds that making it took.
  struct MadeScene {
    scene::Scene scene;
    std::size_t number;
    std::vector<double> seconds;
  };

  /// A Drawing is a picture that is drawn again and again.
  struct Drawing {
    MadeScene* made;
    scene::PixelSampling samples;
    std::unique_ptr<scene::Renderer> renderer;
    std::vector<double> seconds;

    void time_once() {
      if (!has_time(seconds)) return;
      made->scene.samples = samples;  // which pictures of the same scene have changed
      seconds.push_back(renderer->render({}).stats.seconds());
    }
  };

  /// Every geometry is made once for all its pictures; with optimized opacities once for each
  /// sampling, at which they are found.
  MadeScene& scene_of(const DrawPlan& plan) {
    std::string key = plan.scene.dump();
    if (plan.opacities) key += plan.opacities->text() + scene::describe(plan.samples);
    const auto found = scenes_.find(key);
    if (found != scenes_.end()) return found->second;
    const Stopwatch watch;
    scene::Scene made = load(plan);
    return scenes_.emplace(key, MadeScene{std::move(made), scenes_.size(), {watch.seconds()}})
        .first->second;
  }

  scene::Scene load(const DrawPlan& plan) const {
    scene::Scene scene = scene::read_scene(
        plan.scene, {.file = cell_.scene_file.string(), .folder = cell_.scene_file.parent_path()});
    scene.name = drawn_.name;
    scene.camera = drawn_.camera;
    scene::place_halos(scene);
    scene.samples = plan.samples;
    if (plan.opacities)
      optimize_opacities(*plan.opacities, context_, scene, cell_.further_samplings);
    return scene;
  }

  /// The lines of all stages, those that apply with their numbers.
  std::vector<BudgetLine> lines_with(const std::vector<BudgetLine>& numbers) const {
    std::vector<BudgetLine> lines = lines_;
    auto next = numbers.begin();
    for (BudgetLine& line : lines) {
      if (!line.why_not.empty()) continue;
      BudgetLine full = *next++;
      full.stage = line.stage;
      full.refinement = line.refinement;
      line = std::move(full);
    }
    return lines;
  }

  const Cell& cell_;
  const scene::Scene& drawn_;
  const scene::RenderContext& context_;
  BudgetTools tools_;
  DrawPlan base_;
  std::vector<BudgetLine> lines_;
  std::vector<ActiveStage> active_;
  std::map<StageSet, DrawnPicture> pictures_;
  std::map<std::string, MadeScene> scenes_;
  std::map<StageSet, Drawing> drawings_;  // of the scenes, which outlive them
};

/// A mean of 256 samples in float may be off by some steps of 2^-24.
constexpr double rounding_of_sums = 0x1p-21;

/// Why a cell has no budget; empty if it has one.
std::string why_none(const Cell& cell, const scene::Scene& scene) {
  if (cell.call.given) return "the picture is given, so that no stage of it can be refined";
  const auto is_own = [&](const scene::MethodRow& row) { return &row == cell.call.row; };
  if (std::ranges::any_of(surface_methods(), is_own))
    return "an integrator's row replaces the scene's surface; scenes that name the integrator "
           "have one";
  if (cell.call.row->promises.optimizes_opacity && scene::has_importance(scene))
    return "the method chooses opacities itself: what it differs by is meant";
  return "";
}

Image picture_of(const Raster<double>& amounts) {
  Image image(amounts.width, amounts.height);
  std::ranges::transform(amounts.pixels, image.pixels.begin(), [](double amount) {
    return Rgba(glm::vec3(ErrorScale::color(amount)), 1.f);
  });
  return image;
}

}  // namespace

void add_budget(const Cell& cell, const MethodCall& reference, const scene::Scene& scene,
                const scene::RenderContext& context, CellMeasurement& measured) {
  const auto explain = [&](std::string_view why) {
    measured.row.explanation.push_back(fmt::format("error budget: none: {}", why));
  };
  if (const std::string why = why_none(cell, scene); !why.empty()) return explain(why);
  BudgetDrawing drawing(cell, reference, scene, context);
  SplitError split;
  try {
    split = drawing.split();
  } catch (const InputError& error) {  // of stages that go alone, but not together
    return explain(fmt::format("its stages cannot all be refined: {}", error.what()));
  }
  if (split.budget.rmse < rounding_of_sums)
    return explain("nothing to split: the picture is its finest version");
  for (std::size_t i = 0; i < split.amounts.size(); ++i) {
    const BudgetStage& stage = *drawing.active()[i].stage;
    measured.row.pictures.push_back({fmt::format("budget-{}", stage.name),
                                     fmt::format("Error by: {}", stage.title), ErrorScale::min,
                                     ErrorScale::max});
    measured.further.push_back(picture_of(split.amounts[i]));
  }
  measured.row.budget = std::move(split.budget);
}

}  // namespace pellucid::compare
