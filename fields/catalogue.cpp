#include "fields/catalogue.h"

#include "fields/analytic_field.h"
#include "fields/flows/abc.h"
#include "fields/flows/rotation.h"
#include "fields/flows/saddle.h"
#include "fields/flows/shear.h"
#include "fields/flows/tornado.h"

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
    row<flow::Abc>(),    row<flow::Tornado>(), row<flow::Rotation>(),
    row<flow::Saddle>(), row<flow::Shear>(),
};

}  // namespace

std::span<const FieldRow> analytic_fields() { return rows; }

}  // namespace pellucid
