#include "scene/scene_file.h"

#include <gmock/gmock.h>
#include <stdlib.h>

#include <fstream>

#include "core/error.h"
#include "fields/level_field.h"
#include "geometry/mesh_file.h"
#include "scene/appearance.h"
#include "scene/colormap.h"
#include "tests/support/scenes.h"

namespace pellucid {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using namespace testing;

class UnitSceneFile : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "pellucid-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    TriangleMesh mesh = full_layer(0, Rgba(0.25, 0.5, 0.75, 0.125));
    mesh.scalars["speed"] = {0, 1, 2, 4};
    write_mesh(folder_ / "sheet.ply", mesh);
  }
  void TearDown() override { fs::remove_all(folder_); }

  Scene load(const std::string& text) const {
    std::ofstream(folder_ / "scene.json") << text;
    return load_scene(folder_ / "scene.json");
  }
  /// A scene with the given objects and further top-level keys ("\"key\": value, …").
  Scene with(const std::string& objects, const std::string& keys = "") const {
    return load(R"({"format": "pellucid-scene", "version": 1, )" + keys +
                (keys.empty() ? "" : ", ") + R"("objects": [)" + objects + "]}");
  }
  template <class... Texts>
  std::string refusal(const Texts&... texts) const {
    try {
      with(texts...);
    } catch (const InputError& error) {
      return error.what();
    }
    ADD_FAILURE() << "the scene was accepted";
    return {};
  }

  const std::string sheet = R"({"mesh": "sheet.ply"})";
  fs::path folder_;
};

TEST_F(UnitSceneFile, AMeshIsUsedAsItStands) {
  const Scene scene = with(sheet);
  EXPECT_EQ(scene.name, "scene");
  EXPECT_EQ(scene.width, 1000);
  ASSERT_EQ(scene.objects.size(), 1u);
  EXPECT_EQ(scene.objects[0].mesh().colors[0], Rgba(0.25, 0.5, 0.75, 0.125));
}

TEST_F(UnitSceneFile, EveryKeyIsRead) {
  const Scene scene = with(
      R"({"name": "front", "mesh": "sheet.ply", "color": [1, 0, 0.5], "opacity": 0.5, "importance": "speed"})",
      R"("resolution": [30, 20], "background": [0, 0.5, 1], "lighting": "headlight",
         "camera": {"type": "orthographic", "eye": [0, 0, 3], "target": [0, 0, 1], "up": [1, 0, 0], "height": 7})");
  EXPECT_EQ(scene.width, 30);
  EXPECT_EQ(scene.height, 20);
  EXPECT_EQ(scene.background, Vec3(0, 0.5, 1));
  EXPECT_EQ(scene.lighting, Lighting::headlight);
  EXPECT_EQ(scene.camera.projection, Projection::orthographic);
  EXPECT_EQ(scene.camera.height, 7);
  EXPECT_EQ(scene.camera.up, Vec3(1, 0, 0));
  EXPECT_EQ(scene.objects[0].name, "front");
  EXPECT_EQ(scene.objects[0].mesh().colors[3], Rgba(1, 0, 0.5, 0.5));
  EXPECT_EQ(scene.objects[0].mesh().importance, (std::vector<float>{0, 0.25f, 0.5f, 1}));
}

TEST_F(UnitSceneFile, ColourByScalarRunsThroughTheMap) {
  const Scene scene = with(R"({"mesh": "sheet.ply", "color": {"by": "speed", "map": "magma"}})");
  const auto& colors = scene.objects[0].mesh().colors;
  const ColormapRow& magma = find_colormap("magma");
  for (const auto& [vertex, x] : {std::pair(0, 0.0), std::pair(1, 0.25), std::pair(3, 1.0)})
    EXPECT_EQ(colors[vertex], Rgba(magma(x), 0.125));
  const Scene ranged =
      with(R"({"mesh": "sheet.ply", "color": {"by": "speed", "map": "magma", "range": [2, 4]}})");
  EXPECT_EQ(ranged.objects[0].mesh().colors[2], Rgba(magma(0), 0.125));
}

