// SPDX-License-Identifier: GPL-3.0-or-later
// How near a pixel's nearest fragment is, from a sum over its fragments, for GLSL and, through GLM,
// for C++. d in [0, 1].
//
// Of terms that fall by a factor of 2^226 over d a sum of n is between its largest one and n times
// that: the least d is found up to log2(n) / 226, and never found farther than it is. Like all sums
// it adds up over parts of a scene. A float holds the terms, and 10^8 of the largest one.
float nearness(float d) { return exp2(100.0f - 226.0f * d); }

// The least d of the terms, or somewhat less.
float nearest_depth(float sum) { return clamp((100.0f - log2(sum)) / 226.0f, 0.0f, 1.0f); }
