// SPDX-License-Identifier: GPL-3.0-or-later
// Tecplot 360 Data Format Guide 2013, Ch. 3, "Data Format": repeated values, variables by name.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>

#include "core/error.h"
#include "readers/simulations/simulation_checks.h"

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

/// "9*0", "1.5D-03".
bool is_fortran_number(const std::string& word) {
  const auto rest = word.find_first_not_of("0123456789", word.find_first_not_of("+-"));
  if (rest == std::string::npos || rest == 0 ||
      !std::isdigit(static_cast<unsigned char>(word[rest - 1])))
    return false;
  if (word[rest] == '*') return true;
  const auto letter = word.find_first_not_of("0123456789.", rest);
  return letter != std::string::npos && (word[letter] == 'D' || word[letter] == 'd') &&
         word.find_first_not_of("0123456789+-", letter + 1) == std::string::npos;
}

}  // namespace

void refuse_other_coordinates(std::span<const std::string> variables,
                              const std::filesystem::path& path) {
  const Coordinates wanted = meant(variables), vtk = taken(variables);
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (wanted[axis] != vtk[axis])
      throw InputError(fmt::format(
          "{}: VTK takes {} for the coordinate {}; accepted: the names X, Y, Z, and no variable "
          "I, J or K",
          path.string(), vtk[axis] < 0 ? "nothing" : "'" + variables[std::size_t(vtk[axis])] + "'",
          letters.substr(axis, 1)));
}

void refuse_fortran_numbers(const std::filesystem::path& path) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.find_first_of("*Dd") == std::string::npos || line.find('"') != std::string::npos)
      continue;
    std::ranges::replace(line, ',', ' ');
    for (std::size_t end = 0, begin;
         (begin = line.find_first_not_of(" \t\r", end)) != std::string::npos;) {
      if (line[begin] == '#') break;
      end = std::min(line.find_first_of(" \t\r", begin), line.size());
      if (const std::string word = line.substr(begin, end - begin); is_fortran_number(word))
        throw InputError(
            fmt::format("{}: the number {}, which VTK reads as another one; accepted: "
                        "each by itself, exponents after an E",
                        path.string(), word));
    }
  }
}

}  // namespace pellucid::readers
