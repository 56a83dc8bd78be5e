// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vdb/vdb_precheck.h"

#include <fmt/format.h>
#include <openvdb/version.h>

#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

#include "core/error.h"

namespace pellucid::readers {
namespace {

constexpr std::uint32_t oldest_version = 222;  // of the file format: selective compression

/// Reads numbers and texts, and never beyond the end of the file.
class Walker {
 public:
  explicit Walker(const std::filesystem::path& path)
      : path_(path), file_(path, std::ios::binary), size_(std::filesystem::file_size(path)) {}

  [[noreturn]] void fail(std::string_view why) const {
    throw InputError(fmt::format("{}: not a valid .vdb file: {}", path_.string(), why));
  }

  std::uint64_t place() { return std::uint64_t(file_.tellg()); }
  void go_to(std::uint64_t place) {
    if (place > size_) fail(fmt::format("a grid at byte {} of {}", place, size_));
    file_.seekg(std::streamoff(place));
  }
  void skip(std::uint64_t length) {
    if (length > size_ - place()) fail("it ends too early, or a length in it is wrong");
    file_.seekg(std::streamoff(length), std::ios::cur);
  }

  template <class T>
  T number() {
    T value{};
    if (!file_.read(reinterpret_cast<char*>(&value), sizeof value)) fail("it ends too early");
    return value;
  }

  std::string text() {
    const auto length = number<std::uint32_t>();
    if (length > size_ - place()) fail(fmt::format("a text of {} characters", length));
    std::string value(length, '\0');
    if (length > 0 && !file_.read(value.data(), std::streamsize(length))) fail("it ends too early");
    return value;
  }

  /// MetaMap: a count, then name, type, size and bytes of each.
  void metadata() {
    const auto count = number<std::uint32_t>();
    for (std::uint32_t i = 0; i < count; ++i) {
      text();
      const std::string type = text();
      const std::uint64_t begin = place();
      const auto length = number<std::uint32_t>();
      skip(length);
      if (const std::uint32_t expected = size_of(type); expected > 0 && expected != length)
        fail(fmt::format("{} bytes of metadata of type {} at byte {}", length, type, begin));
    }
  }

 private:
  /// Of types whose size does not vary; 0 otherwise.
  static std::uint32_t size_of(std::string_view type) {
    if (type == "bool") return 1;
    if (type == "int32" || type == "float") return 4;
    if (type == "int64" || type == "double") return 8;
    if (type == "vec3i" || type == "vec3s") return 12;
    if (type == "vec3d") return 24;
    return 0;
  }

  std::filesystem::path path_;
  std::ifstream file_;
  std::uint64_t size_;
};

struct Descriptor {
  std::uint64_t grid, end;
};

Descriptor descriptor(Walker& walk) {
  walk.text();  // name
  walk.text();  // type
  walk.text();  // of the instance's parent
  Descriptor result;
  result.grid = walk.number<std::uint64_t>();
  walk.number<std::uint64_t>();  // where its values begin
  result.end = walk.number<std::uint64_t>();
  return result;
}

}  // namespace

void precheck_vdb(const std::filesystem::path& path) {
  Walker walk(path);
  if (walk.number<std::uint64_t>() != 0x56444220) walk.fail("it does not begin with VDB's mark");
  const auto version = walk.number<std::uint32_t>();
  if (version < oldest_version || version > openvdb::OPENVDB_FILE_VERSION)
    walk.fail(fmt::format("format version {}; accepted: {} to {}", version, oldest_version,
                          std::uint32_t(openvdb::OPENVDB_FILE_VERSION)));
  walk.skip(2 * sizeof(std::uint32_t));  // version of the library
  if (walk.number<std::uint8_t>() != 1) walk.fail("its grids cannot be found");
  walk.skip(36);  // the file's identity
  walk.metadata();
  const auto count = walk.number<std::uint32_t>();
  for (std::uint32_t i = 0; i < count; ++i) {
    const Descriptor grid = descriptor(walk);
    walk.go_to(grid.grid);
    walk.skip(sizeof(std::uint32_t));  // compression
    walk.metadata();
    walk.text();  // type of the transform
    walk.go_to(grid.end);
  }
}

}  // namespace pellucid::readers
