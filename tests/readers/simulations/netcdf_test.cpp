// SPDX-License-Identifier: GPL-3.0-or-later
// Where NetCDF's samples are, by the CF conventions, and which of them make one grid.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <netcdf.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkPointData.h>

#include <algorithm>
#include <map>

#include "core/error.h"
#include "readers/vtk/shown_cells.h"
#include "readers/vtk/vtk_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::readers {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A Dimension has a coordinate variable of its name.
struct Dimension {
  std::string name;
  std::vector<double> coordinates;
  std::map<std::string, std::string> attributes;
};

/// A NetcdfFile is one that is being written.
class NetcdfFile {
 public:
  explicit NetcdfFile(const std::filesystem::path& path) {
    EXPECT_EQ(nc_create(path.c_str(), NC_CLOBBER | NC_NETCDF4, &file_), NC_NOERR);
  }
  ~NetcdfFile() { nc_close(file_); }
  NetcdfFile(const NetcdfFile&) = delete;

  int add(const Dimension& dimension) {
    int id = 0, variable = 0;
    nc_def_dim(file_, dimension.name.c_str(), dimension.coordinates.size(), &id);
    nc_def_var(file_, dimension.name.c_str(), NC_DOUBLE, 1, &id, &variable);
    for (const auto& [name, text] : dimension.attributes)
      nc_put_att_text(file_, variable, name.c_str(), text.size(), text.c_str());
    nc_put_var_double(file_, variable, dimension.coordinates.data());
    return id;
  }
  void add(const char* name, const std::vector<int>& dimensions, nc_type type = NC_DOUBLE,
           const std::vector<double>& values = {}) {
    int variable = 0;
    nc_def_var(file_, name, type, int(dimensions.size()), dimensions.data(), &variable);
    if (!values.empty()) nc_put_var_double(file_, variable, values.data());
  }

 private:
  int file_ = 0;
};

class UnitNetcdf : public ::testing::Test {
 protected:
  /// A file of one variable over these dimensions, the last the fastest, in which each sample is
  /// the sum of its own coordinates.
  std::filesystem::path sums(const std::vector<Dimension>& dimensions) const {
    NetcdfFile file(path_);
    std::vector<int> ids;
    std::vector<double> values{0};
    for (const Dimension& dimension : dimensions) {
      ids.push_back(file.add(dimension));
      std::vector<double> finer;
      for (const double value : values)
        for (const double coordinate : dimension.coordinates) finer.push_back(value + coordinate);
      values = finer;
    }
    file.add("sum", ids, NC_DOUBLE, values);
    return path_;
  }

  /// Every sample is where its coordinates are, of which `sign` turns the third round.
  void expect_in_place(const std::vector<Dimension>& dimensions, double sign = 1) const {
    const auto data = read_vtk_data_set(sums(dimensions));
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
      const double* x = data->GetPoint(i);
      EXPECT_EQ(data->GetPointData()->GetArray("sum")->GetComponent(i, 0),
                x[0] + x[1] + sign * x[2]);
    }
    double box[6];
    data->GetBounds(box);
    EXPECT_THAT(std::vector<double>(box, box + 4), ElementsAre(0, 1, 10, 30));
  }

  std::string complaint(const std::string& arrays) const {
    try {
      read_vtk_file(path_, {}, {}, arrays);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no complaint";
  }

  testing::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "a.nc";
};

/// Names that say nothing, so that the attribute does.
std::vector<Dimension> xyz(const std::string& attribute, const std::vector<std::string>& texts) {
  return {{"p", {0, 1}, {{attribute, texts[0]}}},
          {"q", {10, 20, 30}, {{attribute, texts[1]}}},
          {"r", {100, 200, 300, 400}, {{attribute, texts[2]}}}};
}

const std::vector<std::vector<Dimension>>& named_axes() {
  static const std::vector<std::vector<Dimension>> all{
      xyz("axis", {"X", "Y", "Z"}),
      xyz("standard_name", {"longitude", "latitude", "air_pressure"}),
      xyz("standard_name",
          {"projection_x_coordinate", "projection_y_coordinate", "ocean_sigma_coordinate"}),
      xyz("units", {"degrees_east", "degree_N", "hPa"}),
      {{"p", {0, 1}, {{"units", "degrees_east"}}},
       {"q", {10, 20, 30}, {{"units", "degrees_north"}}},
       {"r", {100, 200, 300, 400}, {{"positive", "up"}}}},
      {{"lon", {0, 1}, {}}, {"lat", {10, 20, 30}, {}}, {"height", {100, 200, 300, 400}, {}}}};
  return all;
}

