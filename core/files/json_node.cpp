// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/json_node.h"

#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/files/json_text.h"
#include "core/options/names.h"

namespace pellucid {

JsonNode::JsonNode(std::string file, const nlohmann::json& root)
    : file_(std::move(file)), value_(&root) {}

JsonNode::JsonNode(std::string file, std::string place, const nlohmann::json& value)
    : file_(std::move(file)), place_(std::move(place)), value_(&value) {}

void JsonNode::fail(const std::string& what) const {
  throw InputError(fmt::format("{}: {}{}{}", file_, place_, place_.empty() ? "" : ": ", what));
}

void JsonNode::refuse(std::string_view accepted) const {
  // A long value would hide the message.
  fail(fmt::format("{}; accepted: {}", one_line(json_text(*value_), 60), accepted));
}

bool JsonNode::is_string() const { return value_->is_string(); }
bool JsonNode::is_object() const { return value_->is_object(); }
bool JsonNode::is_array() const { return value_->is_array(); }

void JsonNode::accept_keys(std::span<const std::string_view> known) const {
  if (!value_->is_object())
    refuse(fmt::format("an object with the keys {}", fmt::join(known, ", ")));
  for (const auto& item : value_->items())
    if (std::find(known.begin(), known.end(), item.key()) == known.end())
      fail(unknown_name("key", item.key(), known));
}

void JsonNode::accept_keys(std::initializer_list<std::string_view> known) const {
  accept_keys(std::span(known.begin(), known.size()));
}

bool JsonNode::has(std::string_view key) const {
  return value_->is_object() && value_->contains(std::string(key));
}

JsonNode JsonNode::operator[](std::string_view key) const {
  if (!has(key)) fail(fmt::format("the key '{}' is missing", key));
  const std::string place = place_.empty() ? std::string(key) : fmt::format("{}.{}", place_, key);
  return {file_, place, value_->at(std::string(key))};
}

std::vector<JsonNode> JsonNode::elements() const {
  if (!value_->is_array()) refuse("an array");
  std::vector<JsonNode> nodes;
  for (std::size_t i = 0; i < value_->size(); ++i)
    nodes.push_back({file_, fmt::format("{}[{}]", place_, i), (*value_)[i]});
  return nodes;
}

std::vector<std::string> JsonNode::keys() const {
  if (!value_->is_object()) refuse("an object");
  std::vector<std::string> names;
  for (const auto& item : value_->items()) names.push_back(item.key());
  return names;
}

double JsonNode::number(double min, double max) const {
  const bool valid = value_->is_number() && value_->get<double>() >= min &&
                     value_->get<double>() <= max && std::isfinite(value_->get<double>());
  if (valid) return value_->get<double>();
  if (std::isfinite(min) && std::isfinite(max)) refuse(fmt::format("{} … {}", min, max));
  if (std::isfinite(min)) refuse(fmt::format("a number ≥ {}", min));
  refuse("a finite number");
}

int JsonNode::integer(int min, int max) const {
  const bool valid = value_->is_number_integer() && value_->get<std::int64_t>() >= min &&
                     value_->get<std::int64_t>() <= max;
  if (!valid) refuse(fmt::format("an integer, {} … {}", min, max));
  return value_->get<int>();
}

std::uint64_t JsonNode::whole(double max) const {
  const double value = number(0, max);
  if (value != std::floor(value)) refuse("a whole number");
  return std::uint64_t(value);
}

bool JsonNode::boolean() const {
  if (!value_->is_boolean()) refuse("true or false");
  return value_->get<bool>();
}

std::string JsonNode::string() const {
  if (!value_->is_string()) refuse("a string");
  return value_->get<std::string>();
}

std::string JsonNode::one_of(std::initializer_list<std::string_view> accepted) const {
  return one_of(std::span(accepted.begin(), accepted.size()));
}

std::string JsonNode::one_of(std::span<const std::string_view> accepted) const {
  if (value_->is_string())
    for (const std::string_view word : accepted)
      if (value_->get_ref<const std::string&>() == word) return std::string(word);
  refuse(fmt::format("{}", fmt::join(accepted, ", ")));
}

Vec3 JsonNode::vec3() const {
  if (!value_->is_array() || value_->size() != 3) refuse("three numbers");
  constexpr double any = std::numeric_limits<double>::max();
  const auto parts = elements();
  return {parts[0].number(-any, any), parts[1].number(-any, any), parts[2].number(-any, any)};
}

}  // namespace pellucid
