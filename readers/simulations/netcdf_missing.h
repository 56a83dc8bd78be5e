// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

class vtkDataSetAttributes;

namespace pellucid::readers {

/// A NetcdfVariable is one of an open NetCDF file: its type, and how its numbers are packed.
class NetcdfVariable {
 public:
  NetcdfVariable(int file, const char* name);

  /// Returns the numbers of an attribute; none where there is no such one, or of text.
  std::vector<double> numbers(const char* attribute) const;
  std::optional<double> number(const char* attribute) const;

  /// Returns why VTK cannot load it, "is of int64, which …"; "" where it can.
  std::string unread_by_vtk() const;
  bool is_number() const;
  bool is_integer() const;
  bool is_byte() const;  // with a sign

  /// Returns the number that VTK makes of one in the file, in its own arithmetic.
  double unpacked(double packed) const;
  /// Returns an end of the valid samples: of a wider type than the variable's it is unpacked
  /// already.
  double unpacked_end(const char* attribute, double end) const;
  /// Returns half of what lies between two numbers, at most: what rounding may do.
  double slack() const;

  /// Returns what NetCDF fills in where nothing was written; bytes it does not tell from such that
  /// were.
  std::optional<double> default_fill() const;

 private:
  std::size_t width(int type) const;

  int file_, id_ = -1;
  int type_ = 0;
  double scale_ = 1, offset_ = 0;
};

/// MissingSamples says of the samples that VTK leaves which ones are missing.
class MissingSamples {
 public:
  explicit MissingSamples(const NetcdfVariable& variable);
  bool operator()(double value) const;

 private:
  void add_fills(const NetcdfVariable& variable);
  void narrow(double a, double b);

  double slack_;
  double least_ = -std::numeric_limits<double>::infinity();
  double most_ = std::numeric_limits<double>::infinity();
  std::vector<double> fills_;
};

/// Gives the samples of a variable of bytes their sign, which VTK takes them without.
void sign_bytes(const NetcdfVariable& variable, const char* name, vtkDataSetAttributes& arrays);

/// Puts NaN where samples of an array are missing: integers that miss some become doubles.
void hide_missing(const MissingSamples& is_missing, const char* name, vtkDataSetAttributes& arrays);

}  // namespace pellucid::readers
