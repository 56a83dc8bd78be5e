// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/conform/diagnose.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "compare/conform/wrong_composites.h"
#include "compare/pictures/given_faults.h"

namespace pellucid::compare {
namespace {

/// Half an 8-bit step, and what reading it back rounds.
constexpr double half_step = 0.5 / 255 + 1e-6;
/// As many of the wrong pixels have to be explained.
constexpr double most = 0.9;
/// Of more layers one more or less is not looked for: it would be a guess among too many.
constexpr std::size_t few_layers = 300;

double difference(const glm::dvec4& a, const Rgba& b) {
  const Vec3 off = glm::abs(Vec3(a) - Vec3(b));
  return std::max({off.r, off.g, off.b});
}

class Diagnosis {
 public:
  Diagnosis(const ConformanceCase& c, const Image& picture, bool stored_in_8_bits, double tolerance)
      : case_(c),
        picture_(picture),
        stored_in_8_bits_(stored_in_8_bits),
        tolerance_(tolerance + (stored_in_8_bits ? half_step : 0)) {
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
      const double error =
          difference(composite_of(c.of_pixel(i), c.scene.background), picture.pixels[i]);
      verdict_.max_error = std::max(verdict_.max_error, error);
      if (error > tolerance_) wrong_.push_back(i);
    }
    verdict_.wrong = wrong_.size();
    verdict_.passed = wrong_.empty();
  }

  Verdict verdict() {
    if (verdict_.passed) return verdict_;
    if (!is_nearly_right() && !is_background() && !is_8_bits() && !is_missed() && !is_capped() &&
        !is_doubled() && !is_misordered() && !is_of_the_picture())
      name(Fault::other,
           fmt::format("{} pixels, by {:.2g} at most", verdict_.wrong, verdict_.max_error));
    return verdict_;
  }

 private:
  using Composite = std::function<glm::dvec4(const Layers&, const Vec3&)>;

  bool name(std::string_view fault, std::string explanation) {
    verdict_.fault = fault;
    verdict_.explanation = std::move(explanation);
    return true;
  }

  /// Whether a test of pixels holds for nearly all that are wrong.
  template <class Holds>
  bool explains(const Holds& holds) const {
    const auto explained = std::count_if(wrong_.begin(), wrong_.end(), holds);
    return double(explained) >= most * double(wrong_.size());
  }

  const Layers& layers(std::size_t pixel) const { return case_.of_pixel(pixel); }
  const Vec3& behind() const { return case_.scene.background; }

  bool is(std::size_t pixel, const glm::dvec4& color, double tolerance) const {
    return difference(color, picture_.pixels[pixel]) <= tolerance;
  }
  bool is_composite(const Composite& composite, double tolerance) const {
    return explains(
        [&](std::size_t i) { return is(i, composite(layers(i), behind()), tolerance); });
  }

  /// Of a picture that holds no more digits other explanations would be guesses.
  bool is_nearly_right() {
    if (!stored_in_8_bits_ || verdict_.max_error > 4 * half_step) return false;
    return name(Fault::eight_bits,
                fmt::format("right to {:.1f} of an 8-bit step", 255 * verdict_.max_error));
  }

  /// The colour behind is that of the pixel through which most of it shows.
  bool is_background() {
    const auto left = [&](std::size_t i) { return 1 - composite_of(layers(i), behind()).a; };
    const std::size_t clearest = *std::ranges::max_element(wrong_, {}, left);
    constexpr double enough = 0.02;  // to tell the colour by
    if (left(clearest) < enough) return false;
    const glm::dvec4 own = composite_of(layers(clearest), Vec3(0));
    const Vec3 color = (Vec3(picture_.pixels[clearest]) - Vec3(own)) / left(clearest);
    if (glm::any(glm::lessThan(color, Vec3(-1e-3))) ||
        glm::any(glm::greaterThan(color, Vec3(1.001))))
      return false;
    const bool shows = std::ranges::any_of(
        wrong_, [&](std::size_t i) { return i != clearest && left(i) < left(clearest) - enough; });
    const bool known =
        color == Vec3(0) || glm::length(color) < 1e-3 || shows || left(clearest) > 0.999;
    if (!known || !explains([&](std::size_t i) {
          return is(i, composite_of(layers(i), color), 4 * tolerance_);
        }))
      return false;
    return name(Fault::background,
                fmt::format("({:.3g}, {:.3g}, {:.3g}) shows through, not ({:.3g}, {:.3g}, {:.3g})",
                            color.r, color.g, color.b, behind().r, behind().g, behind().b));
  }

