// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/frames/painter.h"

#include <cstring>

#include "compare/methods/methods.h"
#include "compare/pictures/metrics.h"
#include "compare/results/probe_json.h"
#include "core/error.h"
#include "core/options/names.h"
#include "scene/files/scene_file.h"
#include "tests/view/small_scene.h"

namespace pellucid::view {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

/// A frame as the page takes it apart.
struct Frame {
  nlohmann::json header;
  std::vector<Image> images;

  explicit Frame(const std::string& bytes) {
    std::uint32_t length = 0;
    for (int i = 0; i < 4; ++i)
      length |= std::uint32_t(static_cast<unsigned char>(bytes[i])) << (8 * i);
    header = nlohmann::json::parse(bytes.substr(4, length));
    const int width = header["size"][0], height = header["size"][1];
    std::size_t at = 4 + length;
    for (std::size_t k = 0; k < header["pictures"].size(); ++k) {
      Image image(width, height);
      for (int channel = 0; channel < 3; ++channel)
        for (Rgba& pixel : image.pixels) {
          std::memcpy(&pixel[channel], &bytes.at(at), sizeof(float));
          at += sizeof(float);
        }
      images.push_back(image);
    }
    EXPECT_EQ(at, bytes.size());
  }
};

class UnitPainter : public SmallScene {
 protected:
  Frame frame(nlohmann::json request, std::vector<std::string> methods) {
    request["methods"] = methods;
    return Frame(painter().frame(read_frame_request(JsonNode("request", request)), {}));
  }
  Painter& painter() {
    if (!painter_) {
      scene_.emplace(file());
      painter_.emplace(*scene_, "osmesa");
    }
    return *painter_;
  }
  /// The picture that `render` makes of a scene file.
  static Image rendered(scene::Scene scene, const std::string& call) {
    const NameAndOptions named = parse_name_and_options(call);
    const auto& row = find_row("method", named.name, compare::methods());
    return row.make(scene, Parameters(row.name, row.parameters, named.options), {})
        ->render({})
        .image;
  }
  scene::Scene scene_with(const std::string& what, const std::string& by) const {
    std::string changed = text();
    changed.replace(changed.find(what), what.size(), by);
    write_text(folder_ / "other.json", changed);
    return scene::load_scene(folder_ / "other.json");
  }

  std::optional<ViewedScene> scene_;
  std::optional<Painter> painter_;
};

void expect_equal(const Image& a, const Image& b) {
  ASSERT_EQ(a.pixels.size(), b.pixels.size());
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) ASSERT_EQ(a.pixels[i][c], b.pixels[i][c]) << i;
}

// To the last bit, from whichever side it was seen before.
TEST_F(UnitPainter, DrawsWhatRenderDraws) {
  nlohmann::json turned = state();
  turned["camera"]["eye"] = {3, 1, -2};
  turned["samples"] = 2;
  frame(turned, {"raytrace"});
  const Frame seen = frame(state(), {"raytrace", "weighted-average"});
  expect_equal(seen.images[0], rendered(scene::load_scene(file()), "raytrace"));
  expect_equal(seen.images[1], rendered(scene::load_scene(file()), "weighted-average"));
  scene::Scene other = scene_with("[0, 0, 4]", "[3, 1, -2]");
  other.samples = {.per_axis = 2};
  expect_equal(frame(turned, {"raytrace"}).images[0], rendered(other, "raytrace"));
}

TEST_F(UnitPainter, MeasuresTheSecondPictureAgainstTheFirst) {
  nlohmann::json request = state();
  request["metrics"] = {"rmse", "ssim"};
  const Frame seen = frame(request, {"raytrace", "weighted-average"});
  EXPECT_EQ(seen.header["metrics"]["rmse"], compare::rmse(seen.images[0], seen.images[1]));
  EXPECT_EQ(seen.header["metrics"]["ssim"], *compare::ssim(seen.images[0], seen.images[1]));
  EXPECT_GT(seen.header["metrics"]["rmse"], 1e-4);
}

