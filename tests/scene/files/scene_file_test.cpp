// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/files/scene_file.h"

#include "scene/appearance/appearance.h"
#include "scene/appearance/colormap.h"
#include "tests/scene/files/scene_file_folder.h"

namespace pellucid::scene {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using namespace testing;

class UnitSceneFile : public SceneFileTest {};

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

TEST_F(UnitSceneFile, ImportanceMayBeTheSameEverywhere) {
  const Scene scene = with(R"({"mesh": "sheet.ply", "importance": 0.25})");
  EXPECT_EQ(scene.objects[0].mesh().importance, std::vector<float>(4, 0.25f));
  EXPECT_THAT(refusal(R"({"mesh": "sheet.ply", "importance": 1.5})"),
              HasSubstr("objects[0].importance: 1.5; accepted: 0 … 1"));
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
TEST_F(UnitSceneFile, VerticesThatNothingIsDrawnOfDecideNothing) {
  std::ofstream(folder_ / "far.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 500 500 500\nf 1 2 3\n";
  const Scene scene = with(R"({"mesh": "far.obj"})");
  EXPECT_EQ(scene.bounds().max, Vec3(1, 1, 0));
  EXPECT_LT(glm::length(scene.camera.eye), 10);
  EXPECT_THAT(scene.objects.front().vertices().remarks,
              ::testing::ElementsAre("1 of 4 vertices are of no triangle, and are left out"));
  std::ofstream(folder_ / "far.ply")
      << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
         "property float z\nelement edge 1\nproperty int vertex1\nproperty int vertex2\n"
         "end_header\n0 0 0\n500 500 500\n1 0 0\n0 2\n";
  EXPECT_EQ(with(R"({"lines": "far.ply", "radius": 0.5})").bounds().max, Vec3(1.5, 0.5, 0.5));
}

TEST_F(UnitSceneFile, TrianglesThatPassOverMuchOfAMapAreSaid) {
  const auto remarks = [&](const std::string& range) {
    return with(R"({"mesh": "sheet.ply", "color": {"by": "speed")" + range + "}}")
        .objects.front()
        .vertices()
        .remarks;
  };
  EXPECT_THAT(remarks(""), ::testing::ElementsAre("a triangle passes over 1 of the colour map, "
                                                  "which it has at its ends alone"));
  EXPECT_THAT(remarks(R"(, "range": [-4, 50])"), ::testing::SizeIs(0));
  EXPECT_THAT(remarks(R"(, "range": [-4, 12])"), ::testing::SizeIs(1));
  EXPECT_THAT(remarks(R"(, "range": [5, 6])"), ::testing::SizeIs(0));  // all have the low end's
}

TEST_F(UnitSceneFile, AScalarWithoutAnyNumberIsSaid) {
  std::ofstream(folder_ / "none.csv") << "x,y,z,p\n0,0,0,nan\n1,0,0,nan\n";
  const auto remarks = [&](const std::string& keys) {
    return with(R"({"points": "none.csv", "radius": 0.1, )" + keys + "}")
        .objects.front()
        .vertices()
        .remarks;
  };
  EXPECT_THAT(remarks(R"("color": {"by": "p"})"),
              ::testing::ElementsAre("no value of 'p' is a number: its colour is that of none"));
  EXPECT_THAT(remarks(R"("opacity": {"by": "p", "opacities": [0.2, 0.8]})"),
              ::testing::ElementsAre("no value of 'p' is a number: its opacity is that of none"));
  EXPECT_THAT(remarks(R"("opacity": 0.5)"), ::testing::SizeIs(0));
}

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
  const geometry::TriangleMesh& mesh = scene.objects[0].mesh();
  // Uniform flow sweeps the rectangle [0, 2] × [0, 1].
  const Box3 box = mesh.bounds();
  EXPECT_LE(glm::length(box.min - Vec3(0)), 1e-9);
  EXPECT_LE(glm::length(box.max - Vec3(2, 1, 0)), 1e-9);
  EXPECT_EQ(mesh.colors[0].a, 0.4f);
  EXPECT_FALSE(scene.provenance.empty());
}

TEST_F(UnitSceneFile, LinesAndPointsHaveAWidthAndAProfile) {
  geometry::LineSet lines;
  lines.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  lines.offsets = {0, 3};
  lines.scalars["speed"] = {0, 1, 2};
  geometry::write_lines(folder_ / "lines.vtp", lines);
  const Scene scene = with(
      R"({"lines": "lines.vtp", "radius": 0.1, "profile": "tube", "color": {"by": "speed"}, "opacity": 0.5},
         {"points": "sheet.ply", "radius": 0.25, "opaque": true},
         {"lines": {"field": "formula:u=1,v=0,w=0", "integrator": "stream-lines:particles=5",
                    "seed": {"from": [0, 0, 0], "to": [0, 1, 0]}, "duration": 2}, "radius": 0.01})",
      R"("samples": 2)");
  EXPECT_EQ(scene.samples, PixelSampling{.per_axis = 2});
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
  // The last vertex stands at the duration itself, and the first at its start: nothing is rounded.
  EXPECT_EQ(color.range.value(), Vec2(0, 2));
}

TEST_F(UnitSceneFile, SheetsAreMeshesOfTheirOwn) {
  const auto sheet = [](const std::string& integrator, const std::string& rest) {
    return R"({"surface": {"field": "drift", "integrator": ")" + integrator +
           R"(:particles=3", "duration": 1, )" + rest + R"(}, "color": {"by": "released"}})";
  };
  const std::string line = R"("seed": {"from": [0, 0, 0], "to": [0, 0, 1]})";
  const std::string patch = R"("seed": {"corner": [0, 0, 0], "u": [1, 0, 0], "v": [0, 0, 1]})";
  EXPECT_FALSE(with(sheet("streak-surface", line)).objects[0].source);
  const Scene patches = with(sheet("time-surface", patch));
  EXPECT_TRUE(patches.objects[0].mesh().scalars.contains("u"));
  EXPECT_FALSE(with(sheet("time-surface", R"("seed": {"center": [0, 0, 0], "radius": 1})"))
                   .objects[0]
                   .mesh()
                   .triangles.empty());
  EXPECT_FALSE(with(sheet("time-surface", R"("seed": {"mesh": "sheet.ply"})"))
                   .objects[0]
                   .mesh()
                   .triangles.empty());
  EXPECT_THAT(refusal(sheet("time-surface", line)), HasSubstr("surface.seed"));
  EXPECT_THAT(refusal(sheet("streak-surface", patch)), HasSubstr("surface.seed"));
  EXPECT_THAT(refusal(sheet("streak-surface", line + R"(, "path": true)")), HasSubstr("'path'"));
  EXPECT_THAT(refusal(sheet("time-surface", R"("seed": {"mesh": "none.ply"})")),
              HasSubstr("none.ply"));
  EXPECT_THAT(
      refusal(R"({"surface": {"field": "drift", "integrator": "path-lines", "duration": 1, )" +
              line + "}}"),
      HasSubstr("it draws lines"));
}

