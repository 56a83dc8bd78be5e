// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The options of an algorithm are a struct with their defaults, in units that its comments name. A
// table binds the names that a user types to the struct's members; the defaults that are printed
// come from the struct itself:
//
//   struct BinningOptions {
//     int bins = 7;                     // per pixel
//     BinMode mode = BinMode::linear;   // between the edges of a bin
//   };
//
//   const OptionTable<BinningOptions>& binning_options() {
//     static const OptionTable<BinningOptions> table{
//         number("bins", &BinningOptions::bins, {.min = 1, .max = 256, .unit = "bins"}),
//         choice("mode", &BinningOptions::mode,
//                {{"linear", BinMode::linear}, {"constant", BinMode::constant}})};
//     return table;
//   }

#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/options/parameters.h"

namespace pellucid {

/// An OptionText holds the inclusive bounds of a number, its unit, and one line of help.
struct OptionText {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  std::string_view unit = {};
  std::string_view help = {};
  bool whole = false;  // a real member that only takes whole numbers
};

/// Returns the shortest text that reads back as the same number: "0.0001", "1e-6", "20000000".
std::string number_text(double value);

/// An Option is one row of a table: it binds a name to a member of `Options`. The views of `spec`
/// point into `texts`.
template <class Options>
struct Option {
  /// Texts own what the specification's views show.
  struct Texts {
    std::string default_value, choices, help;
  };

