// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files/gltf/gltf_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "core/error.h"
#include "core/files/json_text.h"
#include "core/files/output_file.h"
#include "geometry/files/gltf/gltf_extensions.h"

namespace pellucid::geometry {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are read as they lie");

template <class T>
T number_at(std::string_view bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

/// A component's type: its size, and how its numbers are read.
struct ComponentType {
  int code;
  std::size_t size;
  double (*read)(const char*);
  double one;  // what stands for 1 when it is normalized
};

template <class T>
double read(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return double(value);
}

constexpr ComponentType component_types[] = {
    {5120, 1, read<std::int8_t>, 127},    {5121, 1, read<std::uint8_t>, 255},
    {5122, 2, read<std::int16_t>, 32767}, {5123, 2, read<std::uint16_t>, 65535},
    {5125, 4, read<std::uint32_t>, 1},    {5126, 4, read<float>, 1}};

const ComponentType* component_type(std::size_t code) {
  const auto found = std::ranges::find(
      component_types, code, [](const ComponentType& type) { return std::size_t(type.code); });
  return found == std::end(component_types) ? nullptr : found;
}

int components_of(const std::string& type) {
  if (type == "SCALAR") return 1;
  if (type == "VEC2") return 2;
  if (type == "VEC3") return 3;
  return type == "VEC4" ? 4 : 0;
}

int base64_digit(char c) {
  static constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t place = digits.find(c);
  return place == digits.npos ? -1 : int(place);
}

/// Up to the first character that is no digit.
std::string decoded_base64(std::string_view text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const int digit = base64_digit(c);
    if (digit < 0) break;
    bits = bits << 6 | std::uint32_t(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += char(bits >> count & 255);
  }
  return bytes;
}

int hexadecimal_digit(char c) {
  const std::size_t place = std::string_view("0123456789abcdef0123456789ABCDEF").find(c);
  return place == std::string_view::npos ? -1 : int(place % 16);
}

/// "a%20b" is "a b"; what only looks like such a code stays.
std::string decoded_percents(std::string_view text) {
  std::string decoded;
  for (; !text.empty(); text.remove_prefix(1)) {
    const int high = text[0] == '%' && text.size() > 2 ? hexadecimal_digit(text[1]) : -1;
    const int low = high >= 0 ? hexadecimal_digit(text[2]) : -1;
    decoded += low >= 0 ? char(high * 16 + low) : text[0];
    if (low >= 0) text.remove_prefix(2);
  }
  return decoded;
}

const nlohmann::json& none() {
  static const nlohmann::json null;
  return null;
}

const nlohmann::json& member(const nlohmann::json& object, const char* key) {
  if (!object.is_object()) return none();
  const auto found = object.find(key);
  return found == object.end() ? none() : *found;
}

}  // namespace

GltfDocument::GltfDocument(const std::filesystem::path& path) : path_(path) {
  std::string content = read_text(path);
  if (content.starts_with("glTF"))
    read_glb(content);
  else
    root_ = parse_json(path.string(), content);
  check();
}

void GltfDocument::fail(const std::string& what) const {
  throw InputError(fmt::format("{}: {}", path_.string(), what));
}

/// A header of 12 bytes; then chunks: length, type, and the bytes of JSON, then of the buffer.
void GltfDocument::read_glb(std::string_view content) {
  constexpr std::uint32_t json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
  bool has_json = false;
  for (std::size_t at = 12; at + 8 <= content.size();) {
    const auto length = number_at<std::uint32_t>(content, at);
    const auto type = number_at<std::uint32_t>(content, at + 4);
    at += 8;
    if (length > content.size() - at) fail("a chunk is longer than the file: truncated?");
    const std::string_view chunk = content.substr(at, length);
    if (type == json_chunk && !has_json) root_ = parse_json(path_.string(), chunk);
    has_json = has_json || type == json_chunk;
    if (type == binary_chunk && binary_.empty()) binary_ = chunk;
    at += length;
  }
  if (!has_json) fail("no chunk of JSON: truncated?");
}

void GltfDocument::check() const {
  const nlohmann::json& version = member(member(root_, "asset"), "version");
  if (!version.is_string() || !version.get<std::string>().starts_with("2"))
    fail("asset.version: accepted: 2.0");
  const nlohmann::json& least = member(member(root_, "asset"), "minVersion");
  if (!least.is_null() && least != "2.0")
    fail(fmt::format("asset.minVersion: {}; accepted: 2.0", least.dump()));
  for (const nlohmann::json& name : member(root_, "extensionsRequired"))
    if (const std::string refusal =
            gltf_extension_refusal(name.is_string() ? name.get<std::string>() : name.dump());
        !refusal.empty())
      fail(refusal);
}

const nlohmann::json& GltfDocument::element(const char* list, const nlohmann::json& index) const {
  const nlohmann::json& all = member(root_, list);
  if (!index.is_number_integer() || index < 0 || !all.is_array() ||
      index.get<std::uint64_t>() >= all.size() || !all[index.get<std::size_t>()].is_object())
    fail(fmt::format("{}[{}]: there is none", list, index.dump()));
  return all[index.get<std::size_t>()];
}

std::size_t GltfDocument::whole(const nlohmann::json& object, const char* key,
                                std::size_t otherwise) const {
  const nlohmann::json& value = member(object, key);
  if (value.is_null()) return otherwise;
  // Beyond 2^53 no file has bytes.
  if (!value.is_number_integer() || value < 0 || value > (std::int64_t(1) << 53))
    fail(fmt::format("{}: {}; accepted: a whole number, at least 0", key, value.dump()));
  return value.get<std::size_t>();
}

std::string_view GltfDocument::buffer(const nlohmann::json& index) {
  const nlohmann::json& object = element("buffers", index);
  const auto number = index.get<std::size_t>();
  const nlohmann::json& uri = member(object, "uri");
  if (uri.is_null()) return binary_;
  if (!uri.is_string()) fail(fmt::format("buffers[{}].uri: accepted: a text", number));
  buffers_.resize(std::max(buffers_.size(), number + 1));
  std::string& bytes = buffers_[number];
  if (!bytes.empty()) return bytes;
  const std::string text = uri.get<std::string>();
  const std::size_t comma = text.find(";base64,");
  if (text.starts_with("data:") && comma != text.npos)
    bytes = decoded_base64(std::string_view(text).substr(comma + 8));
  else
    try {
      bytes = read_text(path_.parent_path() / decoded_percents(text));
    } catch (const InputError& error) {
      fail(fmt::format("buffers[{}].uri: {}", number, error.what()));
    }
  return bytes;
}

std::string_view GltfDocument::view(const nlohmann::json& index, std::size_t& stride) {
  const nlohmann::json& object = element("bufferViews", index);
  const std::string_view bytes = buffer(member(object, "buffer"));
  const std::size_t offset = whole(object, "byteOffset", 0);
  const std::size_t length = whole(object, "byteLength", 0);
  if (offset > bytes.size() || length > bytes.size() - offset)
    fail(fmt::format("bufferViews[{}]: bytes {} to {} of a buffer of {}", index.dump(), offset,
                     offset + length, bytes.size()));
  stride = whole(object, "byteStride", stride);
  return bytes.substr(offset, length);
}

/// Zeros where there is no view: an accessor may then be sparse, or stand for nothing.
void GltfDocument::read_dense(const nlohmann::json& object, const Layout& layout,
                              AccessorData& data) {
  const std::size_t numbers = layout.count * std::size_t(data.components);
  if (member(object, "bufferView").is_null()) {
    constexpr std::size_t most = std::size_t(1) << 22;  // which no byte of a file answers for
    if (layout.count > most)
      fail(fmt::format("{}: {} tuples of zeros; accepted: {}", layout.place, layout.count, most));
    data.numbers.assign(numbers, 0.0);
    return;
  }
  data.numbers = read_numbers(object, layout);
}

std::vector<double> GltfDocument::read_numbers(const nlohmann::json& object, const Layout& layout) {
  const ComponentType* const type = component_type(layout.component_code);
  if (!type) fail(layout.place + ": accepted: the six types of components");
  const std::size_t count = layout.count, each = type->size * layout.components;
  std::size_t stride = each;
  const std::string_view bytes = view(member(object, "bufferView"), stride);
  const std::size_t first = whole(object, "byteOffset", 0);
  const bool fits = count == 0 || (stride >= each && first + each <= bytes.size() &&
                                   (count - 1) <= (bytes.size() - first - each) / stride);
  if (!fits)
    fail(fmt::format("{}: {} × {} bytes, but its view has {}", layout.place, count, each,
                     bytes.size()));
  std::vector<double> numbers;
  numbers.reserve(count * layout.components);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < layout.components; ++c) {
      const double value = type->read(bytes.data() + first + i * stride + c * type->size);
      numbers.push_back(layout.normalized ? std::max(value / type->one, -1.0) : value);
    }
  return numbers;
}

