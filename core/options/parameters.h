// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace pellucid {

/// A ParameterSpec describes one parameter of a method, integrator or field: a row of a constexpr
/// table. `list`, the command line, study files and the report all read it.
struct ParameterSpec {
  /// Kind says which texts a parameter accepts; a flag is "on" or "off". A file is a path, which a
  /// study file has from its own folder on; a row with one does nothing without it.
  enum class Kind { integer, real, choice, flag, text, file };

  std::string_view name;
  Kind kind = Kind::real;
  std::string_view default_value = {};  // as written on the command line; empty: not set
  double min = -std::numeric_limits<double>::infinity();  // numbers: inclusive bounds
  double max = std::numeric_limits<double>::infinity();
  std::string_view unit = {};     // "world units", "1", "bands", …
  std::string_view choices = {};  // kind choice: "on|off"
  std::string_view help = {};     // one line

  /// Returns what it accepts, for messages: "1 … 15", "on|off", "any number", …
  std::string accepted() const;
};

/// RawOptions are options as they were written: name → text.
using RawOptions = std::map<std::string, std::string, std::less<>>;

/// A NameAndOptions is a text such as "fourier:bands=5", split but not yet checked.
struct NameAndOptions {
  std::string name;
  RawOptions options;
};

/// Splits "fourier:bands=5,clamp=0.99". Commas inside parentheses do not split, so that a value may
/// be a formula. Throws InputError for an option without "=", an empty name or a repeated key.
NameAndOptions parse_name_and_options(std::string_view text);

/// Parameters are values checked against their specifications; missing ones hold their default.
/// The accessors assert that a parameter of that name has a value.
class Parameters {
 public:
  Parameters() = default;

  /// Checks `options` against `specs`. Throws InputError for a key without a specification and for
  /// a value that does not fit it; names `owner`, the key, what was given and what is accepted.
  Parameters(std::string_view owner, std::span<const ParameterSpec> specs,
             const RawOptions& options);

  /// Returns the name of the row whose parameters they are: of a method, an integrator, a field.
  const std::string& owner() const { return owner_; }
  bool is_set(std::string_view name) const;  // by the caller or by a default
  double real(std::string_view name) const;
  int integer(std::string_view name) const;
  bool flag(std::string_view name) const;
  const std::string& text(std::string_view name) const;

  /// Says where the file of a parameter lies that was given by a path from elsewhere. given() keeps
  /// the path as it was given, and so do all_as_given() and what is named by them.
  void place_file(std::string_view name, std::string path);

  /// Returns what the caller gave, as "bands=5,clamp=0.99" in the order of the names; empty for
  /// defaults.
  std::string given() const;
  /// Returns the same by name.
  const RawOptions& given_options() const { return given_; }
  /// Returns every value by name, defaults included.
  const RawOptions& all() const { return values_; }
  /// Returns every value by name as the caller gave it: the same wherever the program runs.
  RawOptions all_as_given() const;

 private:
  std::string owner_;
  RawOptions values_;
  RawOptions given_;
};

/// Reads the whole of `text` as a number into `value`; returns false when it is not one.
bool parse_number(std::string_view text, double& value);

}  // namespace pellucid
