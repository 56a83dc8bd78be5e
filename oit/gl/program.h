// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/vec.h"
#include "oit/gl/gl_context.h"
#include "oit/gl/gl_objects.h"

namespace pellucid::oit {

/// Defines are the names and values of the lines "\#define NAME VALUE" that specialise a shader.
using Defines = std::vector<std::pair<std::string, int>>;

/// A FragmentText is what a fragment shader is made of: its body, and a further text that defines
/// what the body or a shared file of it only declares.
struct FragmentText {
  std::string_view body;
  std::string_view appended = {};
};

/// A Program is a linked vertex and fragment shader.
class Program {
 public:
  Program() = default;
  /// Compiles and links the shaders. The sources are bodies: "#version", the defines and the shared
  /// files named by their `#include "…"` lines are put in. Throws WorkError with the compiler's
  /// log.
  Program(const GlContext& context, std::string_view vertex, const FragmentText& fragment,
          const Defines& defines);
  Program(Program&& other) noexcept { swap(other); }
  Program& operator=(Program&& other) noexcept {
    swap(other);
    return *this;
  }
  ~Program() {
    if (id_) gl_->DeleteProgram(id_);
  }

  void use() const { gl_->UseProgram(id_); }
  /// Sets a uniform; T: float, glm::vec2, glm::vec3, int (also for bool), std::uint32_t. Throws
  /// WorkError that names the uniform and the shaders where they declare none of that name: one
  /// that they declare, a driver may have found to change nothing.
  template <class T>
  void set(std::string_view name, const T& value) const {
    if (const GLint at = declared_location(name); at >= 0) set_at(at, value);
  }
  /// Sets a uniform that only some of the programs use that are set alike.
  template <class T>
  void set_if_used(std::string_view name, const T& value) const {
    if (const GLint at = location(name); at >= 0) set_at(at, value);
  }

 private:
  struct Uniform {
    std::string name;
    GLint location;
  };

  void swap(Program& other) noexcept;
  void find_uniforms();
  GLint location(std::string_view name) const;  // -1: not used
  GLint declared_location(std::string_view name) const;
  void set_at(GLint location, float value) const;
  void set_at(GLint location, const glm::vec2& value) const;
  void set_at(GLint location, const glm::vec3& value) const;
  void set_at(GLint location, int value) const;
  void set_at(GLint location, std::uint32_t value) const;

  const Gl* gl_ = nullptr;
  GLuint id_ = 0;
  std::string_view vertex_, fragment_;  // the embedded files' paths
  std::vector<Uniform> uniforms_;       // by name; those that change anything
  std::vector<std::string> declared_;   // in the shaders' texts
};

/// Returns `source` with every line `#include "path"` replaced by the embedded file of that path,
/// which begins with the room's name as in C++. Throws WorkError for an unknown one.
std::string expand_includes(std::string_view source);

}  // namespace pellucid::oit