// The sheet's speeds are 0, 1, 2, 4.
TEST_F(UnitSceneFile, OpacityByScalarIsLinearBetweenTheEnds) {
  const auto alphas = [&](const std::string& range) {
    const Scene scene = with(R"({"mesh": "sheet.ply", "opacity": {"by": "speed", )" + range +
                             R"("opacities": [0.75, 0.25]}})");
    std::vector<float> values;
    for (const Rgba& color : scene.objects[0].mesh().colors) values.push_back(color.a);
    return values;
  };
  EXPECT_EQ(alphas(""), (std::vector<float>{0.75f, 0.625f, 0.5f, 0.25f}));
  EXPECT_EQ(alphas(R"("range": [1, 2], )"), (std::vector<float>{0.75f, 0.75f, 0.25f, 0.25f}));
  EXPECT_THAT(refusal(R"({"mesh": "sheet.ply", "opacity": {"by": "speed", "opacities": [0, 2]}})"),
              HasSubstr("objects[0].opacity.opacities[1]: 2; accepted: 0 … 1"));
}

TEST_F(UnitSceneFile, ASurfaceIsIntegrated) {
  const Scene scene = with(
      R"({"surface": {"field": "formula:u=1,v=0,w=0", "integrator": "hultquist:threshold=0.1",
          "seed": {"from": [0, 0, 0], "to": [0, 1, 0]}, "duration": 2}, "opacity": 0.4})");
  const TriangleMesh& mesh = scene.objects[0].mesh();
  // Uniform flow sweeps the rectangle [0, 2] × [0, 1].
  const Box3 box = mesh.bounds();
  EXPECT_LE(glm::length(box.min - Vec3(0)), 1e-9);
  EXPECT_LE(glm::length(box.max - Vec3(2, 1, 0)), 1e-9);
  EXPECT_EQ(mesh.colors[0].a, 0.4f);
  EXPECT_FALSE(scene.provenance.empty());
}

TEST_F(UnitSceneFile, LinesAndPointsHaveAWidthAndAProfile) {
  LineSet lines;
  lines.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  lines.offsets = {0, 3};
  lines.scalars["speed"] = {0, 1, 2};
  write_lines(folder_ / "lines.vtp", lines);
  const Scene scene = with(
      R"({"lines": "lines.vtp", "radius": 0.1, "profile": "tube", "color": {"by": "speed"}, "opacity": 0.5},
         {"points": "sheet.ply", "radius": 0.25, "opaque": true},
         {"lines": {"field": "formula:u=1,v=0,w=0", "integrator": "stream-lines:particles=5",
                    "seed": {"from": [0, 0, 0], "to": [0, 1, 0]}, "duration": 2}, "radius": 0.01})",
      R"("samples": 2)");
  EXPECT_EQ(scene.samples, 2);
  const auto& tube = std::get<LineObject>(scene.objects[0].shape);
  EXPECT_EQ(tube.profile, LineObject::Profile::tube);
  EXPECT_EQ(tube.radius, 0.1);
  EXPECT_EQ(tube.set.colors[2], Rgba(find_colormap("viridis")(1), 0.5));
  const auto& discs = std::get<PointObject>(scene.objects[1].shape);
  EXPECT_EQ(discs.profile, PointObject::Profile::disc);
  EXPECT_EQ(discs.set.positions.size(), 4u);
  EXPECT_TRUE(scene.objects[1].opaque);
  EXPECT_EQ(std::get<LineObject>(scene.objects[2].shape).set.line_count(), 5u);
}

TEST_F(UnitSceneFile, WidthsAreRefusedWhereTheyMeanNothing) {
  EXPECT_THAT(refusal(R"({"mesh": "sheet.ply", "radius": 1})"),
              HasSubstr("objects[0].radius: only lines and points have one"));
  EXPECT_THAT(refusal(R"({"points": "sheet.ply", "radius": 0})"),
              HasSubstr("accepted: a positive length"));
  EXPECT_THAT(refusal(R"({"points": "sheet.ply", "radius": 1, "profile": "tube"})"),
              HasSubstr("disc"));
  EXPECT_THAT(refusal(R"({"lines": "sheet.obj", "radius": 1})"), HasSubstr("sheet.obj"));
}

