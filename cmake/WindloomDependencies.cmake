# Dependencies are the system's packages (Debian 12 names in scripts/packages.sh). Where one is missing, the same
# release is fetched at a pinned tag instead, so that other systems can build too.
include(FetchContent)
find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)

# windloom_fetch(NAME REPOSITORY TAG)
macro(windloom_fetch name repository tag)
  message(STATUS "${name}: no system package found, fetching ${repository} at ${tag}")
  FetchContent_Declare(${name} GIT_REPOSITORY ${repository} GIT_TAG ${tag} GIT_SHALLOW TRUE)
  FetchContent_MakeAvailable(${name})
endmacro()

find_package(glm QUIET)
if(NOT TARGET glm::glm)
  windloom_fetch(glm https://github.com/g-truc/glm.git 0.9.9.8)
endif()

find_package(nlohmann_json 3.11 QUIET)
if(NOT TARGET nlohmann_json::nlohmann_json)
  windloom_fetch(nlohmann_json https://github.com/nlohmann/json.git v3.11.2)
endif()

find_package(CLI11 2.1 QUIET)
if(NOT TARGET CLI11::CLI11)
  windloom_fetch(CLI11 https://github.com/CLIUtils/CLI11.git v2.1.2)
endif()

find_package(OpenSSL QUIET COMPONENTS Crypto)
if(NOT TARGET OpenSSL::Crypto)
  message(FATAL_ERROR "libcrypto with its headers is needed (Debian: libssl-dev)")
endif()

find_package(PNG QUIET)
if(NOT TARGET PNG::PNG)
  message(FATAL_ERROR "libpng with its headers is needed (Debian: libpng-dev)")
endif()

pkg_check_modules(DEFLATE QUIET IMPORTED_TARGET GLOBAL libdeflate)
if(NOT TARGET PkgConfig::DEFLATE)
  message(FATAL_ERROR "libdeflate with its headers is needed (Debian: libdeflate-dev)")
endif()

pkg_check_modules(ZSTD QUIET IMPORTED_TARGET GLOBAL libzstd)
if(NOT TARGET PkgConfig::ZSTD)
  message(FATAL_ERROR "libzstd with its headers is needed (Debian: libzstd-dev)")
endif()

# stb_dxt packs blocks of BC5. Debian's library holds it compiled.
pkg_check_modules(STB QUIET IMPORTED_TARGET GLOBAL stb)
if(TARGET PkgConfig::STB)
  add_library(windloom_stb_dxt ALIAS PkgConfig::STB)
else()
  FetchContent_Declare(stb GIT_REPOSITORY https://github.com/nothings/stb.git
    GIT_TAG 8b5f1f37b5b75829fc72d38e7b5d4bcbf8a26d55)
  FetchContent_Populate(stb)
  file(WRITE ${CMAKE_BINARY_DIR}/stb_dxt.c "#define STB_DXT_IMPLEMENTATION\n#include <stb_dxt.h>\n")
  add_library(windloom_stb_dxt STATIC ${CMAKE_BINARY_DIR}/stb_dxt.c)
  target_include_directories(windloom_stb_dxt SYSTEM PUBLIC ${stb_SOURCE_DIR})
endif()

find_package(TinyGLTF QUIET)
if(TARGET TinyGLTF::TinyGLTF)
  # An imported target can only be aliased where it is seen everywhere.
  set_target_properties(TinyGLTF::TinyGLTF PROPERTIES IMPORTED_GLOBAL TRUE)
  add_library(windloom_tinygltf ALIAS TinyGLTF::TinyGLTF)
else()
  set(TINYGLTF_BUILD_LOADER_EXAMPLE OFF CACHE BOOL "" FORCE)
  set(TINYGLTF_INSTALL OFF CACHE BOOL "" FORCE)
  windloom_fetch(tinygltf https://github.com/syoyo/tinygltf.git v2.7.0)
  add_library(windloom_tinygltf ALIAS tinygltf)
endif()

pkg_check_modules(EPOXY QUIET IMPORTED_TARGET epoxy)
if(NOT TARGET PkgConfig::EPOXY)
  message(FATAL_ERROR "libepoxy with its headers is needed (Debian: libepoxy-dev)")
endif()

pkg_check_modules(HWY QUIET IMPORTED_TARGET libhwy)
if(TARGET PkgConfig::HWY)
  add_library(windloom_highway ALIAS PkgConfig::HWY)
else()
  set(HWY_ENABLE_TESTS OFF CACHE BOOL "" FORCE)
  set(HWY_ENABLE_EXAMPLES OFF CACHE BOOL "" FORCE)
  windloom_fetch(highway https://github.com/google/highway.git 1.0.3)
  add_library(windloom_highway ALIAS hwy)
endif()

# OpenVDB volumes are written where the library is there. Its headers need Boost's, its own CMake file comes
# without a package.
option(WINDLOOM_OPENVDB "Write OpenVDB volumes, where the library is there" ON)
if(WINDLOOM_OPENVDB)
  find_path(WINDLOOM_OPENVDB_HEADERS openvdb/openvdb.h)
  find_path(WINDLOOM_BOOST_HEADERS boost/uuid/uuid.hpp)
  find_library(WINDLOOM_OPENVDB_LIBRARY openvdb)
  mark_as_advanced(WINDLOOM_OPENVDB_HEADERS WINDLOOM_BOOST_HEADERS WINDLOOM_OPENVDB_LIBRARY)
  find_package(TBB QUIET)
  pkg_check_modules(IMATH QUIET IMPORTED_TARGET Imath)
  if(WINDLOOM_OPENVDB_HEADERS AND WINDLOOM_BOOST_HEADERS AND WINDLOOM_OPENVDB_LIBRARY AND TARGET TBB::tbb
     AND TARGET PkgConfig::IMATH)
    add_library(windloom_openvdb INTERFACE)
    target_include_directories(windloom_openvdb SYSTEM INTERFACE ${WINDLOOM_OPENVDB_HEADERS} ${WINDLOOM_BOOST_HEADERS})
    target_link_libraries(windloom_openvdb INTERFACE ${WINDLOOM_OPENVDB_LIBRARY} TBB::tbb PkgConfig::IMATH)
  else()
    message(STATUS "OpenVDB: not found, its export is left out (Debian: libopenvdb-dev libboost-dev)")
  endif()
endif()

if(WINDLOOM_EDITOR)
  find_package(glfw3 3.3 QUIET)
  if(NOT TARGET glfw)
    windloom_fetch(glfw https://github.com/glfw/glfw.git 3.3.8)
  endif()
  # Debian's libimgui holds the GLFW and OpenGL 3 backends; their headers lie in imgui/backends.
  pkg_check_modules(IMGUI QUIET IMPORTED_TARGET imgui)
  if(TARGET PkgConfig::IMGUI)
    add_library(windloom_imgui ALIAS PkgConfig::IMGUI)
  else()
    FetchContent_Declare(imgui GIT_REPOSITORY https://github.com/ocornut/imgui.git GIT_TAG v1.86 GIT_SHALLOW TRUE)
    FetchContent_Populate(imgui)
    file(GLOB imgui_sources ${imgui_SOURCE_DIR}/*.cpp)
    add_library(windloom_imgui STATIC ${imgui_sources} ${imgui_SOURCE_DIR}/misc/cpp/imgui_stdlib.cpp
      ${imgui_SOURCE_DIR}/backends/imgui_impl_glfw.cpp ${imgui_SOURCE_DIR}/backends/imgui_impl_opengl3.cpp)
    target_include_directories(windloom_imgui SYSTEM PUBLIC ${imgui_SOURCE_DIR} ${imgui_SOURCE_DIR}/misc/cpp ${imgui_SOURCE_DIR}/backends)
    target_link_libraries(windloom_imgui PUBLIC glfw ${CMAKE_DL_LIBS})
  endif()
endif()

if(WINDLOOM_TESTS)
  find_package(GTest QUIET)
  if(NOT TARGET GTest::gtest)
    windloom_fetch(googletest https://github.com/google/googletest.git v1.12.1)
    add_library(GTest::gtest ALIAS gtest)
    add_library(GTest::gtest_main ALIAS gtest_main)
  endif()
  # Micro-benchmarks are built where the library is there; no test needs them.
  find_package(benchmark QUIET)
  # The tests' independent checks are Python scripts; the system's interpreter has Debian's numpy and
  # jsonschema packages, one found earlier on PATH may not.
  find_program(WINDLOOM_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
  if(NOT WINDLOOM_PYTHON)
    find_program(WINDLOOM_PYTHON python3 REQUIRED)
  endif()
endif()
