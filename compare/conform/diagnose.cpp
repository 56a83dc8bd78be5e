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
#include "compare/pictures/srgb.h"

namespace pellucid::compare {
namespace {

/// Half an 8-bit step, and what reading it back rounds.
constexpr double half_step = 0.5 / 255 + 1e-6;
/// As many of the wrong pixels have to be explained.
constexpr double most = 0.9;
/// An explanation of a pixel has to leave less than this share of its error: what changes nothing
/// that is seen explains nothing.
constexpr double most_left = 0.5;
/// Of more layers one more or less is not looked for: it would be a guess among too many.
constexpr std::size_t few_layers = 300;
/// What errs by no more looks right, and is in another order by no means.
constexpr double seen = 0.02;

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
      errors_.push_back(error);
      if (error > tolerance_) wrong_.push_back(i);
    }
    verdict_.wrong = wrong_.size();
    verdict_.passed = wrong_.empty();
  }

  Verdict verdict() {
    if (verdict_.passed) return verdict_;
    const bool named = is_nearly_right() || is_background() || is_curve() || is_8_bits() ||
                       is_of_few_digits() || is_missed() || is_capped() || is_doubled() ||
                       is_clamped() || is_of_the_picture() || is_misordered();
    if (!named)
      name(verdict_.max_error <= seen ? Fault::precision : Fault::other,
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
    return difference(color, picture_.pixels[pixel]) <=
           std::min(tolerance, most_left * errors_[pixel]);
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

  bool is_over(const Vec3& color) {
    const auto over = [&](std::size_t i) {
      return is(i, composite_of(layers(i), color), 4 * tolerance_);
    };
    if (!explains(over)) return false;
    return name(Fault::background,
                fmt::format("({:.3g}, {:.3g}, {:.3g}) shows through, not ({:.3g}, {:.3g}, {:.3g})",
                            color.r, color.g, color.b, behind().r, behind().g, behind().b));
  }

  /// Mostly it is black or white; else the colour behind is that of the pixel through which most of
  /// it shows, where others, through which less does, can confirm it.
  bool is_background() {
    if (is_over(Vec3(0)) || is_over(Vec3(1))) return true;
    const auto left = [&](std::size_t i) { return 1 - composite_of(layers(i), behind()).a; };
    const std::size_t clearest = *std::ranges::max_element(wrong_, {}, left);
    constexpr double enough = 0.02;  // to tell the colour by
    if (left(clearest) < enough) return false;
    const glm::dvec4 own = composite_of(layers(clearest), Vec3(0));
    const Vec3 color = (Vec3(picture_.pixels[clearest]) - Vec3(own)) / left(clearest);
    const Vec3 possible = glm::clamp(color, Vec3(0), Vec3(1));
    if (glm::any(
            glm::greaterThan(glm::abs(color - possible), Vec3(4 * tolerance_ / left(clearest)))))
      return false;
    const bool shows = std::ranges::any_of(
        wrong_, [&](std::size_t i) { return i != clearest && left(i) < left(clearest) - enough; });
    return (shows || left(clearest) > 0.999) && is_over(possible);
  }

  /// Linear values shown as sRGB ones, or the other way round.
  bool is_curve() {
    const auto through = [&](double (*curve)(double)) {
      return is_composite(
          [curve](const Layers& all, const Vec3& background) {
            const glm::dvec4 right = composite_of(all, background);
            return glm::dvec4(curve(right.r), curve(right.g), curve(right.b), right.a);
          },
          2 * tolerance_);
    };
    if (through(encoded_as_srgb<double>)) return name(Fault::picture, "encoded as sRGB");
    if (through(decoded_from_srgb<double>)) return name(Fault::picture, "decoded from sRGB");
    return false;
  }

  /// Whether what is wrong is n/255 all over: what errs by as little may be in half floats.
  bool has_8_bit_values() const {
    constexpr float near = 0.01f;  // of a step
    return std::ranges::all_of(wrong_, [&](std::size_t i) {
      const glm::vec3 steps = 255.f * glm::vec3(picture_.pixels[i]);
      return glm::all(glm::lessThan(glm::abs(steps - glm::round(steps)), glm::vec3(near)));
    });
  }

  /// A Way is how a renderer may lose digits; of some it takes several layers to see.
  struct Way {
    Composite composite;
    const char* what;
    bool takes_several;
  };

  bool is_one_of(std::string_view fault, std::initializer_list<Way> ways, double slack) {
    const bool has_steps =
        std::ranges::any_of(wrong_, [&](std::size_t i) { return layers(i).size() > 1; });
    return std::ranges::any_of(ways, [&](const Way& way) {
      return (has_steps || !way.takes_several) && is_composite(way.composite, slack) &&
             name(fault, way.what);
    });
  }

  /// A renderer may round otherwise by half a step at each of its last steps.
  bool is_8_bits() {
    if (verdict_.max_error <= 2 * half_step && has_8_bit_values())
      return name(Fault::eight_bits, "the result is rounded to 8 bits");
    const auto rounding = [](auto way, Halfway halfway) {
      return [=](const Layers& all, const Vec3& color) { return way(all, color, halfway); };
    };
    for (const double slack : {half_step, 3 * half_step})
      for (const Halfway halfway : {Halfway::down, Halfway::up})
        if (is_one_of(
                Fault::eight_bits,
                {{rounding(blended_in_8_bits, halfway), "every blending is rounded to 8 bits",
                  true},
                 {rounding(accumulated_in_8_bits, halfway),
                  "colour and opacity are summed up in 8 bits", true},
                 {rounding(stored_in_8_bits, halfway), "fragments are kept in 8 bits", false},
                 {rounding(opacities_in_8_bits, halfway), "opacities are kept in 8 bits", false}},
                slack))
          return true;
    return false;
  }

  bool is_of_few_digits() {
    constexpr double step = 0x1p-11;  // of a half float below 1
    return is_one_of(Fault::precision,
                     {{rounded_to_halves, "the result is rounded to half floats", false},
                      {blended_in_halves, "every blending is rounded to half floats", true},
                      {stored_in_halves, "fragments are kept in half floats", false}},
                     tolerance_ + step);
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

  /// Whether it is as if one of the layers, or each, counted up to `most_times`: an edge or vertex
  /// is often met once for each triangle that it belongs to.
  bool counts_again(std::size_t pixel) const {
    constexpr std::size_t most_times = 6, few = 20;
    const Layers& all = layers(pixel);
    for (std::size_t more = 1; more < (all.size() <= few ? most_times : 2); ++more) {
      const auto again = [more](Layers layers, std::size_t i) {
        layers.insert(layers.begin() + std::ptrdiff_t(i), more, Layers::value_type(layers[i]));
        return layers;
      };
      Layers each;
      for (const Rgba& layer : all) each.insert(each.end(), more + 1, layer);
      if (is_with_change(pixel, again) || is(pixel, composite_of(each, behind()), 2 * tolerance_))
        return true;
    }
    return false;
  }

  bool is_doubled() {
    const auto without_one = [](Layers all, std::size_t i) {
      all.erase(all.begin() + std::ptrdiff_t(i));
      return all;
    };
    if (explains([&](std::size_t p) { return counts_again(p); }))
      return name(Fault::doubled, fmt::format("a layer counts again in {} pixels", wrong_.size()));
    const auto missed = std::size_t(std::ranges::count_if(
        wrong_, [&](std::size_t p) { return is_with_change(p, without_one); }));
    const bool both =
        explains([&](std::size_t p) { return counts_again(p) || is_with_change(p, without_one); });
    return both && name(Fault::doubled,
                        fmt::format("a layer counts again in {} pixels, and is missing in {}",
                                    wrong_.size() - missed, missed));
  }

  bool is_clamped() {
    for (const float most_opaque : {0.99f, 0.995f, 254.f / 255, 0.999f, 0.9999f})
      if (is_composite(
              [most_opaque](Layers all, const Vec3& background) {
                for (Rgba& layer : all) layer.a = std::min(layer.a, most_opaque);
                return composite_of(all, background);
              },
              2 * tolerance_))
        return name(Fault::other, fmt::format("opacities end at {:.4g}", most_opaque));
    return false;
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
    if (all.size() < 2 || errors_[pixel] <= seen) return false;
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
  std::vector<double> errors_;  // of each pixel
  std::vector<std::size_t> wrong_;
  Verdict verdict_;
};

}  // namespace

Verdict judge(const ConformanceCase& c, const Image& picture, bool stored_in_8_bits,
              double tolerance) {
  return Diagnosis(c, picture, stored_in_8_bits, tolerance).verdict();
}

}  // namespace pellucid::compare
