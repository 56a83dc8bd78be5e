// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/site/site.h"

#include <fmt/format.h>

#include <charconv>
#include <exception>
#include <new>

#include "compare/methods/methods.h"
#include "compare/pictures/metrics.h"
#include "compare/report/report_data.h"
#include "core/error.h"
#include "core/files/json_text.h"
#include "core/options/parameters_json.h"
#include "scene/files/camera_file.h"
#include "view/scenes/saved_camera.h"
#include "view/site/page_files.h"
#include "view/site/results_files.h"

namespace pellucid::view {
namespace {

using nlohmann::json;

Answer json_answer(const nlohmann::ordered_json& value) {
  return {.status = 200,
          .type = "application/json",
          .body = value.dump(-1, ' ', false, json::error_handler_t::replace)};
}

nlohmann::ordered_json methods_json() {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const scene::MethodRow& row : compare::methods())
    rows.push_back({{"name", row.name},
                    {"title", row.title},
                    {"exact", row.promises.exact},
                    {"parameters", parameters_json(row.parameters)}});
  return rows;
}

/// The metrics that a page shows live: the first of the table.
nlohmann::ordered_json metrics_rows() {
  constexpr std::size_t shown = 2;
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const compare::MetricRow& row : compare::metrics().first(shown))
    rows.push_back({{"name", row.name}, {"title", row.title}, {"symbol", row.symbol}});
  return rows;
}

std::string page_of(const json& body) {
  const auto page = body.find("page");
  if (page == body.end() || !page->is_string() || page->get<std::string>().empty())
    throw InputError("page: accepted: the page's own name, a text");
  return page->get<std::string>();
}

json without_page(json body) {
  body.erase("page");
  return body;
}

scene::Camera read_one_camera(const json& body) {
  const JsonNode root("request", body);
  root.accept_keys({"camera"});
  const scene::Camera camera = scene::read_camera(root["camera"]);
  at_place(root["camera"], [&] { return scene::camera_frame(camera); });
  return camera;
}

}  // namespace

Answer failure(int status, const std::string& what) {
  return {
      .status = status, .type = "application/json", .body = json_text({{"error", one_line(what)}})};
}

/// A Stage is a loaded scene and who draws it.
struct Site::Stage {
  ViewedScene scene;
  Painter painter;

  Stage(const std::filesystem::path& file, const std::string& gl, const Progress& progress)
      : scene(file, progress), painter(scene, gl) {}
};

/// An Endpoint is a row of the table of what a scene's page asks for.
struct Site::Endpoint {
  std::string_view name, verb;
  Answer (Site::*act)(std::size_t, const json&);
};

Site::Site(SiteContent content, std::string gl, std::function<void(const std::string&)> print)
    : content_(std::move(content)),
      gl_(std::move(gl)),
      print_(std::move(print)),
      stages_(content_.scenes.size()) {}

Site::~Site() = default;

void Site::load(std::size_t i, const Progress& progress) {
  run("", [&](const Progress&) { stage(i, progress); });
}

Site::Stage& Site::stage(std::size_t i, const Progress& progress) {
  if (!stages_[i]) stages_[i] = std::make_unique<Stage>(content_.scenes[i].file, gl_, progress);
  return *stages_[i];
}

Answer Site::answer(const Question& question, std::string_view inner_path) {
  try {
    return dispatch(question, inner_path);
  } catch (const Replaced&) {
    return failure(409, "replaced by newer work of this page");
  } catch (const InputError& error) {
    return failure(400, error.what());
  } catch (const std::bad_alloc&) {
    return failure(500, "out of memory");
  } catch (const std::exception& error) {
    return failure(500, error.what());
  }
}

Answer Site::dispatch(const Question& question, std::string_view path) {
  if (path.empty())
    return {.status = 302,
            .type = "text/plain",
            .body = "",
            .location = content_.results ? "report/report.html" : "scene/0/"};
  if (path.starts_with("report/") && content_.results)
    return results_file(*content_.results, path.substr(7), content_.scenes);
  if (!path.starts_with("scene/")) return failure(404, "nothing is here");
  path.remove_prefix(6);
  std::size_t i = 0;
  const auto [end, error] = std::from_chars(path.data(), path.data() + path.size(), i);
  const std::string_view rest = path.substr(std::size_t(end - path.data()));
  if (error != std::errc() || i >= content_.scenes.size() || !rest.starts_with('/'))
    return failure(404, "no scene is here");
  return scene_answer(i, rest.substr(1), question);
}

