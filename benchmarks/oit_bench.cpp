// SPDX-License-Identifier: GPL-3.0-or-later
// Each order-independent method against the sum of its bare passes: the same passes over the same
// scene into the same render targets, with shaders that write constants. Both are timed in turn in
// one run; `ratio` is what counts, since the times are those of whatever driver there is.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/machine/stopwatch.h"
#include "core/options/names.h"
#include "fields/make_field.h"
#include "oit/gl/bindings.h"
#include "oit/registry.h"
#include "oit/stage/stage.h"

namespace pellucid {
namespace {

struct Sheets {
  int layers, size;      // of the picture: pixels each way
  unsigned cells = 100;  // each way, of two triangles
};

/// Wavy sheets over the whole picture, in an order of no meaning.
scene::Scene wavy_sheets(const Sheets& sheets) {
  const auto [layers, size, cells] = sheets;
  scene::Scene scene;
  scene.width = scene.height = size;
  scene.camera.fov = 25;
  for (int i = 0; i < layers; ++i) {
    const int place = i * 7919 % layers;
    geometry::TriangleMesh mesh;
    for (unsigned v = 0; v <= cells; ++v)
      for (unsigned u = 0; u <= cells; ++u) {
        const double x = 2.6 * u / cells - 1.3, y = 2.6 * v / cells - 1.3;
        const double wave = 0.2 * std::sin(5 * x + place) * std::cos(4 * y - place);
        mesh.positions.emplace_back(x, y, 1 - 2.0 * place / layers + wave);
        mesh.colors.emplace_back(float(place) / float(layers), 0.5f, 0.3f,
                                 std::min(0.9f, 2.0f / float(layers)));
      }
    for (unsigned v = 0; v < cells; ++v)
      for (unsigned u = 0; u < cells; ++u) {
        const unsigned a = v * (cells + 1) + u, b = a + cells + 1;
        mesh.triangles.push_back({a, a + 1, b + 1});
        mesh.triangles.push_back({a, b + 1, b});
      }
    scene.objects.push_back({"sheet", std::move(mesh)});
  }
  return scene;
}

/// One pass with a shader that writes constants.
struct BarePass {
  bool over_geometry;
  std::vector<GLenum> targets;  // formats
  std::string shader;
  oit::Blend last_blend =
      oit::Blend::add;  // of the last target; the others of a pass over geometry add up
};

std::string write_constants(int targets) {
  return "layout(location = 0) out vec4 c[" + std::to_string(targets) +
         "];\nvoid main() { for (int i = 0; i < " + std::to_string(targets) +
         "; ++i) c[i] = vec4(0.1); }\n";
}

BarePass geometry_into(std::vector<GLenum> targets) {
  const int count = int(targets.size());
  return {true, std::move(targets), write_constants(count)};
}

// The last target holds a product of transmittances.
BarePass geometry_into_transmittance(std::vector<GLenum> targets) {
  BarePass pass = geometry_into(std::move(targets));
  pass.last_blend = oit::Blend::transmit;
  return pass;
}

BarePass picture() { return {false, {GL_RGBA32F}, write_constants(1)}; }

// What storing a node of a list takes: one count, one exchange, two stores.
constexpr const char* store_node = R"(
#include "oit/lists/fragment_list.glsl"
layout(binding = node_counter) uniform atomic_uint count;
void main() {
  int node = int(atomicCounterIncrement(count)) + 1;
  imageAtomicExchange(heads, ivec2(gl_FragCoord.xy), uint(node));
  imageStore(nodes, node, uvec4(1u));
  imageStore(colors, node, vec4(0.1));
}
)";

// And fetching it: every node of the pool once, in the order of memory.
constexpr const char* load_nodes = R"(
#include "oit/lists/fragment_list.glsl"
layout(location = 0) out vec4 c;
uniform int layers, width;
void main() {
  int first = (int(gl_FragCoord.y) * width + int(gl_FragCoord.x)) * layers;
  c = vec4(0.0);
  for (int i = 0; i < layers; ++i)
    c += imageLoad(colors, first + i) * float(imageLoad(nodes, first + i).x);
}
)";

