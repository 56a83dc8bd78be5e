// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Pictures from elsewhere are cells of a study as all others are: an external program draws the
// exported scene, or a picture is there already.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/methods/method_call.h"

namespace pellucid::compare {

/// A GivenPlace says for which of a study's views a picture is made, and in which folder a program
/// leaves what it makes. Without a folder it is one that goes away.
struct GivenPlace {
  std::filesystem::path folder = {};
  int view = 1;  // from 1
};

/// A GivenMethod makes pictures, or has them, that are no work of this program.
class GivenMethod {
 public:
  /// Takes the name that the rows of a study have, and where its pictures come from: "command",
  /// "picture".
  GivenMethod(std::string name, std::string_view kind);
  virtual ~GivenMethod() = default;
  GivenMethod(const GivenMethod&) = delete;
  GivenMethod& operator=(const GivenMethod&) = delete;

  std::string_view kind() const { return kind_; }
  const std::string& name() const { return name_; }
  const scene::MethodRow& row() const { return row_; }

  /// Returns a renderer whose first picture costs the work; others are the same one again.
  virtual std::unique_ptr<scene::Renderer> make(const scene::Scene& scene,
                                                const GivenPlace& place) const = 0;
  /// Returns all that its picture depends on beside the scene, the content of files as a hash.
  virtual std::string fingerprint(std::string_view scene, int view) const = 0;
  /// Returns whether it has pictures of their own for all scenes, or views: `what` is "scene" or
  /// "view".
  virtual bool tells_apart(std::string_view /*what*/) const { return true; }

 private:
  std::string name_, title_;
  std::string_view kind_;
  scene::MethodRow row_;
};

/// An ExternalCommand is a program that draws an exported scene. In its words {scene}, {camera} and
/// {output} stand for the files that it reads and writes, {view} for the number of the view; other
/// words that are files, seen from `base`, are those files.
struct ExternalCommand {
  std::string name;
  std::vector<std::string> words;
  double timeout = 600;             // seconds
  std::string ending = ".exr";      // of {output}
  std::filesystem::path base = {};  // the folder that relative files start at
};

/// A GivenPicture is a file, in whose name {scene} and {view} are replaced, and what is known of
/// its costs.
struct GivenPicture {
  std::string name;
  std::string file;
  std::optional<double> milliseconds;
  std::optional<std::uint64_t> bytes;
  std::filesystem::path base = {};  // the folder that a relative file starts at
};

/// Return the call of a row of its own. The first throws InputError for a command that has no
/// words, or none with {output}.
///@{
MethodCall external_call(const ExternalCommand& command);
MethodCall picture_call(const GivenPicture& picture);
///@}

/// Makes the renderer of any call.
std::unique_ptr<scene::Renderer> make_renderer(const MethodCall& call, const scene::Scene& scene,
                                               const scene::RenderContext& context,
                                               const GivenPlace& place = {});

}  // namespace pellucid::compare
