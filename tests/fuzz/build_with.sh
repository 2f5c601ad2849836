#!/bin/sh
# build_with.sh PROGRAM IN_PLACE_OF ARGUMENT...: runs PROGRAM with the arguments that were meant for another one, so that
# single targets of a build are compiled and linked by clang. PROGRAM may be several words ("ccache clang++").
program=$1
shift 2
exec $program "$@"