/// Puts other tuples in the place of some.
void GltfDocument::read_sparse(const nlohmann::json& sparse, const Layout& layout,
                               AccessorData& data) {
  const nlohmann::json &where = member(sparse, "indices"), &what = member(sparse, "values");
  Layout of_indices{layout.place + ".sparse.indices", whole(where, "componentType", 0), 1,
                    whole(sparse, "count", 0), false};
  Layout of_values = layout;
  of_values.place += ".sparse.values";
  of_values.count = of_indices.count;
  const std::vector<double> indices = read_numbers(where, of_indices);
  const std::vector<double> values = read_numbers(what, of_values);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (!(indices[i] >= 0 && indices[i] < double(layout.count)) ||
        indices[i] != std::floor(indices[i]))
      fail(fmt::format("{}: {} of {} tuples", of_indices.place, indices[i], layout.count));
    std::copy_n(values.begin() + std::ptrdiff_t(i * layout.components), layout.components,
                data.numbers.begin() + std::ptrdiff_t(std::size_t(indices[i]) * layout.components));
  }
}

AccessorData GltfDocument::accessor(const nlohmann::json& index) {
  const nlohmann::json& object = element("accessors", index);
  const nlohmann::json& type = member(object, "type");
  AccessorData data;
  data.components = type.is_string() ? components_of(type.get<std::string>()) : 0;
  data.count = whole(object, "count", 0);
  const Layout layout{fmt::format("accessors[{}]", index.dump()), whole(object, "componentType", 0),
                      std::size_t(data.components), data.count,
                      member(object, "normalized") == true};
  if (data.components == 0 || !component_type(layout.component_code))
    fail(layout.place + ": accepted: SCALAR to VEC4 of the six types of components");
  read_dense(object, layout, data);
  if (const nlohmann::json& sparse = member(object, "sparse"); !sparse.is_null())
    read_sparse(sparse, layout, data);
  return data;
}

}  // namespace pellucid::geometry
