// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/xml_tags.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <utility>

namespace pellucid::readers {
namespace {

bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

std::string decoded(std::string_view text) {
  constexpr std::pair<std::string_view, char> entities[] = {
      {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}};
  std::string plain;
  while (!text.empty()) {
    std::size_t taken = 1;
    char c = text.front();
    for (const auto& [entity, character] : entities)
      if (text.starts_with(entity)) taken = entity.size(), c = character;
    plain += c;
    text.remove_prefix(taken);
  }
  return plain;
}

/// Takes name="value" from the front; false where there is none.
bool take_attribute(std::string_view& text, XmlTag& tag) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) return false;
  std::string_view name = text.substr(0, equals);
  while (!name.empty() && is_space(name.back())) name.remove_suffix(1);
  const std::size_t open = text.find_first_of("\"'", equals);
  if (open == std::string_view::npos) return false;
  const std::size_t close = text.find(text[open], open + 1);
  if (close == std::string_view::npos) return false;
  tag.attributes.emplace(name, decoded(text.substr(open + 1, close - open - 1)));
  text.remove_prefix(close + 1);
  return true;
}

XmlTag tag_of(std::string_view text) {
  XmlTag tag;
  std::size_t end = 0;
  while (end < text.size() && !is_space(text[end]) && text[end] != '/') ++end;
  tag.name = text.substr(0, end);
  text.remove_prefix(end);
  while (take_attribute(text, tag)) continue;
  return tag;
}

/// Where the tag that begins at the front ends: a '>' that stands in no quotes.
std::size_t end_of_tag(std::string_view text) {
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (quote != 0)
      quote = text[i] == quote ? 0 : quote;
    else if (text[i] == '"' || text[i] == '\'')
      quote = text[i];
    else if (text[i] == '>')
      return i;
  }
  return std::string_view::npos;
}

/// Appends the tags of a text; what begins a tag that does not end is left in it.
void take_tags(std::string_view& text, std::vector<XmlTag>& tags) {
  for (std::size_t begin; (begin = text.find('<')) != std::string_view::npos;) {
    text.remove_prefix(begin);
    const bool is_comment = text.starts_with("<!--");
    const std::size_t end = is_comment ? text.find("-->") : end_of_tag(text);
    if (end == std::string_view::npos) return;
    if (std::string_view("!?/").find(text[1]) == std::string_view::npos)
      tags.push_back(tag_of(text.substr(1, end - 1)));
    text.remove_prefix(end);
  }
  text = {};
}

}  // namespace

std::vector<XmlTag> xml_tags(std::string_view text) {
  std::vector<XmlTag> tags;
  take_tags(text, tags);
  return tags;
}

std::vector<XmlTag> xml_tags(const std::filesystem::path& file) {
  constexpr std::size_t most = 1 << 20;
  std::string text(most, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(text.data(), std::streamsize(most));
  text.resize(std::size_t(std::max<std::streamsize>(0, stream.gcount())));
  return xml_tags(std::string_view(text));
}

std::vector<XmlTag> xml_tags_before_data(const std::filesystem::path& file) {
  constexpr std::size_t piece = 1 << 20, longest_tag = 1 << 20;
  std::ifstream stream(file, std::ios::binary);
  std::vector<XmlTag> tags;
  std::string text;  // that began a tag, and what follows
  while (stream && text.size() <= longest_tag) {
    const std::size_t kept = text.size();
    text.resize(kept + piece);
    stream.read(text.data() + kept, std::streamsize(piece));
    text.resize(kept + std::size_t(std::max<std::streamsize>(0, stream.gcount())));
    std::string_view rest = text;
    const std::size_t before = tags.size();
    take_tags(rest, tags);
    const auto data = std::find_if(tags.begin() + std::ptrdiff_t(before), tags.end(),
                                   [](const XmlTag& tag) { return tag.name == "AppendedData"; });
    if (data != tags.end()) {
      tags.erase(data + 1, tags.end());
      break;
    }
    text = std::string(rest);
  }
  return tags;
}

void refuse_attribute(const std::filesystem::path& path, const XmlTag& tag,
                      std::string_view attribute, const std::string& value,
                      const std::string& accepted) {
  throw InputError(fmt::format("{}: not a valid {} file: <{}>: {}=\"{}\"; accepted: {}",
                               path.string(), path.extension().string(), tag.name, attribute, value,
                               accepted));
}

}  // namespace pellucid::readers
