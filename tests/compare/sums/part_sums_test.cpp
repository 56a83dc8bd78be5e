// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of parts of a scene add up to the whole's, for every method that promises so.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "compare/methods/methods.h"
#include "compare/sums/draw_sums.h"
#include "compare/sums/merge_sums.h"
#include "core/error.h"
#include "groundtruth/traversal/scene_part.h"
#include "tests/support/part_scenes.h"
#include "tests/support/pictures.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::compare {
namespace {

using namespace testing;

/// The picture of a method, from parts of a scene in memory.
class FromParts {
 public:
  FromParts(const MethodCall& call, const scene::Scene& scene, int parts) {
    for (int number = 1; number <= parts; ++number)
      parts_.push_back(
          groundtruth::take_part(scene, {number, parts}, scene::PartOf::transparent_objects));
    for (int phase = 1; phase <= phases_; ++phase) add_phase(call, phase);
  }

  Image picture() const { return composite_sums(totals_, "osmesa"); }
  const std::vector<SumsFile>& totals() const { return totals_; }
  int phases() const { return phases_; }

 private:
  void add_phase(const MethodCall& call, int phase) {
    std::vector<scene::SumPlanes> earlier;
    for (const SumsFile& total : totals_) earlier.push_back(total.planes);
    SumsAdder adder;
    for (const groundtruth::ScenePart& part : parts_) {
      const auto renderer = call.row->make(
          part.scene, call.parameters, {.depths = &part.whole.depths, .part = &part.whole.part});
      scene::PartialSums* const sums = renderer->partial_sums();
      phases_ = sums->phases();
      const DeepInfo of = deep_info(part.scene, part.whole.part, {"f", "", false});
      adder.add("part", {{of, "", call.text(), phase, phases_, part.whole.depths},
                         sums->sum(phase - 1, earlier),
                         sums->behind()});
    }
    totals_.push_back(adder.total());
  }

