// SPDX-License-Identifier: GPL-3.0-or-later
// What VTK's XML readers put a default or zeros for, without a word.

#include "readers/vtk/xml_checks.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <vector>

#include "core/error.h"
#include "core/files/output_file.h"
#include "readers/vtk/vtk_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::readers {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A file of pieces with one point array each, or one of cells.
std::string grid(const std::string& attributes, const std::vector<std::string>& extents,
                 const std::string& data = "PointData") {
  std::string pieces;
  for (const std::string& extent : extents)
    pieces += fmt::format(
        "<Piece Extent=\"{0}\"><{1}><DataArray type=\"Float32\" Name=\"q\" format=\"appended\" "
        "offset=\"0\"/></{1}></Piece>",
        extent, data);
  return fmt::format(
      "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\">"
      "<ImageData {}>{}</ImageData><AppendedData encoding=\"raw\">_<Piece Extent=\"no tag\"/>"
      "</AppendedData></VTKFile>",
      attributes, pieces);
}

class UnitXmlChecks : public ::testing::Test {
 protected:
  std::string complaint(const std::string& name, const std::string& text) const {
    write_text(folder_ / name, text);
    try {
      check_xml(folder_ / name);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), StartsWith((folder_.path() / "").string()));
      return error.what();
    }
    return "";
  }
  std::string of_pieces(const std::vector<std::string>& extents,
                        const std::string& data = "PointData") const {
    return complaint("a.vti", grid("WholeExtent=\"0 9 0 3 0 2\"", extents, data));
  }
  testing::TemporaryFolder folder_;
};

TEST_F(UnitXmlChecks, AttributesAreWhatTheyHaveToBe) {
  const std::string whole = "WholeExtent=\"0 4 0 3 0 2\"", piece = "0 4 0 3 0 2";
  const auto with = [&](const std::string& attributes) {
    return complaint("a.vti", grid(whole + " " + attributes, {piece}));
  };
  EXPECT_EQ(with("Origin=\"-1.5 +2 1e3\" Spacing=\"1\n2\t.5\" Direction=\"1 0 0 0 1 0 0 0 1\""),
            "");
  EXPECT_THAT(with("Spacing=\"2,2,2\""),
              HasSubstr("<ImageData>: Spacing=\"2,2,2\"; accepted: 3 numbers"));
  for (const char* wrong : {"2", "1 1 1 1", "nan 1 1", "1 1 x", "", "1 1 inf"})
    EXPECT_NE(with(fmt::format("Spacing=\"{}\"", wrong)), "") << wrong;
  EXPECT_THAT(with("Origin=\"1,1,1\""), HasSubstr("Origin=\"1,1,1\""));
  EXPECT_THAT(with("Direction=\"1 0 0\""), HasSubstr("accepted: 9 numbers"));
  EXPECT_THAT(complaint("a.vti", grid("WholeExtent=\"0 4.0 0 3 0 2\"", {piece})),
              HasSubstr("accepted: 6 whole numbers"));
  EXPECT_THAT(complaint("a.vti", grid(whole, {"0 4 0 3 0"})), HasSubstr("<Piece>: Extent="));
  for (const char* wrong : {"0", "3x", "-1", "2.5"})
    EXPECT_THAT(complaint("a.vtp", fmt::format("<DataArray NumberOfComponents=\"{}\"/>", wrong)),
                HasSubstr("accepted: a whole number from 1 on"));
  EXPECT_THAT(complaint("a.vtu", "<Piece NumberOfPoints=\"4 5\" NumberOfCells=\"1\"/>"),
              HasSubstr("NumberOfPoints=\"4 5\"; accepted: a whole number from 0 on"));
  EXPECT_THAT(complaint("a.vtu", "<VTKFile byte_order=\"little\">"),
              HasSubstr("accepted: LittleEndian, BigEndian"));
}

