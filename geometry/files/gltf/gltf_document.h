// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// glTF 2.0 (Khronos, ISO/IEC 12113): the document, and the numbers that its accessors name. Debian
// packages no small reader: VTK's knows no colours of three floats and no attributes of one's own.

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace pellucid::geometry {

/// An AccessorData is what an accessor names: `count` tuples of `components` numbers. Integers that
/// the document calls normalized are in [0, 1] or [-1, 1].
struct AccessorData {
  int components = 1;
  std::size_t count = 0;
  std::vector<double> numbers;

  double at(std::size_t tuple, int component) const {
    return numbers[tuple * std::size_t(components) + std::size_t(component)];
  }
};

/// A GltfDocument is a .gltf file with the buffers it names, or a .glb file.
class GltfDocument {
 public:
  /// Reads the document; buffers beside it or within it are read when an accessor asks for them.
  /// Throws InputError for what is no glTF of version 2, or needs an extension that is not
  /// known.
  explicit GltfDocument(const std::filesystem::path& path);

  /// Returns the element of a list: "meshes", "nodes", …. Throws InputError when there is none.
  const nlohmann::json& element(const char* list, const nlohmann::json& index) const;
  /// Returns what an accessor names.
  AccessorData accessor(const nlohmann::json& index);
  const nlohmann::json& root() const { return root_; }
  /// Returns the numbers of an array, all finite since JSON has no others; nothing when the object
  /// has none. Throws InputError when there are not N.
  template <int N>
  std::optional<std::array<double, N>> numbers(const nlohmann::json& object, const char* key) const;

  /// Throws InputError "FILE: `what`".
  [[noreturn]] void fail(const std::string& what) const;

 private:
  /// How an accessor's numbers lie in a view, and its name for messages.
  struct Layout {
    std::string place;
    std::size_t component_code, components, count;
    bool normalized;
  };

  void read_glb(std::string_view content);
  void check() const;
  std::string_view buffer(const nlohmann::json& index);
  std::string_view view(const nlohmann::json& index, std::size_t& stride);
  void read_dense(const nlohmann::json& object, const Layout& layout, AccessorData& data);
  void read_sparse(const nlohmann::json& sparse, const Layout& layout, AccessorData& data);
  std::vector<double> read_numbers(const nlohmann::json& object, const Layout& layout);
  std::size_t whole(const nlohmann::json& object, const char* key, std::size_t otherwise) const;

  std::filesystem::path path_;
  nlohmann::json root_;
  std::string binary_;                // of a .glb
  std::vector<std::string> buffers_;  // empty until asked for
};

template <int N>
std::optional<std::array<double, N>> GltfDocument::numbers(const nlohmann::json& object,
                                                           const char* key) const {
  const auto found = object.find(key);
  if (found == object.end()) return std::nullopt;
  std::array<double, N> numbers{};
  bool fits = found->is_array() && found->size() == N;
  for (std::size_t i = 0; fits && i < N; ++i) {
    fits = (*found)[i].is_number();
    if (fits) numbers[i] = (*found)[i];
  }
  if (!fits) fail(std::string(key) + ": accepted: " + std::to_string(N) + " numbers");
  return numbers;
}

}  // namespace pellucid::geometry
