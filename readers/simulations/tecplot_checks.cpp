// SPDX-License-Identifier: GPL-3.0-or-later
// Tecplot 360 Data Format Guide 2013, Ch. 3, "Data Format": repeated values.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>

#include "core/error.h"
#include "readers/simulations/simulation_checks.h"

namespace pellucid::readers {
namespace {

/// "9*0", "1.5D-03".
bool is_fortran_number(const std::string& word) {
  const auto rest = word.find_first_not_of("0123456789", word.find_first_not_of("+-"));
  if (rest == std::string::npos || rest == 0 ||
      !std::isdigit(static_cast<unsigned char>(word[rest - 1])))
    return false;
  if (word[rest] == '*') return true;
  const auto letter = word.find_first_not_of("0123456789.", rest);
  return letter != std::string::npos && (word[letter] == 'D' || word[letter] == 'd') &&
         word.find_first_not_of("0123456789+-", letter + 1) == std::string::npos;
}

}  // namespace

void refuse_fortran_numbers(const std::filesystem::path& path) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.find_first_of("*Dd") == std::string::npos || line.find('"') != std::string::npos)
      continue;
    std::ranges::replace(line, ',', ' ');
    for (std::size_t end = 0, begin;
         (begin = line.find_first_not_of(" \t\r", end)) != std::string::npos;) {
      if (line[begin] == '#') break;
      end = std::min(line.find_first_of(" \t\r", begin), line.size());
      if (const std::string word = line.substr(begin, end - begin); is_fortran_number(word))
        throw InputError(
            fmt::format("{}: the number {}, which VTK reads as another one; accepted: "
                        "each by itself, exponents after an E",
                        path.string(), word));
    }
  }
}

}  // namespace pellucid::readers
