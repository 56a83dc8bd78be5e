// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/read_given.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "compare/methods/given_method.h"

namespace pellucid::compare {
namespace {

constexpr double most = 1e15;                    // of any cost
constexpr double longest = 30.0 * 24 * 60 * 60;  // a command's month, seconds

std::string read_name(const JsonNode& node, const Catalogue& catalogue) {
  std::string name = node.string();
  const auto is_odd = [](char c) {
    return c == ':' || std::iscntrl(static_cast<unsigned char>(c));
  };
  if (name.empty() || std::ranges::any_of(name, is_odd))
    node.fail(fmt::format("'{}'; accepted: a name without ':'", name));
  for (const scene::MethodRow& row : catalogue.rows)
    if (row.name == name)
      node.fail(
          fmt::format("'{}' is a {} of the program; accepted: another name", name, catalogue.kind));
  return name;
}

/// {NAME} stands for something; of no other name is there a file.
void refuse_unknown_marks(const JsonNode& node, std::initializer_list<std::string_view> known) {
  const std::string text = node.string();
  for (std::size_t at = 0; (at = text.find('{', at)) != text.npos; ++at) {
    const std::size_t end = text.find('}', at);
    if (end == text.npos) return;
    const std::string name = text.substr(at + 1, end - at - 1);
    if (std::ranges::find(known, name) == known.end())
      node.fail(fmt::format("'{}': nothing is known as {{{}}}; accepted: {{{}}}", text, name,
                            fmt::join(known, "}, {")));
  }
}

MethodCall read_command(const JsonNode& node, const std::filesystem::path& base,
                        const Catalogue& catalogue) {
  node.accept_keys({"external", "command", "timeout", "output"});
  ExternalCommand command{.name = read_name(node["external"], catalogue), .words = {}};
  for (const JsonNode& word : node["command"].elements()) command.words.push_back(word.string());
  constexpr double least = 1e-3;
  if (node.has("timeout")) command.timeout = node["timeout"].number(least, longest);
  if (node.has("output")) command.ending = '.' + node["output"].one_of({"exr", "png"});
  command.base = base;
  return at_place(node["command"], [&] { return external_call(command); });
}

MethodCall read_picture(const JsonNode& node, const std::filesystem::path& base,
                        const Catalogue& catalogue) {
  node.accept_keys({"picture", "name", "ms", "bytes"});
  GivenPicture picture{.name = read_name(node["name"], catalogue),
                       .file = node["picture"].string(),
                       .milliseconds = {},
                       .bytes = {}};
  refuse_unknown_marks(node["picture"], {"scene", "view"});
  if (node.has("ms")) picture.milliseconds = node["ms"].number(0, most);
  if (node.has("bytes")) picture.bytes = node["bytes"].whole(most);
  picture.base = base;
  return picture_call(picture);
}

}  // namespace

bool is_given(const JsonNode& node) {
  return node.is_object() && (node.has("external") || node.has("picture"));
}

MethodCall read_given(const JsonNode& node, const std::filesystem::path& base,
                      const Catalogue& catalogue) {
  return node.has("external") ? read_command(node, base, catalogue)
                              : read_picture(node, base, catalogue);
}

}  // namespace pellucid::compare