TEST_F(UnitSceneFile, ASurfaceKeepsWhatItWasMadeFrom) {
  const Scene scene = with(
      R"({"surface": {"field": "rotation", "integrator": "hultquist:threshold=0.2",
          "seed": {"from": [1, 0, 0], "to": [2, 0, 0]}, "duration": 2, "start_time": 3},
          "color": {"by": "t"}})");
  const FlowSource& source = scene.objects[0].source.value();
  EXPECT_EQ(source.duration, 2);
  EXPECT_EQ(source.start_time, 3);
  EXPECT_EQ(source.seed.point_at(0.5), Vec3(1.5, 0, 0));
  const auto& color = std::get<ScalarColor>(source.appearance.color);
  EXPECT_NEAR(glm::length(color.range.value() - Vec2(0, 2)), 0, 1e-9);
}

TEST_F(UnitSceneFile, RefusalsNamePlaceAndAccepted) {
  EXPECT_THAT(refusal(R"({"mesh": "sheet.ply", "opacity": 1.5})"),
              HasSubstr("objects[0].opacity: 1.5; accepted: 0 … 1"));
  EXPECT_THAT(refusal(R"({"mesh": "sheet.ply", "opacty": 1})"),
              HasSubstr("objects[0]: unknown key 'opacty'; known: opacity"));
  EXPECT_THAT(refusal(R"({"mesh": "none.ply"})"),
              AllOf(HasSubstr("objects[0].mesh"), HasSubstr("none.ply")));
  EXPECT_THAT(refusal(R"({"color": [1, 0, 0]})"),
              HasSubstr("exactly one of the keys mesh, surface, lines, points, dataset"));
  EXPECT_THAT(refusal(R"({"mesh": "sheet.ply", "color": {"by": "sped"}})"),
              HasSubstr("unknown scalar 'sped'; known: speed"));
  EXPECT_THAT(refusal(R"({"mesh": "sheet.ply", "color": {"by": "speed", "map": "virids"}})"),
              HasSubstr("unknown colour map 'virids'; known: viridis"));
  EXPECT_THAT(refusal(R"({"mesh": "sheet.ply", "color": [1, 2, 0]})"),
              HasSubstr("objects[0].color[1]: 2; accepted: 0 … 1"));
  EXPECT_THAT(refusal(""), HasSubstr("the scene is empty"));
  EXPECT_THAT(refusal(sheet, R"("resolution": [0, 10])"),
              HasSubstr("resolution[0]: 0; accepted: an integer, 1 …"));
  EXPECT_THAT(refusal(sheet, R"("lighting": "sun")"),
              HasSubstr("accepted: none, headlight, phong"));
  EXPECT_THAT(refusal(sheet, R"("backgroud": [0, 0, 0])"), HasSubstr("known: background"));
}

TEST_F(UnitSceneFile, ACameraInsideOutIsRefused) {
  EXPECT_THAT(refusal(sheet, R"("camera": {"eye": [0, 0, 0], "target": [0, 0, 0]})"),
              HasSubstr("camera.target"));
  EXPECT_THAT(refusal(sheet, R"("camera": {"fov": 180})"), HasSubstr("camera.fov: 180"));
  EXPECT_THAT(refusal(sheet, R"("camera": {"type": "orthographic", "height": -2})"),
              HasSubstr("camera.height: -2"));
  EXPECT_THAT(refusal(sheet, R"("camera": {"type": "orthographic", "fov": 45})"),
              HasSubstr("it takes height"));
  EXPECT_THAT(refusal(sheet, R"("camera": {"eye": [0, 0]})"),
              HasSubstr("camera.eye: [0,0]; accepted: three numbers"));
}

