// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/report/source_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "compare/report/column_json.h"
#include "compare/results/number_json.h"
#include "core/files/files_read.h"
#include "core/files/output_file.h"

namespace pellucid::compare {
namespace {

using nlohmann::json;

json check_json(const Claim& claim, const ClaimCheck& check) {
  json values = json::array();
  for (const ClaimedValue& value : check.values)
    values.push_back({{"of", value.of}, {"text", claim.by.text(value.value)}});
  return {{"of", check.of},
          {"values", values},
          {"against", check.against},
          {"undecided", check.undecided}};
}

json cost_line_json(const CostLine& line) {
  json steps = json::array();
  for (const std::optional<double>& step : line.steps) steps.push_back(step ? json(*step) : json());
  return {{"scene", line.scene},
          {"call", line.call},
          {"milliseconds", line.milliseconds ? json(*line.milliseconds) : json()},
          {"bytes", line.bytes ? json(*line.bytes) : json()},
          {"steps", steps},
          {"bottleneck", line.bottleneck ? json(*line.bottleneck) : json()}};
}

}  // namespace

json study_json(const Study& study) {
  json j{{"name", study.name},
         {"file", without_dots(std::filesystem::absolute(study.file)).string()},
         {"title", study.title},
         {"source", study.source},
         {"notes", study.notes}};
  if (study.opacities) j["opacities"] = study.opacities->text();
  return j;
}

json inputs_json(const Study& study) {
  std::vector<std::filesystem::path> files{study.file};
  files.insert(files.end(), study.scenes.begin(), study.scenes.end());
  for (const auto& [scene, file] : study.reference_scenes)
    if (std::ranges::find(files, file) == files.end()) files.push_back(file);
  json inputs = json::array();
  for (const std::filesystem::path& file : files)
    if (std::filesystem::is_regular_file(file))
      inputs.push_back({{"file", without_dots(std::filesystem::absolute(file)).string()},
                        {"text", read_text(file)}});
  return inputs;
}

json claims_json(const Study& study, std::span<const ResultRow> rows) {
  json claims = json::array();
  for (const Claim& claim : study.claims) {
    json checks = json::array();
    for (const ClaimCheck& check : check_claim(claim, scene_names(study), rows))
      checks.push_back(check_json(claim, check));
    claims.push_back({{"text", claim.text}, {"by", claim.by.heading()}, {"checks", checks}});
  }
  return claims;
}

json ladders_json(const Study& study, std::span<const ResultRow> rows) {
  const LadderTable table = ladder_table(study.ladders, rows);
  json lines = json::array();
  for (const auto& [call, cells] : table.lines) lines.push_back({{"call", call}, {"cells", cells}});
  return {{"heads", table.heads}, {"lines", lines}};
}

json growth_json(const Study& study, std::span<const ResultRow> rows) {
  json plots = json::array();
  for (const Growth& growth : study.growth)
    for (const Column* column : growth.by) {
      json curves = json::array();
      for (const GrowthCurve& curve : growth_curves(growth, *column, rows)) {
        json x = json::array(), y = json::array();
        for (const auto& [size, number] : curve.points) {
          x.push_back(size);
          y.push_back(number_json(number));
        }
        curves.push_back({{"label", curve.call}, {"x", x}, {"y", y}, {"law", text_of(curve.law)}});
      }
      plots.push_back(
          {{"title", growth.title}, {"column", column_json(*column)}, {"curves", curves}});
    }
  return plots;
}

json costs_json(const Study& study, std::span<const ResultRow> rows) {
  json tables = json::array(), ratios = json::array();
  for (const CostTable& table : cost_tables(study, rows)) {
    json lines = json::array();
    for (const CostLine& line : table.lines) lines.push_back(cost_line_json(line));
    tables.push_back({{"title", table.title}, {"steps", table.steps}, {"lines", lines}});
  }
  for (const CostRatio& ratio : cost_ratios(study, rows))
    ratios.push_back({{"scene", ratio.scene},
                      {"call", ratio.call},
                      {"here", ratio.here ? json(*ratio.here) : json()},
                      {"published", ratio.published ? json(*ratio.published) : json()}});
  return {{"tables", tables}, {"ratios", ratios}, {"reference", study.reference.text()}};
}

}  // namespace pellucid::compare
