# windloom_module(NAME SOURCES a.cpp ... DEPENDS target ... [PRIVATE_DEPENDS target ...])
# Makes the static library windloom_NAME of the room in the current folder. Headers are included
# from the repository root ("engine/core/result.hpp"), so an include line always names its room.
function(windloom_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_library(windloom_${name} STATIC ${ARG_SOURCES})
  target_include_directories(windloom_${name} PUBLIC ${CMAKE_SOURCE_DIR})
  target_link_libraries(windloom_${name} PUBLIC ${ARG_DEPENDS} windloom_options PRIVATE ${ARG_PRIVATE_DEPENDS} windloom_warnings windloom_paths)
endfunction()