  /// Whether what is wrong is n/255 all over: what errs by as little may be in half floats.
  bool has_8_bit_values() const {
    constexpr float near = 0.01f;  // of a step
    return std::ranges::all_of(wrong_, [&](std::size_t i) {
      const glm::vec3 steps = 255.f * glm::vec3(picture_.pixels[i]);
      return glm::all(glm::lessThan(glm::abs(steps - glm::round(steps)), glm::vec3(near)));
    });
  }

  /// A renderer may round otherwise by half a step at each of its last steps.
  bool is_8_bits() {
    constexpr double most_slack = 3 * half_step;
    if (verdict_.max_error <= 2 * half_step)
      return has_8_bit_values() && name(Fault::eight_bits, "the result is rounded to 8 bits");
    const struct {
      Composite composite;
      const char* what;
    } ways[] = {{blended_in_8_bits, "every blending is rounded to 8 bits"},
                {accumulated_in_8_bits, "colour and opacity are summed up in 8 bits"},
                {stored_in_8_bits, "fragments are kept in 8 bits"}};
    const bool has_steps =
        std::ranges::any_of(wrong_, [&](std::size_t i) { return layers(i).size() > 1; });
    for (const double slack : {half_step, most_slack})
      for (const auto& way : ways)
        if (has_steps && verdict_.max_error > 2 * slack && is_composite(way.composite, slack))
          return name(Fault::eight_bits, way.what);
    return false;
  }

  /// The nearest or the farthest k of the layers.
  static Layers some(const Layers& all, std::size_t k, bool nearest) {
    const auto count = std::ptrdiff_t(std::min(k, all.size()));
    return nearest ? Layers(all.begin(), all.begin() + count)
                   : Layers(all.end() - count, all.end());
  }

  /// Every k for which that is the pixel's colour.
  std::vector<std::size_t> caps_of(std::size_t pixel, bool nearest) const {
    const Layers& all = layers(pixel);
    std::vector<std::size_t> fit;
    glm::dvec4 sum = nearest ? glm::dvec4(0) : glm::dvec4(behind(), 0);
    for (std::size_t k = 1; k < all.size(); ++k) {
      const Rgba& layer = nearest ? all[k - 1] : all[all.size() - k];
      const double alpha = double(layer.a);
      const glm::dvec4 opaque(Vec3(layer), 1);
      sum = nearest ? sum + (1 - sum.a) * alpha * opaque : glm::mix(sum, opaque, alpha);
      const Vec3 color = nearest ? Vec3(sum) + (1 - sum.a) * behind() : Vec3(sum);
      if (is(pixel, {color, 0}, 2 * tolerance_)) fit.push_back(k);
    }
    return fit;
  }

  bool is_capped() {
    constexpr std::size_t most_tried = 8;
    const std::size_t deepest =
        *std::ranges::max_element(wrong_, {}, [&](std::size_t i) { return layers(i).size(); });
    if (layers(deepest).size() <= 2) return false;
    for (const bool nearest : {true, false}) {
      std::vector<std::size_t> caps = caps_of(deepest, nearest);
      caps.resize(std::min(caps.size(), most_tried));
      for (const std::size_t k : caps)
        if (is_composite(
                [&](const Layers& all, const Vec3& background) {
                  return composite_of(some(all, k, nearest), background);
                },
                2 * tolerance_))
          return name(Fault::capped,
                      fmt::format("only the {} {} layers", nearest ? "nearest" : "farthest", k));
    }
    return false;
  }

  /// Whether the pixel is that of `changed(layers, i)` for one of its layers i.
  template <class Changed>
  bool is_with_change(std::size_t pixel, const Changed& changed) const {
    const Layers& all = layers(pixel);
    if (all.size() > few_layers) return false;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Layers layers = changed(all, i);
      if (layers.size() != all.size() && is(pixel, composite_of(layers, behind()), 2 * tolerance_))
        return true;
    }
    return false;
  }

