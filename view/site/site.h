// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "view/frames/painter.h"
#include "view/frames/worker.h"
#include "view/site/exchange.h"

namespace pellucid::view {

/// A SceneFile is a scene that a page may turn.
struct SceneFile {
  std::filesystem::path file;
  bool may_be_written = false;  // it was named on the command line
};

/// A SiteContent is what may be seen.
struct SiteContent {
  std::vector<SceneFile> scenes;
  std::optional<std::filesystem::path> results = std::nullopt;  // a study's folder with its report
  std::optional<std::filesystem::path> study = std::nullopt;    // a study file that views go to
};

/// A Site answers questions that a Gate has let in. Any number of threads may ask; all work is done
/// on one of its own.
///
///     ""                       leads to the report, or to the first scene
///     report/FILE              a file of the study's folder
///     scene/I/                 the page that turns scene I, its view.js and view.css
///     scene/I/scene            what the page has to know
///     scene/I/frame            pictures (Painter::frame), scene/I/probe (Painter::probe)
///     scene/I/camera           the camera that sees all from a side: the state_keys and "view"
///     scene/I/save, …/print    writes a camera into the scene file, or to the terminal
///     scene/I/study            adds it to the views of the study
class Site {
 public:
  /// `print` gets lines for the terminal.
  Site(SiteContent content, std::string gl, std::function<void(const std::string&)> print);
  ~Site();

  /// Loads scene `i` now. Throws as load_scene() does.
  void load(std::size_t i, const Progress& progress);

  /// Answers; what is wrong with a question is {"error": one line} with a status of 400 or above.
  Answer answer(const Question& question, std::string_view inner_path);

  /// Ends all work; questions that wait for it are answered.
  void end() { worker_.end(); }

 private:
  struct Stage;
  struct Endpoint;

  Answer dispatch(const Question& question, std::string_view path);
  Answer scene_answer(std::size_t i, std::string_view name, const Question& question);
  Answer act(const Endpoint& endpoint, std::size_t i, const Question& question);
  Stage& stage(std::size_t i, const Progress& progress = {});
  void run(const std::string& page, const Worker::Work& work) { worker_.run(page, work); }

  Answer describe(std::size_t i, const nlohmann::json& body);
  Answer frame(std::size_t i, const nlohmann::json& body);
  Answer probe(std::size_t i, const nlohmann::json& body);
  Answer camera(std::size_t i, const nlohmann::json& body);
  Answer save(std::size_t i, const nlohmann::json& body);
  Answer print(std::size_t i, const nlohmann::json& body);
  Answer add_to_study(std::size_t i, const nlohmann::json& body);

  SiteContent content_;
  std::string gl_;
  std::function<void(const std::string&)> print_;
  std::vector<std::unique_ptr<Stage>> stages_;  // of the worker's thread, but while none asks
  Worker worker_;                               // the last: it uses all others
};

}  // namespace pellucid::view
