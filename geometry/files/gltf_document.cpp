// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files/gltf_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "core/error.h"
#include "core/files/json_text.h"
#include "core/files/output_file.h"

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

/// Extensions without which triangles, lines and points come out as they are.
bool may_be_ignored(std::string_view extension) {
  return extension.starts_with("KHR_materials_") || extension.starts_with("KHR_texture_") ||
         extension.starts_with("KHR_lights_") || extension == "KHR_mesh_quantization";
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
  for (const nlohmann::json& name : member(root_, "extensionsRequired"))
    if (!name.is_string() || !may_be_ignored(name.get<std::string>()))
      fail(fmt::format("it needs the extension {}, which is not read; write it without compression",
                       name.dump()));
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
      bytes = read_text(path_.parent_path() / text);
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

AccessorData GltfDocument::accessor(const nlohmann::json& index) {
  const nlohmann::json& object = element("accessors", index);
  const std::string place = fmt::format("accessors[{}]", index.dump());
  const nlohmann::json& type = member(object, "type");
  AccessorData data;
  data.components = type.is_string() ? components_of(type.get<std::string>()) : 0;
  const auto component =
      std::ranges::find(component_types, whole(object, "componentType", 0),
                        [](const ComponentType& t) { return std::size_t(t.code); });
  if (data.components == 0 || component == std::end(component_types))
    fail(place + ": accepted: SCALAR to VEC4 of the six types of components");
  if (object.contains("sparse")) fail(place + ": sparse ones are not read");
  data.count = whole(object, "count", 0);
  const std::size_t each = component->size * std::size_t(data.components);
  std::size_t stride = each;
  const std::string_view bytes = view(member(object, "bufferView"), stride);
  const std::size_t first = whole(object, "byteOffset", 0);
  const bool fits = data.count == 0 || (stride >= each && first + each <= bytes.size() &&
                                        (data.count - 1) <= (bytes.size() - first - each) / stride);
  if (!fits)
    fail(fmt::format("{}: {} × {} bytes, but its view has {}", place, data.count, each,
                     bytes.size()));
  const bool normalized = member(object, "normalized") == true;
  data.numbers.reserve(data.count * std::size_t(data.components));
  for (std::size_t i = 0; i < data.count; ++i)
    for (std::size_t c = 0; c < std::size_t(data.components); ++c) {
      const double value = component->read(bytes.data() + first + i * stride + c * component->size);
      data.numbers.push_back(normalized ? std::max(value / component->one, -1.0) : value);
    }
  return data;
}

}  // namespace pellucid::geometry
