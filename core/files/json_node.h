// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/files/json_text.h"
#include "core/vec.h"

namespace pellucid {

/// A JsonNode is a value of a JSON file that knows its place, so that every complaint reads
/// "scene.json: objects[1].opacity: 1.5; accepted: 0 … 1". Accessors throw InputError for a value
/// of another type or out of bounds.
class JsonNode {
 public:
  /// Stands at the root of a file, which `file` names in messages. `root` has to outlive the node.
  JsonNode(std::string file, const nlohmann::json& root);

  const nlohmann::json& value() const { return *value_; }
  bool is_string() const;
  bool is_object() const;
  bool is_array() const;

  /// Throws InputError for a key that is not among `known`; it lists them, the nearest first.
  void accept_keys(std::span<const std::string_view> known) const;
  void accept_keys(std::initializer_list<std::string_view> known) const;
  bool has(std::string_view key) const;
  JsonNode operator[](std::string_view key) const;  // the key must be there
  std::vector<JsonNode> elements() const;           // of an array
  std::vector<std::string> keys() const;            // of an object

  double number(double min, double max) const;  // inclusive bounds
  int integer(int min, int max) const;
  std::uint64_t whole(double max) const;  // 0 to max, which is at most 2^53
  bool boolean() const;
  std::string string() const;
  std::string one_of(std::span<const std::string_view> accepted) const;
  std::string one_of(std::initializer_list<std::string_view> accepted) const;
  Vec3 vec3() const;

  /// Throws InputError "FILE: PLACE: `what`".
  [[noreturn]] void fail(const std::string& what) const;
  /// Returns where the value is in its file: "objects[1].opacity"; empty at the root.
  const std::string& place() const { return place_; }

 private:
  JsonNode(std::string file, std::string place, const nlohmann::json& value);
  [[noreturn]] void refuse(std::string_view accepted) const;

  std::string file_;
  std::string place_;
  const nlohmann::json* value_;
};

/// Runs `make` and puts the node's place in front of the InputError that it throws. Returns what
/// `make` does, references as references.
template <class Make>
decltype(auto) at_place(const JsonNode& node, const Make& make) {
  try {
    return make();
  } catch (const InputError& error) {
    node.fail(error.what());
  }
}

}  // namespace pellucid