TEST_F(UnitSceneFile, BadSurfacesAreRefusedAtTheirPlace) {
  const auto surface = [](const std::string& field, const std::string& integrator) {
    return R"({"surface": {"field": ")" + field + R"(", "integrator": ")" + integrator +
           R"(", "seed": {"from": [0, 0, 0], "to": [0, 1, 0]}, "duration": 1}})";
  };
  EXPECT_THAT(refusal(surface("abd", "hultquist")),
              AllOf(HasSubstr("objects[0].surface.field"), HasSubstr("known: abc")));
  EXPECT_THAT(refusal(surface("abc", "hultqvist")), HasSubstr("unknown integrator 'hultqvist'"));
  EXPECT_THAT(refusal(surface("abc", "hultquist:threshold=-1")), HasSubstr("threshold=-1"));
  EXPECT_THAT(refusal(surface("formula:u=x+,v=0,w=0", "hultquist")), HasSubstr("u"));
}

TEST_F(UnitSceneFile, SyntaxErrorsNameTheLine) {
  try {
    load("{\n \"format\": ,\n}");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("scene.json"), HasSubstr("line 2")));
  }
  EXPECT_THROW(load(""), InputError);
  EXPECT_THROW(load(R"({"format": "pellucid-scene", "version": 2, "objects": []})"), InputError);
  EXPECT_THROW(load_scene(folder_ / "none.json"), InputError);
}

TEST_F(UnitSceneFile, AnIsosurfaceKeepsTheReconstructionItNames) {
  for (const ReconstructionRow& row : reconstructions) {
    const Scene scene = with(R"({"isosurface": {"dataset": "sphere-levels:levels=1", "value": 0.9,
        "scalar": "magnitude", "reconstruction": ")" +
                             std::string(row.name) + R"("}})");
    const auto& surface = std::get<Isosurface>(scene.objects.front().shape);
    EXPECT_EQ(&surface.field->reconstruction(), &row);  // of the table, no copy that dies
  }
}

TEST_F(UnitSceneFile, EnergyWeightsAreOptional) {
  const Scene scene = with(sheet, R"("energy": {"q": 60, "lambda": 0.26})");
  EXPECT_EQ(scene.energy.q, 60);
  EXPECT_EQ(scene.energy.r, 100);  // the default
  EXPECT_EQ(scene.energy.lambda, 0.26);
  EXPECT_EQ(scene.energy.p, 1);
  EXPECT_THAT(refusal(sheet, R"("energy": {"q": -1})"),
              AllOf(HasSubstr("energy.q"), HasSubstr("-1")));
  EXPECT_THAT(refusal(sheet, R"("energy": {"s": 15})"), HasSubstr("energy"));
}

TEST_F(UnitSceneFile, AnIsosurfaceMayBeAMesh) {
  const auto text = [](const std::string& keys) {
    return R"({"isosurface": {"dataset": "sphere-levels:levels=1", "value": 0.9,
        "scalar": "magnitude", "mesh": true)" +
           keys + R"(}, "color": [1, 0, 0], "opacity": 0.25})";
  };
  const TriangleMesh whole = with(text("")).objects.front().mesh();
  EXPECT_EQ(whole.normals.size(), whole.positions.size());
  EXPECT_EQ(whole.colors.front(), Rgba(1, 0, 0, 0.25));
  const TriangleMesh cut =
      with(text(R"(, "hole": {"center": [0, 0, 0], "radius": 1.5})")).objects.front().mesh();
  EXPECT_LT(cut.triangles.size(), whole.triangles.size());
  for (const auto& triangle : cut.triangles)
    for (const std::uint32_t corner : triangle) EXPECT_GE(glm::length(cut.positions[corner]), 1.5);
}

