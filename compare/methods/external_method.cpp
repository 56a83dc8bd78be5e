// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdlib.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "compare/export/export_scene.h"
#include "compare/methods/given_method.h"
#include "compare/methods/given_renderer.h"
#include "core/error.h"
#include "core/files/files_read.h"
#include "core/files/json_node.h"
#include "core/files/output_file.h"
#include "core/machine/program_run.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

constexpr const char* wall_clock = "wall clock of the command";
constexpr const char* as_reported = "as the command says";
constexpr double most = 1e15;  // of any cost

/// The folder in which a command runs: the place's, made anew, or one that goes away.
class RunFolder {
 public:
  explicit RunFolder(const GivenPlace& place) : kept_(!place.folder.empty()) {
    path_ = kept_ ? fs::absolute(place.folder) : temporary();
    if (kept_) fs::remove_all(path_);
    fs::create_directories(path_ / "scene");
  }
  ~RunFolder() {
    std::error_code ignored;
    fs::remove_all(kept_ ? path_ / "scene" : path_, ignored);
  }
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  fs::path operator/(std::string_view name) const { return path_ / name; }
  const fs::path& path() const { return path_; }
  bool is_temporary() const { return !kept_; }

 private:
  static fs::path temporary() {
    std::string name = (fs::temp_directory_path() / "pellucid-command-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw WorkError(name + ": cannot make the folder");
    return name;
  }

  bool kept_;
  fs::path path_;
};

/// What a program complained of last.
std::string last_line(const fs::path& file) {
  const std::string text = read_text(file);
  const std::size_t end = text.find_last_not_of(" \n\r\t");
  if (end == text.npos) return "";
  const std::size_t before = text.find_last_of('\n', end);
  const std::size_t begin = before == text.npos ? 0 : before + 1;
  return ": " + text.substr(begin, end + 1 - begin);
}

void read_steps(const JsonNode& node, double milliseconds, scene::RenderStats& stats) {
  double sum = 0;
  for (const std::string& step : node.keys()) {
    stats.steps.push_back({step, node[step].number(0, most) / 1e3});
    sum += 1e3 * stats.steps.back().seconds;
  }
  // So much is lost when a program prints its times with a few digits.
  const double rounding = 0.01 * milliseconds + 0.01;
  if (sum > milliseconds + rounding)
    node.fail(fmt::format("{} ms together; accepted: no more than 'ms', {}", sum, milliseconds));
  if (sum < milliseconds - rounding) stats.steps.push_back({"other", (milliseconds - sum) / 1e3});
}

/// {"ms", "bytes", "steps": {NAME: ms}, "fragments"}, each where it is known.
void read_costs(const JsonNode& node, double seconds, scene::RenderStats& stats) {
  node.accept_keys({"ms", "bytes", "steps", "fragments"});
  const double milliseconds = node.has("ms") ? node["ms"].number(0, most) : 1e3 * seconds;
  if (node.has("steps"))
    read_steps(node["steps"], milliseconds, stats);
  else
    stats.steps = {{node.has("ms") ? as_reported : wall_clock, milliseconds / 1e3}};
  if (node.has("bytes")) stats.bytes = {{as_reported, node["bytes"].whole(most)}};
  if (node.has("fragments")) stats.fragments = node["fragments"].whole(most);
}

class ExternalRenderer final : public GivenRenderer {
 public:
  ExternalRenderer(const scene::Scene& scene, const ExternalCommand& command, GivenPlace place)
      : scene_(scene), command_(command), place_(std::move(place)) {}

  std::vector<std::string> explain() const override {
    std::vector<std::string> lines{fmt::format("drawn by: {}", fmt::join(command_.words, " ")),
                                   fmt::format("its time: {}", time_)};
    if (!place_.folder.empty())
      lines.push_back(fmt::format("what it printed and wrote is in {}", place_.folder.string()));
    return lines;
  }
  std::map<std::string, std::string> facts() const override { return {{"time", time_}}; }

 private:
  scene::Rendering make_once() override {
    const RunFolder folder(place_);
    export_scene(scene_, folder / "scene", {.reference = false});
    export_camera(scene_, folder / "camera.json");
    const fs::path output = folder / ("output" + command_.ending);
    const ProgramRun run = start(folder, output);
    const UnnotedReads own;  // what the cell has written itself is no input of its
    if (!run.succeeded())
      throw WorkError(
          fmt::format("the command {}{}", run.failure(), last_line(folder / "stderr.txt")));
    if (!fs::exists(output)) throw WorkError("the command left no picture at {output}");
    scene::Rendering rendering;
    rendering.image = read_given_picture(output.string(), scene_);
    add_costs(output.string() + ".json", run.seconds, rendering.stats);
    return rendering;
  }

