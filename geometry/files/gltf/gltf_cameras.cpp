// SPDX-License-Identifier: GPL-3.0-or-later
// glTF 2.0, 5.12 to 5.14: a camera looks along its node's -z, with +y up; yfov is the whole
// vertical angle in radians, ymag half the height of the picture.
#include "geometry/files/gltf/gltf_cameras.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/trigonometric.hpp>

#include "geometry/files/gltf/gltf_document.h"
#include "geometry/files/gltf/gltf_transforms.h"

namespace pellucid::geometry {
namespace {

using Json = nlohmann::json;

class CameraReader {
 public:
  explicit CameraReader(const std::filesystem::path& path) : document_(path) {}

  std::vector<GltfCamera> read() {
    try {
      visit_gltf_nodes(document_, [&](const Json& node, const Json&, const Mat4& world_from_node) {
        if (const auto camera = node.find("camera"); camera != node.end())
          cameras_.push_back(camera_of(*camera, world_from_node));
      });
    } catch (const Json::exception& error) {
      document_.fail(fmt::format("not as glTF has it: {}", error.what()));
    }
    return std::move(cameras_);
  }

 private:
  GltfCamera camera_of(const Json& index, const Mat4& world_from_node) const {
    const Json& camera = document_.element("cameras", index);
    GltfCamera read{Vec3(world_from_node[3]),
                    glm::normalize(-Vec3(world_from_node[2])),
                    glm::normalize(Vec3(world_from_node[1])),
                    {},
                    {}};
    if (!std::isfinite(glm::dot(read.forward, read.up)))
      document_.fail(fmt::format("cameras[{}]: its node's transform is flat", index.dump()));
    if (camera.at("type") == "perspective")
      read.fov_degrees = glm::degrees(camera.at("perspective").at("yfov").get<double>());
    else
      read.height = 2 * camera.at("orthographic").at("ymag").get<double>();
    return read;
  }

  GltfDocument document_;
  std::vector<GltfCamera> cameras_;
};

}  // namespace

std::vector<GltfCamera> read_gltf_cameras(const std::filesystem::path& path) {
  return CameraReader(path).read();
}

}  // namespace pellucid::geometry
