// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace pellucid::readers {

/// An XmlTag is a start tag of an XML text: its name and attributes, entities replaced.
struct XmlTag {
  std::string name;
  std::map<std::string, std::string, std::less<>> attributes;
};

/// Returns the start tags of a text in their order; comments, declarations and end tags are left
/// out. What is no XML has none, or some that are wrong: the caller checks what they say.
std::vector<XmlTag> xml_tags(std::string_view text);

/// The same of the first MiB of a file: a list of other files is no longer.
std::vector<XmlTag> xml_tags(const std::filesystem::path& file);

/// The same of a file of any length up to its appended data, whose bytes may look like tags. The
/// texts between the tags are not kept.
std::vector<XmlTag> xml_tags_before_data(const std::filesystem::path& file);

/// Throws InputError for an attribute's value that is not what is `accepted`; it names the file.
[[noreturn]] void refuse_attribute(const std::filesystem::path& path, const XmlTag& tag,
                                   std::string_view attribute, const std::string& value,
                                   const std::string& accepted);

}  // namespace pellucid::readers