TEST_F(UnitXmlChecks, PiecesMakeUpTheirGrid) {
  EXPECT_EQ(of_pieces({"0 9 0 3 0 2"}), "");
  EXPECT_EQ(of_pieces({"0 4 0 3 0 2", "4 9 0 3 0 2"}, "CellData"), "");
  EXPECT_EQ(of_pieces({"4 9 0 3 0 2", "0 4 0 1 0 2", "0 4 1 3 0 2"}), "");
  EXPECT_THAT(
      of_pieces({"0 4 0 3 0 2"}),
      AllOf(HasSubstr("its 1 piece holds 24 of the 54 cells of WholeExtent=\"0 9 0 3 0 2\""),
            HasSubstr("not the one at 4 0 0")));
  EXPECT_THAT(of_pieces({"0 4 0 3 0 2", "0 4 0 3 0 2"}), HasSubstr("not the one at 4 0 0"));
  EXPECT_THAT(of_pieces({"0 9 0 3 0 2", "4 5 0 1 0 1"}), HasSubstr("2 pieces hold 55 of the 54"));
  EXPECT_THAT(of_pieces({"0 9 0 3 0 1", "0 9 0 2 1 2"}), HasSubstr("not the one at 0 2 1"));
  EXPECT_THAT(of_pieces({"0 10 0 3 0 2"}), HasSubstr("within WholeExtent"));
}

/// A process that had nothing to write does so.
TEST_F(UnitXmlChecks, EmptyPiecesAndEmptyGrids) {
  EXPECT_EQ(of_pieces({"0 9 0 3 0 2", "0 -1 0 -1 0 -1"}), "");
  EXPECT_EQ(complaint("a.vti", grid("WholeExtent=\"0 -1 0 -1 0 -1\"", {"0 -1 0 -1 0 -1"})), "");
  EXPECT_THAT(of_pieces({"0 -1 0 -1 0 -1"}), HasSubstr("its 0 pieces hold 0 of the 54 cells"));
  EXPECT_THAT(of_pieces({}), HasSubstr("its 0 pieces hold 0 of the 54 cells"));
}

/// Side by side without a shared layer pieces hold every sample, and no cell between them.
TEST_F(UnitXmlChecks, PiecesOfSamplesAlone) {
  EXPECT_EQ(of_pieces({"0 4 0 3 0 2", "5 9 0 3 0 2"}), "");
  EXPECT_THAT(of_pieces({"0 4 0 3 0 2", "5 9 0 3 0 2"}, "CellData"), HasSubstr("48 of the 54"));
}

TEST_F(UnitXmlChecks, AFlatGridHasCells) {
  const auto flat = [&](const std::vector<std::string>& extents) {
    return complaint("a.vti", grid("WholeExtent=\"0 9 0 3 0 0\"", extents));
  };
  EXPECT_EQ(flat({"0 9 0 3 0 0"}), "");
  EXPECT_EQ(flat({"0 5 0 3 0 0", "5 9 0 3 0 0"}), "");
  EXPECT_NE(flat({"0 5 0 3 0 0"}), "");
}

TEST_F(UnitXmlChecks, PiecesHaveTheSameArraysInOneOrder) {
  const auto piece = [](const std::string& arrays, int points = 8) {
    std::string text;
    for (const char name : arrays) text += fmt::format("<DataArray Name=\"{}\"/>", name);
    return fmt::format(
        "<Piece NumberOfPoints=\"{}\"><PointData>{}</PointData><Points><DataArray Name=\"x\"/>"
        "</Points><Cells><DataArray Name=\"types\"/></Cells></Piece>",
        points, text);
  };
  const auto of = [&](const std::string& pieces) { return complaint("a.vtu", pieces); };
  EXPECT_EQ(of(piece("UW") + piece("UW")), "");
  EXPECT_EQ(of(piece("", 0) + piece("UW") + piece("", 0) + piece("UW")), "");
  EXPECT_THAT(of(piece("UW") + piece("WU")),
              HasSubstr("one of its pieces has the arrays 'U', 'W', another one 'W', 'U'"));
  EXPECT_THAT(of(piece("UW") + piece("W")), HasSubstr("another one 'W'; accepted"));
  EXPECT_THAT(of(piece("U") + piece("UW")), HasSubstr("accepted: pieces that have the same"));
}

