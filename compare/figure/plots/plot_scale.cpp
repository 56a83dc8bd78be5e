// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/figure/plots/plot_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pellucid::compare {
namespace {

constexpr double rail_length = 14;  // points
constexpr double beyond = 0.04;     // of a logarithmic axis, on either side
constexpr double least_decades = 0.5;
constexpr double wanted_ticks = 5;

/// The next of 1, 2 and 5 times a power of ten.
double round_step(double step) {
  const double power = std::pow(10, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (step <= factor * power * (1 + 1e-9)) return factor * power;
  return 10 * power;
}

std::string with_minus(std::string text) {
  if (text.starts_with('-')) text.replace(0, 1, "−");
  return text;
}

}  // namespace

std::vector<TextRun> tick_label(double number) {
  if (number == 0) return {{"0"}};
  const double size = std::abs(number);
  const int exponent = int(std::floor(std::log10(size) + 1e-9));
  if (exponent >= -3 && exponent < 5) return {{with_minus(fmt::format("{:.6g}", number))}};
  const double mantissa = number / std::pow(10, exponent);
  const std::string power = with_minus(fmt::format("{}", exponent));
  if (std::abs(mantissa - 1) < 1e-9) return {{"10"}, {power, false, true}};
  return {{with_minus(fmt::format("{:.4g}", mantissa)) + "·10"}, {power, false, true}};
}

PlotScale::PlotScale(std::vector<double> numbers, const PlotAxis& axis, double length)
    : axis_(axis), length_(length) {
  std::erase_if(numbers, [](double number) { return !std::isfinite(number); });
  choose_domain(std::move(numbers));
  if (rail_ > 0) {
    std::vector<TextRun> label = tick_label(axis_.least);
    if (axis_.least > 0) label.front().text.insert(0, "≤ ");
    ticks_.push_back({rail_ / 2, std::move(label)});
  }
  if (!axis_.logarithmic)
    add_steps(round_step((high_ - low_) / wanted_ticks));
  else
    add_decades();
}

double PlotScale::measure(double number) const {
  return axis_.logarithmic ? std::log10(number) : number;
}

void PlotScale::choose_domain(std::vector<double> numbers) {
  if (axis_.logarithmic) {
    const auto is_low = [this](double number) { return number <= axis_.least; };
    if (std::erase_if(numbers, is_low) > 0) rail_ = rail_length;
  }
  if (numbers.empty()) numbers = {1};
  const auto [least, most] = std::ranges::minmax(numbers);
  low_ = measure(least);
  high_ = measure(most);
  if (axis_.logarithmic) {
    const double missing = std::max(0.0, least_decades - (high_ - low_)) / 2;
    const double margin = std::max(missing, beyond * (high_ - low_));
    low_ -= margin;
    high_ += margin;
    return;
  }
  if (low_ == high_) low_ = std::min(0.0, 2 * low_), high_ = std::max({0.0, 2 * high_, low_ + 1});
  const double step = round_step((high_ - low_) / wanted_ticks);
  low_ = step * std::floor(low_ / step + 1e-9);
  high_ = step * std::ceil(high_ / step - 1e-9);
}

double PlotScale::at(double number) const {
  if (axis_.logarithmic && number <= axis_.least) return rail_ / 2;
  return rail_ + (length_ - rail_) * (measure(number) - low_) / (high_ - low_);
}

void PlotScale::add(double number, std::vector<TextRun> label) {
  ticks_.push_back({at(number), std::move(label)});
}

void PlotScale::add_steps(double step) {
  for (double i = std::ceil(low_ / step - 1e-9); i * step <= high_ + 1e-9 * step; ++i)
    add(i * step, tick_label(i * step));
}

/// Of few decades multiples by 2 and 5 are ticks, too; of many every second or third is.
void PlotScale::add_decades() {
  const int first = int(std::ceil(low_ - 1e-9)), last = int(std::floor(high_ + 1e-9));
  const int every = std::max(1, int(std::ceil((last - first) / (2 * wanted_ticks))));
  const bool few = high_ - low_ < 2.5;
  for (int power = int(std::floor(low_)); power <= last; power += few ? 1 : every)
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double number = factor * std::pow(10.0, power), place = std::log10(number);
      if ((factor == 1 || few) && place >= low_ - 1e-9 && place <= high_ + 1e-9)
        add(number, tick_label(number));
    }
}

}  // namespace pellucid::compare
