// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/conform/conform_json.h"

#include <nlohmann/json.hpp>

namespace pellucid::compare {
namespace {

nlohmann::ordered_json to_json(const CaseResult& result) {
  const Verdict& v = result.verdict;
  nlohmann::ordered_json json{{"name", result.name},    {"family", result.family},
                              {"n", result.n},          {"what", result.what},
                              {"passed", v.passed},     {"max_error", v.max_error},
                              {"wrong_pixels", v.wrong}};
  if (!v.passed) {
    json["fault"] = v.fault;
    json["explanation"] = v.explanation;
  }
  return json;
}

nlohmann::ordered_json to_json(const FamilySummary& family) {
  nlohmann::ordered_json json{
      {"family", family.family}, {"passed", family.passed}, {"cases", family.cases}};
  if (const CaseResult* failed = family.first_failed) {
    json["first_failed"] = failed->name;
    json["n"] = failed->n;
    json["fault"] = failed->verdict.fault;
  }
  return json;
}

}  // namespace

nlohmann::ordered_json json_of(const std::vector<CaseResult>& results) {
  nlohmann::ordered_json json{{"families", nlohmann::ordered_json::array()},
                              {"cases", nlohmann::ordered_json::array()}};
  for (const auto& family : summarize(results)) json["families"].push_back(to_json(family));
  for (const auto& result : results) json["cases"].push_back(to_json(result));
  return json;
}

}  // namespace pellucid::compare