struct Case {
  const char* method;
  std::vector<BarePass> passes;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> table = {
      {"weighted-sum", {geometry_into({GL_RGBA32F}), picture()}},
      {"weighted-average", {geometry_into({GL_RGBA32F, GL_R32F}), picture()}},
      {"weighted-blended", {geometry_into_transmittance({GL_RGBA32F, GL_R32F}), picture()}},
      {"fourier:bands=2",
       {geometry_into({GL_RGBA32F, GL_RGBA32F}), geometry_into({GL_RGBA32F}), picture()}},
      {"fourier:bands=5",
       {geometry_into({GL_RGBA32F, GL_RGBA32F, GL_RGBA32F}), geometry_into({GL_RGBA32F}),
        picture()}},
      {"moment", {geometry_into({GL_R32F, GL_RGBA32F}), geometry_into({GL_RGBA32F}), picture()}},
      {"linked-list",
       {{true, {}, "void main() {}\n"},
        {true, {}, store_node},
        {false, {GL_RGBA32F}, load_nodes}}}};
  return table;
}

/// The bare passes of a case, ready to be drawn.
class BareRenderer {
 public:
  BareRenderer(const scene::Scene& scene, const Case& what, int layers)
      : stage_(scene, {}),
        heads_(stage_.gl(), GL_R32UI, scene.width, scene.height),
        nodes_(stage_.gl(), GL_RGBA32UI, 16 * (stage_.pixel_count() * layers + 1)),
        colors_(stage_.gl(), GL_RGBA32F, 16 * (stage_.pixel_count() * layers + 1)),
        counter_(stage_.gl(), 4) {
    for (const BarePass& pass : what.passes) add(pass, layers);
  }

  double seconds() {
    stage_.make_current();
    counter_.clear(0);
    const Stopwatch watch;
    for (const Pass& pass : passes_) draw(pass);
    return watch.seconds();
  }

 private:
  struct Pass {
    bool over_geometry;
    oit::Blend last_blend;
    std::vector<oit::Texture> targets;
    std::vector<oit::Framebuffer> framebuffers;  // one
    oit::GeometryProgram geometry;
    oit::Program screen;
  };

  void add(const BarePass& bare, int layers) {
    Pass pass;
    pass.over_geometry = bare.over_geometry;
    pass.last_blend = bare.last_blend;
    for (const GLenum format : bare.targets)
      pass.targets.emplace_back(stage_.gl(), format, stage_.width(), stage_.height());
    const auto& t = pass.targets;
    const oit::Gl& gl = stage_.gl();
    if (t.empty()) pass.framebuffers.emplace_back(gl, stage_.width(), stage_.height());
    if (t.size() == 1) pass.framebuffers.push_back({gl, {{t[0]}}});
    if (t.size() == 2) pass.framebuffers.push_back({gl, {{t[0]}, {t[1]}}});
    if (t.size() == 3) pass.framebuffers.push_back({gl, {{t[0]}, {t[1]}, {t[2]}}});
    if (pass.over_geometry) {
      pass.geometry = stage_.geometry_program(bare.shader);
    } else {
      pass.screen = stage_.screen_program(bare.shader);
      pass.screen.set_if_used("layers", layers);
      pass.screen.set_if_used("width", stage_.width());
    }
    passes_.push_back(std::move(pass));
  }

  oit::Resources lists() const {
    return {heads_.as_image(oit::bindings::heads_image),
            nodes_.as_image(oit::bindings::nodes_image),
            colors_.as_image(oit::bindings::node_colors_image),
            counter_.as_atomic_counter(oit::bindings::node_counter)};
  }

  void draw(const Pass& pass) const {
    const oit::Framebuffer& target = pass.framebuffers[0];
    target.clear_all(0);
    const oit::Blend blend = pass.over_geometry ? oit::Blend::add : oit::Blend::replace;
    const oit::Blend last = target.attachments() > 1 ? pass.last_blend : blend;
    const oit::Pass drawn(target, {blend, last}, lists());
    pass.over_geometry ? stage_.draw_geometry(drawn, pass.geometry)
                       : stage_.draw_screen(drawn, pass.screen);
    stage_.gl().Finish();
  }

  oit::Stage stage_;
  oit::Texture heads_;
  oit::BufferTexture nodes_, colors_;
  oit::Buffer counter_;
  std::vector<Pass> passes_;
};

