// SPDX-License-Identifier: GPL-3.0-or-later
// VTK takes the last dimension for x, whatever it is, and spacings within 1 % of each
// other for even ones, by a first sample that it forgets to turn round where heights count
// downwards: axes are rectilinear here, with the coordinates of the file. VTK takes bytes for such
// without a sign, times for such that ascend, and a time for one where it is the first dimension.

#include "readers/simulations/make_netcdf.h"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNetCDFCFReader.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtk_netcdf.h>

#include <algorithm>
#include <optional>

#include "core/error.h"
#include "readers/simulations/netcdf_axes.h"
#include "readers/simulations/netcdf_choice.h"
#include "readers/simulations/netcdf_missing.h"
#include "readers/simulations/netcdf_times.h"
#include "readers/simulations/permuted_axes.h"

namespace pellucid::readers {
namespace {

/// Longitudes of their own, as of ocean models, jump somewhere from 360 to 0: a cell across would
/// lie folded over all others, and be found in their place. So would one with a pole inside.
void hide_folded_cells(vtkDataSet& data) {
  vtkUnsignedCharArray* marks = data.GetCellGhostArray();
  for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) {
    double box[6];
    data.GetCellBounds(i, box);
    if (box[1] - box[0] <= 180) continue;
    if (!marks) marks = data.AllocateCellGhostArray();
    const int mark = marks->GetValue(i) | vtkDataSetAttributes::HIDDENCELL;
    marks->SetValue(i, static_cast<unsigned char>(mark));
  }
}

class NetcdfReader : public vtkNetCDFCFReader {
 public:
  static NetcdfReader* New() { VTK_STANDARD_NEW_BODY(NetcdfReader); }

  std::vector<std::string> pick(const std::string& wanted) {
    std::vector<std::string> left_out;
    const std::vector<NetcdfChoice> choices = all_choices();
    const std::string dimensions = chosen_dimensions(choices, wanted, GetFileName());
    for (const NetcdfChoice& choice : choices) {
      const bool fits = choice.is_grid() && choice.dimensions == dimensions;
      if (fits && choice.time_is_late) refuse_late_time(choice);
      SetVariableArrayStatus(choice.name.c_str(), fits);
      if (!fits && choice.axes() > 0)
        left_out.push_back(
            fmt::format("{}{}: it {}", choice.name, choice.dimensions, reason_of(choice)));
    }
    return left_out;
  }

 protected:
  int RequestDataObject(vtkInformation* request, vtkInformationVector** input,
                        vtkInformationVector* output) override {
    if (!vtkNetCDFCFReader::RequestDataObject(request, input, output)) return 0;
    if (vtkImageData::GetData(output))
      output->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(),
                                           vtkNew<vtkRectilinearGrid>());
    return 1;
  }

  int RequestData(vtkInformation* request, vtkInformationVector** input,
                  vtkInformationVector* output) override {
    if (!vtkNetCDFCFReader::RequestData(request, input, output)) return 0;
    if (auto* grid = vtkRectilinearGrid::GetData(output)) {
      refuse_listed_places();
      permute_axes(*grid, order_in_file());
    } else if (auto* cells = vtkDataSet::GetData(output)) {
      hide_folded_cells(*cells);
    }
    return 1;
  }

  int LoadVariable(int file, const char* name, double time, vtkDataSet* output) override {
    time_to_load_ = time;
    const bool is_loaded = vtkNetCDFCFReader::LoadVariable(file, name, time, output) != 0;
    time_to_load_.reset();
    if (!is_loaded) return 0;
    const NetcdfVariable variable(file, name);
    sign_bytes(variable, name, *output->GetPointData());
    sign_bytes(variable, name, *output->GetCellData());
    const MissingSamples is_missing(variable);
    hide_missing(is_missing, name, *output->GetPointData());
    hide_missing(is_missing, name, *output->GetCellData());
    return 1;
  }

  vtkSmartPointer<vtkDoubleArray> GetTimeValues(int file, int dimension) override {
    const auto times = vtkNetCDFCFReader::GetTimeValues(file, dimension);
    if (!times) return times;
    return time_to_load_ ? times_to_load(*times, *time_to_load_)
                         : ascending_times(*times, GetFileName());
  }

