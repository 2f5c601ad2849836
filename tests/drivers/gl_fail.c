// Preloaded: lets OpenGL fail where the file $GL_FAIL_FOLDER/NAME exists: `reset` says that the GPU was reset,
// `texture` that there is no memory for a texture. Everything else is the driver's own. The program calls OpenGL through
// libepoxy's variables; at first each holds a stub that finds the function and puts it there.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

typedef unsigned (*GetValue)(void);
typedef void (*Storage2D)(unsigned, int, unsigned, int, int);

enum { kOutOfMemory = 0x0505, kGuiltyReset = 0x8253 };

static GetValue *resetPlace, *errorPlace, realReset, realError;
static Storage2D *storagePlace, realStorage;
static __thread int memoryEnded;

static int asked(const char* what) {
  const char* folder = getenv("GL_FAIL_FOLDER");
  char path[4096];
  if (folder == NULL) return 0;
  snprintf(path, sizeof path, "%s/%s", folder, what);
  return access(path, F_OK) == 0;
}

static unsigned failingReset(void);
static unsigned failingError(void);
static void failingStorage(unsigned name, int levels, unsigned format, int width, int height);

/// Calls it and keeps what it found, where that was the stub, which looks whether the place is still its own.
static unsigned callReal(GetValue* real, GetValue* place, GetValue mine) {
  *place = *real;
  const unsigned value = (*real)();
  *real = *place;
  *place = mine;
  return value;
}

static unsigned failingReset(void) {
  return asked("reset") ? kGuiltyReset : callReal(&realReset, resetPlace, failingReset);
}

static unsigned failingError(void) {
  if (!memoryEnded) return callReal(&realError, errorPlace, failingError);
  memoryEnded = 0;
  return kOutOfMemory;
}

static void failingStorage(unsigned name, int levels, unsigned format, int width, int height) {
  if (asked("texture")) {
    memoryEnded = 1;
    return;
  }
  *storagePlace = realStorage;
  realStorage(name, levels, format, width, height);
  realStorage = *storagePlace;
  *storagePlace = failingStorage;
}

__attribute__((constructor)) static void takePlaces(void) {
  resetPlace = (GetValue*)dlsym(RTLD_DEFAULT, "epoxy_glGetGraphicsResetStatus");
  errorPlace = (GetValue*)dlsym(RTLD_DEFAULT, "epoxy_glGetError");
  storagePlace = (Storage2D*)dlsym(RTLD_DEFAULT, "epoxy_glTextureStorage2D");
  if (resetPlace == NULL || errorPlace == NULL || storagePlace == NULL) return;  // a program without OpenGL
  realReset = *resetPlace, *resetPlace = failingReset;
  realError = *errorPlace, *errorPlace = failingError;
  realStorage = *storagePlace, *storagePlace = failingStorage;
}
