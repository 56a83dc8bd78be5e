// SPDX-License-Identifier: GPL-3.0-or-later
// For targets whose files are JSON: most inputs stay JSON while one of their values changes, so
// that the fuzzer gets past the parser. libFuzzer's own mutations are taken one time in four, and
// for what is no JSON.

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "core/files/json_text.h"
#include "fuzz/support/bytes.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace pellucid::fuzz {
namespace {

using nlohmann::json;

class Mutator {
 public:
  Mutator(json& root, unsigned seed) : random_(seed) { collect(root); }

  void change() {
    json& node = *pick();
    switch (below(6)) {
      case 0:
        node = json(*pick());
        break;
      case 1:
        node = number();
        break;
      case 2:
        if (node.is_array() && !node.empty()) node.push_back(json(node[below(node.size())]));
        break;
      case 3:
        if (node.is_structured() && !node.empty())
          node.erase(std::next(node.begin(), std::ptrdiff_t(below(node.size()))));
        break;
      case 4:
        if (node.is_object()) node[name_of_any()] = json(*pick());
        break;
      default:
        if (node.is_string()) node = mutated(node.get<std::string>());
        if (node.is_number()) node = node.get<double>() * (below(2) ? -1 : 0.5);
    }
  }

 private:
  void collect(json& node) {
    nodes_.push_back(&node);
    for (auto item = node.begin(); node.is_structured() && item != node.end(); ++item) {
      if (node.is_object()) names_.push_back(item.key());
      collect(item.value());
    }
  }
  std::size_t below(std::size_t count) { return std::size_t(random_()) % count; }
  json* pick() { return nodes_[below(nodes_.size())]; }
  std::string name_of_any() { return names_.empty() ? "a" : names_[below(names_.size())]; }

  json number() {
    using Limits = std::numeric_limits<double>;
    const json values[] = {0,
                           1,
                           -1,
                           2,
                           0.5,
                           1e-9,
                           1e9,
                           2.5,
                           360,
                           1e154,
                           1e300,
                           Limits::max(),
                           -Limits::max(),
                           Limits::denorm_min(),
                           1e-310,
                           true,
                           {},
                           "",
                           1 << 30,
                           std::numeric_limits<std::uint64_t>::max()};
    return values[below(std::size(values))];
  }

  static std::string mutated(std::string text) {
    const std::size_t size = text.size();
    text.resize(size + 16);
    text.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(text.data()), size, text.size()));
    return text;
  }

  std::minstd_rand random_;
  std::vector<json*> nodes_;
  std::vector<std::string> names_;
};

}  // namespace
}  // namespace pellucid::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  using namespace pellucid;
  nlohmann::json root = nlohmann::json::parse(fuzz::text_of({data, size}), nullptr, false);
  if (root.is_discarded() || seed % 4 == 0) return LLVMFuzzerMutate(data, size, most);
  for (unsigned i = 0; i <= seed / 4 % 3; ++i) fuzz::Mutator(root, seed + i).change();
  const std::string text = json_text(root);
  if (text.size() > most) return LLVMFuzzerMutate(data, size, most);
  std::copy(text.begin(), text.end(), data);
  return text.size();
}
