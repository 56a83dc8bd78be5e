// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/options/keyed_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/options/names.h"
#include "core/options/parameters.h"
#include "core/options/split.h"

namespace pellucid {
namespace {

std::vector<double> finite_numbers(std::string_view option, const KeyedWords& words,
                                   std::string_view key, std::size_t count) {
  const auto found = words.find(key);
  if (found == words.end())
    throw InputError(fmt::format("{}: '{}' is missing; it must be given", option, key));
  std::vector<double> numbers(count);
  bool valid = found->second.size() == count;
  for (std::size_t i = 0; valid && i < count; ++i)
    valid = parse_number(found->second[i], numbers[i]) && std::isfinite(numbers[i]);
  if (!valid)
    throw InputError(fmt::format("{}: {}={}; accepted: {}", option, key,
                                 fmt::join(found->second, ","),
                                 count == 1 ? "a finite number" : "three finite numbers, X,Y,Z"));
  return numbers;
}

}  // namespace

KeyedWords keyed_words(std::string_view option, std::string_view text,
                       std::span<const std::string_view> known) {
  KeyedWords words;
  std::string_view key;
  for (std::string_view word : split(text, ',')) {
    if (const std::size_t equals = word.find('='); equals != word.npos) {
      key = word.substr(0, equals);
      word.remove_prefix(equals + 1);
      if (words.contains(key))
        throw InputError(fmt::format("{}: '{}' is given twice", option, key));
    }
    if (key.empty())
      throw InputError(fmt::format("{}: '{}'; accepted: KEY=VALUES, of the keys {}", option, word,
                                   fmt::join(known, ", ")));
    if (std::ranges::find(known, key) == known.end())
      throw InputError(fmt::format("{}: {}", option, unknown_name("key", key, known)));
    words[key].push_back(word);
  }
  return words;
}

double number_of_key(std::string_view option, const KeyedWords& words, std::string_view key) {
  return finite_numbers(option, words, key, 1)[0];
}

Vec3 vector_of_key(std::string_view option, const KeyedWords& words, std::string_view key) {
  const auto numbers = finite_numbers(option, words, key, 3);
  return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace pellucid
