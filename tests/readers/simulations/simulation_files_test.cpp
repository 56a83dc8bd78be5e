// SPDX-License-Identifier: GPL-3.0-or-later
// What the formats of simulations mean, where VTK's readers by themselves take something else.

#include <fmt/format.h>
#include <netcdf.h>

#include <map>

#include "core/files/output_file.h"
#include "tests/readers/simulations/read_files.h"

namespace pellucid::readers {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

class UnitSimulationFiles : public ReadFiles {
 protected:
  /// A cube of eight points, at each of which the numbers are those of `row`.
  std::filesystem::path tecplot(const std::string& variables, std::string_view row) const {
    std::string text = fmt::format("VARIABLES = {}\nZONE I=2, J=2, K=2, F=POINT\n", variables);
    for (int i = 0; i < 8; ++i)
      text += fmt::format(fmt::runtime(row), fmt::arg("x", i & 1), fmt::arg("y", i >> 1 & 1),
                          fmt::arg("z", i >> 2)) +
              "\n";
    write_text(folder_ / "t.tec", text);
    return folder_ / "t.tec";
  }

  /// A case of EnSight of one block of eight points.
  std::filesystem::path ensight(std::string_view type) const {
    const bool is_gold = type.ends_with("gold");
    const std::string part = is_gold ? "part\n         1\n" : "part 1\n";
    write_text(folder_ / "e.case", fmt::format("FORMAT\ntype: {}\nGEOMETRY\nmodel: e.geo\n"
                                               "VARIABLE\nvector per node: U e.U\n",
                                               type));
    std::string places, vectors;
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < 8; ++i) {
        const bool ends_line = is_gold || i % 6 == 5 || i == 7;
        const char* const end = ends_line ? "\n" : "";
        places += fmt::format("{:12.5e}{}", double(i >> axis & 1), end);
        vectors += fmt::format("{:12.5e}{}", double(axis + 1), end);
      }
    const std::string size =
        is_gold ? "         2         2         2\n" : "       2       2       2\n";
    write_text(folder_ / "e.geo",
               fmt::format("a\nb\nnode id off\nelement id off\n{}{}box\nblock\n{}{}",
                           is_gold ? "" : "coordinates\n       0\n", part, size, places));
    write_text(folder_ / "e.U", fmt::format("U\n{}block\n{}", part, vectors));
    return folder_ / "e.case";
  }
};

/// The vectors that a field takes unless told otherwise, of one point.
std::vector<double> active_vector(vtkDataSet& data, vtkIdType point) {
  vtkDataArray* vectors = data.GetPointData()->GetVectors();
  if (!vectors) return {};
  return {vectors->GetComponent(point, 0), vectors->GetComponent(point, 1),
          vectors->GetComponent(point, 2)};
}

/// Eight lines of a value each.
std::string column(double value) {
  std::string text;
  for (int i = 0; i < 8; ++i) text += fmt::format("{}\n", value);
  return text;
}

TEST_F(UnitSimulationFiles, Plot3dVectorsAreMomentumOverDensity) {
  std::string places;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 8; ++i) places += fmt::format("{}\n", i >> axis & 1);
  write_text(folder_ / "p.xyz", "2 2 2\n" + places);
  write_text(folder_ / "p.q",
             "2 2 2\n0.5 0 1 0\n" + column(4) + column(2) + column(-3) + column(1) + column(10));
  const auto data = read_vtk_data_set(folder_ / "p.xyz");
  EXPECT_STREQ(data->GetPointData()->GetVectors()->GetName(), "Velocity");
  EXPECT_THAT(active_vector(*data, 7), ElementsAre(0.5, -0.75, 0.25));
}

/// As meshio 5.0 writes them: without its file_size, but with each value's own variable.
TEST_F(UnitSimulationFiles, ExodusValuesThatTheLibraryDoesNotFindAreRefused) {
  const auto path = folder_ / "a.e";
  for (const bool is_large : {false, true}) {
    int file = 0, dimension = 0, variable = 0;
    ASSERT_EQ(nc_create(path.c_str(), NC_CLOBBER, &file), NC_NOERR);
    nc_def_dim(file, "num_nod_var", 1, &dimension);
    nc_def_var(file, is_large ? "vals_nod_var" : "vals_nod_var1", NC_DOUBLE, 1, &dimension,
               &variable);
    const int size = is_large ? 1 : 0;
    if (is_large) nc_put_att_int(file, NC_GLOBAL, "file_size", NC_INT, 1, &size);
    nc_close(file);
    EXPECT_THAT(complaint(path), HasSubstr(is_large ? "its file_size is 1, but vals_nod_var1,"
                                                    : "its file_size is 0, but vals_nod_var,"));
  }
}

TEST_F(UnitSimulationFiles, BlocksOfEnsightGoldAreReadAndOf6Refused) {
  const auto data = read_vtk_data_set(ensight("ensight gold"));
  EXPECT_THAT(active_vector(*data, 0), ElementsAre(1, 2, 3));
  EXPECT_THAT(active_vector(*data, 7), ElementsAre(1, 2, 3));
  EXPECT_THAT(complaint(ensight("ensight")), HasSubstr("structured blocks of EnSight 6"));
}

