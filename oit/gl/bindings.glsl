// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BINDINGS
#define BINDINGS
// The units at which shaders find what a pass binds, for GLSL and, through bindings.h, for C++: every
// `layout(binding = …)`, every vertex attribute. No shader and no call has a number of its own, and
// a pass lists what it binds by these names (see pass.h).
//
// Each kind of unit has its own numbers, and no two names that one pass can bind share one. Drivers
// have 8 image units, all that OpenGL promises, so families that never meet in a pass share them:
//
//   image unit         0           1            2            3      4       5           6            7
//   lists              heads       nodes        node colours
//   optical depth      target 0    target 1     target 2
//   k-buffer           depths      colours
//   MLAB               depths      colours                   locks
//   averages of bins   sums        counts                    locks
//   dual peeling       ends        nearest      farthest     locks
//   driver check       head        stores
//   trees of layers                                          trees  layers  links       colours     normals
//   opacity                                                         faces   segments    importance  elements
//
// A picture's passes are those of one of the first seven families: they never meet each other. Trees of
// layers meet lists, opacity meets lists and optical depth; trees meet neither locks nor opacity.
//
// Texture units: OpenGL promises 16 that one stage finds, and 80 in all. Shapes and stage are there in
// every pass and have the first ones; from 10 to 15 are a method's own, and one method's passes never
// meet another's. No stage finds all: a program draws one kind of shapes.

const int image_units = 8;
const int texture_units = 18;
const int textures_of_stage = 16;
const int uniform_blocks = 2;
const int storage_blocks = 2;
const int atomic_counters = 1;

// Images: lists of fragments.
const int heads_image = 0;
const int nodes_image = 1;
const int node_colors_image = 2;
// Optical depth: target i of the coefficients at this + i, three at most.
const int coefficients_image = 0;
// k-buffer.
const int k_depths_image = 0;
const int k_colors_image = 1;
// MLAB.
const int layer_depths_image = 0;
const int layer_sums_image = 1;
// Averages of bins.
const int bin_sums_image = 0;
const int bin_counts_image = 1;
// Dual peeling.
const int ends_image = 0;
const int nearest_layer_image = 1;
const int farthest_layer_image = 2;
// Driver check.
const int checked_head_image = 0;
const int checked_stores_image = 1;
// Locks of pixels.
const int locks_image = 3;
// Trees of layers.
const int trees_image = 3;
const int layers_image = 4;
const int layer_links_image = 5;
const int layer_colors_image = 6;
const int layer_normals_image = 7;
// Opacity.
const int importance_image = 6;
const int element_opacities_image = 7;
const int triangle_elements_image = 4;  // which element a face is a part of
const int segment_elements_image = 5;

// Textures: shapes.
const int points_texture = 0;
const int point_importances_texture = 1;
const int element_opacities_texture = 2;
const int solids_texture = 7;
const int solid_points_texture = 8;
const int solid_overlaps_texture = 9;
const int isosurface_pieces_texture = 16;
const int isosurface_numbers_texture = 17;
// Stage: what is opaque.
const int opaque_picture_texture = 5;
const int opaque_keys_texture = 6;
// The first of a method's own. Methods outside of oit/ name theirs by it: own_texture + 1.
const int own_texture = 10;
// Optical depth.
const int coefficients_texture = 10;
const int color_sums_texture = 11;
// Weighted sums, averages and blending.
const int weighted_sums_texture = 10;
const int fragment_count_texture = 11;
const int weighted_transmittance_texture = 12;
// Averages of bins.
const int gathered_bins_texture = 10;
// k-buffer.
const int tail_texture = 10;
const int tail_transmittance_texture = 11;
// Depth peeling.
const int peeled_keys_texture = 10;
const int nearest_depth_texture = 11;
const int peeled_layer_texture = 12;
const int peeled_layer_key_texture = 13;
const int peeled_sum_texture = 14;
// Dual peeling.
const int left_keys_texture = 10;
const int ends_texture = 11;
const int nearest_layer_texture = 12;
const int farthest_layer_texture = 13;
const int front_sum_texture = 14;
const int back_sum_texture = 15;
// Stochastic transparency.
const int sample_texture = 10;
const int sample_sum_texture = 11;
const int sample_average_texture = 12;
const int sample_transmittance_texture = 13;

// Uniform blocks.
const int view_block = 0;
const int energy_block = 1;

// Storage blocks.
const int longest_storage = 0;
const int unfinished_storage = 1;

// Atomic counters. OpenGL promises one; the lists, the trees and the driver check count in passes of
// their own.
const int node_counter = 0;
const int layer_counter = 0;
const int checked_counter = 0;

// Attributes of vertices, …
const int position_attribute = 0;
const int color_attribute = 1;
const int direction_attribute = 2;
const int importance_attribute = 3;
const int opacity_attribute = 4;
// … and the buffers that they come from.
const int vertices_buffer = 0;
const int directions_buffer = 1;
const int importances_buffer = 2;
const int opacities_buffer = 3;
#endif
