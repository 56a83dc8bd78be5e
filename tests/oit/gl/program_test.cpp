// SPDX-License-Identifier: GPL-3.0-or-later
// Uniforms by name.
#include <gmock/gmock.h>

#include "core/error.h"
#include "oit/gl/program.h"
#include "oit_glsl.h"

namespace pellucid::oit::test {
namespace {

using ::testing::HasSubstr;

constexpr std::string_view fragment = R"(
uniform float scale;
uniform uint number;
uniform bool flag;
uniform float forgotten;
layout(location = 0) out vec4 color;
void main() { color = vec4(scale, float(number), flag, 1.0); }
)";

struct ProgramOfThree {
  GlContext context{"osmesa"};
  Program program{context, oit_glsl::screen_vert_glsl(), {fragment}, {}};
};

/// What the program draws.
glm::vec4 color_of(const GlContext& context, const Program& program) {
  const Gl& gl = context.gl();
  const Texture texture(gl, GL_RGBA32F, 1, 1);
  const Framebuffer target(gl, {{texture}});
  const VertexArray no_attributes(gl);
  target.bind();
  gl.BindVertexArray(no_attributes.id());
  program.use();
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  glm::vec4 color;
  texture.read(GL_RGBA, GL_FLOAT, sizeof color, &color);
  return color;
}

TEST(UnitProgram, SetsEachUniformByItsName) {
  ProgramOfThree three;
  three.program.set("flag", 1);
  three.program.set("scale", 0.25f);
  three.program.set("number", std::uint32_t(7));
  EXPECT_EQ(color_of(three.context, three.program), glm::vec4(0.25f, 7, 1, 1));
  three.program.set_if_used("number", std::uint32_t(8));
  EXPECT_EQ(color_of(three.context, three.program), glm::vec4(0.25f, 8, 1, 1));
  three.context.check("setting uniforms");
}

TEST(UnitProgram, KeepsItsUniformsWhenItMoves) {
  ProgramOfThree three;
  Program moved = std::move(three.program);
  moved.set("scale", 2.0f);
  EXPECT_EQ(color_of(three.context, moved), glm::vec4(2, 0, 0, 1));
}

TEST(UnitProgram, AUniformThatIsNotThereIsAnError) {
  ProgramOfThree three;
  // One that no shader declares, a prefix and an extension of one, and what stands before a name.
  for (const char* name : {"brightness", "scal", "scale2", "float", ""})
    EXPECT_THROW(three.program.set(name, 1.0f), WorkError) << name;
  three.context.check("setting uniforms");
}

/// Which uniforms change nothing, drivers find out to different depths.
TEST(UnitProgram, AUniformThatIsDeclaredButChangesNothingMayBeSet) {
  ProgramOfThree three;
  EXPECT_NO_THROW(three.program.set("forgotten", 1.0f));
  three.context.check("setting uniforms");
}

TEST(UnitProgram, TheErrorNamesTheUniformAndTheShaders) {
  const GlContext context("osmesa");
  const Program program(context, oit_glsl::screen_vert_glsl(), {oit_glsl::list_merge_frag_glsl()},
                        {});
  EXPECT_NO_THROW(program.set("length_of_runs", 1));
  try {
    program.set("length", 1);
    FAIL() << "nothing was thrown";
  } catch (const WorkError& error) {
    EXPECT_THAT(error.what(), HasSubstr("'length'"));
    EXPECT_THAT(error.what(), HasSubstr("oit/gl/screen.vert.glsl"));
    EXPECT_THAT(error.what(), HasSubstr("oit/lists/list_merge.frag.glsl"));
  }
}

TEST(UnitProgram, AnOptionalUniformMayBeMissing) {
  ProgramOfThree three;
  EXPECT_NO_THROW(three.program.set_if_used("brightness", 1.0f));
  EXPECT_NO_THROW(three.program.set_if_used("forgotten", 1.0f));
  three.context.check("setting uniforms");
}

}  // namespace
}  // namespace pellucid::oit::test
