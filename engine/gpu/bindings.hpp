#pragma once
// What is bound in this thread's OpenGL context, so that binding the same again costs nothing: a wind step would make a
// hundred calls otherwise. All buffers and programs are bound through here.

#include <epoxy/gl.h>

namespace windloom::gpu {

void bindProgram(GLuint program);
/// An indexed binding of GL_SHADER_STORAGE_BUFFER or GL_UNIFORM_BUFFER; `bytes` 0: all of the buffer.
void bindIndexed(GLenum target, GLuint index, GLuint buffer, GLintptr offset = 0, GLsizeiptr bytes = 0);

/// The object is about to be deleted: its name may come back for another one.
void forgetBuffer(GLuint buffer);
void forgetProgram(GLuint program);
/// Another context is current.
void forgetBindings();

}  // namespace windloom::gpu
