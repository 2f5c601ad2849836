// Preloaded: lets OpenGL fail where the file $GL_FAIL_FOLDER/NAME exists: `reset` says that the GPU was reset,
// `texture` that there is no memory for a texture. Everything else is the driver's own.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef void* (*Lookup)(const char*);
typedef void* (*Symbol)(void*, const char*);
typedef unsigned (*GetValue)(void);
typedef void (*Storage2D)(unsigned, int, unsigned, int, int);

enum { kOutOfMemory = 0x0505, kGuiltyReset = 0x8253 };

static Symbol realSymbol;
static Lookup realEgl, realGlx, realGlxArb;
static GetValue realError, realReset;
static Storage2D realStorage;
static __thread int memoryEnded;

static int asked(const char* what) {
  const char* folder = getenv("GL_FAIL_FOLDER");
  char path[4096];
  if (folder == NULL) return 0;
  snprintf(path, sizeof path, "%s/%s", folder, what);
  return access(path, F_OK) == 0;
}

static unsigned failingReset(void) { return asked("reset") ? kGuiltyReset : realReset(); }

static unsigned failingError(void) {
  if (!memoryEnded) return realError();
  memoryEnded = 0;
  return kOutOfMemory;
}

static void failingStorage(unsigned name, int levels, unsigned format, int width, int height) {
  if (asked("texture"))
    memoryEnded = 1;
  else
    realStorage(name, levels, format, width, height);
}

/// What takes the place of the function that was found.
static void* instead(const char* name, void* found) {
  if (found == NULL) return NULL;
  if (strcmp(name, "glGetGraphicsResetStatus") == 0) return realReset = (GetValue)found, (void*)failingReset;
  if (strcmp(name, "glGetError") == 0) return realError = (GetValue)found, (void*)failingError;
  if (strcmp(name, "glTextureStorage2D") == 0) return realStorage = (Storage2D)found, (void*)failingStorage;
  return found;
}

static void* eglLookup(const char* name) { return instead(name, realEgl(name)); }
static void* glxLookup(const char* name) { return instead(name, realGlx(name)); }
static void* glxArbLookup(const char* name) { return instead(name, realGlxArb(name)); }

void* dlsym(void* library, const char* name) {
  if (realSymbol == NULL) {
    realSymbol = (Symbol)dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.34");
    if (realSymbol == NULL) realSymbol = (Symbol)dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.2.5");
    if (realSymbol == NULL) abort();
  }
  void* found = realSymbol(library, name);
  if (found == NULL) return NULL;
  if (strcmp(name, "eglGetProcAddress") == 0) return realEgl = (Lookup)found, (void*)eglLookup;
  if (strcmp(name, "glXGetProcAddress") == 0) return realGlx = (Lookup)found, (void*)glxLookup;
  if (strcmp(name, "glXGetProcAddressARB") == 0) return realGlxArb = (Lookup)found, (void*)glxArbLookup;
  return instead(name, found);
}
