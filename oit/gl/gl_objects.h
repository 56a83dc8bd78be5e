// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Owners of OpenGL names. Each is move-only and deletes what it owns; the context that made it has
// to be current then.

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/vec.h"
#include "oit/gl/resources.h"

namespace pellucid::oit {

/// A GlName is an OpenGL name and its deleter, e.g. GlName<&Gl::DeleteTextures>.
template <auto Delete>
class GlName {
 public:
  GlName() = default;
  GlName(const Gl& gl, GLuint id) : gl_(&gl), id_(id) {}
  GlName(GlName&& other) noexcept : gl_(other.gl_), id_(std::exchange(other.id_, 0)) {}
  GlName& operator=(GlName&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(id_, other.id_);
    return *this;
  }
  ~GlName() {
    if (id_) (gl_->*Delete)(1, &id_);
  }

  const Gl& gl() const { return *gl_; }
  GLuint id() const { return id_; }

 private:
  const Gl* gl_ = nullptr;
  GLuint id_ = 0;
};

/// A Texture is a two-dimensional texture or array without mipmaps, sampled without filtering. Its
/// row 0 is the picture's top row.
class Texture {
 public:
  Texture() = default;
  /// Allocates `width` × `height` texels: a plain texture if `layers` is 0, otherwise an array.
  /// Throws WorkError when memory does not suffice.
  Texture(const Gl& gl, GLenum format, int width, int height, int layers = 0);

  GLuint id() const { return name_.id(); }
  GLenum format() const { return format_; }
  int width() const { return width_; }
  int height() const { return height_; }
  int layers() const { return layers_; }  // 0 of a plain texture
  std::uint64_t bytes() const { return bytes_; }
  /// Names it as what a sampler2D or sampler2DArray finds; units are those of bindings.glsl, here
  /// and below.
  Resource as_texture(int unit) const {
    return {&name_.gl(), ResourceKind::texture, GLuint(unit), id()};
  }
  /// Names it as what an image2D or image2DArray finds, which reads and writes it.
  Resource as_image(int unit) const {
    return {&name_.gl(), ResourceKind::image, GLuint(unit), id(), format_, GL_TRUE};
  }
  void clear(std::uint32_t value) const;  // every component of an unsigned integer format
  void clear_floats(float value) const;   // … of a format of floats
  void read(GLenum format, GLenum type, std::size_t bytes, void* data) const;
  /// Reads one pixel of all `layers`, the first layer first.
  void read_pixel(int x, int y, int layers, GLenum format, GLenum type, std::size_t bytes,
                  void* data) const;
  /// Reads, or writes, all texels of one layer of an array, or of a plain texture.
  ///@{
  void read_layer(int layer, GLenum format, GLenum type, std::size_t bytes, void* data) const;
  void write_layer(int layer, GLenum format, GLenum type, const void* data) const;
  ///@}

 private:
  GlName<&Gl::DeleteTextures> name_;
  GLenum format_ = 0;
  int width_ = 0, height_ = 0, layers_ = 0;
  std::uint64_t bytes_ = 0;
};

/// A Buffer is memory of the driver of a fixed size; a constructor throws WorkError when there is
/// not enough of it.
class Buffer {
 public:
  Buffer() = default;
  Buffer(const Gl& gl, std::uint64_t bytes, const void* data = nullptr)
      : Buffer(gl, bytes, data, 0) {}
  template <class T>
  Buffer(const Gl& gl, const std::vector<T>& data)
      : Buffer(gl, data.size() * sizeof(T), data.data()) {}

  /// Makes a buffer for write(), its content undefined.
  static Buffer writable(const Gl& gl, std::uint64_t bytes) {
    return {gl, bytes, nullptr, GL_MAP_WRITE_BIT};
  }
  /// Makes a buffer of `count` of T, which `fill(T*)` writes, one after the other, into the
  /// driver's own memory.
  template <class T, class Fill>
  static Buffer filled(const Gl& gl, std::uint64_t count, Fill&& fill) {
    Buffer buffer = writable(gl, count * sizeof(T));
    if (count) buffer.write<T>(std::forward<Fill>(fill));
    return buffer;
  }
  /// Lets `fill(T*)` write into the driver's own memory. Throws WorkError when it cannot be mapped.
  template <class T, class Fill>
  void write(Fill&& fill) const {
    fill(static_cast<T*>(map()));
    name_.gl().UnmapNamedBuffer(id());
  }

  GLuint id() const { return name_.id(); }
  std::uint64_t bytes() const { return bytes_; }
  /// Names it as what a block or a counter finds.
  ///@{
  Resource as_uniform_block(int unit) const { return as(ResourceKind::uniform_block, unit); }
  Resource as_storage_block(int unit) const { return as(ResourceKind::storage_block, unit); }
  Resource as_atomic_counter(int unit) const { return as(ResourceKind::atomic_counter, unit); }
  ///@}