  ParameterSpec spec;
  std::shared_ptr<const Texts> texts;
  /// Stores a text that fits the specification into the struct.
  std::function<void(Options&, const std::string&)> store;
};

namespace option_detail {

/// ValueOf<T>::type is T, or what a std::optional T holds.
template <class T>
struct ValueOf {
  using type = T;
};
/// ValueOf of a std::optional is the type of its value.
template <class T>
struct ValueOf<std::optional<T>> {
  using type = T;
};

/// Makes a row that owns its default and its choices.
template <class Options>
Option<Options> make(ParameterSpec spec, std::string default_value, std::string choices,
                     std::function<void(Options&, const std::string&)> store) {
  auto texts =
      std::make_shared<const typename Option<Options>::Texts>(typename Option<Options>::Texts{
          std::move(default_value), std::move(choices), std::string(spec.help)});
  spec.default_value = texts->default_value;
  spec.choices = texts->choices;
  spec.help = texts->help;
  return {spec, std::move(texts), std::move(store)};
}

/// Appends a name to "a|b".
inline void add_choice(std::string& names, std::string_view name) {
  if (!names.empty()) names += '|';
  names += name;
}

/// Returns the text of a number that is a default; empty for a std::optional without a value.
///@{
template <class T>
std::string default_text(const T& value) {
  return number_text(double(value));
}
template <class T>
std::string default_text(const std::optional<T>& value) {
  return value ? default_text(*value) : "";
}
///@}

}  // namespace option_detail

/// Makes the row of an integer or a real number, as the member's type has it. A std::optional
/// member is not set by default.
template <class Options, class T>
Option<Options> number(std::string_view name, T Options::*member, const OptionText& text) {
  using Value = typename option_detail::ValueOf<T>::type;
  using Kind = ParameterSpec::Kind;
  const ParameterSpec spec{
      .name = name,
      .kind = std::is_integral_v<Value> || text.whole ? Kind::integer : Kind::real,
      .min = text.min,
      .max = text.max,
      .unit = text.unit,
      .help = text.help};
  return option_detail::make<Options>(spec, option_detail::default_text(Options{}.*member), "",
                                      [member](Options& options, const std::string& given) {
                                        double value = 0;
                                        parse_number(given, value);
                                        options.*member = Value(value);
                                      });
}

/// Makes the row of a flag, which is "on" or "off".
template <class Options>
Option<Options> flag(std::string_view name, bool Options::*member, std::string_view help = {}) {
  const ParameterSpec spec{.name = name, .kind = ParameterSpec::Kind::flag, .help = help};
  return option_detail::make<Options>(
      spec, Options{}.*member ? "on" : "off", "on|off",
      [member](Options& options, const std::string& given) { options.*member = given == "on"; });
}

/// Makes the row of a text, which may be any.
template <class Options>
Option<Options> text(std::string_view name, std::string Options::*member,
                     std::string_view help = {}) {
  const ParameterSpec spec{.name = name, .kind = ParameterSpec::Kind::text, .help = help};
  return option_detail::make<Options>(
      spec, Options{}.*member, "",
      [member](Options& options, const std::string& given) { options.*member = given; });
}

/// Makes the row of a file's path.
template <class Options>
Option<Options> file(std::string_view name, std::string Options::*member,
                     std::string_view help = {}) {
  const ParameterSpec spec{.name = name, .kind = ParameterSpec::Kind::file, .help = help};
  return option_detail::make<Options>(
      spec, Options{}.*member, "",
      [member](Options& options, const std::string& given) { options.*member = given; });
}

/// Makes the row of a member of any type, by its own way to write and to read it; `read` throws
/// InputError for what it does not accept.
template <class Options, class T>
Option<Options> written(std::string_view name, T Options::*member,
                        std::string (*write)(const std::type_identity_t<T>&),
                        T (*read)(const std::string&), std::string_view help = {},
                        std::string_view unit = {}) {
  const ParameterSpec spec{
      .name = name, .kind = ParameterSpec::Kind::text, .unit = unit, .help = help};
  return option_detail::make<Options>(spec, write(Options{}.*member), "",
                                      [member, read](Options& options, const std::string& given) {
                                        options.*member = read(given);
                                      });
}

/// Makes the row of a choice among a few values, each with its name; a std::optional member is not
/// set by default.
template <class Options, class T>
Option<Options> choice(
    std::string_view name, T Options::*member,
    std::initializer_list<
        std::pair<std::string_view, std::type_identity_t<typename option_detail::ValueOf<T>::type>>>
        values,
    std::string_view help = {}, std::string_view unit = {}) {
  std::string names, default_name;
  const std::optional<typename option_detail::ValueOf<T>::type> initial = Options{}.*member;
  for (const auto& [value_name, value] : values) {
    option_detail::add_choice(names, value_name);
    if (initial && *initial == value) default_name = value_name;
  }
  const ParameterSpec spec{
      .name = name, .kind = ParameterSpec::Kind::choice, .unit = unit, .help = help};
  return option_detail::make<Options>(
      spec, default_name, names,
      [member, named = std::vector(values)](Options& options, const std::string& given) {
        for (const auto& [value_name, value] : named)
          if (value_name == given) options.*member = value;
      });
}

/// One of a table's rows, by its name; the rows live as long as the program.
template <class Options, class Row>
Option<Options> choice(std::string_view name, const Row* Options::*member,
                       std::type_identity_t<std::span<const Row>> rows,
                       std::string_view help = {}) {
  std::string names;
  for (const Row& row : rows) option_detail::add_choice(names, row.name);
  const ParameterSpec spec{.name = name, .kind = ParameterSpec::Kind::choice, .help = help};
  return option_detail::make<Options>(spec, std::string((Options{}.*member)->name), names,
                                      [member, rows](Options& options, const std::string& given) {
                                        for (const Row& row : rows)
                                          if (row.name == given) options.*member = &row;
                                      });
}

template <class Options>
class OptionTable;

/// Returns the rows of a struct that is a member of `Options`, under the same names.
template <class Options, class Part>
std::vector<Option<Options>> part(Part Options::*member, const OptionTable<Part>& table);

/// An OptionTable holds all options of an algorithm, in the order in which they are listed.
template <class Options>
class OptionTable {
 public:
  /// Rows are one option, or those of a part.
  struct Rows {
    Rows(Option<Options> row) : rows{std::move(row)} {}
    Rows(std::vector<Option<Options>> several) : rows(std::move(several)) {}
    std::vector<Option<Options>> rows;
  };

  OptionTable(std::initializer_list<Rows> groups) {
    for (const Rows& group : groups)
      for (const Option<Options>& row : group.rows) rows_.push_back(row);
    for (const Option<Options>& row : rows_) specs_.push_back(row.spec);
  }

  /// Returns what the command line, `list` and study files read. Valid as long as the table.
  std::span<const ParameterSpec> specs() const { return specs_; }
  std::span<const Option<Options>> rows() const { return rows_; }

  /// Returns the struct's defaults, changed by what `parameters` holds, which were checked against
  /// specs().
  Options read(const Parameters& parameters) const {
    Options options;
    for (const Option<Options>& row : rows_)
      if (parameters.is_set(row.spec.name)) row.store(options, parameters.text(row.spec.name));
    return options;
  }

 private:
  std::vector<Option<Options>> rows_;
  std::vector<ParameterSpec> specs_;
};

template <class Options, class Part>
std::vector<Option<Options>> part(Part Options::*member, const OptionTable<Part>& table) {
  std::vector<Option<Options>> rows;
  for (const Option<Part>& row : table.rows())
    rows.push_back(option_detail::make<Options>(
        row.spec, row.texts->default_value, row.texts->choices,
        [member, store = row.store](Options& options, const std::string& given) {
          store(options.*member, given);
        }));
  return rows;
}

}  // namespace pellucid
