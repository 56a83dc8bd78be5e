// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/gl/program.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

std::string_view shared_file(std::string_view path) {
  for (const oit_glsl::File& file : oit_glsl::files())
    if (file.path == path) return file.text();
  throw WorkError(fmt::format("a shader includes the unknown file '{}'", path));
}

/// The path of an embedded file's text; of another text there is none.
std::string_view path_of(std::string_view text) {
  for (const oit_glsl::File& file : oit_glsl::files())
    if (file.text().data() == text.data()) return file.path;
  return "a shader of no file";
}

std::string complete(const FragmentText& source, const Defines& defines) {
  std::string text = "#version 450 core\n";
  for (const auto& [name, value] : defines) text += fmt::format("#define {} {}\n", name, value);
  return text + expand_includes(source.body) + expand_includes(source.appended);
}

/// A compiled shader, deleted when the program that it is linked into is made.
class Shader {
 public:
  Shader(const Gl& gl, GLenum stage, const std::string& text)
      : gl_(gl), id_(gl.CreateShader(stage)) {
    const char* begin = text.c_str();
    gl.ShaderSource(id_, 1, &begin, nullptr);
    gl.CompileShader(id_);
    GLint good = 0;
    gl.GetShaderiv(id_, GL_COMPILE_STATUS, &good);
    if (!good) fail();
  }
  ~Shader() { gl_.DeleteShader(id_); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;
  GLuint id() const { return id_; }

 private:
  [[noreturn]] void fail() {
    std::string log(4096, '\0');
    gl_.GetShaderInfoLog(id_, GLsizei(log.size()), nullptr, log.data());
    gl_.DeleteShader(id_);
    throw WorkError(fmt::format("a shader does not compile: {}", log.c_str()));
  }

  const Gl& gl_;
  GLuint id_;
};

void link(const Gl& gl, GLuint program) {
  gl.LinkProgram(program);
  GLint good = 0;
  gl.GetProgramiv(program, GL_LINK_STATUS, &good);
  if (good) return;
  std::string log(4096, '\0');
  gl.GetProgramInfoLog(program, GLsizei(log.size()), nullptr, log.data());
  throw WorkError(fmt::format("a shader program does not link: {}", log.c_str()));
}

/// Appends the name of each line "uniform TYPE NAME…".
void add_declared(std::string_view text, std::vector<std::string>& names) {
  constexpr std::string_view keyword = "uniform ";
  constexpr const char* of_name = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
  for (std::size_t at = 0; (at = text.find(keyword, at)) != text.npos; ++at) {
    if (at > 0 && text[at - 1] != '\n' && text[at - 1] != ' ') continue;
    const std::size_t type = at + keyword.size(), name = text.find(' ', type) + 1;
    names.emplace_back(text.substr(name, text.find_first_not_of(of_name, name) - name));
  }
}

}  // namespace

std::string expand_includes(std::string_view source) {
  constexpr std::string_view directive = "#include \"";
  std::string text;
  for (std::size_t begin = 0; begin < source.size();) {
    const std::size_t end = std::min(source.find('\n', begin), source.size() - 1) + 1;
    const std::string_view line = source.substr(begin, end - begin);
    if (line.starts_with(directive))
      text += expand_includes(
          shared_file(line.substr(directive.size(), line.rfind('"') - directive.size())));
    else
      text += line;
    begin = end;
  }
  return text;
}

Program::Program(const GlContext& context, std::string_view vertex, const FragmentText& fragment,
                 const Defines& defines)
    : gl_(&context.gl()),
      id_(gl_->CreateProgram()),
      vertex_(path_of(vertex)),
      fragment_(path_of(fragment.body)) {
  const std::string vertex_text = complete({vertex}, defines),
                    fragment_text = complete(fragment, defines);
  const Shader vertex_shader(*gl_, GL_VERTEX_SHADER, vertex_text);
  const Shader fragment_shader(*gl_, GL_FRAGMENT_SHADER, fragment_text);
  gl_->AttachShader(id_, vertex_shader.id());
  gl_->AttachShader(id_, fragment_shader.id());
  link(*gl_, id_);
  find_uniforms();
  add_declared(vertex_text, declared_);
  add_declared(fragment_text, declared_);
}

void Program::swap(Program& other) noexcept {
  std::swap(gl_, other.gl_);
  std::swap(id_, other.id_);
  std::swap(vertex_, other.vertex_);
  std::swap(fragment_, other.fragment_);
  std::swap(uniforms_, other.uniforms_);
  std::swap(declared_, other.declared_);
}

void Program::find_uniforms() {
  GLint count = 0;
  gl_->GetProgramiv(id_, GL_ACTIVE_UNIFORMS, &count);
  for (GLuint i = 0; i < GLuint(count); ++i) {
    char name[256];
    GLint size;
    GLenum type;
    gl_->GetActiveUniform(id_, i, sizeof name, nullptr, &size, &type, name);
    // -1: in a block.
    if (const GLint at = gl_->GetUniformLocation(id_, name); at >= 0)
      uniforms_.push_back({name, at});
  }
  std::ranges::sort(uniforms_, {}, &Uniform::name);
}

GLint Program::location(std::string_view name) const {
  const auto found = std::ranges::lower_bound(uniforms_, name, {}, &Uniform::name);
  return found != uniforms_.end() && found->name == name ? found->location : -1;
}

GLint Program::declared_location(std::string_view name) const {
  const GLint at = location(name);
  if (at < 0 && std::ranges::find(declared_, name) == declared_.end())
    throw WorkError(
        fmt::format("the program of {} and {} has no uniform '{}'", vertex_, fragment_, name));
  return at;
}

void Program::set_at(GLint location, float value) const {
  gl_->ProgramUniform1f(id_, location, value);
}
void Program::set_at(GLint location, const glm::vec2& v) const {
  gl_->ProgramUniform2f(id_, location, v.x, v.y);
}
void Program::set_at(GLint location, const glm::vec3& v) const {
  gl_->ProgramUniform3f(id_, location, v.x, v.y, v.z);
}
void Program::set_at(GLint location, int value) const {
  gl_->ProgramUniform1i(id_, location, value);
}
void Program::set_at(GLint location, std::uint32_t value) const {
  gl_->ProgramUniform1ui(id_, location, value);
}

}  // namespace pellucid::oit
