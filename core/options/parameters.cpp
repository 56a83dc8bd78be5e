// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/options/parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <vector>

#include "core/error.h"
#include "core/options/names.h"
#include "core/options/split.h"

namespace pellucid {
namespace {

bool is_choice(std::string_view value, std::string_view choices) {
  return std::ranges::count(split(choices, '|'), value) > 0;
}

bool is_valid(const ParameterSpec& spec, std::string_view value) {
  double number = 0;
  switch (spec.kind) {
    case ParameterSpec::Kind::text:
    case ParameterSpec::Kind::file:
      return true;
    case ParameterSpec::Kind::flag:
      return value == "on" || value == "off";
    case ParameterSpec::Kind::choice:
      return is_choice(value, spec.choices);
    case ParameterSpec::Kind::integer:
      return parse_number(value, number) && number == std::floor(number) && number >= spec.min &&
             number <= spec.max;
    case ParameterSpec::Kind::real:
      return parse_number(value, number) && number >= spec.min && number <= spec.max;
  }
  return false;
}

std::string range(const ParameterSpec& spec, std::string_view what) {
  const bool has_min = std::isfinite(spec.min), has_max = std::isfinite(spec.max);
  if (has_min && has_max) return fmt::format("{} … {}", spec.min, spec.max);
  if (has_min) return fmt::format("{} ≥ {}", what, spec.min);
  if (has_max) return fmt::format("{} ≤ {}", what, spec.max);
  return fmt::format("any {}", what);
}

}  // namespace

bool parse_number(std::string_view text, double& value) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  return result.ec == std::errc() && result.ptr == text.data() + text.size();
}

std::string ParameterSpec::accepted() const {
  switch (kind) {
    case Kind::text:
      return "text";
    case Kind::file:
      return "a file";
    case Kind::flag:
      return "on|off";
    case Kind::choice:
      return std::string(choices);
    case Kind::integer:
      return range(*this, "integer");
    case Kind::real:
      return range(*this, "number");
  }
  return {};
}

NameAndOptions parse_name_and_options(std::string_view text) {
  NameAndOptions result;
  const std::size_t colon = std::min(text.find(':'), text.size());
  result.name = text.substr(0, colon);
  if (result.name.empty()) throw InputError(fmt::format("'{}': the name is empty", text));
  if (colon + 1 >= text.size()) return result;
  for (const std::string_view part : split_outside_parentheses(text.substr(colon + 1), ',')) {
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos || equals == 0)
      throw InputError(fmt::format("'{}': option '{}' is not of the form key=value", text, part));
    const std::string key(part.substr(0, equals));
    if (!result.options.emplace(key, part.substr(equals + 1)).second)
      throw InputError(fmt::format("'{}': option '{}' is given twice", text, key));
  }
  return result;
}

Parameters::Parameters(std::string_view owner, std::span<const ParameterSpec> specs,
                       const RawOptions& options)
    : owner_(owner), given_(options) {
  std::vector<std::string_view> known;
  for (const ParameterSpec& spec : specs) {
    known.push_back(spec.name);
    if (!spec.default_value.empty()) {
      assert(is_valid(spec, spec.default_value));
      values_.emplace(spec.name, spec.default_value);
    }
  }
  for (const auto& [key, value] : options) {
    const ParameterSpec* spec = nullptr;
    for (const ParameterSpec& candidate : specs)
      if (candidate.name == key) spec = &candidate;
    if (!spec && specs.empty())
      throw InputError(fmt::format("{}: unknown key '{}'; it takes no parameters", owner, key));
    if (!spec) throw InputError(fmt::format("{}: {}", owner, unknown_name("key", key, known)));
    if (!is_valid(*spec, value))
      throw InputError(fmt::format("{}: {}={}; accepted: {}", owner, key, value, spec->accepted()));
    values_[key] = value;
  }
}

bool Parameters::is_set(std::string_view name) const { return values_.find(name) != values_.end(); }

const std::string& Parameters::text(std::string_view name) const {
  const auto found = values_.find(name);
  assert(found != values_.end() && "asks for a parameter that its table does not have");
  return found->second;
}

double Parameters::real(std::string_view name) const {
  double value = 0;
  parse_number(text(name), value);
  return value;
}

int Parameters::integer(std::string_view name) const { return static_cast<int>(real(name)); }

bool Parameters::flag(std::string_view name) const { return text(name) == "on"; }

void Parameters::place_file(std::string_view name, std::string path) {
  const auto found = values_.find(name);
  assert(found != values_.end() && "places a file that was not given");
  found->second = std::move(path);
}

RawOptions Parameters::all_as_given() const {
  RawOptions all = values_;
  for (const auto& [key, value] : given_) all[key] = value;
  return all;
}

std::string Parameters::given() const {
  std::string joined;
  for (const auto& [key, value] : given_) {
    joined += fmt::format("{}{}={}", joined.empty() ? "" : ",", key, value);
  }
  return joined;
}

}  // namespace pellucid