// A control is the same as another scene file.
TEST_F(UnitPainter, SettingsAreThoseOfTheSceneFile) {
  const struct {
    nlohmann::json objects;
    const char *what, *by;
  } cases[] = {
      {{{{"opacity", "0.9"}}, nlohmann::json::object()}, "\"opacity\": 0.4", "\"opacity\": 0.9"},
      {{{{"map", "magma"}}, nlohmann::json::object()}, "viridis", "magma"},
      {{nlohmann::json::object(), {{"radius", "0.1"}}}, "0.05, \"color\"", "0.1, \"color\""},
      {{nlohmann::json::object(), {{"halo-width", "0.2"}}},
       "{\"width\": 0.05}",
       "{\"width\": 0.2}"}};
  const Image plain = frame(state(), {"raytrace"}).images[0];
  for (const auto& [objects, what, by] : cases) {
    nlohmann::json request = state();
    request["objects"] = objects;
    const Image seen = frame(request, {"raytrace"}).images[0];
    expect_equal(seen, rendered(scene_with(what, by), "raytrace"));
    EXPECT_GT(compare::rmse(plain, seen), 1e-4) << by;
  }
  expect_equal(frame(state(), {"raytrace"}).images[0], plain);
}

TEST_F(UnitPainter, AProbeIsThatOfRender) {
  nlohmann::json request = state();
  request["pixel"] = {20, 12};
  request["method"] = "fourier:bands=3";
  const nlohmann::json answer =
      painter().probe(read_probe_request(JsonNode("request", request)), {});
  const nlohmann::json exact = compare::probe_json(scene::load_scene(file()), {20, 12});
  EXPECT_EQ(answer["exact"], exact);
  EXPECT_THAT(exact["pixels"][0]["layers"], SizeIs(::testing::Gt(0u)));
  EXPECT_EQ(answer["names"].size(), 3u);      // the lines' halo is one
  ASSERT_THAT(answer["curves"], SizeIs(1u));  // no importance, no G
  const nlohmann::json& tau = answer["curves"][0];
  ASSERT_EQ(tau["exact"].size(), answer["d"].size());
  for (std::size_t i = 0; i < answer["d"].size(); ++i) {
    nlohmann::json expected = 0.0;  // of the last layer that is no farther
    for (const nlohmann::json& layer : exact["pixels"][0]["layers"])
      if (layer["d"] <= answer["d"][i]) expected = layer["optical_depth"];
    ASSERT_EQ(tau["exact"][i], expected) << answer["d"][i];
  }
  // A Fourier series ends at the sum's end: Eq. 5's terms vanish at d = 1.
  EXPECT_NEAR(tau["method"].back(), tau["exact"].back().get<double>(), 1e-3);
}

TEST_F(UnitPainter, AWrongRequestIsToldInOneLine) {
  const struct {
    const char *key, *value, *message;
  } cases[] = {{"size", "[0, 10]", "size[0]"},
               {"size", "[10, 100000]", "size[1]"},
               {"samples", "99", "samples"},
               {"camera", R"({"eye": [0, 0, 0]})", "camera"},
               {"methods", "[]", "one call or two"},
               {"methods", R"(["furier"])", "fourier"},
               {"methods", R"(["fourier:bands=x"])", "bands"},
               {"objects", R"([{"opacity": 1}, {}])", "opacity"},
               {"objects", R"([{"opacity": "2"}, {}])", "opacity"},
               {"objects", R"([{"file": "/etc/passwd"}, {}])", "file"},
               {"objects", R"([{"opacity": "1"}])", "objects"},
               {"metrics", R"(["rmsee"])", "rmse"},
               {"file", "1", "file"}};
  for (const auto& [key, value, message] : cases) {
    nlohmann::json request = state();
    request["methods"] = {"raytrace"};
    request[key] = nlohmann::json::parse(value);
    try {
      painter().frame(read_frame_request(JsonNode("request", request)), {});
      ADD_FAILURE() << key << ' ' << value;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(message));
    }
  }
}

}  // namespace
}  // namespace pellucid::view
