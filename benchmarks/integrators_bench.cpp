// SPDX-License-Identifier: GPL-3.0-or-later
// Integral surfaces, on one thread: triangles per second of processor time, and that time against
// the field evaluations' alone: the very places that a run asks for are recorded, and asked for
// once more in the same order.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ctime>

#include "benchmarks/field_samples.h"
#include "integrators/lines/integrate_lines.h"
#include "tests/integrators/closed_forms.h"

namespace {

using namespace pellucid;
using namespace pellucid::benchmarks;

/// Processor time of all threads: the machine may be shared.
double cpu_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

struct Request {
  Vec3 x;
  double t;
  bool jacobian;
};

/// A field that writes down what it is asked; for one thread.
class RecordedField final : public fields::VectorField {
 public:
  explicit RecordedField(const fields::VectorField& field) : field_(field) {}

  std::unique_ptr<fields::FieldSampler> sampler() const override {
    return std::make_unique<Sampler>(field_.sampler(), requests_);
  }
  Box3 domain() const override { return field_.domain(); }
  bool steady() const override { return field_.steady(); }
  std::optional<double> cell_size() const override { return field_.cell_size(); }
  std::optional<double> sampling_error() const override { return field_.sampling_error(); }
  bool fills_domain() const override { return field_.fills_domain(); }
  std::string description() const override { return field_.description(); }

  const std::vector<Request>& requests() const { return requests_; }

 private:
  class Sampler final : public fields::FieldSampler {
   public:
    Sampler(std::unique_ptr<fields::FieldSampler> sampler, std::vector<Request>& requests)
        : sampler_(std::move(sampler)), requests_(requests) {}
    fields::SampleStatus velocity(const Vec3& x, double t, Vec3& v) override {
      requests_.push_back({x, t, false});
      return sampler_->velocity(x, t, v);
    }
    fields::SampleStatus velocity_and_jacobian(const Vec3& x, double t, Vec3& v,
                                               Mat3& jacobian) override {
      requests_.push_back({x, t, true});
      return sampler_->velocity_and_jacobian(x, t, v, jacobian);
    }

   private:
    std::unique_ptr<fields::FieldSampler> sampler_;
    std::vector<Request>& requests_;
  };

  const fields::VectorField& field_;
  mutable std::vector<Request> requests_;
};

/// Processor time of the field evaluations of a run by themselves: the median of five.
double evaluation_seconds(const fields::VectorField& field, const std::vector<Request>& requests) {
  const auto sampler = field.sampler();
  std::array<double, 5> seconds;
  for (double& each : seconds) {
    const double begin = cpu_seconds();
    for (const Request& request : requests) {
      Vec3 v;
      Mat3 jacobian;
      if (request.jacobian)
        sampler->velocity_and_jacobian(request.x, request.t, v, jacobian);
      else
        sampler->velocity(request.x, request.t, v);
      benchmark::DoNotOptimize(v);
      benchmark::DoNotOptimize(jacobian);
    }
    each = cpu_seconds() - begin;
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}

void report_surface(benchmark::State& state, const integrators::IntegratedSurface& surface,
                    double evaluation_seconds, double seconds) {
  const double triangles = double(surface.mesh.triangles.size());
  const double each = seconds / double(state.iterations());
  state.counters["triangles"] = triangles;
  state.counters["evaluations"] = double(surface.stats.evaluations);
  state.counters["triangles/s"] = triangles / each;
  state.counters["time/evaluations"] = each / evaluation_seconds;
  state.counters["mesh_ns/triangle"] = 1e9 * (each - evaluation_seconds) / triangles;
}

/// Runs it again and again, and once more to see what its field evaluations take by themselves.
integrators::IntegratedSurface time_surface(benchmark::State& state,
                                            integrators::SurfaceRequest request,
                                            const std::string& integrator) {
  integrators::IntegratedSurface surface;
  const double begin = cpu_seconds();
  for (auto _ : state) surface = integrators::integrate_surface(integrator, request);
  const double seconds = cpu_seconds() - begin;
  const fields::VectorField& field = *request.field;
  const RecordedField recorded(field);
  request.field = &recorded;
  integrators::integrate_surface(integrator, request);
  report_surface(state, surface, evaluation_seconds(field, recorded.requests()), seconds);
  return surface;
}

void abc_lines(benchmark::State& state) {
  const auto field = fields::make_field("abc");
  integrators::LineRequest request;
  request.field = field.get();
  request.seeds =
      integrators::seeds_on(integrators::segment_seed({2.64, 3.14, 3.14}, {3.64, 3.14, 3.14}), 65);
  request.duration = 12;
  std::size_t vertices = 0;
  for (auto _ : state)
    vertices =
        integrators::integrate_lines("stream-lines:step=0.05", request).lines.positions.size();
  state.counters["vertices"] = double(vertices);
}

/// The same surface of the same flow by three kinds of field whose evaluations cost differently.
std::unique_ptr<fields::VectorField> abc_field(const std::string& kind) {
  if (kind == "formula")
    return fields::make_field(
        "formula:u=sqrt(3)*sin(z)+cos(y),v=sqrt(2)*sin(x)+sqrt(3)*cos(z),w=sin(y)+sqrt(2)*cos(x)");
  auto abc = fields::make_field("abc");
  return kind == "samples" ? sampled(*abc, {Vec3(1, -14, 0), Vec3(9, 4, 6)}, 128) : std::move(abc);
}

void abc_surface(benchmark::State& state, const std::string& kind, const std::string& integrator) {
  const auto field = abc_field(kind);
  const Vec3 seed(2.64, 3.14, 3.14);
  time_surface(
      state, {field.get(), integrators::segment_seed(seed, seed + Vec3(1, 0, 0)), 7, 0, false, {}},
      integrator);
}

template <class Function, class... Arguments>
void add(const std::string& name, Function function, Arguments... arguments) {
  benchmark::RegisterBenchmark(name.c_str(), function, arguments...)
      ->MeasureProcessCPUTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv) {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  for (const char* integrator : {"hultquist:threshold=0.05", "hultquist:threshold=0.01",
                                 "hultquist:tolerance=1e-4", "fixed-front:particles=1000,rows=400",
                                 "adaptive-front:threshold=0.05", "adaptive-front:tolerance=1e-3"})
    add(fmt::format("abc/closed form/{}", integrator), abc_surface, std::string("closed form"),
        std::string(integrator));
  for (const char* kind : {"samples", "formula"})
    add(fmt::format("abc/{}/hultquist:tolerance=1e-3", kind), abc_surface, std::string(kind),
        std::string("hultquist:tolerance=1e-3"));
  add("abc/65 stream lines of length 12", abc_lines);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
