// The OpenGL functions that we use, found at run time: one list for OpenGL 3.3 core and ES 3.0 on every system.
#pragma once

#include <GL/glcorearb.h>

namespace tumble {

class Window;

#define TUMBLE_GL_FUNCTIONS(X)                                                                                         \
  X(PFNGLACTIVETEXTUREPROC, ActiveTexture)                                                                             \
  X(PFNGLATTACHSHADERPROC, AttachShader)                                                                               \
  X(PFNGLBINDBUFFERPROC, BindBuffer)                                                                                   \
  X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                                                                         \
  X(PFNGLBINDRENDERBUFFERPROC, BindRenderbuffer)                                                                       \
  X(PFNGLBINDTEXTUREPROC, BindTexture)                                                                                 \
  X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                                                                         \
  X(PFNGLBLENDFUNCSEPARATEPROC, BlendFuncSeparate)                                                                     \
  X(PFNGLBLITFRAMEBUFFERPROC, BlitFramebuffer)                                                                         \
  X(PFNGLBUFFERDATAPROC, BufferData)                                                                                   \
  X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus)                                                           \
  X(PFNGLCLEARPROC, Clear)                                                                                             \
  X(PFNGLCOMPILESHADERPROC, CompileShader)                                                                             \
  X(PFNGLCREATEPROGRAMPROC, CreateProgram)                                                                             \
  X(PFNGLCREATESHADERPROC, CreateShader)                                                                               \
  X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                                                                             \
  X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)                                                                   \
  X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                                                                             \
  X(PFNGLDELETERENDERBUFFERSPROC, DeleteRenderbuffers)                                                                 \
  X(PFNGLDELETESHADERPROC, DeleteShader)                                                                               \
  X(PFNGLDELETETEXTURESPROC, DeleteTextures)                                                                           \
  X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)                                                                   \
  X(PFNGLDEPTHFUNCPROC, DepthFunc)                                                                                     \
  X(PFNGLDEPTHMASKPROC, DepthMask)                                                                                     \
  X(PFNGLDISABLEPROC, Disable)                                                                                         \
  X(PFNGLDRAWARRAYSPROC, DrawArrays)                                                                                   \
  X(PFNGLDRAWARRAYSINSTANCEDPROC, DrawArraysInstanced)                                                                 \
  X(PFNGLDRAWBUFFERSPROC, DrawBuffers)                                                                                 \
  X(PFNGLDRAWELEMENTSINSTANCEDPROC, DrawElementsInstanced)                                                             \
  X(PFNGLENABLEPROC, Enable)                                                                                           \
  X(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray)                                                         \
  X(PFNGLFINISHPROC, Finish)                                                                                           \
  X(PFNGLFRAMEBUFFERRENDERBUFFERPROC, FramebufferRenderbuffer)                                                         \
  X(PFNGLFRAMEBUFFERTEXTURE2DPROC, FramebufferTexture2D)                                                               \
  X(PFNGLGENBUFFERSPROC, GenBuffers)                                                                                   \
  X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                                                                         \
  X(PFNGLGENRENDERBUFFERSPROC, GenRenderbuffers)                                                                       \
  X(PFNGLGENTEXTURESPROC, GenTextures)                                                                                 \
  X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                                                                         \
  X(PFNGLGETINTEGERVPROC, GetIntegerv)                                                                                 \
  X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)                                                                     \
  X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                                                                               \
  X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)                                                                       \
  X(PFNGLGETSHADERIVPROC, GetShaderiv)                                                                                 \
  X(PFNGLGETSTRINGPROC, GetString)                                                                                     \
  X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)                                                                   \
  X(PFNGLLINKPROGRAMPROC, LinkProgram)                                                                                 \
  X(PFNGLPIXELSTOREIPROC, PixelStorei)                                                                                 \
  X(PFNGLPOLYGONOFFSETPROC, PolygonOffset)                                                                             \
  X(PFNGLREADBUFFERPROC, ReadBuffer)                                                                                   \
  X(PFNGLREADPIXELSPROC, ReadPixels)                                                                                   \
  X(PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC, RenderbufferStorageMultisample)                                           \
  X(PFNGLSHADERSOURCEPROC, ShaderSource)                                                                               \
  X(PFNGLTEXIMAGE2DPROC, TexImage2D)                                                                                   \
  X(PFNGLTEXPARAMETERIPROC, TexParameteri)                                                                             \
  X(PFNGLTEXSUBIMAGE2DPROC, TexSubImage2D)                                                                             \
  X(PFNGLUNIFORM1FPROC, Uniform1f)                                                                                     \
  X(PFNGLUNIFORM1IPROC, Uniform1i)                                                                                     \
  X(PFNGLUNIFORM2FPROC, Uniform2f)                                                                                     \
  X(PFNGLUNIFORM3FPROC, Uniform3f)                                                                                     \
  X(PFNGLUNIFORM4FVPROC, Uniform4fv)                                                                                   \
  X(PFNGLUNIFORMMATRIX4FVPROC, UniformMatrix4fv)                                                                       \
  X(PFNGLUSEPROGRAMPROC, UseProgram)                                                                                   \
  X(PFNGLVERTEXATTRIBDIVISORPROC, VertexAttribDivisor)                                                                 \
  X(PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer)                                                                 \
  X(PFNGLVIEWPORTPROC, Viewport)

struct Gl {
#define TUMBLE_GL_MEMBER(Type, name) Type name = nullptr;
  TUMBLE_GL_FUNCTIONS(TUMBLE_GL_MEMBER)
#undef TUMBLE_GL_MEMBER
  bool es = false;
};

// Throws Error, naming the function, where the driver lacks one.
Gl load_gl(const Window& window);

}  // namespace tumble
