// SPDX-License-Identifier: GPL-3.0-or-later
// The suite's answers are right, and each kind of fault is told.
#include "compare/conform/conform.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <glm/gtc/packing.hpp>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "compare/methods/methods.h"
#include "compare/pictures/image_file.h"
#include "compare/pictures/srgb.h"
#include "core/error.h"
#include "core/files/json_text.h"
#include "core/options/names.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::compare {
namespace {

using pellucid::testing::TemporaryFolder;
using ::testing::HasSubstr;

MethodCall call(std::string_view method) {
  const scene::MethodRow& row = find_row("method", method, methods());
  return {&row, Parameters(row.name, row.parameters, {})};
}

/// The closed forms and the exact renderer come to the same by different ways.
TEST(AgreementConform, RaytracePassesEveryCase) {
  const std::vector<CaseResult> results = conform({.call = call("raytrace")});
  EXPECT_GE(results.size(), 35u);
  for (const CaseResult& result : results) {
    EXPECT_TRUE(result.verdict.passed) << result.name << ": " << result.verdict.explanation;
    EXPECT_LT(result.verdict.max_error, 1e-6) << result.name;  // it is stored in floats
  }
}

/// Which mixes all layers: it is right where a pixel's layers have one colour, and only there.
TEST(AgreementConform, WeightedAverageFailsWhereLayersDiffer) {
  const std::vector<ConformanceCase> cases = conformance_cases();
  for (const CaseResult& result :
       conform({.call = call("weighted-average"), .only = "[!ls]*"})) {  // thin things may miss
    const ConformanceCase& c = *std::ranges::find(cases, result.name, &ConformanceCase::name);
    const bool of_one_color = std::ranges::all_of(c.layers, [](const Layers& layers) {
      return std::ranges::all_of(layers, [&](const Rgba& layer) {
        return layer.a == 0 || Vec3(layer) == Vec3(layers.front()) || layers.front().a == 0;
      });
    });
    if (of_one_color && c.family == "edges") {
      EXPECT_TRUE(result.verdict.passed) << result.name;
    }
    if (!of_one_color && c.family != "opaque" && c.family != "opacity") {
      EXPECT_EQ(result.verdict.fault, Fault::misordered)
          << result.name << ": " << result.verdict.explanation;
    }
  }
}

/// Every family begins with a case of fewer layers, and ends with one that is harder.
TEST(UnitConformanceCases, HaveNamesOfTheirOwnAndPixelsAwayFromRims) {
  std::set<std::string> names;
  for (const ConformanceCase& c : conformance_cases()) {
    EXPECT_TRUE(names.insert(c.name).second) << c.name;
    EXPECT_TRUE(c.name.starts_with(c.family + "-"));
    EXPECT_EQ(c.which.pixels.size(), 256u);
    for (const scene::SceneObject& object : c.scene.objects)
      for (const Vec3& x : object.vertices().positions)
        EXPECT_EQ(x, Vec3(glm::vec3(x))) << c.name << ": its file holds floats";
  }
}

TEST(UnitConformanceCases, CompositeIsTheKnownPower) {
  const Layers equal(10, Rgba(1, 0.5, 0, 0.25));
  const glm::dvec4 sum = composite_of(equal, {0, 0, 1});
  EXPECT_NEAR(sum.a, 1 - std::pow(0.75, 10), 1e-15);
  EXPECT_NEAR(sum.g, 0.5 * sum.a, 1e-15);
  EXPECT_NEAR(sum.b, 1 - sum.a, 1e-15);
}

/// A right renderer but for what becomes of each pixel's layers.
class UnitVerdict : public ::testing::Test {
 protected:
  static const ConformanceCase& named(std::string_view name) {
    static const std::vector<ConformanceCase> cases = conformance_cases();
    return *std::ranges::find(cases, name, &ConformanceCase::name);
  }

