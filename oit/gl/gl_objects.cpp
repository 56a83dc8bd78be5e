// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/gl/gl_objects.h"

#include <fmt/format.h>

#include <cassert>

#include "core/error.h"

namespace pellucid::oit {
namespace {

template <class Create>
GLuint create(Create&& call) {
  GLuint id = 0;
  call(&id);
  return id;
}

std::uint64_t texel_bytes(GLenum format) {
  switch (format) {
    case GL_R32F:
    case GL_R32UI:
    case GL_DEPTH_COMPONENT32F:
    case GL_RG16F:
      return 4;
    case GL_RG32F:
    case GL_RG32UI:
    case GL_RGBA16F:
      return 8;
    case GL_RGBA32F:
    case GL_RGBA32UI:
      return 16;
    default:
      assert(false && "a format that this room does not use");
      return 16;  // the largest
  }
}

// glGetError is asked here, where the size is known, for the one error that is not a mistake.
void check_memory(const Gl& gl, std::uint64_t bytes) {
  if (gl.GetError() == GL_OUT_OF_MEMORY)
    throw WorkError(fmt::format("out of memory: OpenGL cannot allocate {} bytes", bytes));
}

}  // namespace

Texture::Texture(const Gl& gl, GLenum format, int width, int height, int layers)
    : name_(gl, create([&](GLuint* id) {
              gl.CreateTextures(layers ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D, 1, id);
            })),
      format_(format),
      width_(width),
      height_(height),
      layers_(layers),
      bytes_(texel_bytes(format) * std::uint64_t(width) * height * std::max(layers, 1)) {
  if (layers)
    gl.TextureStorage3D(id(), 1, format, width, height, layers);
  else
    gl.TextureStorage2D(id(), 1, format, width, height);
  gl.TextureParameteri(id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TextureParameteri(id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  check_memory(gl, bytes_);
}

void Texture::clear(std::uint32_t value) const {
  const std::uint32_t texel[] = {value, value, value, value};
  name_.gl().ClearTexImage(id(), 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT, texel);
}

void Texture::clear_floats(float value) const {
  const float texel[] = {value, value, value, value};
  name_.gl().ClearTexImage(id(), 0, GL_RGBA, GL_FLOAT, texel);
}

void Texture::read(GLenum format, GLenum type, std::size_t bytes, void* data) const {
  name_.gl().GetTextureImage(id(), 0, format, type, GLsizei(bytes), data);
}

void Texture::read_pixel(int x, int y, int layers, GLenum format, GLenum type, std::size_t bytes,
                         void* data) const {
  name_.gl().GetTextureSubImage(id(), 0, x, y, 0, 1, 1, layers, format, type, GLsizei(bytes), data);
}

void Texture::read_layer(int layer, GLenum format, GLenum type, std::size_t bytes,
                         void* data) const {
  name_.gl().GetTextureSubImage(id(), 0, 0, 0, layer, width_, height_, 1, format, type,
                                GLsizei(bytes), data);
}

void Texture::write_layer(int layer, GLenum format, GLenum type, const void* data) const {
  const Gl& gl = name_.gl();
  if (layers_)
    gl.TextureSubImage3D(id(), 0, 0, 0, layer, width_, height_, 1, format, type, data);
  else
    gl.TextureSubImage2D(id(), 0, 0, 0, width_, height_, format, type, data);
}

Buffer::Buffer(const Gl& gl, std::uint64_t bytes, const void* data, GLbitfield flags)
    : name_(gl, create([&](GLuint* id) { gl.CreateBuffers(1, id); })), bytes_(bytes) {
  // A buffer of no bytes is an error in OpenGL; an empty scene needs none of them.
  gl.NamedBufferStorage(id(), GLsizeiptr(bytes ? bytes : 16), bytes ? data : nullptr, flags);
  check_memory(gl, bytes);
}

void* Buffer::map() const {
  void* memory = name_.gl().MapNamedBufferRange(id(), 0, GLsizeiptr(bytes_), GL_MAP_WRITE_BIT);
  if (!memory) throw WorkError(fmt::format("OpenGL cannot map {} bytes", bytes_));
  return memory;
}

void Buffer::clear(std::uint32_t value) const {
  name_.gl().ClearNamedBufferData(id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &value);
}

std::uint32_t Buffer::read_word(std::size_t index) const {
  std::uint32_t word = 0;
  name_.gl().GetNamedBufferSubData(id(), GLintptr(index * sizeof word), sizeof word, &word);
  return word;
}

void Buffer::read(std::uint64_t bytes, void* data) const {
  if (bytes) name_.gl().GetNamedBufferSubData(id(), 0, GLsizeiptr(bytes), data);
}

BufferTexture::BufferTexture(const Gl& gl, GLenum format, Buffer buffer)
    : buffer_(std::move(buffer)),
      name_(gl, create([&](GLuint* id) { gl.CreateTextures(GL_TEXTURE_BUFFER, 1, id); })),
      format_(format) {
  GLint most = 0;
  gl.GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  if (const std::uint64_t texels = buffer_.bytes() / texel_bytes(format);
      texels > std::uint64_t(most))
    throw InputError(fmt::format("{} texels in a buffer; the driver accepts {}", texels, most));
  gl.TextureBuffer(name_.id(), format, buffer_.id());
}

Framebuffer::Framebuffer(const Gl& gl, std::span<const Attachment> attachments)
    : name_(gl, create([&](GLuint* id) { gl.CreateFramebuffers(1, id); })),
      width_(attachments.begin()->texture.width()),
      height_(attachments.begin()->texture.height()) {
  std::vector<GLenum> buffers;
  const auto next = [&] {
    buffers.push_back(GL_COLOR_ATTACHMENT0 + GLenum(buffers.size()));
    return buffers.back();
  };
  for (const Attachment& a : attachments) {
    if (a.texture.format() == GL_DEPTH_COMPONENT32F)
      gl.NamedFramebufferTexture(id(), GL_DEPTH_ATTACHMENT, a.texture.id(), 0);
    else if (!a.layers)
      gl.NamedFramebufferTexture(id(), next(), a.texture.id(), 0);
    for (int layer = a.first; layer < a.first + a.layers; ++layer)
      gl.NamedFramebufferTextureLayer(id(), next(), a.texture.id(), 0, layer);
  }
  attachments_ = int(buffers.size());
  gl.NamedFramebufferDrawBuffers(id(), attachments_, buffers.data());
  check_complete();
}

Framebuffer::Framebuffer(const Gl& gl, int width, int height)
    : name_(gl, create([&](GLuint* id) { gl.CreateFramebuffers(1, id); })),
      width_(width),
      height_(height) {
  gl.NamedFramebufferParameteri(id(), GL_FRAMEBUFFER_DEFAULT_WIDTH, width);
  gl.NamedFramebufferParameteri(id(), GL_FRAMEBUFFER_DEFAULT_HEIGHT, height);
  check_complete();
}

void Framebuffer::bind() const {
  const Gl& gl = name_.gl();
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, id());
  gl.Viewport(0, 0, width_, height_);
  gl.Disable(GL_SCISSOR_TEST);
}

void Framebuffer::bind(const Rows& rows) const {
  const Gl& gl = name_.gl();
  bind();
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(0, rows.first, width_, rows.count);
}

void Framebuffer::check_complete() const {
  const Gl& gl = name_.gl();
  if (gl.CheckNamedFramebufferStatus(id(), GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw WorkError(fmt::format("the driver cannot draw into {} such targets", attachments_));
}

void Framebuffer::clear(int index, const glm::vec4& texel) const {
  name_.gl().Disable(GL_SCISSOR_TEST);
  name_.gl().ClearNamedFramebufferfv(id(), GL_COLOR, index, &texel.x);
}

void Framebuffer::clear_all(float value) const {
  for (int i = 0; i < attachments_; ++i) clear(i, value);
}

void Framebuffer::clear_depth(float value) const {
  name_.gl().Disable(GL_SCISSOR_TEST);
  name_.gl().ClearNamedFramebufferfv(id(), GL_DEPTH, 0, &value);
}

VertexArray::VertexArray(const Gl& gl)
    : name_(gl, create([&](GLuint* id) { gl.CreateVertexArrays(1, id); })) {}

void VertexArray::attribute(int location, int binding, int count, unsigned offset) const {
  const Gl& gl = name_.gl();
  gl.EnableVertexArrayAttrib(id(), GLuint(location));
  gl.VertexArrayAttribFormat(id(), GLuint(location), count, GL_FLOAT, GL_FALSE, offset);
  gl.VertexArrayAttribBinding(id(), GLuint(location), GLuint(binding));
}

SampleQuery::SampleQuery(const Gl& gl)
    : name_(gl, create([&](GLuint* id) { gl.CreateQueries(GL_SAMPLES_PASSED, 1, id); })) {}

void SampleQuery::begin() const { name_.gl().BeginQuery(GL_SAMPLES_PASSED, name_.id()); }

std::uint64_t SampleQuery::end() const {
  name_.gl().EndQuery(GL_SAMPLES_PASSED);
  std::uint64_t samples = 0;
  name_.gl().GetQueryObjectui64v(name_.id(), GL_QUERY_RESULT, &samples);
  return samples;
}

}  // namespace pellucid::oit
