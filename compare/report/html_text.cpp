// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/report/html_text.h"

namespace pellucid::compare {

std::string html_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text)
    escaped += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return escaped;
}

}  // namespace pellucid::compare
