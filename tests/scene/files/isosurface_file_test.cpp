// SPDX-License-Identifier: GPL-3.0-or-later
// Isosurfaces of a scene file.

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>

#include "fields/levels/level_field.h"
#include "scene/appearance/colormap.h"
#include "tests/scene/files/scene_file_folder.h"

namespace pellucid::scene {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using namespace testing;

class UnitIsosurfaceFile : public SceneFileTest {};

TEST_F(UnitIsosurfaceFile, AnIsosurfaceKeepsTheReconstructionItNames) {
  for (const fields::ReconstructionRow& row : fields::reconstructions) {
    const Scene scene = with(R"({"isosurface": {"dataset": "sphere-levels:levels=1", "value": 0.9,
        "scalar": "magnitude", "reconstruction": ")" +
                             std::string(row.name) + R"("}})");
    const auto& surface = std::get<Isosurface>(scene.objects.front().shape);
    EXPECT_EQ(&surface.field->reconstruction(), &row);  // of the table, no copy that dies
  }
}

TEST_F(UnitIsosurfaceFile, AnIsosurfaceMayBeAMesh) {
  const auto text = [](const std::string& keys) {
    return R"({"isosurface": {"dataset": "sphere-levels:levels=1", "value": 0.9,
        "scalar": "magnitude", "mesh": true)" +
           keys + R"(}, "color": [1, 0, 0], "opacity": 0.25})";
  };
  const geometry::TriangleMesh whole = with(text("")).objects.front().mesh();
  EXPECT_EQ(whole.normals.size(), whole.positions.size());
  EXPECT_EQ(whole.colors.front(), Rgba(1, 0, 0, 0.25));
  const geometry::TriangleMesh cut =
      with(text(R"(, "hole": {"center": [0, 0, 0], "radius": 1.5})")).objects.front().mesh();
  EXPECT_LT(cut.triangles.size(), whole.triangles.size());
  for (const auto& triangle : cut.triangles)
    for (const std::uint32_t corner : triangle) EXPECT_GE(glm::length(cut.positions[corner]), 1.5);
}

