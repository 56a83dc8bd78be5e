#include "oit/methods/fourier.h"

#include <optional>

#include "oit/optical_depth_passes.h"
#include "oit_glsl.h"

namespace pellucid {
namespace {

// Two bands to a target, band 0 included.
int target_count(int bands) { return (bands + 2) / 2; }

// OpenGL promises 8 colour attachments: 15 bands in one pass.
constexpr int targets_per_pass = 8;

/// A pass that projects onto some of the bands.
struct BandPass {
  Framebuffer targets;
  GeometryProgram program;
};

class Fourier final : public OitMethod {
 public:
  Fourier(Stage& stage, const Parameters& parameters)
      : stage_(stage),
        bands_(parameters.integer("bands")),
        passes_(stage,
                {{"Fourier coefficients", coefficient_format(parameters), target_count(bands_)}},
                geometry_program(oit_glsl::fourier_weight_frag_glsl(), parameters),
                stage.screen_program(oit_glsl::fourier_composite_frag_glsl(),
                                     {{"NORMALIZE", parameters.flag("normalize")}})) {
    if (parameters.integer("subset") > 1)
      subset_ = stage.geometry().every(std::uint32_t(parameters.integer("subset")));
    for (int first = 0; first < target_count(bands_); first += targets_per_pass)
      band_passes_.push_back(band_pass(first, parameters));
  }

  void draw(Frame& frame) override {
    frame.step("project", [&] {
      for (const BandPass& pass : band_passes_) {
        passes_.begin_sum(pass.targets);
        subset_ ? stage_.draw_geometry(pass.program, *subset_) : stage_.draw_geometry(pass.program);
      }
    });
    passes_.weight_and_composite(frame);
  }

 private:
  static GLenum coefficient_format(const Parameters& parameters) {
    return parameters.text("precision") == "16" ? GL_RGBA16F : GL_RGBA32F;
  }

  BandPass band_pass(int first, const Parameters& parameters) const {
    const int targets = std::min(targets_per_pass, target_count(bands_) - first);
    return {{stage_.gl(), {{passes_.coefficients(0), targets, first}}},
            geometry_program(oit_glsl::fourier_project_frag_glsl(), parameters,
                             {{"FIRST_BAND", 2 * first}, {"TARGETS", targets}})};
  }

  GeometryProgram geometry_program(std::string_view fragment, const Parameters& parameters,
                                   Defines defines = {}) const {
    defines.emplace_back("BANDS", bands_);
    defines.emplace_back("PRECISION", parameters.integer("precision"));
    defines.emplace_back("MIDDLE", parameters.text("at") == "middle");
    defines.emplace_back("SUBSET", parameters.integer("subset"));
    GeometryProgram program =
        clamped_geometry_program(stage_, fragment, std::move(defines), parameters);
    program.set("margin", float(parameters.real("margin")));
    return program;
  }

  const Stage& stage_;
  int bands_;
  OpticalDepthPasses passes_;
  std::optional<Subset> subset_;
  std::vector<BandPass> band_passes_;
};

constexpr ParameterSpec parameters[] = {
    {.name = "bands",
     .kind = ParameterSpec::Kind::integer,
     .default_value = "5",
     .min = 1,
     .max = 64,
     .unit = "bands",
     .help =
         "frequencies of the series (m in the paper); beyond 15 each 16 more take another pass"},
    normalize_parameter,
    clamp_parameter,
    {.name = "at",
     .kind = ParameterSpec::Kind::choice,
     .default_value = "behind",
     .choices = "behind|middle",
     .help = "where the series is taken to be at a fragment: behind it as in Eq. 15, or in the "
             "middle of its step, whither a series converges"},
    {.name = "margin",
     .kind = ParameterSpec::Kind::real,
     .default_value = "0",
     .min = 0,
     .max = 1,
     .unit = "depth ranges",
     .help = "what the series' period exceeds the depth range by on either side; at 0 the nearest "
             "and the farthest depth are one and the same to it"},
    {.name = "precision",
     .kind = ParameterSpec::Kind::choice,
     .default_value = "32",
     .unit = "bits",
     .choices = "32|16",
     .help = "of a coefficient"},
    {.name = "subset",
     .kind = ParameterSpec::Kind::integer,
     .default_value = "1",
     .min = 1,
     .max = 1e6,
     .unit = "primitives",
     .help = "project every n-th triangle, segment and point only, n-fold (section 5.5.3)"}};

}  // namespace

const MethodRow& fourier_method() {
  static constexpr MethodRow row{
      .name = "fourier",
      .title = "Fourier",
      .citation =
          "Baeza Rojo, Gross and Guenther 2019, Fourier opacity optimization for scalable "
          "exploration, TVCG",
      .equations = "14 to 19",
      .parameters = parameters,
      // Sums of n float terms in another order differ by n roundings at most; the exponential of
      // tau makes that n roundings of tau.
      .promises = {.order_spread = 1e-3, .convex_hull = true, .fixed_memory = true},
      .bytes_per_pixel = "precision / 2 ceil((2 bands + 1) / 4) + 16",
      .sweep = "bands=1|2|3|5|8|10|15",
      .make = make_oit<Fourier>};
  return row;
}

}  // namespace pellucid