 private:
  /// None of a file that cannot be read, of which VTK complains when asked again.
  std::vector<NetcdfChoice> all_choices() {
    std::vector<NetcdfChoice> choices;
    int file = 0;
    refuse_lost_bounds();
    if (!UpdateMetaData() || nc_open(GetFileName(), NC_NOWRITE, &file) != NC_NOERR) return choices;
    for (int i = 0; i < GetNumberOfVariableArrays(); ++i) {
      const char* const name = GetVariableArrayName(i);
      const NetcdfVariable variable(file, name);
      choices.push_back({name, GetVariableDimensions()->GetValue(i), variable.is_number(),
                         variable.unread_by_vtk(), is_time_late(file, name)});
    }
    if (choices.empty()) refuse_groups(file);
    nc_close(file);
    return choices;
  }
  static std::string reason_of(const NetcdfChoice& choice) {
    if (!choice.is_number) return "holds no numbers";
    return choice.unread.empty() ? "has other dimensions" : choice.unread;
  }
  /// VTK looks for the bounds that a coordinate names, and does not say which one it misses.
  void refuse_lost_bounds() {
    int file = 0, count = 0;
    if (nc_open(GetFileName(), NC_NOWRITE, &file) != NC_NOERR) return;
    nc_inq_ndims(file, &count);
    for (int i = 0; i < count; ++i) {
      char name[NC_MAX_NAME + 1] = {};
      int id = 0, other = 0;
      if (nc_inq_dimname(file, i, name) != NC_NOERR || nc_inq_varid(file, name, &id) != NC_NOERR)
        continue;
      const std::string bounds = text_attribute(file, id, "bounds");
      if (!bounds.empty() && nc_inq_varid(file, bounds.c_str(), &other) != NC_NOERR)
        throw InputError(
            fmt::format("{}: the coordinate '{}' has its bounds in '{}', which is not "
                        "there; accepted: none (ncatted -a bounds,{},d,,)",
                        GetFileName(), name, bounds, name));
    }
    nc_close(file);
  }
  /// VTK knows the variables of the root group alone.
  void refuse_groups(int file) {
    int count = 0;
    if (nc_inq_grps(file, &count, nullptr) != NC_NOERR || count == 0) return;
    std::vector<int> groups(std::size_t(count), 0);
    nc_inq_grps(file, nullptr, groups.data());
    char name[NC_MAX_NAME + 1] = {};
    nc_inq_grpname(groups.front(), name);
    throw InputError(
        fmt::format("{}: its variables are in groups, '{}' is the first of {}; accepted: variables "
                    "of the file itself (ncks -G : brings them there)",
                    GetFileName(), name, count));
  }
  /// Says whether a variable has its time among its dimensions, but not as the first.
  bool is_time_late(int file, const char* name) {
    int id = 0, count = 0, dimensions[NC_MAX_VAR_DIMS] = {};
    if (nc_inq_varid(file, name, &id) != NC_NOERR ||
        nc_inq_var(file, id, nullptr, nullptr, &count, dimensions, nullptr) != NC_NOERR)
      return false;
    return std::any_of(dimensions + std::min(count, 1), dimensions + count,
                       [&](int dimension) { return IsTimeDimension(file, dimension) != 0; });
  }
  [[noreturn]] void refuse_late_time(const NetcdfChoice& choice) {
    throw InputError(
        fmt::format("{}: '{}' has the dimensions {}, the time not first, and VTK would take it for "
                    "one of space; accepted: the time first (ncpdq -a TIME puts it there)",
                    GetFileName(), choice.name, choice.dimensions));
  }
  /// Of the dimensions that are loaded, the last being the fastest.
  AxisOrder order_in_file() {
    std::vector<int> dimensions;
    for (vtkIdType i = LoadingDimensions->GetNumberOfTuples(); i-- > 0;)
      dimensions.push_back(LoadingDimensions->GetValue(i));
    int file = 0;
    if (nc_open(GetFileName(), NC_NOWRITE, &file) != NC_NOERR)
      throw InputError(fmt::format("{}: cannot be opened again", GetFileName()));
    const AxisOrder order = axis_order(file, dimensions);
    for (const int dimension : dimensions) refuse_packed(file, dimension);
    nc_close(file);
    return order;
  }
  /// On a grid along axes VTK has not looked at `coordinates`: samples would be at their numbers.
  void refuse_listed_places() {
    int file = 0, id = 0;
    if (nc_open(GetFileName(), NC_NOWRITE, &file) != NC_NOERR) return;
    for (int i = 0; i < GetNumberOfVariableArrays(); ++i) {
      const char* const name = GetVariableArrayName(i);
      if (!GetVariableArrayStatus(name) || nc_inq_varid(file, name, &id) != NC_NOERR) continue;
      if (const std::string along = dimension_of_listed_places(file, id); !along.empty())
        throw InputError(
            fmt::format("{}: '{}' has its places one by one along '{}', which is not "
                        "read; accepted: axes, longitudes and latitudes of two "
                        "dimensions (cdo remapbil makes them)",
                        GetFileName(), name, along));
    }
    nc_close(file);
  }
  /// VTK leaves coordinates as they are in the file.
  void refuse_packed(int file, int dimension) {
    char name[NC_MAX_NAME + 1] = {};
    int id = 0;
    if (nc_inq_dimname(file, dimension, name) != NC_NOERR ||
        nc_inq_varid(file, name, &id) != NC_NOERR)
      return;
    if (const NetcdfVariable coordinate(file, name);
        coordinate.unpacked(0) != 0 || coordinate.unpacked(1) != 1)
      throw InputError(
          fmt::format("{}: the coordinate '{}' has a scale_factor or an add_offset, "
                      "which VTK does not apply; accepted: none",
                      GetFileName(), name));
  }

  std::optional<double> time_to_load_;  // while VTK loads a variable
};

}  // namespace

vtkSmartPointer<vtkAlgorithm> make_netcdf(const std::filesystem::path& path) {
  const auto reader = vtkSmartPointer<NetcdfReader>::New();
  reader->SetFileName(path.c_str());
  reader->SphericalCoordinatesOff();
  return reader;
}

std::vector<std::string> pick_netcdf_variables(vtkAlgorithm& reader, const std::string& wanted) {
  auto* netcdf = dynamic_cast<NetcdfReader*>(&reader);
  return netcdf ? netcdf->pick(wanted) : std::vector<std::string>();
}

}  // namespace pellucid::readers
