// SPDX-License-Identifier: GPL-3.0-or-later
// The tree of a pixel's layers, compiled as C++ from the text that the shaders run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace glsl {

using namespace glm;
#include "oit/lists/layer_tree.glsl"

namespace {

/// What the shaders keep in images. Layer 0 stands for none.
struct Memory {
  std::vector<Layer> layers{Layer{}};
  std::vector<uint> next{0}, extra{0};
} memory;

}  // namespace

Layer load_layer(uint id) { return memory.layers[id]; }
void store_layer(uint id, Layer layer) { memory.layers[id] = layer; }
uint load_next(uint id) { return memory.next[id]; }
void store_next(uint id, uint next) { memory.next[id] = next; }
uint load_order(uint id) { return memory.extra[id]; }

}  // namespace glsl

namespace pellucid::oit::test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// The tree of one pixel.
struct PixelTree {
  explicit PixelTree(float epsilon) : epsilon2(epsilon * epsilon) { glsl::memory = {}; }

  void add(float depth, bool crossing = false, glm::uint order = 0) {
    const glsl::Entry entry{depth, crossing, order};
    const glsl::Place place = glsl::find_place(tree, entry, epsilon2, first_met);
    longest = std::max(longest, place.steps);
    too_deep += place.too_deep;
    if (place.too_deep) return;
    if (place.nearest != 0) return merge(place.nearest, depth);
    const auto id = glm::uint(glsl::memory.layers.size());
    glsl::memory.layers.emplace_back();
    glsl::memory.next.push_back(0);
    glsl::memory.extra.push_back(crossing ? order : 1);
    tree = glsl::insert_layer(tree, entry, place, id);
  }

  void merge(glm::uint id, float depth) {
    const glm::uint n = ++glsl::memory.extra[id];
    glsl::memory.layers[id].depth = glsl::running_mean(glsl::memory.layers[id].depth, depth, n);
  }

  /// Layers from front to back, along the links.
  std::vector<glm::uint> in_order() const {
    std::vector<glm::uint> ids;
    for (glm::uint id = tree.first; id != 0; id = glsl::memory.next[id]) ids.push_back(id);
    return ids;
  }
  std::vector<float> depths() const {
    std::vector<float> result;
    for (const glm::uint id : in_order()) result.push_back(glsl::memory.layers[id].depth);
    return result;
  }

  glsl::Tree tree{0, 0};
  float epsilon2;
  bool first_met = false;
  int longest = 0;   // search path
  int too_deep = 0;  // fragments that found no place
};

std::vector<float> random_depths(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(0, 1);
  std::vector<float> depths(n);
  for (float& d : depths) d = unit(random);
  return depths;
}

/// Search order by the children, for comparison with the links.
void visit(glm::uint id, std::vector<glm::uint>& ids) {
  if (id == 0) return;
  const glsl::Layer layer = glsl::load_layer(id);
  visit(layer.left, ids);
  ids.push_back(id);
  visit(layer.right, ids);
}

// Epsilon 0 merges nothing, not even equal depths: every fragment is a layer.
TEST(UnitLayerTree, EpsilonZeroSorts) {
  std::vector<float> depths = random_depths(1000, 1);
  depths.insert(depths.end(), 10, depths[0]);
  PixelTree pixel(0);
  for (const float d : depths) pixel.add(d);
  std::sort(depths.begin(), depths.end());
  EXPECT_EQ(pixel.depths(), depths);
}

TEST(UnitLayerTree, EpsilonInfiniteIsOneLayerAtTheMean) {
  PixelTree pixel(infinity);
  const std::vector<float> depths = random_depths(1000, 2);
  double sum = 0;
  for (const float d : depths) pixel.add(d), sum += d;
  ASSERT_EQ(pixel.in_order().size(), 1u);
  // Each of the 1000 updates of the mean rounds it once.
  EXPECT_NEAR(pixel.depths()[0], sum / 1000, 1000 * 6e-8);
}

TEST(UnitLayerTree, LinksAreTheOrderOfTheTree) {
  PixelTree pixel(1e-3f);
  for (const float d : random_depths(3000, 3)) pixel.add(d);
  std::vector<glm::uint> ids;
  visit(pixel.tree.root, ids);
  EXPECT_EQ(pixel.in_order(), ids);
  EXPECT_GT(ids.size(), 300u);
  EXPECT_LT(ids.size(), 1000u);
}

/// Algorithm 2 of Tian and Guenther with the stack of its Fig. 3: a node is blended when it has no
/// unvisited left child, then its right child follows.
std::vector<glm::uint> by_stack(glm::uint root) {
  std::vector<glm::uint> blended, stack;
  for (glm::uint id = root; id != 0 || !stack.empty();) {
    for (; id != 0; id = glsl::load_layer(id).left) stack.push_back(id);
    blended.push_back(stack.back());
    id = glsl::load_layer(stack.back()).right;
    stack.pop_back();
  }
  return blended;
}

