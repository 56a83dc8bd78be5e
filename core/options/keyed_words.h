// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "core/vec.h"

namespace pellucid {

/// KeyedWords are the words of each key of a text such as "eye=0,0,5,fov=45": a word with "="
/// begins a key, those without go on with it. They are views into the text.
using KeyedWords = std::map<std::string_view, std::vector<std::string_view>>;

/// Splits such a text. Throws InputError that names `option` for a key that is not known or given
/// twice.
KeyedWords keyed_words(std::string_view option, std::string_view text,
                       std::span<const std::string_view> known);

/// Returns the finite number, or the three, that a key must have. Throws InputError that names
/// `option` and the key.
///@{
double number_of_key(std::string_view option, const KeyedWords& words, std::string_view key);
Vec3 vector_of_key(std::string_view option, const KeyedWords& words, std::string_view key);
///@}

}  // namespace pellucid
