// SPDX-License-Identifier: GPL-3.0-or-later
// The JSON that all files of ours are, and the questions that their readers ask of a value.

#include <nlohmann/json.hpp>

#include "core/files/json_node.h"
#include "fuzz/support/attempt.h"
#include "fuzz/support/bytes.h"

using namespace pellucid;

namespace {

void ask(const JsonNode& node) {
  const std::string place = "input";
  fuzz::attempt(place, [&] { node.number(-1, 1e300); });
  fuzz::attempt(place, [&] { node.integer(-1, 1 << 30); });
  fuzz::attempt(place, [&] { node.boolean(); });
  fuzz::attempt(place, [&] { node.one_of({"a", "b"}); });
  fuzz::attempt(place, [&] { node.vec3(); });
  fuzz::attempt(place, [&] { node.accept_keys({"a", "b"}); });
  if (node.is_array())
    for (const JsonNode& element : node.elements()) ask(element);
  if (node.is_object())
    for (const auto& item : node.value().items()) ask(node[item.key()]);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::attempt("input", [&] {
    const nlohmann::json json = parse_json("input", fuzz::text_of({data, size}));
    if (parse_json("input", json_text(json)) != json) std::abort();  // written and read again
    ask(JsonNode("input", json));
  });
  return 0;
}
