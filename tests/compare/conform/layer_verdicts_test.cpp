// SPDX-License-Identifier: GPL-3.0-or-later
// Faults of layers: missed, doubled, cut off, in another order.
#include <fmt/format.h>

#include <algorithm>

#include "tests/compare/conform/verdicts.h"

namespace pellucid::compare {
namespace {

using testing::UnitVerdict;

TEST_F(UnitVerdict, NamesTheCap) {
  for (const std::size_t k : {1u, 4u, 8u}) {
    const Verdict nearest = verdict("layers-100", [k](Layers layers) {
      layers.resize(std::min(layers.size(), k));
      return layers;
    });
    EXPECT_EQ(nearest.fault, Fault::capped);
    EXPECT_EQ(nearest.explanation, fmt::format("only the nearest {} layers", k));
  }
  EXPECT_EQ(verdict("layers-10000",
                    [](Layers layers) { return Layers(layers.begin(), layers.begin() + 1024); })
                .fault,
            Fault::capped);
}

TEST_F(UnitVerdict, NamesWhatIsMissedAndWhatIsDoubled) {
  const auto without_last_equal = [](Layers layers) {
    for (std::size_t i = 1; i < layers.size(); ++i)
      if (layers[i] == layers[i - 1]) return layers.erase(layers.begin() + long(i)), layers;
    return layers;
  };
  EXPECT_EQ(verdict("equal-depth-2", without_last_equal).fault, Fault::missed);
  EXPECT_EQ(verdict("equal-depth-5", without_last_equal).fault, Fault::missed);
  const Verdict one_left = verdict("equal-depth-50", [](const Layers& layers) {
    return Layers{layers.front(), layers.back()};
  });
  EXPECT_EQ(one_left.explanation, "of equal layers one is left");
  EXPECT_EQ(verdict("edges-vertices", [](const Layers&) { return Layers(); }).explanation,
            "all layers are missing");
  EXPECT_EQ(verdict("edges-through",
                    [](Layers layers) {
                      layers.push_back(layers.front());
                      return layers;
                    })
                .fault,
            Fault::doubled);
}

TEST_F(UnitVerdict, NamesAnotherOrder) {
  EXPECT_EQ(verdict("layers-10", backwards).explanation,
            "the farthest layer is taken for the nearest");
  EXPECT_EQ(verdict("crossing-3",
                    [](Layers layers) {
                      std::ranges::sort(layers, {}, [](const Rgba& layer) { return layer.r; });
                      return layers;
                    })
                .explanation,
            "layers in another order");
  EXPECT_EQ(verdict("layers-100",
                    [](Layers layers) {
                      std::ranges::sort(layers, {}, [](const Rgba& layer) { return layer.g; });
                      return layers;
                    })
                .fault,
            Fault::misordered);
}

TEST_F(UnitVerdict, NamesEdgesThatCountForEachTriangle) {
  for (const std::size_t times : {2u, 3u, 6u})
    EXPECT_EQ(verdict("edges-vertices",
                      [times](Layers layers) {
                        layers.insert(layers.begin(), times - 1, Rgba(layers.front()));
                        return layers;
                      })
                  .fault,
              Fault::doubled);
}

TEST_F(UnitVerdict, NamesOpacitiesThatEndBelowOne) {
  const Verdict ended = verdict("opaque-alpha", [](Layers layers) {
    for (Rgba& layer : layers) layer.a = std::min(layer.a, 0.99f);
    return layers;
  });
  EXPECT_EQ(ended.explanation, "opacities end at 0.99");
}

/// What the opaque sheet hides is known, too.
TEST_F(UnitVerdict, KnowsWhatIsBehindAnOpaqueSheet) {
  const auto without = [](std::size_t from, std::size_t to) {
    return [=](Layers layers) {
      layers.erase(layers.begin() + long(from), layers.begin() + long(to));
      return layers;
    };
  };
  for (const char* name : {"opaque-alpha", "opaque-object"}) {
    EXPECT_EQ(named(name).of_pixel(0).size(), 5u);
    EXPECT_EQ(verdict(name, backwards).fault, Fault::misordered) << name;
    EXPECT_EQ(verdict(name, without(2, 3)).fault, Fault::missed) << name;
    EXPECT_EQ(verdict(name, without(0, 2)).fault, Fault::missed) << name;
  }
}

TEST_F(UnitVerdict, NamesOpaqueObjectsThatLetThrough) {
  const ConformanceCase& c = named("opaque-object");
  const float alpha = c.scene.objects.back().vertices().colors.front().a;
  EXPECT_LT(alpha, 1);
  const Verdict ignored = verdict(c.name, [alpha](Layers layers) {
    for (Rgba& layer : layers)
      if (layer.a == 1) layer.a = alpha;
    return layers;
  });
  EXPECT_EQ(ignored.fault, Fault::opaque) << ignored.explanation;
  const Verdict mean = verdict(c.name, [&](const Layers& layers) {
    Vec3 sum(0);
    double weight = 0, left = 1;
    for (const Rgba& layer : as_drawn(c, layers)) {
      sum += double(layer.a) * Vec3(layer);
      weight += double(layer.a);
      left *= 1 - double(layer.a);
    }
    return Layers{Rgba(Vec3(sum / weight), 1 - left)};
  });
  EXPECT_EQ(mean.explanation, "no order: the mean colour of all layers");
}

/// What leaves least of the error is named, though blending in 8 bits leaves less than half of it.
TEST_F(UnitVerdict, NamesTheCapOfThinLayers) {
  for (const std::size_t k : {1u, 4u}) {
    const auto nearest = [k](const Layers& all) {
      return Layers(all.begin(), all.begin() + long(k));
    };
    const auto farthest = [k](const Layers& all) { return Layers(all.end() - long(k), all.end()); };
    EXPECT_EQ(verdict("opacity-1-510", nearest).explanation,
              fmt::format("only the nearest {} layers", k));
    EXPECT_EQ(verdict("opacity-1-510", farthest).explanation,
              fmt::format("only the farthest {} layers", k));
  }
}

TEST_F(UnitVerdict, NamesTheOneLayerOfAThousand) {
  const Verdict one = verdict("layers-1000", [](Layers layers) {
    layers.erase(layers.begin() + 500);
    return layers;
  });
  EXPECT_EQ(one.explanation, "a layer is missing in 256 pixels");
}

/// An edge of two triangles, a vertex of six, and neither.
TEST_F(UnitVerdict, CountsEachLayerOfAFewByItself) {
  const auto counted = [](std::vector<std::size_t> times) {
    return [times](const Layers& all) {
      Layers layers;
      for (std::size_t i = 0; i < all.size(); ++i)
        layers.insert(layers.end(), times[i], Rgba(all[i]));
      return layers;
    };
  };
  EXPECT_EQ(verdict("edges-both", counted({2, 6, 1})).fault, Fault::doubled);
  EXPECT_EQ(verdict("edges-both", counted({0, 0, 1})).fault, Fault::missed);
}

/// A turn moves what is right, too: where that stays as it was there is none.
TEST_F(UnitVerdict, TakesNoMissedLayerForAShift) {
  const Verdict one = verdict("points-large", [](Layers layers) {
    layers.resize(std::min<std::size_t>(layers.size(), 1));
    return layers;
  });
  EXPECT_EQ(one.fault, Fault::missed) << one.explanation;
}

}  // namespace
}  // namespace pellucid::compare
