// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// OpenGL 4.5 core as a table of the entry points that this room uses. The table is filled by the
// context (gl_context.h): no loader library works through OSMesa.

#include <GL/glcorearb.h>

// clang-format off
#define PELLUCID_GL_ENTRY_POINTS(X)                                                             \
  X(GetString, GETSTRING) X(GetIntegerv, GETINTEGERV) X(GetError, GETERROR)                     \
  X(Enable, ENABLE) X(Disable, DISABLE) X(Finish, FINISH) X(Viewport, VIEWPORT)                 \
  X(DebugMessageCallback, DEBUGMESSAGECALLBACK) X(MemoryBarrier, MEMORYBARRIER)                 \
  X(BlendFunci, BLENDFUNCI) X(BlendEquationi, BLENDEQUATIONI) X(Enablei, ENABLEI)               \
  X(Disablei, DISABLEI) X(DepthFunc, DEPTHFUNC) X(Scissor, SCISSOR)                             \
  X(CreateShader, CREATESHADER) X(ShaderSource, SHADERSOURCE) X(CompileShader, COMPILESHADER)   \
  X(GetShaderiv, GETSHADERIV) X(GetShaderInfoLog, GETSHADERINFOLOG)                             \
  X(DeleteShader, DELETESHADER) X(CreateProgram, CREATEPROGRAM) X(AttachShader, ATTACHSHADER)   \
  X(LinkProgram, LINKPROGRAM) X(GetProgramiv, GETPROGRAMIV)                                     \
  X(GetProgramInfoLog, GETPROGRAMINFOLOG) X(DeleteProgram, DELETEPROGRAM)                       \
  X(UseProgram, USEPROGRAM) X(GetUniformLocation, GETUNIFORMLOCATION)                           \
  X(GetActiveUniform, GETACTIVEUNIFORM)                                                         \
  X(ProgramUniform1f, PROGRAMUNIFORM1F) X(ProgramUniform2f, PROGRAMUNIFORM2F)                   \
  X(ProgramUniform3f, PROGRAMUNIFORM3F) X(ProgramUniform1i, PROGRAMUNIFORM1I)                   \
  X(ProgramUniform1ui, PROGRAMUNIFORM1UI)                                                       \
  X(CreateVertexArrays, CREATEVERTEXARRAYS) X(DeleteVertexArrays, DELETEVERTEXARRAYS)           \
  X(BindVertexArray, BINDVERTEXARRAY) X(EnableVertexArrayAttrib, ENABLEVERTEXARRAYATTRIB)       \
  X(VertexArrayAttribFormat, VERTEXARRAYATTRIBFORMAT)                                           \
  X(VertexArrayAttribBinding, VERTEXARRAYATTRIBBINDING)                                         \
  X(VertexArrayVertexBuffer, VERTEXARRAYVERTEXBUFFER)                                           \
  X(VertexArrayElementBuffer, VERTEXARRAYELEMENTBUFFER)                                         \
  X(DrawArrays, DRAWARRAYS) X(DrawElements, DRAWELEMENTS)                                       \
  X(CreateBuffers, CREATEBUFFERS) X(DeleteBuffers, DELETEBUFFERS)                               \
  X(NamedBufferStorage, NAMEDBUFFERSTORAGE) X(GetNamedBufferSubData, GETNAMEDBUFFERSUBDATA)     \
  X(MapNamedBufferRange, MAPNAMEDBUFFERRANGE) X(UnmapNamedBuffer, UNMAPNAMEDBUFFER)             \
  X(ClearNamedBufferData, CLEARNAMEDBUFFERDATA) X(BindBufferBase, BINDBUFFERBASE)               \
  X(CopyNamedBufferSubData, COPYNAMEDBUFFERSUBDATA)                                             \
  X(CreateTextures, CREATETEXTURES) X(DeleteTextures, DELETETEXTURES)                           \
  X(TextureStorage2D, TEXTURESTORAGE2D) X(TextureStorage3D, TEXTURESTORAGE3D)                   \
  X(TextureBuffer, TEXTUREBUFFER) X(TextureParameteri, TEXTUREPARAMETERI)                       \
  X(BindTextureUnit, BINDTEXTUREUNIT) X(BindImageTexture, BINDIMAGETEXTURE)                     \
  X(GetTextureImage, GETTEXTUREIMAGE) X(GetTextureSubImage, GETTEXTURESUBIMAGE)                 \
  X(ClearTexImage, CLEARTEXIMAGE) X(TextureSubImage2D, TEXTURESUBIMAGE2D)                       \
  X(TextureSubImage3D, TEXTURESUBIMAGE3D)                                                       \
  X(CreateFramebuffers, CREATEFRAMEBUFFERS) X(DeleteFramebuffers, DELETEFRAMEBUFFERS)           \
  X(BindFramebuffer, BINDFRAMEBUFFER) X(NamedFramebufferTexture, NAMEDFRAMEBUFFERTEXTURE)       \
  X(NamedFramebufferTextureLayer, NAMEDFRAMEBUFFERTEXTURELAYER)                                 \
  X(NamedFramebufferDrawBuffers, NAMEDFRAMEBUFFERDRAWBUFFERS)                                   \
  X(NamedFramebufferParameteri, NAMEDFRAMEBUFFERPARAMETERI)                                     \
  X(CheckNamedFramebufferStatus, CHECKNAMEDFRAMEBUFFERSTATUS)                                   \
  X(ClearNamedFramebufferfv, CLEARNAMEDFRAMEBUFFERFV)                                           \
  X(CreateQueries, CREATEQUERIES) X(DeleteQueries, DELETEQUERIES) X(BeginQuery, BEGINQUERY)     \
  X(EndQuery, ENDQUERY) X(GetQueryObjectui64v, GETQUERYOBJECTUI64V)                             \
  X(GetQueryiv, GETQUERYIV) X(QueryCounter, QUERYCOUNTER)
// clang-format on

namespace pellucid::oit {

/// A Gl is the table of entry points: gl.CreateTextures(…) is glCreateTextures(…).
struct Gl {
#define PELLUCID_GL_MEMBER(name, type_name) PFNGL##type_name##PROC name = nullptr;
  PELLUCID_GL_ENTRY_POINTS(PELLUCID_GL_MEMBER)
#undef PELLUCID_GL_MEMBER
};

}  // namespace pellucid::oit
