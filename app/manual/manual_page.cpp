// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/manual/manual_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/manual/command_tree.h"
#include "core/error.h"
#include "core/machine/build_info.h"
#include "core/options/names.h"

namespace pellucid::app {
namespace {

/// What roff would take for its own: backslashes, hyphens, and requests at a line's beginning.
std::string roff(std::string_view text) {
  std::string safe;
  bool line_begins = true;
  for (const char c : text) {
    if (line_begins && (c == '.' || c == '\'')) safe += "\\&";
    safe += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
    line_begins = c == '\n';
  }
  return safe;
}

/// "pellucid", or "pellucid render".
std::string full_name(const CLI::App& app) {
  return app.get_parent() ? app.get_parent()->get_name() + ' ' + app.get_name() : app.get_name();
}

/// "-m, --method TEXT", or "SCENE".
std::string usage_of(const CLI::Option& option) {
  if (option.get_positional()) return option.get_name(true, false);
  std::string usage = fmt::format("{}", fmt::join(names_of(option), ", "));
  if (option.get_items_expected_max() > 0) usage += ' ' + option.get_type_name();
  return usage;
}

std::string described(const CLI::Option& option) {
  std::string text = option.get_description();
  if (const std::string value = option.get_default_str(); !value.empty())
    text += fmt::format(" (default: {})", value);
  return text;
}

std::string synopsis(const CLI::App& app) {
  std::string text = full_name(app);
  if (!app.get_parent()) return text + " COMMAND [OPTIONS]";
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_positional()) continue;
    const std::string name = option->get_name(true, false);
    text += option->get_required() ? ' ' + name : " [" + name + ']';
  }
  return text + " [OPTIONS]";
}

/// A paragraph with a hanging tag.
std::string tagged(const std::string& tag, const std::string& text) {
  return fmt::format(".TP\n.B {}\n{}\n", roff(tag), roff(text));
}

std::string commands_section(const CLI::App& program) {
  std::string text = ".SH COMMANDS\n";
  for (const CLI::App* command : commands_of(program))
    text += tagged(
        command->get_name(),
        fmt::format("{}; see pellucid-{}(1)", command->get_description(), command->get_name()));
  return text;
}

std::string see_also(const CLI::App& app) {
  std::vector<std::string> pages{"pellucid(1)"};
  for (const std::string& name : command_names(app.get_parent() ? *app.get_parent() : app))
    pages.push_back(fmt::format("pellucid-{}(1)", name));
  return ".SH SEE ALSO\n" + roff(fmt::format("{}\n", fmt::join(pages, ", ")));
}

std::string heading(const CLI::App& app) {
  std::string title = full_name(app), summary = app.get_description();
  std::ranges::replace(title, ' ', '-');
  std::ranges::replace(summary, '\n', ' ');
  return fmt::format(".TH {} 1 \"\" \"pellucid {}\" \"User Commands\"\n.SH NAME\n{} \\- {}\n",
                     roff(title), build_version, roff(title), roff(summary));
}

}  // namespace

std::string manual_page(const CLI::App& app) {
  std::string page = heading(app);
  page += ".SH SYNOPSIS\n.B " + roff(synopsis(app)) + '\n';
  page += ".SH DESCRIPTION\n" + roff(app.get_description()) + '\n';
  if (!app.get_parent()) page += commands_section(app);
  page += ".SH OPTIONS\n";
  for (const CLI::Option* option : app.get_options())
    page += tagged(usage_of(*option), described(*option));
  if (!app.get_footer().empty())
    page += ".SH NOTES AND EXAMPLES\n.nf\n" + roff(app.get_footer()) + "\n.fi\n";
  return page + see_also(app);
}

std::string manual_page(const CLI::App& program, const std::string& name) {
  if (name == program.get_name()) return manual_page(program);
  for (const CLI::App* command : commands_of(program))
    if (command->get_name() == name) return manual_page(*command);
  std::vector<std::string> names = command_names(program);
  names.insert(names.begin(), program.get_name());
  throw InputError(
      unknown_name("manual page", name, std::vector<std::string_view>(names.begin(), names.end())));
}

}  // namespace pellucid::app