TEST_F(UnitNetcdf, AxesAreThoseOfTheirNamesInAnyOrder) {
  for (const std::vector<Dimension>& dimensions : named_axes()) expect_in_place(dimensions);
  std::vector<Dimension> dimensions = named_axes().front();
  const auto by_name = [](const Dimension& a, const Dimension& b) { return a.name < b.name; };
  while (std::next_permutation(dimensions.begin(), dimensions.end(), by_name))
    expect_in_place(dimensions);
}

TEST_F(UnitNetcdf, APlaneIsAlongTheAxesOfItsNames) {
  expect_in_place({{"lon", {0, 1}, {}}, {"lat", {10, 20, 30}, {}}});
  double box[6];
  read_vtk_data_set(sums({{"x", {0, 1}, {}}, {"z", {10, 20, 30}, {}}}))->GetBounds(box);
  EXPECT_THAT(box, ElementsAre(0, 1, 0, 0, 10, 30));
}

TEST_F(UnitNetcdf, AxesThatNothingNamesAreInTheirOrder) {
  expect_in_place({{"r", {100, 200, 300, 400}, {}}, {"q", {10, 20, 30}, {}}, {"p", {0, 1}, {}}});
  const std::map<std::string, std::string> x{{"axis", "X"}};  // twice: of no use
  expect_in_place({{"r", {100, 200, 300, 400}, x}, {"q", {10, 20, 30}, {}}, {"p", {0, 1}, x}});
}

TEST_F(UnitNetcdf, DepthsAreNegativeHeights) {
  for (const std::vector<double>& depths :
       {std::vector<double>{5, 15, 25, 35}, std::vector<double>{5, 15, 30, 70}})
    expect_in_place(
        {{"depth", depths, {{"positive", "down"}}}, {"lat", {10, 20, 30}, {}}, {"lon", {0, 1}, {}}},
        -1);
}

/// VTK takes spacings for even ones that differ by up to 1 %.
TEST_F(UnitNetcdf, CoordinatesAreThoseOfTheFile) {
  expect_in_place({{"z", {100, 200.5, 300}, {}}, {"y", {10, 19.9375, 30}, {}}, {"x", {0, 1}, {}}});
}

TEST_F(UnitNetcdf, PackedCoordinatesAreRefused) {
  sums({{"y", {10, 20, 30}, {}}, {"x", {0, 1}, {}}});
  int file = 0, variable = 0;
  const double scale = 0.5;
  nc_open(path_.c_str(), NC_WRITE, &file);
  nc_inq_varid(file, "x", &variable);
  nc_put_att_double(file, variable, "scale_factor", NC_DOUBLE, 1, &scale);
  nc_close(file);
  EXPECT_THAT(complaint(""), HasSubstr("the coordinate 'x' has a scale_factor"));
}

TEST_F(UnitNetcdf, BoundsThatAreNotThereAreNamed) {
  sums({{"y", {10, 20, 30}, {{"bounds", "y_bnds"}}}, {"x", {0, 1}, {}}});
  EXPECT_THAT(complaint(""),
              HasSubstr("the coordinate 'y' has its bounds in 'y_bnds', which is not there"));
}

TEST_F(UnitNetcdf, ALevelAloneIsAPlaneAtItsHeight) {
  expect_in_place({{"z", {100}, {}}, {"y", {10, 20, 30}, {}}, {"x", {0, 1}, {}}});
}

TEST_F(UnitNetcdf, VariablesOfOtherDimensionsAreLeftOut) {
  {
    NetcdfFile file(path_);
    const int lev = file.add({"lev", {1, 2}, {}}), lat = file.add({"lat", {1, 2, 3}, {}}),
              lon = file.add({"lon", {1, 2, 3, 4}, {}});
    file.add("crs", {});
    file.add("sp", {lat, lon}), file.add("ice", {lat, lon}), file.add("sst", {lat, lon});
    file.add("u", {lev, lat, lon}), file.add("title", {lat}, NC_CHAR);
  }
  const auto names = [&](const std::string& wanted) {
    const auto read = read_vtk_file(path_, {}, {}, wanted);
    std::vector<std::string> all = read.front().left_out;
    for (int i = 0; i < read.front().data->GetPointData()->GetNumberOfArrays(); ++i)
      all.push_back(read.front().data->GetPointData()->GetArrayName(i));
    return all;
  };
  const std::string other = ": it has other dimensions";
  const auto levels = ElementsAre("ice(lat, lon)" + other, "sp(lat, lon)" + other,
                                  "sst(lat, lon)" + other, "title(lat): it holds no numbers", "u");
  EXPECT_THAT(names(""), levels);
  EXPECT_THAT(names("u"), levels);
  EXPECT_THAT(names("point:u,other"), levels);
  EXPECT_THAT(names("sp,ice"), ElementsAre("title(lat): it holds no numbers",
                                           "u(lev, lat, lon)" + other, "ice", "sp", "sst"));
  EXPECT_THAT(complaint("u,sp"),
              HasSubstr("'u' has the dimensions (lev, lat, lon) and 'sp' (lat, lon)"));
}

