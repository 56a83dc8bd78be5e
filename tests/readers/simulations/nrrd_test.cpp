// SPDX-License-Identifier: GPL-3.0-or-later
// NRRD images as their format's page describes them: where samples are, what a sample holds, in
// which files.

#include <fmt/format.h>
#include <vtkImageData.h>

#include <functional>
#include <glm/glm.hpp>

#include "core/files/output_file.h"
#include "readers/vtk/vtk_formats.h"
#include "tests/readers/simulations/read_files.h"

namespace pellucid::readers {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Where sample (i, j, k) is.
using Place = std::function<glm::dvec3(const glm::dvec3&)>;

class UnitNrrd : public ReadFiles {
 protected:
  std::filesystem::path write(const std::string& fields, const std::string& data,
                              const char* name = "i.nrrd") const {
    write_text(folder_ / name, "NRRD0005\n# a remark\n" + fields + "\n" + data);
    return folder_ / name;
  }

  /// 2 × 3 × 4 samples that number themselves, as text.
  std::filesystem::path numbered(const std::string& fields) const {
    std::string data;
    for (int i = 0; i < 24; ++i) data += fmt::format("{} ", i);
    return write("type: int\nencoding: ascii\n" + fields, data);
  }

  static void expect_places(const std::filesystem::path& file, const Place& place) {
    const auto data = read_vtk_data_set(file);
    ASSERT_EQ(data->GetNumberOfPoints(), 24) << file;
    for (vtkIdType id = 0; id < 24; ++id) {
      const int n = int(data->GetPointData()->GetArray("NRRD")->GetComponent(id, 0));
      glm::dvec3 x;
      data->GetPoint(id, &x.x);
      EXPECT_LT(glm::length(x - place({n % 2, n / 2 % 3, n / 6})), 1e-12) << n;
    }
  }
};

TEST_F(UnitNrrd, SamplesAreWhereSpacingsMinsAndCentersHaveThem) {
  const std::string sizes = "dimension: 3\nsizes: 2 3 4\n";
  expect_places(numbered(sizes), [](auto& i) { return i; });
  expect_places(numbered(sizes + "spacings: 2 0.5 3\n"),
                [](auto& i) { return glm::dvec3(2, 0.5, 3) * i; });
  expect_places(numbered(sizes + "axis mins: 1 2 3\naxis maxs: 3 3 9\n"),
                [](auto& i) { return glm::dvec3(1, 2, 3) + glm::dvec3(2, 0.5, 2) * i; });
  expect_places(numbered(sizes + "centers: cell cell node\naxis mins: 0 0 0\naxis maxs: 2 6 6\n"),
                [](auto& i) { return glm::dvec3(0.5, 1, 0) + glm::dvec3(1, 2, 2) * i; });
}

/// `space` may stand before the sizes, where another reader loses layers by it.
TEST_F(UnitNrrd, AnatomicalSpacesAreBroughtToRas) {
  const std::string rest =
      "sizes: 2 3 4\nspace directions: (2,0,0) (0,3,0) (0,0,4)\nspace origin: (10,20,30)\n";
  const std::pair<const char*, glm::dvec3> spaces[] = {{"left-posterior-superior", {-1, -1, 1}},
                                                       {"LAS", {-1, 1, 1}},
                                                       {"right-anterior-superior", {1, 1, 1}},
                                                       {"scanner-xyz", {-1, -1, 1}},
                                                       {"3D-right-handed", {1, 1, 1}}};
  for (const auto& [space, signs] : spaces)
    expect_places(numbered(fmt::format("dimension: 3\nspace: {}\n{}", space, rest)), [&](auto& i) {
      return signs * (glm::dvec3(10, 20, 30) + glm::dvec3(2, 3, 4) * i);
    });
}

TEST_F(UnitNrrd, AxesMayBeExchangedAndTurned) {
  const std::string head = "dimension: 3\nsizes: 2 3 4\nspace dimension: 3\n";
  expect_places(numbered(head + "space directions: (0,2,0) (0,0,-1) (3,0,0)\n"),
                [](auto& i) { return glm::dvec3(3 * i.z, 2 * i.x, -i.y); });
  expect_places(
      numbered(head + "space directions: (0.6,0.8,0) (-0.8,0.6,0) (0,0,1)\n"
                      "space origin: (1,0,0)\n"),
      [](auto& i) { return glm::dvec3(1 + 0.6 * i.x - 0.8 * i.y, 0.8 * i.x + 0.6 * i.y, i.z); });
}

TEST_F(UnitNrrd, RowsOfNumbersAreVectorsInTheSpaceOfTheImage) {
  const auto vectors = [&](const std::string& fields, bool rows_first) {
    const std::string data =
        rows_first ? "1 2 3  4 5 6  7 8 9  10 11 12" : "1 4 7 10  2 5 8 11  3 6 9 12";
    const auto read =
        read_vtk_data_set(write("type: double\nencoding: text\ndimension: 4\n" + fields, data));
    std::vector<glm::dvec3> all;
    for (vtkIdType id = 0; id < read->GetNumberOfPoints(); ++id) {
      glm::dvec3 v;
      read->GetPointData()->GetArray("NRRD")->GetTuple(id, &v.x);
      all.push_back(v);
    }
    return all;
  };
  using V = glm::dvec3;
  const auto as_they_are = ElementsAre(V(1, 2, 3), V(4, 5, 6), V(7, 8, 9), V(10, 11, 12));
  EXPECT_THAT(vectors("sizes: 3 2 2 1\n", true), as_they_are);
  EXPECT_THAT(vectors("sizes: 3 2 2 1\nkinds: vector domain domain domain\n", true), as_they_are);
  EXPECT_THAT(vectors("sizes: 2 2 1 3\nkinds: space space space 3-vector\n", false), as_they_are);
  const std::string lps =
      "sizes: 3 2 2 1\nkinds: vector space space space\nspace: LPS\n"
      "space directions: none (1,0,0) (0,1,0) (0,0,1)\n";
  // The points ascend along the axes that were turned round: the last sample is the first.
  EXPECT_THAT(vectors(lps, true),
              ElementsAre(V(-10, -11, 12), V(-7, -8, 9), V(-4, -5, 6), V(-1, -2, 3)));
  // The columns of the frame: measured x along y, y along -x.
  EXPECT_THAT(vectors(lps + "measurement frame: (0,1,0) (-1,0,0) (0,0,1)\n", true),
              ElementsAre(V(11, -10, 12), V(8, -7, 9), V(5, -4, 6), V(2, -1, 3)));
}

TEST_F(UnitNrrd, DataMayLieInFilesThatCountAsRead) {
  for (const char* name : {"a.txt", "b.txt"})
    write_text(folder_ / name, "1 2 3 4 5 6 7 8 9 10 11 12");
  const std::string head = "type: float\nencoding: ascii\ndimension: 3\nsizes: 2 3 4\n";
  const auto list = write(head + "data file: LIST 3\na.txt\nb.txt", "", "l.nhdr");
  EXPECT_EQ(read_vtk_data_set(list)->GetPointData()->GetArray(0)->GetComponent(12, 0), 1);
  EXPECT_THAT(files_beside(list, *vtk_format(list)),
              ElementsAre(folder_ / "a.txt", folder_ / "b.txt"));
  const auto one = write(
      "type: float\nencoding: ascii\ndimension: 3\nsizes: 2 3 2\n"
      "datafile: b.txt",
      "", "o.nhdr");
  EXPECT_THAT(files_beside(one, *vtk_format(one)), ElementsAre(folder_ / "b.txt"));
  EXPECT_EQ(read_vtk_data_set(one)->GetPointData()->GetArray(0)->GetComponent(11, 0), 12);
  EXPECT_THAT(complaint(write(head + "data file: %c.txt 1 2 1", "", "p.nhdr")),
              HasSubstr("data file: %c.txt 1 2 1; accepted: one file, or LIST"));
}

TEST_F(UnitNrrd, OtherImagesAreRefused) {
  const std::string text = "type: float\nencoding: ascii\n";
  EXPECT_THAT(complaint(write(text + "dimension: 3\nsizes: 2 2 3\nkinds: space space time\n",
                              "1 2 3 4 5 6 7 8 9 10 11 12")),
              HasSubstr("i.nrrd: 3 samples over time; accepted: one"));
  EXPECT_THAT(complaint(write(text + "dimension: 1\nsizes: 2\n", "1 2")),
              HasSubstr("1 axes of space; accepted: 2 or 3"));
  EXPECT_THAT(complaint(write(text + "dimension: 2\nsizes: 2 2\nspace dimension: 2\n"
                                     "space directions: (1,0) (0,1)\n",
                              "1 2 3 4")),
              HasSubstr("a space of 2 dimensions; accepted: 3"));
  EXPECT_THAT(complaint(write("type: float\nencoding: raw\nendian: little\ndimension: 3\n"
                              "sizes: 2 2 9\n",
                              "short")),
              HasSubstr("i.nrrd: not a valid NRRD file: "));
  EXPECT_THAT(complaint(write("type: float\nencoding: raw\nendian: little\ndimension: 3\n"
                              "sizes: 200000 200000 200000\n",
                              "short")),
              HasSubstr("i.nrrd: "));
}

}  // namespace
}  // namespace pellucid::readers