/// Front-to-back blending of layers whose opacity and grey follow from their number.
std::pair<float, float> blend(const std::vector<glm::uint>& ids) {
  float grey = 0, transmittance = 1;
  for (const glm::uint id : ids) {
    const float alpha = 0.2f + 0.6f * glsl::uniform_number(id);
    grey += transmittance * alpha * glsl::uniform_number(id + 77);
    transmittance *= 1 - alpha;
  }
  return {grey, transmittance};
}

// To the last bit, after any number of fragments: the links are no second opinion of the order.
TEST(PropertyLayerTree, TheStackOfAlgorithm2AndTheLinksBlendOnePicture) {
  for (const bool first_met : {false, true})
    for (const float epsilon : {0.f, 1e-3f, 0.1f})
      for (const int n : {1, 2, 7, 100, 2000}) {
        PixelTree pixel(epsilon);
        pixel.first_met = first_met;
        for (const float d : random_depths(n, 50 + unsigned(n))) pixel.add(d);
        EXPECT_EQ(pixel.in_order(), by_stack(pixel.tree.root)) << n << ' ' << epsilon;
        EXPECT_EQ(blend(pixel.in_order()), blend(by_stack(pixel.tree.root))) << n << ' ' << epsilon;
      }
}

// Noise of less than half of epsilon around well separated depths, in any order.
TEST(UnitLayerTree, FindsTheLayersOfNoisyFragments) {
  PixelTree pixel(1e-3f);
  std::mt19937 random(4);
  std::uniform_real_distribution<float> noise(-4e-4f, 4e-4f);
  std::vector<float> fragments;
  for (int i = 0; i < 20 * 200; ++i) fragments.push_back(0.05f * float(i % 20) + noise(random));
  std::shuffle(fragments.begin(), fragments.end(), random);
  for (const float d : fragments) pixel.add(d);
  const std::vector<float> depths = pixel.depths();
  ASSERT_EQ(depths.size(), 20u);
  // Five standard errors of the mean of 200 uniform numbers.
  for (int k = 0; k < 20; ++k)
    EXPECT_NEAR(depths[k], 0.05f * float(k), 5 * 4e-4 / std::sqrt(3 * 200)) << k;
}

// Sorted input makes a list of an unbalanced tree. The expected path of a treap is 2 ln n; three
// times that is beyond any luck (Seidel and Aragon 1996: the probability falls with n^-6).
TEST(UnitLayerTree, SortedInputKeepsPathsShort) {
  constexpr int n = 100'000;
  for (const bool ascending : {true, false}) {
    PixelTree pixel(0);
    for (int i = 0; i < n; ++i) pixel.add(float(ascending ? i : n - i) / n);
    EXPECT_LT(pixel.longest, 6 * std::log(n)) << ascending;
    const std::vector<float> depths = pixel.depths();
    EXPECT_EQ(depths.size(), std::size_t(n));
    EXPECT_TRUE(std::is_sorted(depths.begin(), depths.end()));
  }
}

TEST(UnitLayerTree, CrossingsAreMergedWithNothing) {
  PixelTree pixel(infinity);
  pixel.add(0.5f, true, 7);
  pixel.add(0.6f);
  pixel.add(0.5f, true, 3);
  pixel.add(0.7f);
  pixel.add(0.5f, true, 5);
  // The two fragments of lines are one layer; crossings of equal depth are ordered.
  ASSERT_EQ(pixel.in_order().size(), 4u);
  std::vector<glm::uint> orders;
  for (const glm::uint id : pixel.in_order())
    if (glsl::is_crossing(glsl::load_layer(id))) orders.push_back(glsl::load_order(id));
  EXPECT_EQ(orders, (std::vector<glm::uint>{3, 5, 7}));
}

/// Algorithm 1 of Tian and Guenther in the paper's words, with its two slips mended: every fragment
/// of the list is traversed, once, and Diff, which is squared, is held against the square.
struct Algorithm1 {
  struct Node {
    float depth;
    int count = 1;
    std::unique_ptr<Node> left, right;
  };
  using Layers = std::vector<std::pair<float, int>>;  // depth, fragments

