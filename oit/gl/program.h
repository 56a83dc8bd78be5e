// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

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
  Program(Program&& other) noexcept : gl_(other.gl_), id_(std::exchange(other.id_, 0)) {}
  Program& operator=(Program&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(id_, other.id_);
    return *this;
  }
  ~Program() {
    if (id_) gl_->DeleteProgram(id_);
  }

  void use() const { gl_->UseProgram(id_); }
  /// Sets a uniform; one that the shader does not use is ignored, as OpenGL does with location -1.
  ///@{
  void set(const char* name, float value) const;
  void set(const char* name, const glm::vec2& value) const;
  void set(const char* name, const glm::vec3& value) const;
  void set(const char* name, int value) const;
  void set(const char* name, std::uint32_t value) const;
  ///@}

 private:
  GLint location(const char* name) const { return gl_->GetUniformLocation(id_, name); }

  const Gl* gl_ = nullptr;
  GLuint id_ = 0;
};

/// Returns `source` with every line `#include "path"` replaced by the embedded file of that path,
/// which begins with the room's name as in C++. Throws WorkError for an unknown one.
std::string expand_includes(std::string_view source);

}  // namespace pellucid::oit
