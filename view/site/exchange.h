// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace pellucid::view {

/// A Question is what a browser asks for. What it left out is empty.
struct Question {
  std::string verb;  // "GET", "POST"
  std::string path;  // decoded, from "/"
  std::string host, origin, content_type;
  std::string body;
};

/// An Answer is what it gets.
struct Answer {
  int status = 200;
  std::string type = "application/json";
  std::string body;
  std::string location = {};  // of a redirection
};

/// Returns the answer that something is wrong: {"error": `what`}, one line.
Answer failure(int status, const std::string& what);

}  // namespace pellucid::view