TEST_F(UnitSceneFile, AnIsosurfaceIsColouredByAScalarOfItsData) {
  const auto text = [](const std::string& color, const std::string& keys = "") {
    return R"({"isosurface": {"dataset": "sphere-levels:levels=1", "value": 0.9,
        "scalar": "magnitude")" +
           keys + R"(}, "opacity": 0.25, "color": {"by": )" + color + "}}";
  };
  const ColormapRow& map = find_colormap("four-color");
  // Its own scalar is 0.9 all over it.
  const Scene scene = with(text(R"("speed", "map": "four-color", "range": [0, 1.8])"));
  const auto& surface = std::get<Isosurface>(scene.objects.front().shape);
  ASSERT_TRUE(surface.coloring);
  EXPECT_EQ(surface.corners.colors.front().a, 0.25f);
  EXPECT_EQ(surface.coloring->scalar.fraction(Vec3(3, 0.5, 0)),
            *surface.field->value(Vec3(3, 0.5, 0)) / 1.8);
  EXPECT_EQ(surface.coloring->color(0.5), map(0.5));
  const TriangleMesh mesh =
      with(text(R"("speed", "map": "four-color", "range": [0, 1.8])", R"(, "mesh": true)"))
          .objects.front()
          .mesh();
  for (const Rgba& color : mesh.colors) {
    EXPECT_LT(glm::length(Vec3(color) - map(0.5)), 1e-5);  // vertices lie on it to some 1e-6
    EXPECT_EQ(color.a, 0.25f);
  }
  // Without a range that of all samples.
  const Scene free = with(text(R"("q")"));
  const auto& coloring = *std::get<Isosurface>(free.objects.front().shape).coloring;
  float low = 1e9f, high = -1e9f;
  for (const float q : coloring.scalar.field->levels().front().samples) {
    low = std::min(low, q);
    high = std::max(high, q);
  }
  EXPECT_EQ(coloring.scalar.range, Vec2(low, high));
  EXPECT_THAT(refusal(text(R"("vorticity")")), HasSubstr("unknown scalar 'vorticity'"));
  EXPECT_THAT(refusal(text(R"("speed", "map": "rainbow")")), HasSubstr("unknown colour map"));
}

TEST_F(UnitSceneFile, ReadsHalosAndCameraPaths) {
  const std::string line = R"({"lines": {"field": "formula:u=1,v=0,w=0", "integrator":
      "stream-lines:particles=2", "seed": {"from": [0, 0, 0], "to": [0, 1, 0]}, "duration": 1},
      "radius": 0.1)";
  const Scene scene =
      with(line + R"(, "halo": {"width": 0.2}})", R"("camera_path": {"orbit": 20, "frames": 5})");
  EXPECT_EQ(std::get<LineObject>(scene.objects.at(0).shape).halo->depth, 0.2);
  EXPECT_TRUE(scene.objects.at(1).is_halo);
  EXPECT_EQ(scene.camera_path.size(), 5u);
  EXPECT_EQ(scene.camera_path.front().eye, scene.camera.eye);
  EXPECT_THAT(refusal(line + R"(, "halo": {"depth": 0.2}})"),
              HasSubstr("halo: the key 'width' is missing"));
  EXPECT_THAT(refusal(R"({"mesh": "sheet.ply", "halo": {"width": 0.2}})"),
              HasSubstr("only lines have one"));
  EXPECT_THAT(refusal(line + "}", R"("camera_path": {"frames": 5})"), HasSubstr("orbit, keys"));
  EXPECT_THAT(refusal(line + "}", R"("camera_path": {"frames": 1, "orbit": 5})"),
              HasSubstr("frames"));
  EXPECT_THAT(refusal(line + "}", R"("camera_path": {"frames": 3, "keys": [{"eye": [1, 0, 0]}]})"),
              HasSubstr("at least two"));
}

TEST_F(UnitSceneFile, AnIsosurfaceFadesByAScalarOfItsData) {
  const auto text = [](const std::string& opacity, const std::string& keys = "") {
    return R"({"isosurface": {"dataset": "sphere-levels:levels=1", "value": 0.9,
        "scalar": "magnitude")" +
           keys + R"(}, "color": [1, 0, 0], "opacity": )" + opacity + "}";
  };
  // Its own scalar is 0.9 all over it: a third of the way.
  const std::string by = R"({"by": "speed", "opacities": [0.9, 0.3], "range": [0.6, 1.5]})";
  const Scene scene = with(text(by));
  const auto& surface = std::get<Isosurface>(scene.objects.front().shape);
  ASSERT_TRUE(surface.fading);
  const Vec3 x(3, 0.5, 0);
  const double share = (*surface.field->value(x) - 0.6) / 0.9;
  EXPECT_NEAR(surface.fading->opacity(x), 0.9 - 0.6 * share, 1e-7);
  EXPECT_EQ(surface.corners.colors.front(), Rgba(1, 0, 0, 1));
  const Scene triangles = with(text(by, R"(, "mesh": true)"));
  for (const Rgba& color : triangles.objects.front().mesh().colors) {
    EXPECT_NEAR(color.a, 0.7, 1e-5);  // vertices lie on it to some 1e-6
    EXPECT_EQ(Vec3(color), Vec3(1, 0, 0));
  }
  // Constant beyond the range.
  const Scene beyond = with(text(R"({"by": "speed", "opacities": [0.9, 0.3], "range": [0, 0.1]})"));
  EXPECT_FLOAT_EQ(std::get<Isosurface>(beyond.objects.front().shape).fading->opacity(x), 0.3f);
  EXPECT_THAT(refusal(text(R"({"by": "vorticity", "opacities": [0, 1]})")),
              HasSubstr("unknown scalar 'vorticity'"));
}

