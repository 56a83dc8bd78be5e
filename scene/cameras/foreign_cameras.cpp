// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/cameras/foreign_cameras.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <vector>

#include "core/error.h"
#include "core/options/lower_case.h"
#include "geometry/files/gltf/gltf_cameras.h"
#include "scene/cameras/paraview_cameras.h"

namespace pellucid::scene {
namespace {

namespace fs = std::filesystem;

Camera camera_of(const geometry::GltfCamera& from) {
  Camera camera;
  camera.eye = from.eye;
  camera.target = from.eye + from.forward;
  camera.up = from.up;
  if (from.fov_degrees) camera.fov = *from.fov_degrees;
  if (from.height) {
    camera.projection = Projection::orthographic;
    camera.height = *from.height;
  }
  return camera;
}

std::vector<Camera> read_gltf(const fs::path& path) {
  std::vector<Camera> cameras;
  for (const geometry::GltfCamera& camera : geometry::read_gltf_cameras(path))
    cameras.push_back(camera_of(camera));
  return cameras;
}

struct FormatRow {
  std::string_view ending;
  std::vector<Camera> (*read)(const fs::path&);
};
constexpr FormatRow formats[] = {{".pvcc", read_paraview_cameras},
                                 {".pvsm", read_paraview_cameras},
                                 {".gltf", read_gltf},
                                 {".glb", read_gltf}};

const FormatRow* format_of(std::string_view path) {
  const std::string lower = lower_case(path);
  const auto row =
      std::ranges::find_if(formats, [&](const auto& each) { return lower.ends_with(each.ending); });
  return row == std::end(formats) ? nullptr : row;
}

}  // namespace

std::string foreign_camera_endings() {
  std::string endings;
  for (const FormatRow& row : formats)
    endings += (endings.empty() ? "" : ", ") + std::string(row.ending);
  return endings;
}

std::optional<ForeignCamera> foreign_camera(std::string_view text) {
  if (format_of(text)) return ForeignCamera{fs::path(text), std::nullopt};
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos || !format_of(text.substr(0, colon))) return std::nullopt;
  const std::string_view digits = text.substr(colon + 1);
  int number = 0;
  const auto [end, error] = std::from_chars(digits.begin(), digits.end(), number);
  if (error != std::errc() || end != digits.end() || number < 1)
    throw InputError(fmt::format("{}: '{}'; accepted: which camera of the file, 1, 2, …",
                                 text.substr(0, colon), digits));
  return ForeignCamera{fs::path(text.substr(0, colon)), number};
}

Camera read_foreign_camera(const ForeignCamera& from, const fs::path& base) {
  const fs::path path = base / from.file;
  const std::vector<Camera> cameras = format_of(path.string())->read(path);
  if (cameras.empty()) throw InputError(path.string() + ": it has no camera");
  const int count = int(cameras.size()), number = from.number.value_or(count == 1 ? 1 : 0);
  if (number < 1 || number > count)
    throw InputError(
        fmt::format("{}: it has {} cameras; accepted: one of them by its number, "
                    "{}:1 to {}:{}",
                    path.string(), count, from.file.string(), from.file.string(), count));
  return cameras[std::size_t(number - 1)];
}

}  // namespace pellucid::scene
