// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/budget/budget_stages.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "compare/methods/methods.h"
#include "compare/study/study.h"
#include "core/options/names.h"

namespace pellucid::compare {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

MethodCall call(std::string_view name, const RawOptions& options = {}) {
  const scene::MethodRow& row = find_row("method", name, methods());
  return {&row, Parameters(row.name, row.parameters, options)};
}

BudgetTools make_tools() {
  BudgetTools tools{{}, call("linked-list"), call("raytrace"), call("decoupled-lists")};
  tools.options.field = "abc";
  return tools;
}

DrawPlan plan_of(const json& object, std::string_view method = "weighted-average") {
  return {{{"objects", {object}}}, {}, std::nullopt, call(method)};
}

json surface(const std::string& field, const std::string& integrator) {
  return {{"surface",
           {{"field", field},
            {"integrator", integrator},
            {"seed", {{"from", {0, 0, 1}}, {"to", {0, 2, 0}}}}}}};
}

json lines(const std::string& integrator) {
  return {{"lines", surface("abc", integrator)["surface"]}};
}

StageRefinement refine(std::string_view stage, DrawPlan& plan) {
  return find_row("stage", stage, budget_stages()).refine(make_tools(), plan);
}

std::string integrator_after(std::string_view stage, const json& object) {
  DrawPlan plan = plan_of(object);
  EXPECT_EQ(refine(stage, plan).why_not, "");
  const json& made = plan.scene["objects"][0];
  return made[made.contains("lines") ? "lines" : "surface"]["integrator"];
}

TEST(UnitBudgetStages, ClaimsNameThemAsTheyAre) {
  EXPECT_TRUE(std::ranges::equal(budget_stages(), budget_stage_names, {}, &BudgetStage::name));
}

TEST(UnitBudgetStages, TheFormulaTakesTheSamplesPlace) {
  DrawPlan plan = plan_of(surface("abc-20.mha:periodic=x,y,z", "hultquist"));
  EXPECT_EQ(refine("field", plan).what, "abc");
  EXPECT_EQ(plan.scene["objects"][0]["surface"]["field"], "abc");
  EXPECT_THAT(refine("field", plan).why_not, HasSubstr("no field of the scene is sampled"));
}

TEST(UnitBudgetStages, AnUnknownFormulaIsSaid) {
  DrawPlan plan = plan_of(surface("flow.vti", "hultquist"));
  BudgetTools without = make_tools();
  without.options.field.clear();
  EXPECT_THAT(find_row("stage", "field", budget_stages()).refine(without, plan).why_not,
              HasSubstr("the formula behind flow.vti is not known"));
  EXPECT_EQ(plan.scene["objects"][0]["surface"]["field"], "flow.vti");
}

TEST(UnitBudgetStages, MeshesAreDividedAsTheirErrorGoes) {
  EXPECT_EQ(integrator_after("mesh", surface("abc", "hultquist:threshold=0.2,rip=1e-8")),
            "hultquist:rip=1e-8,threshold=0.05");
  EXPECT_EQ(integrator_after("mesh", surface("abc", "hultquist")), "hultquist:threshold=0.0125");
  EXPECT_EQ(integrator_after("mesh", surface("abc", "adaptive-front:tolerance=0.16")),
            "adaptive-front:tolerance=0.01");
  EXPECT_EQ(integrator_after("mesh", surface("abc", "fixed-front:particles=11,rows=21")),
            "fixed-front:particles=41,rows=81");
  EXPECT_EQ(integrator_after("mesh", lines("stream-lines:particles=9")),
            "stream-lines:particles=9,turn=0.75");
  EXPECT_EQ(integrator_after("mesh", lines("stream-lines:step=0.4,turn=8")),
            "stream-lines:step=0.1,turn=2");
}

TEST(UnitBudgetStages, ParticlesMoveFinely) {
  EXPECT_EQ(integrator_after("integration", lines("stream-lines:stepper=euler,dt=0.5,cells=2")),
            "stream-lines:accuracy=2.24e-10");  // 1e-10 of √5 units, as far as the seeds reach
  EXPECT_EQ(integrator_after("integration", lines("stream-lines:accuracy=1e-8")),
            "stream-lines:accuracy=1e-11");
}

TEST(UnitBudgetStages, GivenGeometryHasNoMeshStage) {
  DrawPlan plan = plan_of({{"mesh", "sheets.ply"}});
  EXPECT_THAT(refine("mesh", plan).why_not, HasSubstr("is given"));
  EXPECT_THAT(refine("integration", plan).why_not, HasSubstr("nothing of the scene"));
}

TEST(UnitBudgetStages, AnIsosurfaceIsDrawnItself) {
  DrawPlan plan = plan_of({{"isosurface", {{"mesh", true}}}});
  EXPECT_EQ(refine("mesh", plan).what, "the isosurface itself");
  EXPECT_EQ(plan.scene["objects"][0]["isosurface"]["mesh"], false);
}

TEST(UnitBudgetStages, SamplesDoubleAtLeast) {
  DrawPlan plan = plan_of({});
  refine("samples", plan);
  EXPECT_EQ(plan.samples.per_axis, 4);
  refine("samples", plan);
  EXPECT_EQ(plan.samples.per_axis, 8);
  refine("samples", plan);
  EXPECT_THAT(refine("samples", plan).why_not, HasSubstr("the most"));
  plan.samples = {.frames = 8};
  EXPECT_THAT(refine("samples", plan).why_not, HasSubstr("frames"));
}

TEST(UnitBudgetStages, CompositingGoesByListsToDouble) {
  DrawPlan plan = plan_of({});
  EXPECT_EQ(refine("compositing", plan).what, "linked-list");
  EXPECT_THAT(refine("compositing", plan).why_not, HasSubstr("composites every layer exactly"));
  EXPECT_EQ(refine("arithmetic", plan).what, "raytrace, in double");
  EXPECT_THAT(refine("arithmetic", plan).why_not, HasSubstr("computes in double"));
}

TEST(UnitBudgetStages, OpacitiesKeepWhatBothMethodsKnow) {
  DrawPlan plan = plan_of({});
  EXPECT_THAT(refine("opacities", plan).why_not, HasSubstr("its own"));
  plan.opacities = call("fourier-opacity", {{"q", "40"}, {"bands", "3"}});
  EXPECT_EQ(refine("opacities", plan).why_not, "");
  EXPECT_EQ(plan.opacities->row->name, "decoupled-lists");
  EXPECT_EQ(plan.opacities->parameters.real("q"), 40);
  EXPECT_THAT(refine("opacities", plan).why_not, HasSubstr("sums importance exactly"));
}

}  // namespace
}  // namespace pellucid::compare