  std::vector<groundtruth::ScenePart> parts_;
  std::vector<SumsFile> totals_;
  int phases_ = 1;
};

/// A sum of parts and a sum of all at once are both sums in some order.
double accepted_difference(const scene::MethodRow& row) { return 2 * row.promises.order_spread; }

void expect_parts_are_the_whole(const scene::Scene& scene, int parts) {
  for (const scene::MethodRow& row : methods()) {
    if (!row.promises.adds_up) continue;
    const MethodCall call = parse_call(row.name);
    const Image whole = render(row, scene).image;
    EXPECT_LE(largest_difference(FromParts(call, scene, parts).picture(), whole),
              accepted_difference(row))
        << row.name << ", " << scene.name << ", " << parts << " parts";
  }
}

TEST(PropertyPartSums, PartsOfEveryKindAddUpToTheWhole) {
  std::uint32_t seed = 0;
  for (const ScenesOfKind& kind : kinds_of_parts)
    expect_parts_are_the_whole(scene_of_kind(kind, ++seed), 3);
}

TEST(PropertyPartSums, OpaqueObjectsHideWhatIsInOtherParts) {
  scene::Scene scene = scene_of_kind(kinds_of_parts[0], 2);
  scene.objects.push_back(part_scenes::opaque_triangles(4));
  scene.objects.push_back(part_scenes::spheres(5));
  for (const int parts : {1, 2, 7}) expect_parts_are_the_whole(scene, parts);
}

TEST(PropertyPartSums, MorePartsThanPrimitivesLeaveSomeEmpty) {
  expect_parts_are_the_whole(stack(5, 4, {Rgba(0.5), Rgba(0.25), Rgba(0.75)}), 9);
}

TEST(PropertyPartSums, EverySettingAddsUp) {
  const scene::Scene scene = scene_of_kind(kinds_of_parts[0], 3);
  for (const char* text :
       {"fourier:bands=20", "fourier:bands=3,precision=16", "fourier:margin=0.2,normalize=off",
        "moment:moments=8,basis=trigonometric", "moment:moments=6", "binning:bins=7,mode=linear",
        "bin-average:bins=20,bins-per-pass=7", "weighted-blended:weight=7",
        "weighted-sum:clamp=on"}) {
    const MethodCall call = parse_call(text);
    const Image whole = call.row->make(scene, call.parameters, {})->render({}).image;
    // Half floats round a sum of two parts to 2^-11 of it, and tau is in an exponent.
    const double half = std::string_view(text).find("precision=16") != std::string_view::npos;
    EXPECT_LE(largest_difference(FromParts(call, scene, 4).picture(), whole),
              accepted_difference(*call.row) + 0.01 * half)
        << text;
  }
}

TEST(UnitPartSums, OneMethodInTwoHasTwoPhases) {
  const scene::Scene scene = stack(3, 3, {Rgba(0.5)});
  EXPECT_EQ(FromParts(parse_call("fourier"), scene, 1).phases(), 2);
  EXPECT_EQ(FromParts(parse_call("bin-average:bins=300"), scene, 1).phases(), 1);
  EXPECT_EQ(FromParts(parse_call("weighted-sum"), scene, 1).phases(), 1);
}

TEST(UnitPartSums, AWeightedSumIsTheSum) {
  // One pixel, two layers of alpha 0.5 and 0.25 in two parts: 0.5 C + 0.25 C and 0.75.
  const FromParts parts(parse_call("weighted-sum"),
                        stack(1, 1, {Rgba(1, 0, 0, 0.5), Rgba(0, 1, 0, 0.25)}), 2);
  const scene::SumPlane& plane = parts.totals().at(0).planes.at(0);
  EXPECT_EQ(plane.name, "sums of colour and opacity 0.0");
  EXPECT_EQ(plane.values, (std::vector<float>{0.5f, 0.25f, 0, 0.75f}));
}

TEST(UnitPartSums, FilesHoldThemToTheLastBit) {
  const TemporaryFolder folder;
  const FromParts parts(parse_call("fourier:bands=3"), scene_of_kind(kinds_of_parts[0], 1), 2);
  for (const SumsFile& sums : parts.totals()) {
    write_sums_file(folder / "sums.exr", sums);
    const SumsFile read = read_sums_file(folder / "sums.exr");
    EXPECT_EQ(read.info.of, sums.info.of);
    EXPECT_EQ(read.info.method, "fourier:bands=3");
    EXPECT_EQ(read.info.phase, sums.info.phase);
    EXPECT_EQ(read.info.depths.near, sums.info.depths.near);
    EXPECT_EQ(read.info.depths.far, sums.info.depths.far);
    EXPECT_EQ(read.behind.pixels, sums.behind.pixels);
    ASSERT_EQ(read.planes.size(), sums.planes.size());
    for (std::size_t i = 0; i < sums.planes.size(); ++i) {
      EXPECT_EQ(read.planes[i].name, sums.planes[i].name);
      EXPECT_EQ(read.planes[i].combine, sums.planes[i].combine);
      EXPECT_EQ(read.planes[i].values, sums.planes[i].values);
    }
  }
}

TEST(UnitPartSums, PlanesThatAreNotTheMethodsAreRefused) {
  const FromParts parts(parse_call("fourier:bands=3"), stack(3, 3, {Rgba(0.5)}), 1);
  const auto refused = [&](const auto& change) {
    std::vector<SumsFile> totals = parts.totals();
    change(totals);
    EXPECT_THROW(composite_sums(totals, "osmesa"), InputError);
  };
  refused([](std::vector<SumsFile>& totals) { totals[0].planes.pop_back(); });
  refused([](std::vector<SumsFile>& totals) { totals[0].planes[1].name = "others"; });
  refused([](std::vector<SumsFile>& totals) { totals[1].planes[0].values.resize(5); });
  refused([](std::vector<SumsFile>& totals) { totals.pop_back(); });
}

TEST(UnitPartSums, WhatIsNoSumIsRefused) {
  scene::Scene scene = stack(3, 3, {Rgba(0.5)});
  const MethodCall subset = parse_call("fourier:subset=2");
  EXPECT_THROW(subset.row->make(scene, subset.parameters, {})->partial_sums(), InputError);
  scene.samples.per_axis = 2;
  const MethodCall sum = parse_call("weighted-sum");
  EXPECT_THROW(sum.row->make(scene, sum.parameters, {})->partial_sums(), InputError);
  for (const scene::MethodRow& row : methods())
    if (!row.promises.adds_up && row.name != "march") {
      EXPECT_EQ(
          row.make(stack(3, 3, {Rgba(0.5)}), parse_call(row.name).parameters, {})->partial_sums(),
          nullptr)
          << row.name;
    }
}

}  // namespace
}  // namespace pellucid::compare