  void clear(std::uint32_t value) const;
  std::uint32_t read_word(std::size_t index) const;
  void read(void* data) const { read(bytes_, data); }
  void read(std::uint64_t bytes, void* data) const;  // the first ones

 private:
  Buffer(const Gl& gl, std::uint64_t bytes, const void* data, GLbitfield flags);
  Resource as(ResourceKind kind, int unit) const { return {&name_.gl(), kind, GLuint(unit), id()}; }
  void* map() const;

  GlName<&Gl::DeleteBuffers> name_;
  std::uint64_t bytes_ = 0;
};

/// A BufferTexture is a buffer seen as an image of texels. Unlike a storage block it is not limited
/// to 128 MiB on llvmpipe.
class BufferTexture {
 public:
  BufferTexture() = default;
  BufferTexture(const Gl& gl, GLenum format, std::uint64_t bytes)
      : BufferTexture(gl, format, Buffer(gl, bytes)) {}
  /// Throws InputError for more texels than the driver's textures hold.
  BufferTexture(const Gl& gl, GLenum format, Buffer buffer);

  std::uint64_t bytes() const { return buffer_.bytes(); }
  const Buffer& buffer() const { return buffer_; }
  /// For samplerBuffer.
  Resource as_texture(int unit) const {
    return {&name_.gl(), ResourceKind::texture, GLuint(unit), name_.id()};
  }
  /// For imageBuffer, read and written.
  Resource as_image(int unit) const {
    return {&name_.gl(), ResourceKind::image, GLuint(unit), name_.id(), format_, GL_FALSE};
  }

 private:
  Buffer buffer_;
  GlName<&Gl::DeleteTextures> name_;
  GLenum format_ = 0;
};

/// Rows are some that follow each other, of a picture from its top.
struct Rows {
  int first, count;
};

/// A Framebuffer has colour attachments 0, 1, … in the order given, and a depth texture as the
/// depth attachment; all are of one size, which is the viewport where it is bound. A constructor
/// throws WorkError when the driver cannot draw into them.
class Framebuffer {
 public:
  /// An Attachment is a texture, or some layers of an array, each of them an attachment.
  struct Attachment {
    const Texture& texture;
    int layers = 0;  // of an array: how many …
    int first = 0;   // … from this one
  };

  Framebuffer() = default;
  Framebuffer(const Gl& gl, std::span<const Attachment> attachments);
  Framebuffer(const Gl& gl, std::initializer_list<Attachment> attachments)
      : Framebuffer(gl, std::span(attachments.begin(), attachments.size())) {}
  /// Makes one without attachments, for passes that only store; its size is in pixels.
  Framebuffer(const Gl& gl, int width, int height);

  GLuint id() const { return name_.id(); }
  int attachments() const { return attachments_; }
  glm::vec2 size() const { return {width_, height_}; }  // pixels
  /// Draws into the whole of it from here on, or into some of its rows alone.
  ///@{
  void bind() const;
  void bind(const Rows& rows) const;
  ///@}
  /// Clears the whole of attachment `index`.
  void clear(int index, const glm::vec4& texel) const;
  /// Clears attachment `index` to `value` in every component.
  void clear(int index, float value) const { clear(index, glm::vec4(value)); }
  void clear_all(float value) const;
  void clear_depth(float value) const;

 private:
  void check_complete() const;

  GlName<&Gl::DeleteFramebuffers> name_;
  int attachments_ = 0;
  int width_ = 0, height_ = 0;
};

/// A VertexArray says where a vertex shader finds its attributes.
class VertexArray {
 public:
  explicit VertexArray(const Gl& gl);
  GLuint id() const { return name_.id(); }
  /// Takes `buffer` as source `binding`, with `stride` bytes a vertex.
  void source(int binding, const Buffer& buffer, unsigned stride) const {
    name_.gl().VertexArrayVertexBuffer(id(), GLuint(binding), buffer.id(), 0, GLsizei(stride));
  }
  /// Takes attribute `location` from source `binding`: `count` floats at byte `offset` of each
  /// vertex.
  void attribute(int location, int binding, int count, unsigned offset) const;

 private:
  GlName<&Gl::DeleteVertexArrays> name_;
};

/// A SampleQuery counts the fragments that pass between begin() and end().
class SampleQuery {
 public:
  explicit SampleQuery(const Gl& gl);
  void begin() const;
  std::uint64_t end() const;  // waits for the result

 private:
  GlName<&Gl::DeleteQueries> name_;
};

}  // namespace pellucid::oit
