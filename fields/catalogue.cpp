#include "fields/catalogue.h"

#include "fields/analytic_field.h"
#include "fields/flows/abc.h"
#include "fields/flows/benzene.h"
#include "fields/flows/delta_wing.h"
#include "fields/flows/double_gyre.h"
#include "fields/flows/drift.h"
#include "fields/flows/hill.h"
#include "fields/flows/kelvin_helmholtz.h"
#include "fields/flows/pulsing_saddle.h"
#include "fields/flows/rotation.h"
#include "fields/flows/rotor_wake.h"
#include "fields/flows/saddle.h"
#include "fields/flows/shear.h"
#include "fields/flows/shed_wake.h"
#include "fields/flows/sphere.h"
#include "fields/flows/step.h"
#include "fields/flows/tornado.h"
#include "fields/flows/trefoil.h"

namespace pellucid {
namespace {

template <class Flow>
std::unique_ptr<VectorField> make(const Parameters& parameters) {
  return std::make_unique<AnalyticField<Flow>>(parameters);
}

template <class Flow>
constexpr FieldRow row() {
  return {Flow::facts, Flow::parameters, make<Flow>};
}

constexpr FieldRow rows[] = {
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

}  // namespace

std::span<const FieldRow> analytic_fields() { return rows; }

}  // namespace pellucid
