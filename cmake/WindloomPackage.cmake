# Debian packages: `cmake --build build/release --target package`. One for the programs, one for the documentation, one for games
# that link the runtime library. No maintainer scripts: the caches of MIME types, desktop entries and icons are kept by triggers
# of Debian's own packages.
set(name "The Windloom authors")
set(address "windloom@localhost")
if(NOT "$ENV{DEBFULLNAME}" STREQUAL "")  # as Debian's own tools have it
  set(name "$ENV{DEBFULLNAME}")
endif()
if("$ENV{DEBEMAIL}" MATCHES "<.+>")
  set(maintainer "$ENV{DEBEMAIL}")
else()
  if(NOT "$ENV{DEBEMAIL}" STREQUAL "")
    set(address "$ENV{DEBEMAIL}")
  endif()
  set(maintainer "${name} <${address}>")
endif()
set(WINDLOOM_MAINTAINER "${maintainer}" CACHE STRING "Who answers for the packages, as Debian writes it: NAME <ADDRESS>")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME windloom)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT ${WINDLOOM_MAINTAINER})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package's description begins with its own line
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_PACKAGE_CHECKSUM SHA256)
set(CPACK_COMPONENTS_ALL programs documentation runtime)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
  WORLD_EXECUTE)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE gzip)  # most of it are pictures, which nothing makes smaller

set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME windloom)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON)
# Opened while the program runs, so that nothing in it names them: OpenGL by epoxy, and the editor's fonts.
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_DEPENDS "libegl1, libgl1")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SUGGESTS "windloom-doc, libwindloom-runtime-dev")
if(WINDLOOM_EDITOR)
  string(APPEND CPACK_DEBIAN_PROGRAMS_PACKAGE_DEPENDS ", fonts-inter, fonts-fork-awesome")
  set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS xdg-utils)  # opens the folder of an export
endif()
set(CPACK_DEBIAN_PROGRAMS_DESCRIPTION "wind editor: draw wind, see grass answer, export it for games
In Windloom an artist draws wind as trees of arrows on a landscape. A gust
starts at a tree's root, travels along its branches and drives an
incompressible wind field, on the GPU or on the CPU; a meadow of a million
blades and more bends in it while the mouse still moves.
.
What was drawn is a small JSON project. One command bakes it into files that
a game loads: flow maps, texture arrays, volumes and vector fields, in the
axes and units of its engine.")

set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_NAME windloom-doc)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_SUGGESTS windloom)
set(CPACK_DEBIAN_DOCUMENTATION_DESCRIPTION "wind editor (documentation)
The documentation of Windloom: a tutorial, the editor's tools and keys, what
is exported and in which format byte by byte, the solver's equations and its
measurements, and a small game to copy from.")

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME libwindloom-runtime-dev)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS windloom-doc)
if(TARGET windloom_runtime_zstd)
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS libzstd-dev)
endif()
set(CPACK_DEBIAN_RUNTIME_DESCRIPTION "wind editor (library for games that play its wind)
What a game links to read baked wind: a static library in C, with a header
for C++, that loads a wind pack and tells the wind at a place and a time. It
needs no graphics and no other library of Windloom.")

# What Debian wants beside the files of any other system. The stages of a package are told by their folder.
foreach(package windloom windloom-doc libwindloom-runtime-dev)
  set(changes ${CMAKE_BINARY_DIR}/packaging/${package}.changelog)
  configure_file(packaging/changelog.Debian.in ${changes} @ONLY)
endforeach()
find_program(WINDLOOM_GZIP gzip)
foreach(pair programs:windloom documentation:windloom-doc runtime:libwindloom-runtime-dev)
  string(REPLACE ":" ";" pair ${pair})
  list(GET pair 0 component)
  list(GET pair 1 package)
  install(CODE "set(windloom_package ${package})\nset(windloom_debian ${CMAKE_SOURCE_DIR}/packaging)\nset(windloom_gzip \"${WINDLOOM_GZIP}\")\nset(windloom_changes ${CMAKE_BINARY_DIR}/packaging/${package}.changelog)"
    COMPONENT ${component})
  install(CODE [[
    if("$ENV{DESTDIR}" MATCHES "/_CPack_Packages/")
      set(windloom_doc "${CMAKE_INSTALL_PREFIX}/share/doc/${windloom_package}")
      file(INSTALL DESTINATION "${windloom_doc}" TYPE FILE FILES ${windloom_debian}/copyright)
      if(windloom_gzip)
        file(INSTALL DESTINATION "${windloom_doc}" TYPE FILE RENAME changelog.Debian FILES ${windloom_changes})
        execute_process(COMMAND ${windloom_gzip} -9nf "$ENV{DESTDIR}${windloom_doc}/changelog.Debian" COMMAND_ERROR_IS_FATAL ANY)
      endif()
    endif()]] COMPONENT ${component})
endforeach()
include(CPack)
