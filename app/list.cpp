// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/listings.h"
#include "core/error.h"
#include "core/files/json_text.h"
#include "core/options/names.h"

namespace pellucid::app {
namespace {

std::string text_of(const nlohmann::ordered_json& value) {
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

void print_parameter(const nlohmann::ordered_json& parameter) {
  std::string line = "      " + text_of(parameter["name"]);
  if (!text_of(parameter["default"]).empty()) line += "=" + text_of(parameter["default"]);
  line += fmt::format("   [{}]", text_of(parameter["accepted"]));
  if (!text_of(parameter["unit"]).empty()) line += "  " + text_of(parameter["unit"]);
  std::cout << line << "   " << text_of(parameter["help"]) << '\n';
}

void print(const nlohmann::ordered_json& rows) {
  for (const nlohmann::ordered_json& row : rows) {
    std::cout << text_of(row["name"]) << "   " << text_of(row["title"]) << '\n';
    for (const auto& [key, value] : row.items())
      if (key != "name" && key != "title" && key != "parameters" && !text_of(value).empty())
        std::cout << "   " << key << ": " << text_of(value) << '\n';
    if (row.contains("parameters") && !row["parameters"].empty()) {
      std::cout << "   parameters:\n";
      for (const nlohmann::ordered_json& parameter : row["parameters"]) print_parameter(parameter);
    }
    std::cout << '\n';
  }
}

/// Every column of rows that have no source of their own.
void print_markdown_of_all(const nlohmann::ordered_json& rows) {
  std::string head, line;
  for (const auto& [key, value] : rows.front().items())
    head += fmt::format("| {} ", key), line += "|---";
  std::cout << head << "|\n" << line << "|\n";
  for (const nlohmann::ordered_json& row : rows) {
    for (const auto& [key, value] : row.items())
      std::cout << (key == "name" ? fmt::format("| `{}` ", text_of(value))
                                  : fmt::format("| {} ", text_of(value)));
    std::cout << "|\n";
  }
}

/// The columns that are short enough for a table: name, title, citation.
void print_markdown(const nlohmann::ordered_json& rows) {
  const nlohmann::ordered_json& first = rows.front();
  if (!first.contains("citation") && !first.contains("source")) return print_markdown_of_all(rows);
  std::cout << "| name | what it is | source |\n|---|---|---|\n";
  for (const nlohmann::ordered_json& row : rows)
    std::cout << fmt::format("| `{}` | {} | {} |\n", text_of(row["name"]), text_of(row["title"]),
                             text_of(row.contains("citation") ? row["citation"] : row["source"]));
}

/// The one row of that name. Throws InputError with the nearest names.
nlohmann::ordered_json row_of(const Listing& listing, const nlohmann::ordered_json& rows,
                              const std::string& name) {
  std::vector<std::string> known;
  for (const nlohmann::ordered_json& row : rows) {
    if (row["name"] == name) return nlohmann::ordered_json::array({row});
    known.push_back(row["name"]);
  }
  throw InputError(
      unknown_name(listing.kind, name, std::vector<std::string_view>(known.begin(), known.end())));
}

struct ListArguments {
  std::string what, name;
  bool markdown = false;
};

void run(const ListArguments& arguments, const GlobalOptions& globals) {
  const Listing& listing = find_row("listing", arguments.what, listings());
  nlohmann::ordered_json rows = listing.make();
  if (!arguments.name.empty()) rows = row_of(listing, rows, arguments.name);
  if (globals.json)
    std::cout << json_text(rows, 2) << '\n';
  else if (arguments.markdown)
    print_markdown(rows);
  else
    print(rows);
}

}  // namespace

void add_list_command(CLI::App& app, GlobalOptions& globals) {
  std::string names;
  for (const Listing& listing : listings())
    names += (names.empty() ? "" : ", ") + std::string(listing.name);
  CLI::App* command = app.add_subcommand("list", "List " + names);
  const auto arguments = std::make_shared<ListArguments>();
  command->add_option("WHAT", arguments->what, names)->required();
  command->add_option("NAME", arguments->name, "One row of it; without: all");
  command->add_flag("--markdown", arguments->markdown,
                    "Print a Markdown table of names and sources");
  command->footer(
      "Examples:\n  pellucid list methods\n  pellucid list methods fourier --json\n"
      "  pellucid list colormaps");
  add_global_options(*command, globals);
  command->callback([arguments, &globals] { run(*arguments, globals); });
}

}  // namespace pellucid::app