TEST_F(UnitSceneFile, RefusalsNamePlaceAndAccepted) {
  for (const char* seed :
       {R"({"from": [0, 0, 0], "to": [0, 1, 0], "closed": true})",
        R"({"center": [0, 0, 0], "normal": [0, 0, 1], "radius": 1, "to": [1, 0, 0]})"})
    EXPECT_THAT(
        refusal(std::string(R"({"surface": {"field": "rotation", "integrator": "fixed-front",
                                        "duration": 1, "seed": )") +
                seed + "}}"),
        HasSubstr("surface.seed: unknown key"));
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

TEST_F(UnitSceneFile, AnObjectMayHaveALightOfItsOwn) {
  const Scene scene = with(
      R"({"mesh": "sheet.ply"}, {"mesh": "sheet.ply", "lighting": "phong"},
         {"mesh": "sheet.ply", "lighting": "none"})",
      R"("lighting": "headlight")");
  EXPECT_EQ(lighting_of(scene, scene.objects[0]), Lighting::headlight);
  EXPECT_EQ(lighting_of(scene, scene.objects[1]), Lighting::phong);
  EXPECT_EQ(lighting_of(scene, scene.objects[2]), Lighting::none);
  const Scene unlit =
      with(R"({"mesh": "sheet.ply", "lighting": "headlight"}, {"mesh": "sheet.ply"})");
  EXPECT_EQ(unlit.objects[0].mesh().normals.size(), 4u);
  EXPECT_TRUE(is_lit(unlit));
  EXPECT_EQ(common_lighting(unlit), std::nullopt);
  EXPECT_THAT(refusal(R"({"mesh": "sheet.ply", "lighting": "sun"})"),
              HasSubstr("objects[0].lighting"));
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

}  // namespace
}  // namespace pellucid::scene