  static Verdict verdict(std::string_view name, const std::function<Layers(Layers)>& change,
                         std::optional<Vec3> background = std::nullopt) {
    const ConformanceCase& c = named(name);
    Image image(c.scene.width, c.scene.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      image.pixels[i] =
          Rgba(composite_of(change(c.of_pixel(i)), background.value_or(c.scene.background)));
    return judge(c, image, false);
  }

  static Layers as_they_are(Layers layers) { return layers; }
};

TEST_F(UnitVerdict, OfTheRightPictureIsThatItPasses) {
  for (const ConformanceCase& c : conformance_cases()) {
    EXPECT_TRUE(judge(c, expected_picture(c), false).passed) << c.name;
    EXPECT_TRUE(judge(c, displayed_values(expected_picture(c)), true).passed) << c.name;
  }
}

TEST_F(UnitVerdict, NamesAResultOfEightBitsInAFileOfFloats) {
  const ConformanceCase& c = named("layers-10");
  EXPECT_EQ(judge(c, displayed_values(expected_picture(c)), false).fault, Fault::eight_bits);
}

/// Half floats err by as little as 8 bits do, but otherwise.
TEST_F(UnitVerdict, TakesNoHalfFloatsForEightBits) {
  const ConformanceCase& c = named("layers-10");
  Image halves = expected_picture(c);
  for (Rgba& pixel : halves.pixels)
    for (int k = 0; k < 3; ++k) pixel[k] = glm::unpackHalf1x16(glm::packHalf1x16(pixel[k]));
  const Verdict verdict = judge(c, halves, false, 1e-6);
  EXPECT_FALSE(verdict.passed);
  EXPECT_NE(verdict.fault, Fault::eight_bits);
}

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
  const auto backwards = [](Layers layers) {
    std::ranges::reverse(layers);
    return layers;
  };
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

TEST_F(UnitVerdict, NamesAnotherBackground) {
  EXPECT_EQ(verdict("layers-10", as_they_are, Vec3(0)).fault, Fault::background);
  const Verdict white = verdict("lines-wide", as_they_are, Vec3(1));
  EXPECT_EQ(white.fault, Fault::background);
  EXPECT_THAT(white.explanation, HasSubstr("(1, 1, 1) shows through, not (0.1, 0.5, 0.9)"));
}

/// Blending in 8 bits draws nothing of 255 layers of half a step.
TEST_F(UnitVerdict, NamesBlendingInEightBits) {
  const ConformanceCase& c = named("opacity-1-510");
  Image image(c.scene.width, c.scene.height, Rgba(c.scene.background, 1));
  EXPECT_EQ(judge(c, displayed_values(image), false).fault, Fault::eight_bits);
}

TEST_F(UnitVerdict, NamesAPictureThatIsTurned) {
  const ConformanceCase& c = named("points-large");
  Image image = expected_picture(c);
  std::ranges::reverse(image.pixels);
  const Verdict turned = judge(c, image, false);
  EXPECT_EQ(turned.fault, Fault::picture);
  EXPECT_THAT(turned.explanation, HasSubstr("180 degrees"));
}

/// Small errors look right: they are never said to be of another order, or of no change at all.
TEST_F(UnitVerdict, NamesWhatKeepsFewDigits) {
  const auto halves = [](float x) { return glm::unpackHalf1x16(glm::packHalf1x16(x)); };
  const auto bytes = [](float x) { return std::round(255 * x) / 255; };
  const auto each = [](const auto& round, bool color) {
    return [=](Layers layers) {
      for (Rgba& l : layers)
        l = color ? Rgba(round(l.r), round(l.g), round(l.b), round(l.a))
                  : Rgba(l.r, l.g, l.b, round(l.a));
      return layers;
    };
  };
  for (const ConformanceCase& c : conformance_cases()) {
    const Verdict half = verdict(c.name, each(halves, true)),
                  byte = verdict(c.name, each(bytes, true)),
                  alpha = verdict(c.name, each(bytes, false));
    if (!half.passed) {
      EXPECT_EQ(half.fault, Fault::precision) << c.name << ": " << half.explanation;
    }
    if (!byte.passed) {
      EXPECT_EQ(byte.fault, Fault::eight_bits) << c.name << ": " << byte.explanation;
    }
    if (!alpha.passed) {
      EXPECT_EQ(alpha.fault, Fault::eight_bits) << c.name << ": " << alpha.explanation;
    }
  }
}

TEST_F(UnitVerdict, NamesABlackBackgroundInAFileOfEightBits) {
  for (const ConformanceCase& c : conformance_cases()) {
    Image image(c.scene.width, c.scene.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      image.pixels[i] = Rgba(composite_of(c.of_pixel(i), Vec3(0)));
    const Verdict black = judge(c, displayed_values(image), true);
    if (!black.passed && black.max_error > 0.02) {
      EXPECT_EQ(black.fault, Fault::background) << c.name << ": " << black.explanation;
    }
  }
}

TEST_F(UnitVerdict, NamesATransferCurve) {
  for (const char* name : {"layers-1", "layers-10", "crossing-3", "points-large"}) {
    const ConformanceCase& c = named(name);
    Image image = expected_picture(c);
    for (Rgba& pixel : image.pixels)
      pixel = Rgba(encoded_as_srgb(pixel.r), encoded_as_srgb(pixel.g), encoded_as_srgb(pixel.b), 1);
    const Verdict curve = judge(c, image, false);
    EXPECT_EQ(curve.fault, Fault::colors) << name << ": " << curve.explanation;
    EXPECT_EQ(curve.explanation, "encoded as sRGB");
  }
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

/// In every case, whatever its layers; what is not seen passes.
void expect_everywhere(std::string_view fault,
                       const std::function<Image(const ConformanceCase&)>& drawn) {
  for (const ConformanceCase& c : conformance_cases()) {
    const Verdict verdict = judge(c, drawn(c), false);
    if (!verdict.passed) {
      EXPECT_EQ(verdict.fault, fault) << c.name << ": " << verdict.explanation;
    }
  }
}

template <class Change>
Image changed(const ConformanceCase& c, const Change& change) {
  Image image = expected_picture(c);
  for (Rgba& pixel : image.pixels) pixel = change(pixel);
  return image;
}

/// One layer's picture has but one colour to tell a background by: that it is grey bears it out.
TEST(UnitVerdictOfTheSuite, NamesAGreyBackground) {
  expect_everywhere(Fault::background, [](const ConformanceCase& c) {
    Image image(c.scene.width, c.scene.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      image.pixels[i] = Rgba(composite_of(c.of_pixel(i), Vec3(0.5)));
    return image;
  });
}

/// A background has to differ from the scene's own to be another one.
TEST(UnitVerdictOfTheSuite, NamesTheRoundingOfHalfFloats) {
  expect_everywhere(Fault::precision, [](const ConformanceCase& c) {
    return changed(c, [](Rgba p) {
      for (int k = 0; k < 3; ++k) p[k] = glm::unpackHalf1x16(glm::packHalf1x16(p[k]));
      return p;
    });
  });
}

TEST(UnitVerdictOfTheSuite, NamesWrongColours) {
  const std::function<Rgba(Rgba)> wrong[] = {
      [](Rgba p) { return Rgba(255.f * glm::vec3(p), p.a); },
      [](Rgba p) { return Rgba(1.1f * glm::vec3(p), p.a); },
      [](Rgba p) { return Rgba(p.b, p.g, p.r, p.a); },
      [](Rgba p) { return Rgba(glm::pow(glm::vec3(p), glm::vec3(1 / 2.2f)), p.a); },
      [](Rgba p) { return Rgba(glm::pow(glm::vec3(p), glm::vec3(2.2f)), p.a); }};
  for (const auto& change : wrong)
    expect_everywhere(Fault::colors, [&](const ConformanceCase& c) { return changed(c, change); });
  const auto is = [](const auto& change, const char* text) {
    const ConformanceCase c = conformance_cases().front();
    EXPECT_EQ(judge(c, changed(c, change), false).explanation, text);
  };
  is(wrong[0], "values of 0 to 255 in the place of 0 to 1");
  is(wrong[1], "values are multiplied by 1.1");
  is(wrong[2], "channels are exchanged: BGR for RGB");
  is(wrong[3], "values are raised to a power of 1/2.2");
  is(wrong[4], "values are raised to a power of 2.2");
}

/// What the opaque sheet hides is known, too.
TEST_F(UnitVerdict, KnowsWhatIsBehindAnOpaqueSheet) {
  const auto backwards = [](Layers layers) {
    std::ranges::reverse(layers);
    return layers;
  };
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

TEST_F(UnitVerdict, NamesAShiftByWholePixels) {
  const ConformanceCase& c = named("points-small");
  const Image right = expected_picture(c);
  Image moved = right;
  for (int y = 0; y < right.height; ++y)
    for (int x = 1; x < right.width; ++x) moved.at(x, y) = right.at(x - 1, y);
  EXPECT_EQ(judge(c, moved, false).explanation, "shifted by 1 pixels to the right and 0 down");
}

TEST(UnitConform, TakesPicturesFromAFolderAndTellsWhichAreMissing) {
  const TemporaryFolder folder;
  for (const ConformanceCase& c : conformance_cases())
    if (c.name == "layers-1") write_image(folder / "layers-1.png", expected_picture(c), {});
  const auto results = conform({.call = {}, .pictures = folder.path(), .only = "layers-1*"});
  ASSERT_EQ(results.size(), 5u);
  EXPECT_TRUE(results[0].verdict.passed);
  EXPECT_EQ(results[1].verdict.fault, Fault::no_picture);
  EXPECT_THAT(results[1].verdict.explanation, HasSubstr("neither layers-10.exr nor .png"));
  const auto families = summarize(results);
  ASSERT_EQ(families.size(), 1u);
  EXPECT_EQ(families[0].passed, 1);
  EXPECT_EQ(families[0].first_failed->name, "layers-10");
  EXPECT_THROW(conform({.call = call("raytrace"), .only = "nothing*"}), InputError);
}

TEST(UnitConform, LeavesItsScenesForOthers) {
  const TemporaryFolder folder;
  make_conformance_scenes(folder.path(), "opaque-*");
  const nlohmann::json list = read_json(folder / "cases.json");
  ASSERT_EQ(list["cases"].size(), 2u);
  EXPECT_EQ(read_json(folder / "opaque-object" / "scene.json")["objects"][1]["opaque"], true);
  EXPECT_EQ(read_image(folder / "opaque-alpha" / "expected.exr").width, 16);
}

}  // namespace
}  // namespace pellucid::compare
