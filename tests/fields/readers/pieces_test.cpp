// SPDX-License-Identifier: GPL-3.0-or-later
// Data sets in several files: pieces, blocks, collections over time.

#include <gmock/gmock.h>

#include "core/error.h"
#include "core/files/files_read.h"
#include "fields/make_field.h"
#include "tests/fields/probe.h"
#include "tests/fields/readers/grid_files.h"
#include "tests/fields/readers/xml_grids.h"

namespace pellucid::fields {
namespace {

using namespace xml_grids;
using ::testing::HasSubstr;

/// Two halves of a box: x from 0 to 1 and from 1 to 3.
const Axes left{evenly(0, 0.5, 3), evenly(0, 0.5, 4), evenly(0, 1, 3)};
const Axes right{evenly(1, 0.5, 5), evenly(0, 0.5, 4), evenly(0, 1, 3)};

std::string half(const Axes& axes, const VectorAt& velocity = straight) {
  return unstructured(crossings(axes), hexahedra(axes),
                      vectors("U", crossings(axes), velocity) +
                          scalars("p", crossings(axes), [](const Vec3& x) { return x.x; }));
}

class UnitPieces : public ::testing::Test {
 protected:
  UnitPieces() {
    write_bytes(folder_ / "left.vtu", half(left));
    write_bytes(folder_ / "right.vtu", half(right));
  }
  std::unique_ptr<VectorField> read(std::string_view name, std::string_view text,
                                    std::string_view options = {}) {
    write_bytes(folder_ / name, text);
    return make_field((folder_ / name).string() + std::string(options));
  }
  std::string complaint(std::string_view name, std::string_view text,
                        std::string_view options = {}) {
    try {
      read(name, text, options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no complaint";
  }
  static void expect_both_halves(const VectorField& field) {
    for (const Vec3& x : {Vec3(0.3, 0.7, 1.2), Vec3(1, 0.2, 0.9), Vec3(2.8, 1.4, 1.9)})
      EXPECT_NEAR_VEC(velocity_of(field, x), straight(x), 1e-9);
    EXPECT_EQ(status_at(field, {3.1, 0.7, 1}), SampleStatus::outside);
  }
  TemporaryFolder folder_;
};

constexpr std::string_view blocks =
    "<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\" byte_order=\"LittleEndian\">"
    "<vtkMultiBlockDataSet><Block index=\"0\" name=\"body\">"
    "<DataSet index=\"0\" name=\"west\" file=\"left.vtu\"/>"
    "<DataSet index=\"1\" name=\"east\" file=\"right.vtu\"/></Block>"
    "</vtkMultiBlockDataSet></VTKFile>";

TEST_F(UnitPieces, BlocksAreMerged) {
  const FilesRead files;
  const auto field = read("b.vtm", blocks);
  expect_both_halves(*field);
  EXPECT_THAT(field->description(), HasSubstr("2 blocks merged"));
  const auto paths = files.paths();
  EXPECT_TRUE(paths.contains(folder_ / "right.vtu"));  // a report knows what was read
}

/// Vectors that are floats in one block and doubles in the other are there all the same, and no
/// others are taken for them.
TEST_F(UnitPieces, BlocksOfFloatsAndOfDoublesAreMerged) {
  const auto both = [](const Axes& axes, std::string_view type) {
    const auto points = crossings(axes);
    std::string text = vectors("U", points, straight);
    text.replace(text.find("Float64"), 7, type);
    std::string file = unstructured(
        points, hexahedra(axes), text + vectors("W", points, [](auto&) { return Vec3(0, 0, 9); }));
    return file.insert(file.find("<PointData") + 10, " Vectors=\"U\"");
  };
  write_bytes(folder_ / "left.vtu", both(left, "Float32"));
  write_bytes(folder_ / "right.vtu", both(right, "Float64"));
  for (const char* options : {"", ":array=U"}) {
    const auto field = read("b.vtm", blocks, options);
    for (const Vec3& x : {Vec3(0.3, 0.7, 1.2), Vec3(2.8, 1.4, 1.9)})
      EXPECT_NEAR_VEC(velocity_of(*field, x), straight(x), 1e-6) << options;
  }
}

TEST_F(UnitPieces, BlocksAreChosenByName) {
  for (const char* options : {":block=east", ":block=body/east"}) {
    const auto field = read("b.vtm", blocks, options);
    EXPECT_EQ(status_at(*field, {0.3, 0.7, 1.2}), SampleStatus::outside);
    EXPECT_NEAR_VEC(velocity_of(*field, {2.8, 1.4, 1.9}), straight({2.8, 1.4, 1.9}), 1e-9);
    EXPECT_THAT(field->description(), HasSubstr("block body/east"));
  }
  expect_both_halves(*read("b.vtm", blocks, ":block=east,west,array=U"));
  expect_both_halves(*read("b.vtm", blocks, ":block=body"));
  EXPECT_THAT(complaint("b.vtm", blocks, ":block=north"),
              HasSubstr("block=north: no such block; accepted: body/west, body/east"));
}

TEST_F(UnitPieces, PiecesOfAnUnstructuredGrid) {
  expect_both_halves(*read(
      "p.pvtu",
      "<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">"
      "<PUnstructuredGrid GhostLevel=\"0\"><PPointData>"
      "<PDataArray type=\"Float64\" Name=\"U\" NumberOfComponents=\"3\"/></PPointData>"
      "<PPoints><PDataArray type=\"Float64\" NumberOfComponents=\"3\"/></PPoints>"
      "<Piece Source=\"left.vtu\"/><Piece Source=\"right.vtu\"/></PUnstructuredGrid></VTKFile>"));
}

/// One piece of an image of unit cells: samples from x = `first` to `last`.
std::string image_piece(int first, int last, std::string_view direction = {}) {
  const Axes axes{evenly(first, 1, last - first + 1), evenly(0, 1, 3), evenly(0, 1, 3)};
  const std::string extent = fmt::format("{} {} 0 2 0 2", first, last);
  return vtk_files::xml(
      "ImageData",
      fmt::format("<ImageData WholeExtent=\"{0}\" Origin=\"0 0 0\" Spacing=\"1 1 1\" {2}>"
                  "<Piece Extent=\"{0}\"><PointData>{1}</PointData></Piece></ImageData>",
                  extent, vectors("U", crossings(axes), straight), direction));
}

std::string image_in_pieces(std::string_view direction = {}) {
  return fmt::format(
      "<VTKFile type=\"PImageData\" version=\"0.1\" byte_order=\"LittleEndian\">"
      "<PImageData WholeExtent=\"0 4 0 2 0 2\" GhostLevel=\"0\" Origin=\"0 0 0\" Spacing=\"1 1 1\" "
      "{}>"
      "<PPointData><PDataArray type=\"Float64\" Name=\"U\" NumberOfComponents=\"3\"/></PPointData>"
      "<Piece Extent=\"0 2 0 2 0 2\" Source=\"0.vti\"/>"
      "<Piece Extent=\"2 4 0 2 0 2\" Source=\"1.vti\"/></PImageData></VTKFile>",
      direction);
}

TEST_F(UnitPieces, PiecesOfAnImageAreOneGrid) {
  write_bytes(folder_ / "0.vti", image_piece(0, 2));
  write_bytes(folder_ / "1.vti", image_piece(2, 4));
  const auto field = read("i.pvti", image_in_pieces(), ":array=U");
  EXPECT_NEAR_VEC(velocity_of(*field, {1.7, 0.4, 1.1}), straight({1.7, 0.4, 1.1}), 1e-12);
  EXPECT_NEAR_VEC(velocity_of(*field, {3.2, 0.4, 1.1}), straight({3.2, 0.4, 1.1}), 1e-12);
  EXPECT_THAT(field->description(), HasSubstr("5 × 3 × 3"));
}

/// Two pieces that share two cells, one of which each marks as the other's.
TEST_F(UnitPieces, GhostsOfPiecesAreCellsOfTheGrid) {
  const auto piece = [](int first, int ghost) {
    std::string marks;
    for (int cell = 0; cell < 12; ++cell) marks += (first + cell % 3 == ghost) ? "1 " : "0 ";
    std::string text = image_piece(first, first + 3);
    marks = vtk_files::array("vtkGhostType", "UInt8", 1, marks);
    return text.insert(text.find("</Piece>"), "<CellData>" + marks + "</CellData>");
  };
  write_bytes(folder_ / "0.vti", piece(0, 2));
  write_bytes(folder_ / "1.vti", piece(1, 1));
  const auto field =
      read("g.pvti",
           "<VTKFile type=\"PImageData\" version=\"0.1\" byte_order=\"LittleEndian\">"
           "<PImageData WholeExtent=\"0 4 0 2 0 2\" GhostLevel=\"1\" Origin=\"0 0 0\" "
           "Spacing=\"1 1 1\">"
           "<PPointData><PDataArray type=\"Float64\" Name=\"U\" NumberOfComponents=\"3\"/>"
           "</PPointData><PCellData><PDataArray type=\"UInt8\" Name=\"vtkGhostType\"/></PCellData>"
           "<Piece Extent=\"0 3 0 2 0 2\" Source=\"0.vti\"/>"
           "<Piece Extent=\"1 4 0 2 0 2\" Source=\"1.vti\"/></PImageData></VTKFile>");
  for (const double x : {0.5, 1.5, 2.5, 3.5})
    EXPECT_NEAR_VEC(velocity_of(*field, {x, 0.4, 1.1}), straight({x, 0.4, 1.1}), 1e-12) << x;
}

/// A quarter turn about z, said by the file, by its pieces or by both.
TEST_F(UnitPieces, PiecesOfATurnedImage) {
  constexpr std::string_view turn = "Direction=\"0 -1 0 1 0 0 0 0 1\"";
  for (const auto& [of_all, of_piece] : {std::pair(turn, turn), {turn, ""}, {"", turn}}) {
    write_bytes(folder_ / "0.vti", image_piece(0, 2, of_piece));
    write_bytes(folder_ / "1.vti", image_piece(2, 4, of_piece));
    const auto field = read("i.pvti", image_in_pieces(of_all), ":array=U");
    EXPECT_NEAR_VEC(velocity_of(*field, {-0.4, 3.2, 1.1}), straight({3.2, 0.4, 1.1}), 1e-12);
  }
  EXPECT_THAT(complaint("i.pvti", image_in_pieces("Direction=\"1 0 0 0 1 0 0 0 1\""), ":array=U"),
              HasSubstr("the Direction of its piece 0.vti is another one"));
}

std::string collection(std::string_view entries) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<!-- <DataSet file=\"none\"/> -->\n"
      "<VTKFile type=\"Collection\" version=\"0.1\"><Collection>{}</Collection></VTKFile>",
      entries);
}

TEST_F(UnitPieces, CollectionsOverTime) {
  for (int k = 0; k < 3; ++k)
    write_bytes(folder_ / fmt::format("t{}.vtu", k),
                half(left, [k](const Vec3& x) { return Vec3(k * x.y, 0, 1); }));
  const std::string text = collection(
      "<DataSet timestep=\"2\" part=\"0\" file=\"t2.vtu\"/>"
      "<DataSet timestep='0' file='t0.vtu'/><DataSet timestep=\"1\" file=\"t1.vtu\"/>");
  const auto field = read("c.pvd", text);
  EXPECT_FALSE(field->steady());
  for (const double t : {0.0, 0.25, 1.0, 1.75, 2.0})
    EXPECT_NEAR_VEC(velocity_of(*field, {0.5, 0.5, 0.5}, t), Vec3(0.5 * t, 0, 1), 1e-9);
  EXPECT_EQ(status_at(*field, {0.5, 0.5, 0.5}, 2.01), SampleStatus::outside);
  EXPECT_THAT(field->description(), HasSubstr("3 times from t = 0 to 2"));
  const auto last = read("c.pvd", text, ":time=last");
  EXPECT_TRUE(last->steady());
  EXPECT_NEAR_VEC(velocity_of(*last, {0.5, 0.5, 0.5}, 99), Vec3(1, 0, 1), 1e-9);
  EXPECT_NEAR_VEC(velocity_of(*read("c.pvd", text, ":time=1"), {0.5, 0.5, 0.5}), Vec3(0.5, 0, 1),
                  1e-9);
  EXPECT_THAT(complaint("c.pvd", text, ":time=1.5"),
              HasSubstr("accepted: first, last, or one of its 3 times from 0 to 2"));
}

TEST_F(UnitPieces, PartsOfOneTimeAreMerged) {
  const std::string text = collection(
      "<DataSet timestep=\"0\" part=\"0\" name=\"west\" file=\"left.vtu\"/>"
      "<DataSet timestep=\"0\" part=\"1\" name=\"east\" file=\"right.vtu\"/>");
  const auto field = read("c.pvd", text);
  EXPECT_TRUE(field->steady());
  expect_both_halves(*field);
  const auto west = read("c.pvd", text, ":block=west");
  EXPECT_EQ(status_at(*west, {2, 1, 1}), SampleStatus::outside);
  EXPECT_THAT(west->description(), ::testing::Not(HasSubstr("merged")));
}

TEST_F(UnitPieces, CollectionsOfBlocksHaveTheirBlocks) {
  write_bytes(folder_ / "b.vtm", blocks);
  const std::string text = collection("<DataSet timestep=\"0\" part=\"0\" file=\"b.vtm\"/>");
  const auto all = read("c.pvd", text);
  expect_both_halves(*all);
  EXPECT_THAT(all->description(), HasSubstr("2 blocks merged"));
  const auto west = read("c.pvd", text, ":block=west");
  EXPECT_NEAR_VEC(velocity_of(*west, {0.3, 0.7, 1.2}), straight({0.3, 0.7, 1.2}), 1e-9);
  EXPECT_EQ(status_at(*west, {2, 1, 1}), SampleStatus::outside);
  EXPECT_THAT(complaint("c.pvd", text, ":block=north"),
              HasSubstr("block=north: no such block; accepted: body/west"));
}

TEST_F(UnitPieces, WrongCollectionsAreRefused) {
  EXPECT_THAT(complaint("c.pvd", collection("")), HasSubstr("accepted: a <Collection>"));
  EXPECT_THAT(complaint("c.pvd", collection("<DataSet timestep=\"x\" file=\"left.vtu\"/>")),
              HasSubstr("timestep=\"x\"; accepted: a number"));
  EXPECT_THAT(complaint("c.pvd", collection("<DataSet timestep=\"0\"/>")),
              HasSubstr("names no file"));
  EXPECT_THAT(complaint("c.pvd", collection("<DataSet timestep=\"0\" file=\"nowhere.vtu\"/>")),
              HasSubstr("nowhere.vtu"));
  EXPECT_THAT(complaint("c.pvd", collection("<DataSet timestep=\"0\" file=\"c.pvd\"/>")),
              HasSubstr("VTK reads no such file"));
}

TEST_F(UnitPieces, EndingsInCapitalLetters) {
  EXPECT_NEAR_VEC(velocity_of(*read("A.VTU", half(left), ":array=U"), {0.3, 0.7, 1.2}),
                  straight({0.3, 0.7, 1.2}), 1e-9);
}

}  // namespace
}  // namespace pellucid::fields