void against_bare_passes(benchmark::State& state, const Case& what, int layers, int size) {
  const scene::Scene scene = wavy_sheets({layers, size});
  const NameAndOptions call = parse_name_and_options(what.method);
  const scene::MethodRow& row = find_row("method", call.name, oit::oit_methods());
  const auto method = row.make(scene, Parameters(row.name, row.parameters, call.options), {});
  BareRenderer bare(scene, what, layers);
  method->render({});
  bare.seconds();
  double method_seconds = 0, bare_seconds = 0;
  for (auto _ : state) {
    const double seconds = method->render({}).stats.seconds();
    bare_seconds += bare.seconds();
    method_seconds += seconds;
    state.SetIterationTime(seconds);
  }
  state.counters["bare_ms"] = 1e3 * bare_seconds / double(state.iterations());
  state.counters["ratio"] = method_seconds / bare_seconds;
}

/// Time of a method over the number of layers, for the curve of cost.
void over_layers(benchmark::State& state, const scene::MethodRow& row, const Sheets& sheets) {
  const scene::Scene scene = wavy_sheets(sheets);
  const auto method = row.make(scene, Parameters(row.name, row.parameters, {}), {});
  const std::uint64_t bytes = method->render({}).stats.total_bytes();
  for (auto _ : state) state.SetIterationTime(method->render({}).stats.seconds());
  state.counters["ns_per_fragment"] = benchmark::Counter(
      double(sheets.layers) * sheets.size * sheets.size * 1e-9,
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["MB"] = 1e-6 * double(bytes);
}

/// A stream surface of the ABC flow, drawn by lines alone.
scene::Scene stream_surface() {
  scene::Scene scene;
  scene.camera = {.eye = {27, 11, 4}, .target = {2.5, 3.3, 3}, .fov = 36};
  scene::SceneObject object;
  scene::FlowSource& source = object.source.emplace();
  source.field = fields::make_field("abc");
  source.seed = integrators::segment_seed({3.1, 3.1, 0.1}, {3.1, 3.1, 6.1});
  source.duration = 9;
  object.mesh().positions = {Vec3(-8), Vec3(14)};  // the depth range
  scene.objects.push_back(std::move(object));
  return scene;
}

/// Frames per second of the progressive tree at so many lines per frame.
void tree_frames(benchmark::State& state) {
  const scene::Scene scene = stream_surface();
  const scene::MethodRow& row = find_row("method", "tree", oit::oit_methods());
  const RawOptions options = {{"lines-per-frame", std::to_string(state.range(0))}, {"frames", "5"}};
  const auto tree = row.make(scene, Parameters(row.name, row.parameters, options), {});
  tree->render({});
  for (auto _ : state) state.SetIterationTime(tree->render({}).stats.seconds());
  state.counters["frames"] = benchmark::Counter(5, benchmark::Counter::kIsIterationInvariantRate);
}

void register_all() {
  benchmark::RegisterBenchmark("tree/lines_per_frame", tree_frames)
      ->Arg(100)
      ->Arg(1000)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);

  for (const Case& what : cases())
    for (const auto& [layers, size] : {std::pair(8, 1000), {32, 500}})
      benchmark::RegisterBenchmark(
          (std::string("bare/") + what.method + "/layers:" + std::to_string(layers)).c_str(),
          [&what, layers = layers, size = size](benchmark::State& state) {
            against_bare_passes(state, what, layers, size);
          })
          ->UseManualTime()
          ->Unit(benchmark::kMillisecond);
  // Lists of three lengths with as many fragments each, and a pool of 1.4 GB; few triangles, so
  // that fragments are what takes the time.
  for (const auto& [layers, size] : {std::pair(8, 1000), {64, 354}, {500, 126}, {45, 1000}})
    benchmark::RegisterBenchmark(("lists/layers:" + std::to_string(layers)).c_str(),
                                 [layers = layers, size = size](benchmark::State& state) {
                                   over_layers(
                                       state, find_row("method", "linked-list", oit::oit_methods()),
                                       {layers, size, 10});
                                 })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  for (const scene::MethodRow& row : oit::oit_methods())
    benchmark::RegisterBenchmark(("layers/" + std::string(row.name)).c_str(),
                                 [&row](benchmark::State& state) {
                                   over_layers(state, row, {int(state.range(0)), 250});
                                 })
        ->RangeMultiplier(4)
        ->Range(1, 256)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace pellucid

int main(int argc, char** argv) {
  pellucid::register_all();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
