// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/options/option_table.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

namespace pellucid {

std::string number_text(double value) {
  if (std::abs(value) < 1e15 && value == std::int64_t(value))
    return fmt::format("{}", std::int64_t(value));
  std::string text = fmt::format("{}", value);
  // fmt writes two digits of an exponent at least.
  if (const std::size_t e = text.find('e'); e != std::string::npos && text[e + 2] == '0')
    text.erase(e + 2, 1);
  return text;
}

}  // namespace pellucid
