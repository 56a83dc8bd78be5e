// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/conform/conform.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <nlohmann/json.hpp>

#include "compare/export/export_scene.h"
#include "compare/methods/given_method.h"
#include "compare/methods/given_renderer.h"
#include "compare/pictures/image_file.h"
#include "compare/pictures/metrics.h"
#include "core/error.h"
#include "core/files/output_file.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

std::vector<ConformanceCase> chosen_cases(const std::string& only) {
  std::vector<ConformanceCase> cases = conformance_cases();
  const std::string example = cases.front().name;
  std::erase_if(cases, [&](const ConformanceCase& c) {
    return !only.empty() && ::fnmatch(only.c_str(), c.name.c_str(), 0) != 0;
  });
  if (cases.empty())
    throw InputError(fmt::format(
        "--only '{}': fits no case; accepted: a pattern of names such as '{}'", only, example));
  return cases;
}

/// Of 8 bits are pictures all of whose values are n / 255.
bool is_stored_in_8_bits(const Image& image) {
  constexpr float rounding = 1e-6f;
  for (const Rgba& p : image.pixels)
    for (int c = 0; c < 3; ++c)
      if (std::abs(p[c] * 255 - std::round(p[c] * 255)) > 255 * rounding) return false;
  return true;
}

Image picture_in(const fs::path& folder, const ConformanceCase& c) {
  for (const char* ending : {".exr", ".png"})
    if (const fs::path file = folder / (c.name + ending); fs::exists(file))
      return read_given_picture(file.string(), c.scene);
  throw WorkError(fmt::format("{}: neither {}.exr nor .png", folder.string(), c.name));
}

Image picture_of(const ConformanceCase& c, const ConformRequest& request) {
  if (!request.call) return picture_in(request.pictures, c);
  return make_renderer(*request.call, c.scene, request.context)->render({}).image;
}

CaseResult result_of(const ConformanceCase& c, const ConformRequest& request) {
  CaseResult result{c.name, c.family, c.what, c.n, {.fault = Fault::no_picture}};
  try {
    Image image = picture_of(c, request);
    if (const std::size_t bad = count_not_finite(image)) {
      result.verdict.explanation = fmt::format("{} pixels are not finite", bad);
      return result;
    }
    result.verdict = judge(c, image, is_stored_in_8_bits(image), request.tolerance);
    result.picture = std::move(image);
  } catch (const std::exception& error) {
    result.verdict.explanation = one_line(error.what());
  }
  return result;
}

}  // namespace

std::vector<CaseResult> conform(const ConformRequest& request) {
  const std::vector<ConformanceCase> cases = chosen_cases(request.only);
  std::vector<CaseResult> results;
  for (const ConformanceCase& c : cases) {
    results.push_back(result_of(c, request));
    if (request.on_case)
      request.on_case(double(results.size()) / double(cases.size()), results.back());
  }
  return results;
}

void make_conformance_scenes(const fs::path& folder, const std::string& only) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ConformanceCase& c : chosen_cases(only)) {
    fs::create_directories(folder / c.name);
    export_scene(c.scene, folder / c.name, {.reference = false});
    write_image(folder / c.name / "expected.exr", expected_picture(c),
                form_of_picture(c.scene, {"closed form", "", false}));
    list.push_back({{"name", c.name},
                    {"family", c.family},
                    {"n", c.n},
                    {"what", c.what},
                    {"scene", c.name + "/" + exported_scene_name}});
  }
  const nlohmann::ordered_json json{
      {"format", "pellucid-conformance"}, {"version", 1}, {"cases", list}};
  write_text(folder / "cases.json", json.dump(1) + '\n');
}

std::vector<FamilySummary> summarize(const std::vector<CaseResult>& results) {
  std::vector<FamilySummary> families;
  for (const CaseResult& result : results) {
    if (families.empty() || families.back().family != result.family)
      families.push_back({.family = result.family});
    FamilySummary& family = families.back();
    ++family.cases;
    family.passed += result.verdict.passed;
    if (!result.verdict.passed && !family.first_failed) family.first_failed = &result;
  }
  return families;
}

}  // namespace pellucid::compare
