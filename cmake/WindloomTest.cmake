# windloom_test(NAME SOURCES a.cpp ... DEPENDS target ... [LABELS label ...] [TIMEOUT seconds] [FILTER tests])
# One GoogleTest program and one CTest entry for a room. Labels: unit (no GPU), gpu (needs OpenGL 4.5,
# llvmpipe will do), golden, cli, ui, rules; `long` marks what only `./test --all` runs.
#
# Sanitizers make everything slower: tests then get more time (WINDLOOM_TEST_PATIENCE, which the scripts multiply their
# own limits by), and each one the options and the list of others' faults from tests/sanitizers.
include(GoogleTest)
add_custom_target(tests_without_window)
set(WINDLOOM_TEST_PATIENCE 1)
set(WINDLOOM_TEST_ENVIRONMENT "")
if(WINDLOOM_SANITIZE)
  set(WINDLOOM_TEST_PATIENCE 8)
  set(lists ${CMAKE_SOURCE_DIR}/tests/sanitizers)
  set(WINDLOOM_TEST_ENVIRONMENT
    "ASAN_OPTIONS=detect_stack_use_after_return=1:strict_string_checks=1:check_initialization_order=1:verify_asan_link_order=0"
    "LSAN_OPTIONS=suppressions=${lists}/leaks.txt:print_suppressions=0"
    "UBSAN_OPTIONS=print_stacktrace=1"
    "TSAN_OPTIONS=suppressions=${lists}/races.txt:second_deadlock_stack=1"
    "WINDLOOM_TEST_PATIENCE=${WINDLOOM_TEST_PATIENCE}")
endif()

# Tests' own code is built without the checks for undefined behaviour: GoogleTest's macros would take most of the time.
add_library(windloom_test_options INTERFACE)
if(WINDLOOM_SANITIZE MATCHES "undefined")
  target_compile_options(windloom_test_options INTERFACE -fno-sanitize=undefined)
endif()

# What every entry has: labels, and as much time as it may take here.
function(windloom_test_properties name labels timeout)
  if(NOT timeout)
    set(timeout 300)
  endif()
  math(EXPR timeout "${timeout} * ${WINDLOOM_TEST_PATIENCE}")
  set(environment ${WINDLOOM_TEST_ENVIRONMENT})
  if(environment AND "ui" IN_LIST labels)
    # The window's OpenGL driver is unloaded before leaks are looked for, and its own leaks then have no name to go by.
    list(TRANSFORM environment REPLACE "^ASAN_OPTIONS=" "ASAN_OPTIONS=detect_leaks=0:")
  endif()
  set_tests_properties(${name} PROPERTIES LABELS "${labels}" TIMEOUT ${timeout} ENVIRONMENT "${environment}")
endfunction()

function(windloom_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT;FILTER" "SOURCES;DEPENDS;LABELS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_DEPENDS} GTest::gtest GTest::gtest_main windloom_warnings windloom_options
    windloom_test_options)
  target_compile_definitions(${name} PRIVATE WINDLOOM_TEST_DATA="${CMAKE_SOURCE_DIR}/tests/data"
    WINDLOOM_PROJECTS="${CMAKE_SOURCE_DIR}/projects")
  if("unit" IN_LIST ARG_LABELS)
    add_dependencies(tests_without_window ${name})
  endif()
  windloom_test_entry(${name} ${name} LABELS ${ARG_LABELS} TIMEOUT ${ARG_TIMEOUT} FILTER ${ARG_FILTER})
endfunction()

# windloom_test_entry(NAME PROGRAM [LABELS label ...] [TIMEOUT seconds] [FILTER tests])
# Another CTest entry of a program of windloom_test, e.g. for tests of another label.
function(windloom_test_entry name program)
  cmake_parse_arguments(ARG "" "TIMEOUT;FILTER" "LABELS" ${ARGN})
  if(NOT ARG_FILTER)
    set(ARG_FILTER "*")
  endif()
  add_test(NAME ${name} COMMAND ${program} --gtest_brief=1 --gtest_filter=${ARG_FILTER})
  windloom_test_properties(${name} "${ARG_LABELS}" "${ARG_TIMEOUT}")
endfunction()

# windloom_python_test(NAME SCRIPT script.py ARGS ... [LABELS ...] [TIMEOUT seconds])
function(windloom_python_test name)
  cmake_parse_arguments(ARG "" "SCRIPT;TIMEOUT" "ARGS;LABELS" ${ARGN})
  add_test(NAME ${name} COMMAND ${WINDLOOM_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/${ARG_SCRIPT} ${ARG_ARGS})
  windloom_test_properties(${name} "${ARG_LABELS}" "${ARG_TIMEOUT}")
endfunction()
