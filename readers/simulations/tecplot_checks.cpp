// SPDX-License-Identifier: GPL-3.0-or-later
// Tecplot 360 Data Format Guide 2013, Ch. 3, "Data Format": repeated values.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <optional>

#include "core/error.h"
#include "core/options/lower_case.h"
#include "core/options/parameters.h"
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

void refuse_several_solution_times(const std::filesystem::path& path) {
  constexpr std::string_view key = "solutiontime";
  std::ifstream file(path);
  std::optional<double> first;
  for (std::string line; std::getline(file, line);) {
    const std::size_t at = lower_case(line).find(key);
    if (at == line.npos || line.find('#') < at) continue;
    const std::size_t begin = line.find_first_not_of(" =\t", at + key.size());
    if (begin == line.npos) continue;
    const std::size_t end = std::min(line.find_first_of(" ,\t\r", begin), line.size());
    double time = 0;
    if (!parse_number(std::string_view(line).substr(begin, end - begin), time)) continue;
    if (first && *first != time)
      throw InputError(
          fmt::format("{}: zones at the times {} and {}; accepted: a file per time, "
                      "and a .series of them",
                      path.string(), *first, time));
    first = time;
  }
}

}  // namespace pellucid::readers
