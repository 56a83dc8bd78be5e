// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// PELLUCID_WIDEST before a function makes a version of it for each width of vectors; each machine
// runs the widest that it has. No version contracts or reorders, so all give the same bits.
// Sanitizers cannot start a resolver that they instrument.

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define PELLUCID_WIDEST __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define PELLUCID_WIDEST
#endif
