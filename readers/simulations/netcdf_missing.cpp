// SPDX-License-Identifier: GPL-3.0-or-later
// VTK 9.1 knows of _FillValue alone, and forgets it in variables of integers, which is how packed
// data are kept. Meanings of the attributes: NetCDF User's Guide, Appendix A, "Attribute
// Conventions".

#include "readers/simulations/netcdf_missing.h"

#include <fmt/format.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkSignedCharArray.h>
#include <vtk_netcdf.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

#include "readers/simulations/netcdf_axes.h"

namespace pellucid::readers {

NetcdfVariable::NetcdfVariable(int file, const char* name) : file_(file) {
  nc_inq_varid(file, name, &id_);
  nc_inq_vartype(file, id_, &type_);
  scale_ = number("scale_factor").value_or(1);
  offset_ = number("add_offset").value_or(0);
}

std::vector<double> NetcdfVariable::numbers(const char* attribute) const {
  std::size_t count = 0;
  nc_type type = NC_NAT;
  if (nc_inq_att(file_, id_, attribute, &type, &count) != NC_NOERR || type == NC_CHAR) return {};
  std::vector<double> values(count);
  if (nc_get_att_double(file_, id_, attribute, values.data()) != NC_NOERR) return {};
  return values;
}

std::optional<double> NetcdfVariable::number(const char* attribute) const {
  const auto values = numbers(attribute);
  return values.empty() ? std::nullopt : std::optional(values.front());
}

/// VTK takes the types of NetCDF 3 alone, and does not know the attribute _Unsigned.
std::string NetcdfVariable::unread_by_vtk() const {
  constexpr std::pair<int, const char*> others[] = {{NC_UBYTE, "ubyte"},
                                                    {NC_USHORT, "ushort"},
                                                    {NC_UINT, "uint"},
                                                    {NC_INT64, "int64"},
                                                    {NC_UINT64, "uint64"}};
  constexpr const char* accepted = "accepted: byte, short, int, float, double";
  for (const auto& [type, name] : others)
    if (type_ == type) return fmt::format("is of {}, which VTK does not read; {}", name, accepted);
  const std::string text = text_attribute(file_, id_, "_Unsigned");
  if (text == "true" || text == "True" || text == "TRUE")
    return fmt::format("has the attribute _Unsigned, which VTK does not know; {}, without it",
                       accepted);
  return {};
}

bool NetcdfVariable::is_number() const {
  return type_ >= NC_BYTE && type_ <= NC_UINT64 && type_ != NC_CHAR;
}

bool NetcdfVariable::is_integer() const { return type_ != NC_FLOAT && type_ != NC_DOUBLE; }

bool NetcdfVariable::is_byte() const { return type_ == NC_BYTE; }

double NetcdfVariable::unpacked(double packed) const {
  if (type_ == NC_FLOAT) packed = float(packed);  // as attributes of doubles meet samples
  return scale_ == 1 && offset_ == 0 ? packed : packed * scale_ + offset_;
}

double NetcdfVariable::unpacked_end(const char* attribute, double end) const {
  nc_type type = NC_NAT;
  nc_inq_atttype(file_, id_, attribute, &type);
  const bool is_packed = scale_ != 1 || offset_ != 0;
  return is_packed && width(type) > width(type_) ? end : unpacked(end);
}

double NetcdfVariable::slack() const { return is_integer() ? std::abs(scale_) / 4 : 0; }

std::optional<double> NetcdfVariable::default_fill() const {
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

std::size_t NetcdfVariable::width(int type) const {
  std::size_t bytes = 0;
  nc_inq_type(file_, type, nullptr, &bytes);
  return bytes;
}

MissingSamples::MissingSamples(const NetcdfVariable& variable) : slack_(variable.slack()) {
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

bool MissingSamples::operator()(double value) const {
  if (value < least_ - slack_ || value > most_ + slack_) return true;
  return std::ranges::any_of(fills_, [&](double fill) { return std::abs(value - fill) <= slack_; });
}

void MissingSamples::add_fills(const NetcdfVariable& variable) {
  fills_ = variable.numbers("_FillValue");
  if (fills_.empty())
    if (const auto fill = variable.default_fill()) fills_.push_back(*fill);
  for (const double value : variable.numbers("missing_value")) fills_.push_back(value);
  for (double& fill : fills_) fill = variable.unpacked(fill);
}

void MissingSamples::narrow(double a, double b) {
  least_ = std::max(least_, std::min(a, b));
  most_ = std::min(most_, std::max(a, b));
}

void sign_bytes(const NetcdfVariable& variable, const char* name, vtkDataSetAttributes& arrays) {
  vtkDataArray* const array = arrays.GetArray(name);
  if (!array || !variable.is_byte()) return;
  if (array->GetDataType() == VTK_UNSIGNED_CHAR) {
    vtkNew<vtkSignedCharArray> numbers;
    numbers->SetName(name);
    numbers->SetNumberOfTuples(array->GetNumberOfTuples());
    std::memcpy(numbers->GetVoidPointer(0), array->GetVoidPointer(0),
                std::size_t(array->GetNumberOfValues()));
    arrays.AddArray(numbers);  // in the place of the one of its name
  } else if (array->GetDataType() == VTK_DOUBLE) {
    const double zero = variable.unpacked(0), one = variable.unpacked(1) - zero;
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
      if (const double value = array->GetComponent(i, 0); (value - zero) / one > 127.5)
        array->SetComponent(i, 0, value - 256 * one);
  }
}

void hide_missing(const MissingSamples& is_missing, const char* name,
                  vtkDataSetAttributes& arrays) {
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

}  // namespace pellucid::readers
