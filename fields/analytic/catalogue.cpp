// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/analytic/catalogue.h"

#include "fields/analytic/analytic_field.h"
#include "fields/analytic/flows/abc.h"
#include "fields/analytic/flows/benzene.h"
#include "fields/analytic/flows/delta_wing.h"
#include "fields/analytic/flows/double_gyre.h"
#include "fields/analytic/flows/drift.h"
#include "fields/analytic/flows/hill.h"
#include "fields/analytic/flows/kelvin_helmholtz.h"
#include "fields/analytic/flows/pulsing_saddle.h"
#include "fields/analytic/flows/rotation.h"
#include "fields/analytic/flows/rotor_wake.h"
#include "fields/analytic/flows/saddle.h"
#include "fields/analytic/flows/shear.h"
#include "fields/analytic/flows/shed_wake.h"
#include "fields/analytic/flows/sphere.h"
#include "fields/analytic/flows/step.h"
#include "fields/analytic/flows/tornado.h"
#include "fields/analytic/flows/trefoil.h"

namespace pellucid::fields {
namespace {

template <class Flow>
std::unique_ptr<VectorField> make(const Parameters& parameters) {
  return std::make_unique<AnalyticField<Flow>>(parameters);
}

template <class Flow>
FieldRow row() {
  return {Flow::facts, Flow::options().specs(), make<Flow>};
}

}  // namespace

std::span<const FieldRow> analytic_fields() {
  static const FieldRow rows[] = {
      row<flow::Abc>(),
      row<flow::Tornado>(),
      row<flow::DoubleGyre>(),
      row<flow::Hill>(),
      row<flow::Trefoil>(),
      row<flow::Benzene>(),
      row<flow::KelvinHelmholtz>(),
      row<flow::DeltaWing>(),
      row<flow::RotorWake>(),
      row<flow::Step>(),
      row<flow::Sphere>(),
      row<flow::ShedWake>(),
      row<flow::Rotation>(),
      row<flow::Saddle>(),
      row<flow::Shear>(),
      row<flow::Drift>(),
      row<flow::PulsingSaddle>(),
  };
  return rows;
}

}  // namespace pellucid::fields
