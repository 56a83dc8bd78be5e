// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>

#include "oit/gl/gl.h"

namespace pellucid::oit {

/// A ResourceKind is a kind of what shaders reach through a unit. Each kind has units of its own.
enum class ResourceKind { texture, image, uniform_block, storage_block, atomic_counter };

/// A Resource is one object at one unit of bindings.glsl. It owns nothing: the object has to live
/// while it is bound. Texture, BufferTexture and Buffer make it.
struct Resource {
  const Gl* gl = nullptr;
  ResourceKind kind = ResourceKind::texture;
  GLuint unit = 0;
  GLuint id = 0;              // of the texture or buffer
  GLenum format = 0;          // of an image
  GLboolean layered = false;  // an image of all layers of an array

  void bind() const;
};

/// Resources are what a pass binds, as a value: it is listed where the pass is, and nothing counts
/// on what an earlier pass bound. Two resources of one kind at one unit are a programmer's error,
/// which asserts.
class Resources {
 public:
  static constexpr std::size_t most = 24;

  Resources() = default;
  Resources(const Resource& one) { add(one); }
  Resources(std::initializer_list<Resource> list) {
    for (const Resource& resource : list) add(resource);
  }

  void add(const Resource& resource);
  void add(const Resources& others);
  bool holds(ResourceKind kind, int unit) const;
  const Resource* begin() const { return list_.data(); }
  const Resource* end() const { return list_.data() + count_; }
  void bind() const;

 private:
  // No allocation: a list is made for every draw.
  std::array<Resource, most> list_;
  std::size_t count_ = 0;
};

/// Returns all of both.
inline Resources operator+(Resources a, const Resources& b) {
  a.add(b);
  return a;
}

}  // namespace pellucid::oit
