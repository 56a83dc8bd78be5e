// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/report/html_text.h"

namespace pellucid::compare {

std::string html_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text)
    escaped += c == '<'   ? "&lt;"
               : c == '>' ? "&gt;"
               : c == '&' ? "&amp;"
               : c == '"' ? "&quot;"
                          : std::string(1, c);
  return escaped;
}

std::string filled(std::string_view page, const std::map<std::string_view, std::string>& texts) {
  std::string result;
  for (std::size_t begin; (begin = page.find("{{")) != std::string_view::npos;) {
    const std::size_t end = page.find("}}", begin);
    result += page.substr(0, begin);
    result += texts.at(page.substr(begin + 2, end - begin - 2));
    page.remove_prefix(end + 2);
  }
  return result.append(page);
}

}  // namespace pellucid::compare