Answer Site::scene_answer(std::size_t i, std::string_view name, const Question& question) {
  static constexpr Endpoint endpoints[] = {
      {"scene", "GET", &Site::describe},     {"frame", "POST", &Site::frame},
      {"probe", "POST", &Site::probe},       {"camera", "POST", &Site::camera},
      {"save", "POST", &Site::save},         {"print", "POST", &Site::print},
      {"study", "POST", &Site::add_to_study}};
  for (const Endpoint& endpoint : endpoints)
    if (endpoint.name == name) return act(endpoint, i, question);
  if (const auto file = page_file(name); file && question.verb == "GET") return *file;
  return failure(404, "nothing is here");
}

/// A page of another site may send forms, but no JSON.
Answer Site::act(const Endpoint& endpoint, std::size_t i, const Question& question) {
  if (question.verb != endpoint.verb)
    return failure(405, fmt::format("accepted: {}", endpoint.verb));
  if (question.verb == "GET") return (this->*endpoint.act)(i, {});
  if (!question.content_type.starts_with("application/json"))
    return failure(415, "Content-Type: accepted: application/json");
  const json body = parse_json("request", question.body);
  if (!body.is_object()) throw InputError("request: accepted: an object of JSON");
  return (this->*endpoint.act)(i, body);
}

Answer Site::describe(std::size_t i, const json&) {
  nlohmann::ordered_json known;
  run("", [&](const Progress&) { known = stage(i).scene.description(); });
  known["methods"] = methods_json();
  known["metrics"] = metrics_rows();
  known["error_scale"] = compare::error_scale_json();
  known["may_save"] = content_.scenes[i].may_be_written;
  known["file"] = content_.scenes[i].file.string();
  known["report"] = content_.results.has_value();
  if (content_.study) known["study"] = content_.study->string();
  return json_answer(known);
}

Answer Site::frame(std::size_t i, const json& body) {
  const json text = without_page(body);
  const FrameRequest request = read_frame_request(JsonNode("request", text));
  Answer answer{.status = 200, .type = "application/octet-stream", .body = ""};
  run(fmt::format("{}/{}", i, page_of(body)),
      [&](const Progress& progress) { answer.body = stage(i).painter.frame(request, progress); });
  return answer;
}

/// A probe is of the page's work, too: who turns on no longer wants to know.
Answer Site::probe(std::size_t i, const json& body) {
  const json text = without_page(body);
  const ProbeRequest request = read_probe_request(JsonNode("request", text));
  json found;
  run(fmt::format("{}/{}", i, page_of(body)),
      [&](const Progress& progress) { found = stage(i).painter.probe(request, progress); });
  return json_answer(found);
}

Answer Site::camera(std::size_t i, const json& body) {
  json text = without_page(body);
  const JsonNode root("request", text);
  const std::string direction = root.has("view") ? root["view"].string() : "";
  const ViewState state = read_view_state(root);
  scene::Camera fitted;
  run("", [&](const Progress&) { fitted = stage(i).painter.fitted(state, direction); });
  return json_answer({{"camera", scene::camera_json(fitted)}});
}

Answer Site::save(std::size_t i, const json& body) {
  const SceneFile& scene = content_.scenes[i];
  if (!scene.may_be_written)
    return failure(
        403, scene.file.string() + ": only a scene that was named on the command line is written");
  save_camera(scene.file, read_one_camera(body));
  print_(fmt::format("{}: camera saved", scene.file.string()));
  return json_answer({{"saved", scene.file.string()}});
}

Answer Site::print(std::size_t, const json& body) {
  const scene::Camera camera = read_one_camera(body);
  const std::string text = scene::camera_text(camera);
  print_("--camera " + text);
  return json_answer({{"text", text}, {"camera", scene::camera_json(camera)}});
}

Answer Site::add_to_study(std::size_t, const json& body) {
  if (!content_.study)
    return failure(403, "only a study that was named on the command line is written: --study FILE");
  const std::size_t views = add_view(*content_.study, read_one_camera(body));
  print_(fmt::format("{}: view {} added", content_.study->string(), views));
  return json_answer({{"study", content_.study->string()}, {"views", views}});
}

}  // namespace pellucid::view
