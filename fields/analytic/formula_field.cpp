// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/analytic/formula_field.h"

#include <fmt/format.h>
#include <muParser.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.h"
#include "core/options/option_table.h"
#include "fields/finite.h"

namespace pellucid::fields {
namespace {

/// Formulas over x, y, z and t; empty: missing.
struct FormulaOptions {
  std::string u, v, w;
};

const OptionTable<FormulaOptions>& formula_options() {
  static const OptionTable<FormulaOptions> table{
      text("u", &FormulaOptions::u), text("v", &FormulaOptions::v), text("w", &FormulaOptions::w)};
  return table;
}

constexpr std::array<std::string_view, 3> component_names = {"u", "v", "w"};
using Formulas = std::array<std::string, 3>;

[[noreturn]] void fail(std::string_view component, const std::string& formula, std::size_t column,
                       std::string_view reason) {
  throw InputError(
      fmt::format("formula: {}={}: column {}: {}", component, formula, column, reason));
}

/// muParser lets a formula assign to its variables; a field's coordinates are not to be changed.
void refuse_assignment(std::string_view component, const std::string& formula) {
  const std::string_view comparisons = "=!<>";
  for (std::size_t i = formula.find('='); i != std::string::npos; i = formula.find('=', i + 1)) {
    if (formula[i + 1] == '=')
      ++i;
    else if (i == 0 || comparisons.find(formula[i - 1]) == std::string_view::npos)
      fail(component, formula, i + 1, "'=' assigns; to compare use ==");
  }
}

/// One thread's parsers and the variables that they read.
class Formula {
 public:
  explicit Formula(const Formulas& formulas) {
    for (std::size_t i = 0; i < 3; ++i) prepare(i, formulas[i]);
  }
  Formula(const Formula&) = delete;  // the parsers point at the variables
  Formula& operator=(const Formula&) = delete;

  /// NaN when muParser finds at run time that it cannot.
  Vec3 operator()(const Vec3& x, double t) {
    x_ = x;
    t_ = t;
    try {
      return {parsers_[0].Eval(), parsers_[1].Eval(), parsers_[2].Eval()};
    } catch (const mu::ParserError&) {
      return Vec3(std::numeric_limits<double>::quiet_NaN());
    }
  }

  bool uses_time() const {
    for (const mu::Parser& parser : parsers_)
      if (parser.GetUsedVar().count("t") > 0) return true;
    return false;
  }

 private:
  void prepare(std::size_t i, const std::string& formula) {
    refuse_assignment(component_names[i], formula);
    mu::Parser& parser = parsers_[i];
    parser.DefineVar("x", &x_.x);
    parser.DefineVar("y", &x_.y);
    parser.DefineVar("z", &x_.z);
    parser.DefineVar("t", &t_);
    parser.DefineConst("pi", std::numbers::pi);
    parser.DefineConst("e", std::numbers::e);
    try {
      parser.SetExpr(formula);
      parser.Eval();  // compiles
    } catch (const mu::ParserError& error) {
      const std::size_t column = error.GetPos() < 0 ? formula.size() : error.GetPos() + 1;
      fail(component_names[i], formula, column, error.GetMsg());
    }
  }

  Vec3 x_{0};
  double t_ = 0;
  std::array<mu::Parser, 3> parsers_;
};

/// Balances rounding ε/h against truncation h⁴, where the flow changes over `length`: neither the
/// unit nor the distance from the origin says over what it does. A power of two, so that far from
/// the origin the places that are compared are exactly so far apart.
double difference_step(double x, double length) {
  const double part = std::pow(std::numeric_limits<double>::epsilon(), 0.2);
  const double h = part * std::min(std::max(1.0, std::abs(x)), length);
  return std::ldexp(1.0, std::ilogb(std::max(h, 0x1p-36 * std::abs(x))));
}

/// Fourth-order central difference along an axis.
Vec3 derivative(Formula& formula, const Vec3& x, double t, int axis, double h) {
  const auto at = [&](double offset) {
    Vec3 shifted = x;
    shifted[axis] += offset;
    return formula(shifted, t);
  };
  return (8.0 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
}

/// Beside the edge of where the formula is a number, as of sqrt(z) above 0, over shorter steps.
Vec3 derivative_within(Formula& formula, const Vec3& x, double t, int axis, double length) {
  constexpr int most_shorter = 6;  // to some 1e-9 of the length: rounding is 1e-7 by then
  double h = difference_step(x[axis], length);
  Vec3 slope = derivative(formula, x, t, axis, h);
  for (int i = 0; i < most_shorter && !is_finite(slope); ++i)
    slope = derivative(formula, x, t, axis, h /= 8);
  return slope;
}

class FormulaSampler final : public FieldSampler {
 public:
  explicit FormulaSampler(const Formulas& formulas) : formula_(formulas) {}

  SampleStatus velocity(const Vec3& x, double t, Vec3& v) override {
    v = formula_(x, t);
    return is_finite(v) ? SampleStatus::ok : SampleStatus::not_finite;
  }

  SampleStatus velocity_and_jacobian(const Vec3& x, double t, Vec3& v, Mat3& jacobian) override {
    const SampleStatus status = velocity(x, t, v);
    if (status != SampleStatus::ok) return status;
    for (int axis = 0; axis < 3; ++axis)
      jacobian[axis] = derivative_within(formula_, x, t, axis, length_);
    return is_finite(jacobian) ? status : SampleStatus::not_finite;
  }

  void resolve(double length) override { length_ = length; }

 private:
  Formula formula_;
  double length_ = std::numeric_limits<double>::infinity();  // world units
};

class FormulaField final : public VectorField {
 public:
  explicit FormulaField(Formulas formulas)
      : formulas_(std::move(formulas)), steady_(!Formula(formulas_).uses_time()) {}

  std::unique_ptr<FieldSampler> sampler() const override {
    return std::make_unique<FormulaSampler>(formulas_);
  }
  bool steady() const override { return steady_; }
  std::string description() const override {
    return fmt::format("formula:u={},v={},w={}", formulas_[0], formulas_[1], formulas_[2]);
  }

 private:
  Formulas formulas_;
  bool steady_;
};

}  // namespace

std::unique_ptr<VectorField> make_formula_field(const RawOptions& components) {
  const FormulaOptions given =
      formula_options().read(Parameters("formula", formula_options().specs(), components));
  Formulas formulas{given.u, given.v, given.w};
  for (std::size_t i = 0; i < 3; ++i)
    if (formulas[i].empty())
      throw InputError(
          fmt::format("formula: {}= is missing; expected formula:u=…,v=…,w=… over "
                      "x, y, z, t",
                      component_names[i]));
  return std::make_unique<FormulaField>(std::move(formulas));
}

}  // namespace pellucid::fields
