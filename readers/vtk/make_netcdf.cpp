// SPDX-License-Identifier: GPL-3.0-or-later
// VTK 9.1 knows of _FillValue alone, and forgets it in variables of integers, which is how packed
// data are kept. Meanings of the attributes: NetCDF User's Guide, Appendix A, "Attribute
// Conventions".

#include "readers/vtk/make_netcdf.h"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkNetCDFCFReader.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtk_netcdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"

namespace pellucid::readers {
namespace {

/// A Variable is one of a NetCDF file: its type, and how its numbers are packed.
class Variable {
 public:
  Variable(int file, const char* name) : file_(file) {
    nc_inq_varid(file, name, &id_);
    nc_inq_vartype(file, id_, &type_);
    scale_ = number("scale_factor").value_or(1);
    offset_ = number("add_offset").value_or(0);
  }

  /// Numbers of an attribute; none where there is no such one, or of text.
  std::vector<double> numbers(const char* attribute) const {
    std::size_t count = 0;
    nc_type type = NC_NAT;
    if (nc_inq_att(file_, id_, attribute, &type, &count) != NC_NOERR || type == NC_CHAR) return {};
    std::vector<double> values(count);
    if (nc_get_att_double(file_, id_, attribute, values.data()) != NC_NOERR) return {};
    return values;
  }
  std::optional<double> number(const char* attribute) const {
    const auto values = numbers(attribute);
    return values.empty() ? std::nullopt : std::optional(values.front());
  }

  /// Says whether the file calls its numbers, of a type with a sign, such without.
  bool is_called_unsigned() const {
    std::size_t length = 0;
    if (nc_inq_attlen(file_, id_, "_Unsigned", &length) != NC_NOERR || length != 4) return false;
    std::string text(length, ' ');
    if (nc_get_att_text(file_, id_, "_Unsigned", text.data()) != NC_NOERR) return false;
    return text == "true" || text == "True" || text == "TRUE";
  }

  bool is_integer() const { return type_ != NC_FLOAT && type_ != NC_DOUBLE; }

  /// The number that VTK makes of one in the file, in its own arithmetic.
  double unpacked(double packed) const {
    if (type_ == NC_FLOAT) packed = float(packed);  // as attributes of doubles meet samples
    return scale_ == 1 && offset_ == 0 ? packed : packed * scale_ + offset_;
  }
  /// An end of the valid samples: of a wider type than the variable's it is unpacked already.
  double unpacked_end(const char* attribute, double end) const {
    nc_type type = NC_NAT;
    nc_inq_atttype(file_, id_, attribute, &type);
    const bool is_packed = scale_ != 1 || offset_ != 0;
    return is_packed && width(type) > width(type_) ? end : unpacked(end);
  }
  /// Half of what lies between two numbers, at most: what rounding may do.
  double slack() const { return is_integer() ? std::abs(scale_) / 4 : 0; }

  /// What NetCDF fills in where nothing was written; bytes it does not tell from such that were.
  std::optional<double> default_fill() const {
    switch (type_) {
      case NC_SHORT:
        return NC_FILL_SHORT;
      case NC_USHORT:
        return NC_FILL_USHORT;
      case NC_INT:
        return NC_FILL_INT;
      case NC_UINT:
        return NC_FILL_UINT;
      case NC_INT64:
        return double(NC_FILL_INT64);
      case NC_UINT64:
        return double(NC_FILL_UINT64);
      case NC_FLOAT:
        return NC_FILL_FLOAT;
      case NC_DOUBLE:
        return NC_FILL_DOUBLE;
      default:
        return std::nullopt;
    }
  }

 private:
  std::size_t width(nc_type type) const {
    std::size_t bytes = 0;
    nc_inq_type(file_, type, nullptr, &bytes);
    return bytes;
  }

  int file_, id_ = -1;
  nc_type type_ = NC_NAT;
  double scale_ = 1, offset_ = 0;
};

/// Says of the samples that VTK leaves which ones are missing.
class Missing {
 public:
  explicit Missing(const Variable& variable) : slack_(variable.slack()) {
    add_fills(variable);
    if (const auto range = variable.numbers("valid_range"); range.size() == 2)
      narrow(variable.unpacked_end("valid_range", range[0]),
             variable.unpacked_end("valid_range", range[1]));
    // A scale below 0 turns an end round: what it leaves on the other side is as far as can be.
    const double all = std::numeric_limits<double>::infinity();
    if (const auto least = variable.number("valid_min"))
      narrow(variable.unpacked_end("valid_min", *least), variable.unpacked(all));
    if (const auto most = variable.number("valid_max"))
      narrow(variable.unpacked(-all), variable.unpacked_end("valid_max", *most));
  }

  bool operator()(double value) const {
    if (value < least_ - slack_ || value > most_ + slack_) return true;
    return std::ranges::any_of(fills_,
                               [&](double fill) { return std::abs(value - fill) <= slack_; });
  }

 private:
  void add_fills(const Variable& variable) {
    fills_ = variable.numbers("_FillValue");
    if (fills_.empty())
      if (const auto fill = variable.default_fill()) fills_.push_back(*fill);
    for (const double value : variable.numbers("missing_value")) fills_.push_back(value);
    for (double& fill : fills_) fill = variable.unpacked(fill);
  }
  void narrow(double a, double b) {
    least_ = std::max(least_, std::min(a, b));
    most_ = std::min(most_, std::max(a, b));
  }

  double slack_;
  double least_ = -std::numeric_limits<double>::infinity();
  double most_ = std::numeric_limits<double>::infinity();
  std::vector<double> fills_;
};

/// Puts NaN where samples are missing: integers that miss some become doubles.
void hide_missing(const Missing& is_missing, const char* name, vtkDataSetAttributes& arrays) {
  vtkDataArray* const array = arrays.GetArray(name);
  if (!array || array->GetNumberOfComponents() != 1) return;
  vtkSmartPointer<vtkDataArray> kept = array;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
    if (!is_missing(array->GetComponent(i, 0))) continue;
    if (kept == array && array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE) {
      kept = vtkSmartPointer<vtkDoubleArray>::New();
      kept->DeepCopy(array);
    }
    kept->SetComponent(i, 0, std::numeric_limits<double>::quiet_NaN());
  }
  if (kept != array) arrays.AddArray(kept);  // in the place of the one of its name
}

class NetcdfReader : public vtkNetCDFCFReader {
 public:
  static NetcdfReader* New() { VTK_STANDARD_NEW_BODY(NetcdfReader); }

 protected:
  int LoadVariable(int file, const char* name, double time, vtkDataSet* output) override {
    refuse_unsigned(Variable(file, name), name);
    if (!vtkNetCDFCFReader::LoadVariable(file, name, time, output)) return 0;
    const Missing is_missing{Variable(file, name)};
    hide_missing(is_missing, name, *output->GetPointData());
    hide_missing(is_missing, name, *output->GetCellData());
    return 1;
  }

 private:
  void refuse_unsigned(const Variable& variable, const char* name) {
    if (variable.is_called_unsigned())
      throw InputError(
          fmt::format("{}: '{}' has the attribute _Unsigned, which VTK does not know; "
                      "accepted: a variable of an unsigned or a wider type",
                      GetFileName(), name));
  }
};

}  // namespace

vtkSmartPointer<vtkAlgorithm> make_netcdf(const std::filesystem::path& path) {
  const auto reader = vtkSmartPointer<NetcdfReader>::New();
  reader->SetFileName(path.c_str());
  reader->SphericalCoordinatesOff();
  return reader;
}

}  // namespace pellucid::readers
