// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/manual/manual_options.h"

#include <iostream>

#include "app/manual/completion.h"
#include "app/manual/manual_page.h"

namespace pellucid::app {
namespace {

/// Prints the text and ends the program, as --help does.
[[noreturn]] void print_and_end(const std::string& text) {
  std::cout << text;
  throw CLI::Success();
}

}  // namespace

void add_manual_options(CLI::App& program) {
  const auto print_page = [&program](const std::string& name) {
    print_and_end(manual_page(program, name));
  };
  const auto print_completion = [&program](const std::string& shell) {
    print_and_end(completion(program, shell));
  };
  program
      .add_option_function<std::string>(
          "--completion", print_completion,
          "Print what bash or zsh reads to complete commands, options and names")
      ->trigger_on_parse()
      ->type_name("SHELL");
  program
      .add_option_function<std::string>(
          "--manual", print_page, "Print the manual page of a command, or of pellucid, for man")
      ->trigger_on_parse()
      ->type_name("COMMAND");
}

}  // namespace pellucid::app