  ProgramRun start(const RunFolder& folder, const fs::path& output) const {
    const std::map<std::string, std::string> values{
        {"scene", folder / "scene" / exported_scene_name},
        {"camera", folder / "camera.json"},
        {"output", output},
        {"view", std::to_string(place_.view)}};
    std::vector<std::string> words;
    for (const std::string& word : command_.words)
      words.push_back(with_values(file_or_word(word), values));
    const fs::path program = find_program(command_.words.front(), command_.base);
    if (program.empty())
      throw WorkError(fmt::format("'{}': no program that may be run", command_.words.front()));
    return run_program(
        program, words,
        {folder.path(), folder / "stdout.txt", folder / "stderr.txt", folder.is_temporary()},
        command_.timeout);
  }

  std::string file_or_word(const std::string& word) const {
    if (word.empty()) return word;  // an argument like others, and no path
    const fs::path path = fs::absolute(command_.base / word);
    std::error_code code;
    return fs::is_regular_file(path, code) ? without_dots(path).string() : word;
  }

  void add_costs(const fs::path& file, double seconds, scene::RenderStats& stats) {
    nlohmann::json json = nlohmann::json::object();
    if (fs::exists(file)) json = read_json(file);
    read_costs(JsonNode(file.string(), json), seconds, stats);
    time_ = json.contains("ms") ? as_reported : wall_clock;
  }

  const scene::Scene& scene_;
  ExternalCommand command_;
  GivenPlace place_;
  std::string time_ = wall_clock;
};

class ExternalMethod final : public GivenMethod {
 public:
  explicit ExternalMethod(ExternalCommand command)
      : GivenMethod(command.name, "command"), command_(std::move(command)) {}

  std::unique_ptr<scene::Renderer> make(const scene::Scene& scene,
                                        const GivenPlace& place) const override {
    return std::make_unique<ExternalRenderer>(scene, command_, place);
  }

  std::string fingerprint(std::string_view, int) const override {
    ContentHashes hashes;
    std::string text = fmt::format("{} {} {}", command_.timeout, command_.ending,
                                   hashes.of(find_program(command_.words[0], command_.base)));
    for (const std::string& word : command_.words)
      text += fmt::format("\n{} {}", word, hash_of_file(command_.base / word, hashes));
    return text;
  }

 private:
  static std::string hash_of_file(const fs::path& path, ContentHashes& hashes) {
    std::error_code code;
    return fs::is_regular_file(path, code) ? hashes.of(path) : "";
  }

  ExternalCommand command_;
};

}  // namespace

namespace {

/// "{sceen}" would be passed on as it stands. Other braces, as of JSON, are the program's.
void refuse_unknown_marks(const std::string& word) {
  constexpr std::string_view known[] = {"scene", "camera", "output", "view"};
  for (std::size_t at = 0; (at = word.find('{', at)) != word.npos; ++at) {
    const std::size_t end = word.find_first_not_of("abcdefghijklmnopqrstuvwxyz_", at + 1);
    if (end == word.npos || word[end] != '}' || end == at + 1) continue;
    const std::string name = word.substr(at + 1, end - at - 1);
    if (std::ranges::find(known, name) == std::end(known))
      throw InputError(fmt::format("'{}': nothing is known as {{{}}}; accepted: {{{}}}", word, name,
                                   fmt::join(known, "}, {")));
  }
}

}  // namespace

MethodCall external_call(const ExternalCommand& command) {
  for (const std::string& word : command.words) refuse_unknown_marks(word);
  const bool has_output = std::ranges::any_of(
      command.words, [](const std::string& word) { return word.find("{output}") != word.npos; });
  if (!has_output)
    throw InputError(
        "no word of the command has {output}; accepted: a program and its arguments, in which "
        "{scene}, {camera}, {output} and {view} stand for what it reads and writes");
  const auto method = std::make_shared<ExternalMethod>(command);
  return {&method->row(), Parameters(method->row().name, {}, {}), method};
}

}  // namespace pellucid::compare