/// VTK would join the line to the polygon's points.
TEST_F(UnitXmlChecks, TheFirstCellsOfAKindAreInTheFirstPiece) {
  const auto piece = [](int points, int lines, int polygons) {
    return fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfLines=\"{}\" NumberOfPolys=\"{}\"/>",
                       points, lines, polygons);
  };
  const auto of = [&](const std::string& pieces) { return complaint("a.vtp", pieces); };
  EXPECT_EQ(of(piece(4, 1, 1) + piece(4, 0, 1) + piece(4, 1, 0)), "");
  EXPECT_EQ(of(piece(0, 0, 0) + piece(4, 0, 1) + piece(4, 0, 1)), "");
  EXPECT_THAT(of(piece(4, 0, 1) + piece(2, 1, 0)), HasSubstr("NumberOfLines above 0"));
  EXPECT_THAT(complaint("a.vtu",
                        "<Piece NumberOfPoints=\"4\" NumberOfCells=\"0\"/>"
                        "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\"/>"),
              HasSubstr("NumberOfCells above 0"));
}

TEST_F(UnitXmlChecks, PiecesHaveArraysAsDeclared) {
  write_text(folder_ / "0.vtu",
             "<Piece NumberOfPoints=\"8\"><PointData><DataArray Name=\"U\" "
             "NumberOfComponents=\"2\"/></PointData><CellData><DataArray Name=\"p\"/></CellData>");
  const auto of = [&](const std::string& declared) {
    return complaint("a.pvtu", "<PPointData>" + declared +
                                   "</PPointData><PCellData><PDataArray "
                                   "Name=\"p\"/></PCellData><Piece Source=\"0.vtu\"/>");
  };
  EXPECT_EQ(of("<PDataArray Name=\"U\" NumberOfComponents=\"2\"/>"), "");
  EXPECT_EQ(of(""), "");
  EXPECT_THAT(
      of("<PDataArray Name=\"U\" NumberOfComponents=\"3\"/>"),
      AllOf(HasSubstr("0.vtu: its array 'U' has NumberOfComponents=\"2\"; accepted: 3, as "),
            HasSubstr("a.pvtu says")));
}

/// A file of blocks is as good as its blocks; the pieces of a parallel file may name the whole.
TEST_F(UnitXmlChecks, FilesThatAreNamed) {
  write_text(folder_ / "half.vti", grid("WholeExtent=\"0 9 0 3 0 2\"", {"0 4 0 3 0 2"}));
  write_text(folder_ / "bad.vti",
             grid("WholeExtent=\"0 4 0 3 0 2\" Spacing=\"1\"", {"0 4 0 3 0 2"}));
  EXPECT_THAT(complaint("b.vtm", "<DataSet file=\"half.vti\"/>"), HasSubstr("half.vti: not a"));
  EXPECT_EQ(complaint("p.pvti", "<Piece Extent=\"0 4 0 3 0 2\" Source=\"half.vti\"/>"), "");
  EXPECT_THAT(complaint("p.pvti", "<Piece Source=\"bad.vti\"/>"), HasSubstr("bad.vti: not a"));
  EXPECT_EQ(complaint("self.vtm", "<DataSet file=\"self.vtm\"/>"), "");
}

/// Long texts between the tags are passed over, wherever they are cut for reading.
TEST_F(UnitXmlChecks, TagsBehindLongTexts) {
  std::string numbers;
  while (numbers.size() < (3u << 20)) numbers += "0.123456789 ";
  EXPECT_THAT(complaint("a.vti", "<DataArray>" + numbers + "</DataArray><Piece Extent=\"x\"/>"),
              HasSubstr("Extent=\"x\""));
  const std::string start(std::size_t(1 << 20) - 8, ' ');  // the tag lies on both sides of a MiB
  EXPECT_THAT(complaint("a.vti", start + "<Piece Extent=\"y\"/>"), HasSubstr("Extent=\"y\""));
}

TEST_F(UnitXmlChecks, TheReaderAsks) {
  write_text(folder_ / "a.vti", grid("WholeExtent=\"0 4 0 3 0 2\" Spacing=\"2\"", {"0 4 0 3 0 2"}));
  EXPECT_THROW(read_vtk_data_set(folder_ / "a.vti"), InputError);
}

}  // namespace
}  // namespace pellucid::readers
