// SPDX-License-Identifier: GPL-3.0-or-later
// ParaView writes <Proxy group="views"> with <Property name="CameraPosition"> and the like, whose
// <Element index="0" value="…"/> are the numbers. CameraViewAngle is the vertical angle in degrees,
// CameraParallelScale half the picture's height in world units (vtkCamera).
#include "scene/cameras/paraview_cameras.h"

#include <expat.h>
#include <fmt/format.h>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/files/output_file.h"
#include "core/options/option_table.h"

namespace pellucid::scene {
namespace {

using Numbers = std::array<std::optional<double>, 3>;  // of a property, by their index

std::string_view attribute(const XML_Char** attributes, std::string_view name) {
  for (; *attributes; attributes += 2)
    if (attributes[0] == name) return attributes[1];
  return {};
}

/// Gathers the properties of the views while expat goes through the file.
class Views {
 public:
  void open(std::string_view element, const XML_Char** attributes) {
    ++depth_;
    if (element == "Proxy" && attribute(attributes, "group") == "views") {
      view_.clear();
      view_depth_ = depth_;
    } else if (element == "Property") {
      property_ = attribute(attributes, "name");
    } else if (element == "Element" && view_depth_ > 0) {
      keep(attribute(attributes, "index"), attribute(attributes, "value"));
    }
  }

  void close() {
    if (depth_ == view_depth_) {
      if (view_.contains("CameraPosition")) views_.push_back(std::move(view_));
      view_depth_ = 0;
    }
    --depth_;
  }

  const std::vector<std::map<std::string, Numbers>>& all() const { return views_; }

 private:
  void keep(std::string_view index, std::string_view value) {
    double number = 0;
    const std::size_t place = index == "0" ? 0 : index == "1" ? 1 : index == "2" ? 2 : 3;
    if (place < 3 && property_.starts_with("Camera") && parse_number(value, number))
      view_[property_][place] = number;
  }

  int depth_ = 0, view_depth_ = 0;  // 0: in no view
  std::string property_;
  std::map<std::string, Numbers> view_;
  std::vector<std::map<std::string, Numbers>> views_;
};

class CameraMaker {
 public:
  CameraMaker(const std::filesystem::path& path, const std::map<std::string, Numbers>& view)
      : path_(path), view_(view) {}

  Camera camera() const {
    Camera camera;
    camera.eye = vector("CameraPosition");
    camera.target = vector("CameraFocalPoint");
    camera.up = vector("CameraViewUp");
    const auto parallel = view_.find("CameraParallelProjection");
    if (parallel != view_.end() && parallel->second[0].value_or(0) != 0) {
      camera.projection = Projection::orthographic;
      camera.height = 2 * number("CameraParallelScale");
    } else {
      camera.fov = number("CameraViewAngle");
    }
    return camera;
  }

 private:
  double number(const std::string& name, std::size_t index = 0) const {
    const auto numbers = view_.find(name);
    if (numbers == view_.end() || !numbers->second[index])
      throw InputError(fmt::format("{}: a view's {} is not there", path_.string(), name));
    return *numbers->second[index];
  }
  Vec3 vector(const std::string& name) const {
    return {number(name, 0), number(name, 1), number(name, 2)};
  }

  const std::filesystem::path& path_;
  const std::map<std::string, Numbers>& view_;
};

void parse(const std::filesystem::path& path, Views& views) {
  const std::string text = read_text(path);
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(
      XML_ParserCreate(nullptr), XML_ParserFree);
  XML_SetUserData(parser.get(), &views);
  XML_SetElementHandler(
      parser.get(),
      [](void* to, const XML_Char* element, const XML_Char** attributes) {
        static_cast<Views*>(to)->open(element, attributes);
      },
      [](void* to, const XML_Char*) { static_cast<Views*>(to)->close(); });
  // The length is an int: what is longer comes in pieces.
  constexpr std::size_t piece = 1 << 20;
  for (std::size_t at = 0; at <= text.size(); at += piece) {
    const std::string_view part = std::string_view(text).substr(at, piece);
    const bool is_last = at + piece > text.size();
    if (XML_Parse(parser.get(), part.data(), int(part.size()), is_last) == XML_STATUS_ERROR)
      throw InputError(fmt::format("{}:{}: {}; accepted: a camera or a state that ParaView wrote",
                                   path.string(), XML_GetCurrentLineNumber(parser.get()),
                                   XML_ErrorString(XML_GetErrorCode(parser.get()))));
  }
}

}  // namespace

std::vector<Camera> read_paraview_cameras(const std::filesystem::path& path) {
  Views views;
  parse(path, views);
  std::vector<Camera> cameras;
  for (const auto& view : views.all()) cameras.push_back(CameraMaker(path, view).camera());
  return cameras;
}

}  // namespace pellucid::scene
