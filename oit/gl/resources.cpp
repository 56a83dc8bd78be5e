// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/gl/resources.h"

#include <algorithm>
#include <cassert>

namespace pellucid::oit {
namespace {

GLenum buffer_target(ResourceKind kind) {
  if (kind == ResourceKind::uniform_block) return GL_UNIFORM_BUFFER;
  if (kind == ResourceKind::storage_block) return GL_SHADER_STORAGE_BUFFER;
  return GL_ATOMIC_COUNTER_BUFFER;
}

}  // namespace

void Resource::bind() const {
  if (kind == ResourceKind::texture) return gl->BindTextureUnit(unit, id);
  if (kind == ResourceKind::image)
    return gl->BindImageTexture(unit, id, 0, layered, 0, GL_READ_WRITE, format);
  gl->BindBufferBase(buffer_target(kind), unit, id);
}

void Resources::add(const Resource& resource) {
  assert(!holds(resource.kind, int(resource.unit)) && "two resources of a pass at one unit");
  assert(count_ < most);
  list_[count_++] = resource;
}

void Resources::add(const Resources& others) {
  for (const Resource& resource : others) add(resource);
}

bool Resources::holds(ResourceKind kind, int unit) const {
  return std::any_of(begin(), end(),
                     [&](const Resource& r) { return r.kind == kind && r.unit == GLuint(unit); });
}

void Resources::bind() const {
  for (const Resource& resource : *this) resource.bind();
}

}  // namespace pellucid::oit