TEST_F(UnitNetcdf, OfAsManyAxesThoseOfMoreVariablesAreRead) {
  {
    NetcdfFile file(path_);
    const int a = file.add({"a", {1, 2}, {}}), b = file.add({"b", {1, 2}, {}}),
              c = file.add({"c", {1, 2}, {}});
    file.add("p", {a, b}), file.add("q", {b, c}), file.add("r", {b, c});
  }
  const auto read = read_vtk_file(path_);
  EXPECT_THAT(read.front().left_out, ElementsAre("p(a, b): it has other dimensions"));
  EXPECT_THAT(read_vtk_file(path_, {}, {}, "p").front().left_out,
              ElementsAre("q(b, c): it has other dimensions", "r(b, c): it has other dimensions"));
}

/// As NumPy's and xarray's masks are: int64.
TEST_F(UnitNetcdf, TypesThatVtkDoesNotReadAreLeftOutUnlessTheyAreWanted) {
  {
    NetcdfFile file(path_);
    const int y = file.add({"y", {1, 2}, {}}), x = file.add({"x", {1, 2, 3}, {}});
    file.add("u", {y, x}), file.add("v", {y, x}), file.add("mask", {y, x}, NC_INT64);
  }
  const auto read = read_vtk_file(path_, {}, {}, "u,v");
  EXPECT_EQ(read.front().data->GetPointData()->GetNumberOfArrays(), 2);
  EXPECT_THAT(read.front().left_out,
              ElementsAre(HasSubstr("mask(y, x): it is of int64, which VTK does not read")));
  EXPECT_THAT(read_vtk_file(path_).front().left_out, ::testing::SizeIs(1));
  EXPECT_THAT(complaint("mask"), HasSubstr("'mask' is of int64, which VTK does not read"));
}

TEST_F(UnitNetcdf, VariablesInGroupsAreSaidToBeThere) {
  int file = 0, group = 0, dimension = 0, variable = 0;
  nc_create(path_.c_str(), NC_NETCDF4, &file);
  nc_def_grp(file, "flow", &group);
  nc_def_dim(group, "x", 2, &dimension);
  nc_def_var(group, "u", NC_DOUBLE, 1, &dimension, &variable);
  nc_close(file);
  EXPECT_THAT(complaint(""), HasSubstr("its variables are in groups, 'flow' is the first of 1"));
}

void put_text(int file, int variable, const char* name, const std::string& text) {
  nc_put_att_text(file, variable, name, text.size(), text.c_str());
}

/// As of ocean models: longitudes and latitudes of two dimensions, which go through 360 once.
TEST_F(UnitNetcdf, CellsAcrossTheJumpOfLongitudesAreHidden) {
  int file = 0, ids[2] = {}, lon = 0, lat = 0, sst = 0;
  ASSERT_EQ(nc_create(path_.c_str(), NC_CLOBBER, &file), NC_NOERR);
  nc_def_dim(file, "j", 2, &ids[0]), nc_def_dim(file, "i", 4, &ids[1]);
  nc_def_var(file, "lon", NC_DOUBLE, 2, ids, &lon), put_text(file, lon, "units", "degrees_east");
  nc_def_var(file, "lat", NC_DOUBLE, 2, ids, &lat), put_text(file, lat, "units", "degrees_north");
  nc_def_var(file, "sst", NC_DOUBLE, 2, ids, &sst), put_text(file, sst, "coordinates", "lon lat");
  nc_enddef(file);
  const double lons[] = {350, 358, 6, 14, 352, 359, 8, 16}, lats[] = {0, 0, 0, 0, 9, 9, 9, 9};
  nc_put_var_double(file, lon, lons), nc_put_var_double(file, lat, lats);
  nc_put_var_double(file, sst, lats);
  nc_close(file);
  const auto data = read_vtk_data_set(path_);
  ASSERT_EQ(data->GetNumberOfCells(), 3);
  EXPECT_FALSE(hides_cell(data, 0));
  EXPECT_TRUE(hides_cell(data, 1));
  EXPECT_FALSE(hides_cell(data, 2));
}

