// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/study/study.h"
#include "core/files/json_node.h"

namespace pellucid::compare {

// What a study file says of its source and asks of its rows. It names scenes and calls of the
// study, which are read before.

/// Reads {"claim": text, "by": column, "order": [call or [calls], …]} and the other forms of a
/// claim. Throws InputError for calls that the study lacks, for a column in which no way is better,
/// and for keys that say nothing beside each other.
Claim read_claim(const JsonNode& node, const Study& study);

/// Reads {"title": text, "by": column, "bound": X, "scenes": [names]}; "measure" may stand for "by"
/// as in a claim. Throws InputError for scenes that the study lacks.
Ladder read_ladder(const JsonNode& node, const Study& study);

/// Reads an element of `growth`: a size, its scenes, and what grows with it.
Growth read_growth(const JsonNode& node, const Study& study);

/// Reads {"machine": text, "steps": [names], "rows": [{"scene", "method", "ms", "bytes",
/// "steps"}]}: milliseconds and bytes as the source printed them. Throws InputError for scenes and
/// calls that the study lacks.
PublishedCosts read_published(const JsonNode& node, const Study& study);

}  // namespace pellucid::compare
