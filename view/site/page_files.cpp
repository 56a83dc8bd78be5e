// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/site/page_files.h"

#include <string>

#include "view_files.h"

namespace pellucid::view {
namespace {

/// All scripts, those of the report's viewer that it shares first; start.js alone does something
/// when it is loaded, and is the last.
std::string page_script() {
  std::string script = "\"use strict\";\n(() => {\n";
  for (const bool own : {false, true})
    for (const view_files::File& file : view_files::files())
      if (file.path.starts_with("view/") == own && file.path.ends_with(".js") &&
          !file.path.ends_with("/start.js"))
        script += file.text();
  return script + std::string(view_files::start_js()) + "})();\n";
}

}  // namespace

std::optional<Answer> page_file(std::string_view name) {
  if (name.empty())
    return Answer{.status = 200,
                  .type = "text/html; charset=utf-8",
                  .body = std::string(view_files::view_html())};
  if (name == "view.css")
    return Answer{
        .status = 200,
        .type = "text/css; charset=utf-8",
        .body = std::string(view_files::report_css()) + std::string(view_files::view_css())};
  if (name == "view.js")
    return Answer{.status = 200, .type = "text/javascript; charset=utf-8", .body = page_script()};
  return std::nullopt;
}

}  // namespace pellucid::view