/// Points are where x, y and z are, and the other variables are arrays.
TEST_F(UnitSimulationFiles, TecplotCoordinatesAreThoseOfTheirNames) {
  const auto expect_cube = [&](const std::string& variables, std::string_view row,
                               const std::map<std::string, double>& others, double top = 1) {
    SCOPED_TRACE(variables);
    const auto data = read_vtk_data_set(tecplot(variables, row));
    double box[6];
    data->GetBounds(box);
    EXPECT_THAT(box, ElementsAre(0, 1, 0, 1, 0, top));
    EXPECT_EQ(data->GetPointData()->GetNumberOfArrays(), int(others.size()));
    for (const auto& [name, value] : others) {
      vtkDataArray* array = data->GetPointData()->GetArray(name.c_str());
      ASSERT_TRUE(array) << name;
      EXPECT_EQ(array->GetComponent(7, 0), value);
    }
  };
  expect_cube(R"("X" "Y" "Z" "U")", "{x} {y} {z} 5", {{"U", 5}});
  expect_cube(R"("U" "V" "X" "Y" "Z")", "5 6 {x} {y} {z}", {{"U", 5}, {"V", 6}});
  expect_cube(R"-("x(m)" "y(m)" "z(m)" "U")-", "{x} {y} {z} 5", {{"U", 5}});
  expect_cube(R"("X [m]" "Y [m]" "Z [m]" "U")", "{x} {y} {z} 5", {{"U", 5}});
  expect_cube(R"("X" "Y" "Z" "K")", "{x} {y} {z} 5", {{"K", 5}});
  expect_cube(R"("X" "Y" "Z" "I" "J" "K")", "{x} {y} {z} 5 6 7", {{"I", 5}, {"J", 6}, {"K", 7}});
  expect_cube(R"("X" "Y" "Z_vorticity")", "{x} {y} 5", {{"Z_vorticity", 5}}, 0);
  expect_cube("X Y Z K0", "{x} {y} {z} 5", {{"K0", 5}});
}

TEST_F(UnitSimulationFiles, TecplotNumbersOfFortranAreRefused) {
  const std::string names = R"("X" "Y" "Z" "U")";
  EXPECT_EQ(complaint(tecplot(names, "{x} {y} {z} -1.5e-03")), "no complaint");
  EXPECT_THAT(complaint(tecplot(names, "{x} {y} 2*{z}")), HasSubstr("the number 2*0, which"));
  EXPECT_THAT(complaint(tecplot(names, "{x} {y} {z} -1.5D-03")),
              HasSubstr("the number -1.5D-03, which"));
}

/// As Tecplot 360 writes them into every zone.
TEST_F(UnitSimulationFiles, TecplotZonesMayHaveATimeAndAStrand) {
  const auto with = [&](const std::string& zone, const std::string& more = "") {
    std::string text = read_text(tecplot(R"("X" "Y" "Z" "U")", "{x} {y} {z} 5"));
    text.replace(text.find("ZONE "), 5, "ZONE " + zone);
    write_text(folder_ / "t.tec", text + more);
    return folder_ / "t.tec";
  };
  EXPECT_EQ(values(with("STRANDID=1, SOLUTIONTIME=0.5, "), 8), std::vector<double>(8, 5));
  EXPECT_THAT(complaint(with("SOLUTIONTIME=0.5, ",
                             "ZONE SOLUTIONTIME=0.75, I=1, J=1, K=1, "
                             "F=POINT\n0 0 0 5\n")),
              HasSubstr("zones at the times 0.5 and 0.75; accepted: a file per time"));
  EXPECT_THAT(complaint(with("VARSHARELIST=([1]=1), ")), HasSubstr("t.tec: "));
}

TEST_F(UnitSimulationFiles, CgnsInCylindricalCoordinatesIsRefused) {
  write_text(folder_ / "c.cgns", std::string(100, ' ') + "CoordinateTheta");
  EXPECT_THAT(complaint(folder_ / "c.cgns"), HasSubstr("it has CoordinateTheta; accepted"));
}

TEST_F(UnitSimulationFiles, FoamWhoseProcessorsHaveMoreIsRefused) {
  for (const std::string part : {"processor0", "processors4"}) {
    const auto folder = folder_ / part / "case";
    for (const auto& time : {folder / "0", folder / part / "0", folder / part / "0.25"})
      std::filesystem::create_directories(time);
    write_text(folder / "c.foam", "");
    EXPECT_THAT(complaint(folder / "c.foam"), HasSubstr(part + " has the time 0.25"));
    std::filesystem::create_directories(folder / "0.25");
    EXPECT_THAT(complaint(folder / "c.foam"), Not(HasSubstr(part + " has")));
  }
}

}  // namespace
}  // namespace pellucid::readers
