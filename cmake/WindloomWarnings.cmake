# One INTERFACE target carries every warning flag; each flag says why it is here.
add_library(windloom_warnings INTERFACE)
target_compile_options(windloom_warnings INTERFACE
  -Wall -Wextra -Wpedantic     # the compiler's own common sense
  -Wshadow                     # a shadowed name is a bug waiting in long numeric functions
  -Wnon-virtual-dtor           # solver backends are deleted through their interface
  -Woverloaded-virtual         # an override that silently isn't one
  -Wimplicit-fallthrough       # state machines in tools and signals
  -Wnull-dereference           # optional parts of a project
  -Wdouble-promotion           # a stray double in a float kernel halves SIMD width
  -Wformat=2)                  # log lines
# Sanitizers' checks confuse the warnings that follow values through a function.
if(WINDLOOM_WERROR AND NOT WINDLOOM_SANITIZE)
  target_compile_options(windloom_warnings INTERFACE -Werror)
endif()

add_library(windloom_options INTERFACE)
# Results must not depend on the compiler contracting a*b+c differently per build: the CPU solver
# promises the same bytes for the same input.
target_compile_options(windloom_options INTERFACE -ffp-contract=off)
# Messages of broken contracts name their file from the repository's root, so that no installed program holds paths of the
# machine that built it. A sanitizer's reports are for that machine.
add_library(windloom_paths INTERFACE)
if(NOT WINDLOOM_SANITIZE)
  target_compile_options(windloom_paths INTERFACE -fmacro-prefix-map=${CMAKE_SOURCE_DIR}/=)
endif()
if(WINDLOOM_SANITIZE)
  target_compile_options(windloom_options INTERFACE -fsanitize=${WINDLOOM_SANITIZE} -fno-sanitize-recover=all
    -fno-omit-frame-pointer -g1)
  target_link_options(windloom_options INTERFACE -fsanitize=${WINDLOOM_SANITIZE})
endif()