/// As of ICON's grids of triangles, with a time that is none of CF's.
TEST_F(UnitNetcdf, PlacesOneByOneAreRefused) {
  int file = 0, ids[2] = {}, clon = 0, clat = 0, salt = 0;
  ASSERT_EQ(nc_create(path_.c_str(), NC_CLOBBER, &file), NC_NOERR);
  nc_def_dim(file, "depth", 2, &ids[0]), nc_def_dim(file, "ncells", 3, &ids[1]);
  nc_def_var(file, "clon", NC_DOUBLE, 1, ids + 1, &clon),
      put_text(file, clon, "standard_name", "longitude");
  nc_def_var(file, "clat", NC_DOUBLE, 1, ids + 1, &clat),
      put_text(file, clat, "standard_name", "latitude");
  nc_def_var(file, "S", NC_DOUBLE, 2, ids, &salt);
  nc_close(file);
  EXPECT_EQ(complaint("S"), "no complaint");
  nc_open(path_.c_str(), NC_WRITE, &file);
  nc_redef(file), put_text(file, salt, "coordinates", "clon clat");
  nc_close(file);
  EXPECT_THAT(complaint("S"), HasSubstr("'S' has its places one by one along 'ncells'"));
}

/// A file of u = 10 t at each of the times, over a plane.
class UnitNetcdfTimes : public UnitNetcdf {
 protected:
  void write(const std::vector<double>& times) const {
    NetcdfFile file(path_);
    const int t = file.add({"time", times, {{"units", "days since 2000-01-01"}, {"axis", "T"}}});
    const int y = file.add({"y", {0, 1}, {}}), x = file.add({"x", {0, 1, 2}, {}});
    std::vector<double> values;
    for (const double time : times) values.insert(values.end(), 6, 10 * time);
    file.add("u", {t, y, x}, NC_DOUBLE, values);
  }
};

TEST_F(UnitNetcdfTimes, AreReadInOrderWhateverTheirs) {
  for (const std::vector<double>& times :
       {std::vector<double>{0, 1, 3}, {3, 1, 0}, {1, 3, 0}, {3, 0, 1}, {-1, 0, 2}}) {
    write(times);
    const auto read = read_vtk_file(path_);
    ASSERT_EQ(read.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(read[i].time > read[0].time, i > 0);
      EXPECT_EQ(read[i].data->GetPointData()->GetArray("u")->GetComponent(4, 0), 10 * read[i].time);
    }
    const auto last = read_vtk_file(path_, {}, "last");
    EXPECT_EQ(last.front().time, std::ranges::max(times));
    EXPECT_EQ(last.front().of.size(), 3u);
  }
}

TEST_F(UnitNetcdfTimes, OfWhichTwoAreTheSameAreRefused) {
  write({0, 1, 1, 2});
  EXPECT_THAT(complaint(""), HasSubstr("two of its times are 1"));
}

TEST_F(UnitNetcdfTimes, ThatAreNotTheFirstDimensionAreRefused) {
  {
    NetcdfFile file(path_);
    const int y = file.add({"y", {0, 1}, {}}), x = file.add({"x", {0, 1, 2}, {}}),
              t = file.add({"time", {0, 1}, {{"units", "days since 2000-01-01"}}});
    file.add("u", {y, x, t}), file.add("p", {y, x});
  }
  EXPECT_THAT(complaint("u"), HasSubstr("the time not first"));
  EXPECT_EQ(complaint("p"), "no complaint");
}

TEST_F(UnitNetcdf, BytesHaveASign) {
  {
    NetcdfFile file(path_);
    const int y = file.add({"y", {0, 1}, {}}), x = file.add({"x", {0, 1}, {}});
    file.add("b", {y, x}, NC_BYTE, {-1, -128, 0, 127});
  }
  const auto data = read_vtk_data_set(path_);
  std::vector<double> values;
  for (vtkIdType i = 0; i < 4; ++i)
    values.push_back(data->GetPointData()->GetArray("b")->GetComponent(i, 0));
  EXPECT_THAT(values, ElementsAre(-1, -128, 0, 127));
}

}  // namespace
}  // namespace pellucid::readers
