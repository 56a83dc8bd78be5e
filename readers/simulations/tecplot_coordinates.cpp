// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/simulations/tecplot_coordinates.h"

#include <fmt/format.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>

#include <array>
#include <cctype>
#include <string_view>

namespace pellucid::readers {
namespace {

constexpr std::string_view letters = "XYZ";

/// Which variable each coordinate is; -1 for none.
using Coordinates = std::array<int, 3>;

std::string trimmed(const std::string& name) {
  const auto first = name.find_first_not_of(" \t");
  return first == std::string::npos ? ""
                                    : name.substr(first, name.find_last_not_of(" \t") - first + 1);
}

bool is_letter(char c, std::size_t axis) {
  return std::toupper(static_cast<unsigned char>(c)) == letters[axis];
}

/// "X", "x", "CoordinateX".
bool is_coordinate(const std::string& name, std::size_t axis) {
  return (name.size() == 1 && is_letter(name[0], axis)) ||
         name == fmt::format("Coordinate{}", letters[axis]);
}

/// "X [m]", "x(m)", "X, m".
bool is_with_unit(const std::string& name, std::size_t axis) {
  const auto next = name.find_first_not_of(' ', 1);
  return name.size() > 1 && is_letter(name[0], axis) && next != std::string::npos &&
         std::string_view("[(,").find(name[next]) != std::string_view::npos;
}

/// By their names: the first that is a coordinate's, or else one with a unit.
Coordinates meant(std::span<const std::string> variables) {
  Coordinates found{-1, -1, -1};
  for (const auto is_meant : {is_coordinate, is_with_unit})
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t v = 0; v < variables.size() && found[axis] < 0; ++v)
        if (is_meant(trimmed(variables[v]), axis)) found[axis] = int(v);
  return found;
}

/// As vtkTecplotReader's GetCoord() and GuessCoord() have it: the last of a name, I, J and K among
/// them, or else the last that goes on after the letter with what is neither a blank nor a letter.
Coordinates taken(std::span<const std::string> variables) {
  constexpr std::string_view grid_letters = "IJK";
  Coordinates exact{-1, -1, -1}, guessed{-1, -1, -1};
  for (std::size_t v = 0; v < variables.size(); ++v) {
    const std::string name = trimmed(variables[v]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (is_coordinate(name, axis) || name == grid_letters.substr(axis, 1)) exact[axis] = int(v);
      const bool is_one = name.size() >= 3 && !std::isspace(static_cast<unsigned char>(name[1])) &&
                          !std::isalnum(static_cast<unsigned char>(name[1]));
      if (is_one && (is_letter(name[0], axis) || name[0] == grid_letters[axis]))
        guessed[axis] = int(v);
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (exact[axis] < 0) exact[axis] = guessed[axis];
  return exact;
}

/// Of all points along an axis.
vtkSmartPointer<vtkFloatArray> coordinates(vtkPointSet& data, int axis, const std::string& name) {
  const auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfTuples(data.GetNumberOfPoints());
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i)
    array->SetValue(i, float(data.GetPoint(i)[axis]));
  return array;
}

void set_coordinates(vtkPointSet& data, int axis, vtkDataArray* values) {
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i)
    data.GetPoints()->GetData()->SetComponent(i, axis, values ? values->GetComponent(i, 0) : 0);
  data.GetPoints()->Modified();
}

}  // namespace

void place_points(vtkPointSet& data, std::span<const std::string> variables) {
  const Coordinates wanted = meant(variables), vtk = taken(variables);
  vtkPointData& arrays = *data.GetPointData();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (wanted[axis] == vtk[axis]) continue;
    vtkSmartPointer<vtkDataArray> right, wrong;
    if (wanted[axis] >= 0) {
      right = arrays.GetArray(variables[std::size_t(wanted[axis])].c_str());
      if (!right) continue;  // another version of VTK, which takes it
    }
    if (vtk[axis] >= 0) wrong = coordinates(data, int(axis), variables[std::size_t(vtk[axis])]);
    set_coordinates(data, int(axis), right);
    if (right) arrays.RemoveArray(right->GetName());
    if (wrong && !arrays.HasArray(wrong->GetName())) arrays.AddArray(wrong);
  }
}

}  // namespace pellucid::readers