TEST_F(UnitSceneFile, AnIsosurfaceMayBeCutAlongABody) {
  write_mesh(folder_ / "body.ply", sphere(4, Rgba(1)));  // facets within 0.005 of the unit sphere
  const auto text = [](const std::string& hole) {
    return R"({"isosurface": {"dataset": "sphere-levels:levels=1", "value": 0.9,
        "scalar": "magnitude", "hole": )" +
           hole + "}}";
  };
  const Scene scene = with(text(R"({"mesh": "body.ply", "distance": 0.25})"));
  const auto& surface = std::get<Isosurface>(scene.objects.front().shape);
  EXPECT_TRUE(surface.cuts_away(Vec3(0.3, 0.2, 0.1)));
  for (const Vec3 direction : {Vec3(1, 0, 0), Vec3(0.6, 0, -0.8), Vec3(0, -0.8, 0.6)}) {
    EXPECT_TRUE(surface.cuts_away(1.24 * direction));
    EXPECT_FALSE(surface.cuts_away(1.26 * direction));
  }
  write_mesh(folder_ / "open.ply", rectangle(0, 1, 0, 1, 0, Rgba(1)));
  EXPECT_THAT(refusal(text(R"({"mesh": "open.ply"})")),
              AllOf(HasSubstr("hole.mesh"), HasSubstr("closed mesh")));
  EXPECT_THAT(refusal(text(R"({"mesh": "body.ply", "radius": 1})")), HasSubstr("radius"));
  EXPECT_THAT(refusal(text(R"({"mesh": "body.ply", "distance": -1})")), HasSubstr("distance"));
}

TEST(UnitAppearance, NormalsAreAreaWeighted) {
  TriangleMesh mesh = sphere(3, Rgba(1));
  mesh.normals.clear();
  ensure_normals(mesh);
  // On a regular subdivision of the sphere the mean of the facets deviates by 2.8° at most.
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    EXPECT_GT(std::abs(glm::dot(mesh.normals[i], mesh.positions[i])),
              std::cos(2.81 * std::numbers::pi / 180));
}

TEST(UnitColormap, EndsAndMiddleAreMatplotlibs) {
  const ColormapRow& viridis = find_colormap("viridis");
  EXPECT_EQ(viridis(0) * 255.0, Vec3(68, 1, 84));
  EXPECT_EQ(viridis(1) * 255.0, Vec3(253, 231, 37));
  EXPECT_EQ(viridis(-5), viridis(0));
  EXPECT_EQ(viridis(7), viridis(1));
}

TEST(UnitColormap, FourColoursPartTheRangeInThree) {
  const ColormapRow& map = find_colormap("four-color");
  const Vec3 knots[] = {{0, 0.9, 0.2}, {0.8, 0.8, 0}, {1, 0, 0}, {0.4, 0.6, 0}};
  for (int i = 0; i < 4; ++i) EXPECT_LT(glm::length(map(i / 3.0) - knots[i]), 1e-15);
  EXPECT_LT(glm::length(map(0.5) - 0.5 * (knots[1] + knots[2])), 1e-15);
  EXPECT_EQ(map(2), map(1));
}

}  // namespace
}  // namespace pellucid