  void traverse(float frag, std::unique_ptr<Node>& node) {
    if (!node) {
      node = std::make_unique<Node>(Node{frag, 1, nullptr, nullptr});
    } else if ((frag - node->depth) * (frag - node->depth) < epsilon2) {
      node->count += 1;
      node->depth += (frag - node->depth) / float(node->count);
    } else {
      traverse(frag, frag < node->depth ? node->left : node->right);
    }
  }
  /// The order in which Algorithm 2 blends.
  void visit(const std::unique_ptr<Node>& node, Layers& layers) const {
    if (!node) return;
    visit(node->left, layers);
    layers.emplace_back(node->depth, node->count);
    visit(node->right, layers);
  }
  Layers layers() const {
    Layers all;
    visit(root, all);
    return all;
  }

  float epsilon2;
  std::unique_ptr<Node> root = nullptr;
};

/// The layers of a tree that are not crossings.
Algorithm1::Layers merged_layers(const PixelTree& pixel) {
  Algorithm1::Layers all;
  for (const glm::uint id : pixel.in_order())
    if (const glsl::Layer layer = glsl::load_layer(id); !glsl::is_crossing(layer))
      all.emplace_back(layer.depth, int(glsl::memory.extra[id]));
  return all;
}

// To the last bit, also where means have passed each other and searches go astray.
TEST(AgreementLayerTree, TheFirstMetIsThatOfAlgorithm1) {
  for (unsigned seed = 0; seed < 300; ++seed)
    for (const int n : {3, 10, 300})
      for (const float epsilon : {0.02f, 0.1f, 0.4f}) {
        PixelTree pixel(epsilon);
        pixel.first_met = true;
        Algorithm1 published{pixel.epsilon2};
        for (const float d : random_depths(n, 1000 + seed)) {
          pixel.add(d);
          published.traverse(d, published.root);
        }
        ASSERT_EQ(merged_layers(pixel), published.layers()) << seed << ' ' << n << ' ' << epsilon;
      }
}

// Crossings, of which the algorithm knows nothing, change nothing of what is merged beside them.
TEST(PropertyLayerTree, CrossingsDoNotChangeWhatIsMetFirst) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    PixelTree pixel(0.1f);
    pixel.first_met = true;
    Algorithm1 published{pixel.epsilon2};
    std::mt19937 random(seed);
    glm::uint crossings = 0;
    for (const float d : random_depths(300, 2000 + seed)) {
      const bool crossing = random() % 2 == 0;
      pixel.add(d, crossing, crossing ? ++crossings : 0);
      if (!crossing) published.traverse(d, published.root);
    }
    ASSERT_EQ(merged_layers(pixel), published.layers()) << seed;
    ASSERT_EQ(pixel.in_order().size(), crossings + published.layers().size()) << seed;
  }
}

// Sorted layers make a list of Algorithm 1's tree, whose last ones find no place; crossings do not.
TEST(UnitLayerTree, PathsOfAlgorithm1EndAtTheirBound) {
  constexpr int n = glsl::longest_path + 1;  // the last one hangs below that many
  PixelTree pixel(0);
  pixel.first_met = true;
  for (int i = 0; i < n + 10; ++i) pixel.add(float(i));
  EXPECT_EQ(pixel.in_order().size(), std::size_t(n));
  EXPECT_EQ(pixel.too_deep, 10);
  PixelTree crossings(0);
  crossings.first_met = true;
  for (int i = 0; i < 10 * n; ++i) crossings.add(float(i), true, glm::uint(i));
  EXPECT_EQ(crossings.in_order().size(), std::size_t(10 * n));
  EXPECT_LT(crossings.longest, 6 * std::log(10 * n));
}

/// Trees of fragments at random depths, few epsilons apart, whose layers do not lie in order.
int trees_out_of_order(bool first_met) {
  int count = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    PixelTree pixel(0.1f);
    pixel.first_met = first_met;
    for (const float d : random_depths(300, 100 + seed)) pixel.add(d);
    const std::vector<float> depths = pixel.depths();
    count += !std::is_sorted(depths.begin(), depths.end());
  }
  return count;
}

// The running mean breaks the order of Algorithm 1's tree, not that of one that merges into the
// nearest layer.
TEST(UnitLayerTree, MergingIntoTheNearestKeepsTheOrder) {
  EXPECT_EQ(trees_out_of_order(false), 0);
  EXPECT_GT(trees_out_of_order(true), 0);
}

TEST(UnitLayerTree, TheNearestLayerTakesAFragment) {
  for (const bool near_first : {true, false}) {
    PixelTree pixel(0.1f);
    pixel.add(near_first ? 0.40f : 0.55f);
    pixel.add(near_first ? 0.55f : 0.40f);
    pixel.add(0.48f);  // within 0.1 of both
    const std::vector<float> depths = pixel.depths();
    ASSERT_EQ(depths.size(), 2u);
    EXPECT_FLOAT_EQ(depths[0], 0.40f);
    EXPECT_FLOAT_EQ(depths[1], 0.515f);
  }
}

}  // namespace
}  // namespace pellucid::oit::test