TEST_F(UnitIsosurfaceFile, AnIsosurfaceIsColouredByAScalarOfItsData) {
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
  const geometry::TriangleMesh mesh =
      with(text(R"("speed", "map": "four-color", "range": [0, 1.8])", R"(, "mesh": true)"))
          .objects.front()
          .mesh();
  for (const Rgba& color : mesh.colors) {
    EXPECT_LT(glm::length(Vec3(color) - map(0.5)), 1e-5);  // vertices lie on it to some 1e-6
    EXPECT_EQ(color.a, 0.25f);
  }
  // Stops that are values lie by their logarithms where the scale is logarithmic.
  const Scene stops = with(text(
      R"("speed", "scale": "logarithmic", "map": [[0.01, "black"], [10, "lime"], [100, "white"]])"));
  const auto& by_factors = *std::get<Isosurface>(stops.objects.front().shape).coloring;
  const Vec3 place(3, 0.5, 0);
  const double speed = *surface.field->value(place);
  ASSERT_LT(speed, 10);
  EXPECT_LE(glm::length(by_factors.color(by_factors.scalar.fraction(place)) -
                        Vec3(0, std::log10(speed / 0.01) / 3, 0)),
            1e-6);
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

TEST_F(UnitIsosurfaceFile, AnIsosurfaceFadesByAScalarOfItsData) {
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
  // The field is read twice, from samples in float: 6e-8 of a value near 1, times 0.6 / 0.9.
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

TEST_F(UnitIsosurfaceFile, AnIsosurfaceMayBeCutAlongABody) {
  geometry::write_mesh(folder_ / "body.ply",
                       sphere(4, Rgba(1)));  // facets within 0.005 of the unit sphere
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
  geometry::write_mesh(folder_ / "open.ply", rectangle(0, 1, 0, 1, 0, Rgba(1)));
  EXPECT_THAT(refusal(text(R"({"mesh": "open.ply"})")),
              AllOf(HasSubstr("hole.mesh"), HasSubstr("closed mesh")));
  EXPECT_THAT(refusal(text(R"({"mesh": "body.ply", "radius": 1})")), HasSubstr("radius"));
  EXPECT_THAT(refusal(text(R"({"mesh": "body.ply", "distance": -1})")), HasSubstr("distance"));
}

/// Big-endian, as NetCDF's classic format has all numbers.
template <class T>
std::string big_endian(T number) {
  std::string bytes(sizeof number, '\0');
  std::memcpy(bytes.data(), &number, sizeof number);
  return {bytes.rbegin(), bytes.rend()};
}
std::string words(std::initializer_list<std::uint32_t> numbers) {
  std::string bytes;
  for (const std::uint32_t number : numbers) bytes += big_endian(number);
  return bytes;
}
std::string counted(std::string text) {
  const std::string count = words({std::uint32_t(text.size())});
  text.resize((text.size() + 3) / 4 * 4, '\0');
  return count + text;
}

/// A NetCDF file (classic format) of the axes time, z, y, x and of a variable p over all of them;
/// `first` is the place of its data.
std::string netcdf_head(std::uint32_t first) {
  constexpr std::pair<const char*, std::uint32_t> axes[] = {
      {"time", 2}, {"z", 3}, {"y", 3}, {"x", 3}};
  std::string head = std::string("CDF\1", 4) + words({0, 10, 4});
  for (const auto& [name, count] : axes) head += counted(name) + words({count});
  head += words({0, 0, 11, 5});
  std::uint32_t axis = 0;
  for (const auto& [name, count] : axes) {
    head += counted(name) + words({1, axis++});
    head += std::string(name) == "time"
                ? words({12, 1}) + counted("units") + words({2}) + counted("seconds since 2000-1-1")
                : words({0, 0});
    head += words({6, 8 * count, first});
    first += 8 * count;
  }
  return head + counted("p") + words({4, 0, 1, 2, 3, 0, 0, 5, 4 * 54, first});
}

/// p is x, from 0 to 2; at the second of two times, 0.5 and 2, 10 more.
std::string netcdf_of_two_times() {
  std::string file = netcdf_head(std::uint32_t(netcdf_head(0).size()));
  for (const double x : {0.5, 2., 0., 1., 2., 0., 1., 2., 0., 1., 2.}) file += big_endian(x);
  for (int i = 0; i < 54; ++i) file += big_endian(float(i % 3 + (i < 27 ? 0 : 10)));
  return file;
}

class UnitIsosurfaceValues : public SceneFileTest {
 protected:
  void SetUp() override {
    std::string values;
    for (int i = 0; i < 27; ++i) values += fmt::format("{} ", i % 3);
    std::ofstream(folder_ / "x.vti")
        << R"(<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian">
<ImageData WholeExtent="0 2 0 2 0 2" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="0 2 0 2 0 2">
<PointData><DataArray type="Float32" Name="p" format="ascii">)"
        << values << "</DataArray></PointData></Piece></ImageData></VTKFile>";
    std::ofstream(folder_ / "times.nc", std::ios::binary) << netcdf_of_two_times();
  }

  static std::string object(const std::string& keys, const std::string& file = "x.vti") {
    return R"({"isosurface": {"file": ")" + file + R"(", "scalar": "p", )" + keys + "}}";
  }
  Scene of(const std::string& keys) const { return with(object(keys, "times.nc")); }
};

TEST_F(UnitIsosurfaceValues, AValueThatNoneReachesIsRefused) {
  EXPECT_EQ(with(object(R"("value": 2)")).objects.size(), 1u);
  for (const char* value : {"5", "-0.1"})
    EXPECT_THAT(refusal(object(std::string("\"value\": ") + value)),
                HasSubstr(std::string("objects[0].isosurface.value: ") + value +
                          "; accepted: from 0 to 2, the range of p of x.vti"));
  EXPECT_THAT(refusal(R"({"isosurface": {"dataset": "sphere-levels:levels=1", "scalar": "speed",
                          "value": 9}})"),
              AllOf(HasSubstr("value: 9; accepted: from 0 to "),
                    HasSubstr(", the range of speed of sphere-levels:levels=1")));
}

TEST_F(UnitIsosurfaceValues, OfSeveralTimesOneIsChosenOrTheFirstOneIsSaid) {
  const auto remarks = [](const Scene& scene) { return scene.objects.front().vertices().remarks; };
  EXPECT_THAT(remarks(of(R"("value": 1.5)")),
              ::testing::ElementsAre("times.nc is drawn at 0.5, the first of its 2 times"));
  EXPECT_TRUE(remarks(with(object(R"("value": 1.5)"))).empty());
  for (const char* time : {"2", "\"2\"", "\"last\""})
    EXPECT_TRUE(remarks(of(std::string(R"("value": 11.5, "time": )") + time)).empty()) << time;
  EXPECT_THAT(refusal(object(R"("value": 1.5, "time": 2)", "times.nc")),
              HasSubstr("accepted: from 10 to 12"));
  EXPECT_THAT(refusal(object(R"("value": 1.5, "time": 1)", "times.nc")),
              HasSubstr("time=1; accepted: first, last, or one of its 2 times from 0.5 to 2"));
  EXPECT_THAT(refusal(object(R"("value": 1.5, "time": "last")")), HasSubstr("it has no times"));
}

}  // namespace
}  // namespace pellucid::scene