  bool is_missed() {
    const auto one = [](Layers all, std::size_t i) {
      all.erase(all.begin() + std::ptrdiff_t(i));
      return all;
    };
    const auto but_one_of_equals = [](const Layers& all, std::size_t i) {
      Layers left;
      for (std::size_t k = 0; k < all.size(); ++k)
        if (k == i || all[k] != all[i]) left.push_back(all[k]);
      return left;
    };
    if (explains([&](std::size_t p) { return is(p, composite_of({}, behind()), 2 * tolerance_); }))
      return name(Fault::missed, "all layers are missing");
    if (explains([&](std::size_t p) { return is_with_change(p, one); }))
      return name(Fault::missed, fmt::format("a layer is missing in {} pixels", wrong_.size()));
    if (explains([&](std::size_t p) { return is_with_change(p, but_one_of_equals); }))
      return name(Fault::missed, "of equal layers one is left");
    return false;
  }

  bool is_doubled() {
    const auto twice = [](Layers all, std::size_t i) {
      all.insert(all.begin() + std::ptrdiff_t(i), all[i]);
      return all;
    };
    if (!explains([&](std::size_t p) { return is_with_change(p, twice); })) return false;
    return name(Fault::doubled, fmt::format("a layer counts twice in {} pixels", wrong_.size()));
  }

  /// Of a few layers any other order is tried.
  bool is_permuted(std::size_t pixel) const {
    constexpr std::size_t few = 6;
    const Layers& all = layers(pixel);
    if (all.size() > few) return false;
    std::vector<std::size_t> order(all.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    while (std::ranges::next_permutation(order).found) {
      Layers permuted;
      for (const std::size_t i : order) permuted.push_back(all[i]);
      if (is(pixel, composite_of(permuted, behind()), 2 * tolerance_)) return true;
    }
    return false;
  }

  /// Every order of layers, and their mean, leaves the same of the background: between the darkest
  /// and the brightest layer over it a colour is one of layers that are there.
  bool is_mixed(std::size_t pixel) const {
    const Layers& all = layers(pixel);
    if (all.size() < 2) return false;
    const double left = 1 - composite_of(all, behind()).a;
    Vec3 low(1), high(0);
    for (const Rgba& layer : all) {
      low = glm::min(low, Vec3(layer));
      high = glm::max(high, Vec3(layer));
    }
    const Vec3 color = Vec3(picture_.pixels[pixel]) - left * behind();
    return glm::all(glm::greaterThanEqual(color, (1 - left) * low - tolerance_)) &&
           glm::all(glm::lessThanEqual(color, (1 - left) * high + tolerance_));
  }

  bool is_misordered() {
    const double slack = 2 * tolerance_;
    const auto backwards = [](const Layers& all, const Vec3& background) {
      return composite_of(Layers(all.rbegin(), all.rend()), background);
    };
    if (is_composite(backwards, slack))
      return name(Fault::misordered, "the farthest layer is taken for the nearest");
    if (is_composite(averaged, slack))
      return name(Fault::misordered, "no order: the mean colour of all layers");
    if (is_composite(averaged_with_opacity, slack))
      return name(Fault::misordered, "no order: mean colour and mean opacity of all layers");
    if (is_composite(summed, slack))
      return name(Fault::misordered, "no order: the sum of all layers");
    if (explains([&](std::size_t p) { return is_permuted(p); }))
      return name(Fault::misordered, "layers in another order");
    if (explains([&](std::size_t p) { return is_mixed(p); }))
      return name(Fault::misordered, "all layers, in another order or in none");
    return false;
  }

  /// In a picture of one colour anything might be seen.
  bool is_of_the_picture() {
    if (case_.layers.size() < 2) return false;
    const auto faults = given_faults(expected_picture(case_), picture_, behind());
    if (faults.empty()) return false;
    return name(Fault::picture, fmt::format("{}", fmt::join(faults, "; ")));
  }

  const ConformanceCase& case_;
  const Image& picture_;
  bool stored_in_8_bits_;
  double tolerance_;
  std::vector<std::size_t> wrong_;
  Verdict verdict_;
};

}  // namespace

Verdict judge(const ConformanceCase& c, const Image& picture, bool stored_in_8_bits,
              double tolerance) {
  return Diagnosis(c, picture, stored_in_8_bits, tolerance).verdict();
}

}  // namespace pellucid::compare
