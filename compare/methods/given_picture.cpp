// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "compare/methods/given_method.h"
#include "compare/methods/given_renderer.h"
#include "compare/pictures/image_file.h"
#include "core/error.h"
#include "core/files/files_read.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

class PictureRenderer final : public GivenRenderer {
 public:
  PictureRenderer(const scene::Scene& scene, const GivenPicture& picture, std::string file)
      : scene_(scene), picture_(picture), file_(std::move(file)) {}

  std::vector<std::string> explain() const override {
    return {fmt::format("the picture was given: {}", file_)};
  }

 private:
  scene::Rendering make_once() override {
    scene::Rendering rendering;
    rendering.image = read_given_picture(file_, scene_);
    if (picture_.milliseconds) rendering.stats.steps = {{"as given", *picture_.milliseconds / 1e3}};
    if (picture_.bytes) rendering.stats.bytes = {{"as given", *picture_.bytes}};
    return rendering;
  }

  const scene::Scene& scene_;
  GivenPicture picture_;
  std::string file_;
};

class PictureMethod final : public GivenMethod {
 public:
  explicit PictureMethod(GivenPicture picture)
      : GivenMethod(picture.name, "picture"), picture_(std::move(picture)) {}

  std::unique_ptr<scene::Renderer> make(const scene::Scene& scene,
                                        const GivenPlace& place) const override {
    return std::make_unique<PictureRenderer>(scene, picture_, file(scene.name, place.view));
  }

  /// A cell has the pictures of all views from this one on: so many as lie there. Only the study's
  /// scene knows how many frames a path has.
  std::string fingerprint(std::string_view scene, int view) const override {
    ContentHashes hashes;
    std::string text = fmt::format("{} {} {} {}", picture_.file, picture_.milliseconds.value_or(-1),
                                   picture_.bytes ? fmt::format("{}", *picture_.bytes) : "",
                                   hashes.of(file(scene, view)));
    std::error_code code;
    while (tells_apart("view") && fs::exists(file(scene, ++view), code))
      text += ' ' + hashes.of(file(scene, view));
    return text;
  }

  bool tells_apart(std::string_view what) const override {
    return picture_.file.find(fmt::format("{{{}}}", what)) != std::string::npos;
  }

 private:
  std::string file(std::string_view scene, int view) const {
    const std::string name =
        with_values(picture_.file, {{"scene", std::string(scene)}, {"view", std::to_string(view)}});
    return without_dots(picture_.base / name).string();
  }

  GivenPicture picture_;
};

}  // namespace

Image read_given_picture(const std::string& path, const scene::Scene& scene) {
  Image image;
  try {
    image = read_image(path);
  } catch (const InputError& error) {
    throw WorkError(error.what());
  }
  if (image.width != scene.width || image.height != scene.height)
    throw WorkError(fmt::format("{}: {} × {} pixels; accepted: the scene's {} × {}", path,
                                image.width, image.height, scene.width, scene.height));
  return image;
}

// Once from left to right: a value may hold braces, too, as the path of a folder does.
std::string with_values(std::string text, const std::map<std::string, std::string>& values) {
  for (std::size_t at = 0; (at = text.find('{', at)) != text.npos;) {
    const std::size_t end = text.find('}', at);
    if (end == text.npos) break;
    const auto value = values.find(text.substr(at + 1, end - at - 1));
    if (value == values.end()) {
      ++at;
      continue;
    }
    text.replace(at, end + 1 - at, value->second);
    at += value->second.size();
  }
  return text;
}

MethodCall picture_call(const GivenPicture& picture) {
  const auto method = std::make_shared<PictureMethod>(picture);
  return {&method->row(), Parameters(method->row().name, {}, {}), method};
}

}  // namespace pellucid::compare
