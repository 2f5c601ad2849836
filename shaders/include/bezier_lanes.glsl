// Invocations of a work-group that looks after a patch: at least as many as blades of it are shown. A software renderer does
// the work of idle ones, too.
#include "shaders/shared/bezier_blade.h"

#ifndef LANES
#define LANES BEZIER_PATCH
#endif
