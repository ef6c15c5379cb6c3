# Every third-party library as one imported target, tumble::<name>, so that the rest of the build names no paths.
#
#   tumble::lua tumble::bullet    our own builds (build.sh), or the system's where those cannot be had
#   tumble::sdl2 tumble::zip tumble::zlib tumble::vorbis      shared libraries of the system
#   tumble::eigen tumble::json tumble::stb tumble::tinygltf tumble::cli11 tumble::catch2    headers only
#
# CMake's own finders are not used: FindLua picks the C build, FindBullet the float one, libzip's wants zipcmp.

include_guard(GLOBAL)
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)

set(TUMBLE_DEPENDENCIES "" CACHE STRING
  "Prefix made by runtime/dependencies/build.sh; empty: build or find it; 'system': the distribution's Lua and Bullet")

# ---- Lua and Bullet

set(prefix "${TUMBLE_DEPENDENCIES}")
if(NOT prefix)
  execute_process(COMMAND "${CMAKE_CURRENT_LIST_DIR}/build.sh" OUTPUT_VARIABLE prefix OUTPUT_STRIP_TRAILING_WHITESPACE
    RESULT_VARIABLE failed)
  if(failed)
    set(prefix "system")
  endif()
endif()

function(tumble_archive name include)
  add_library(tumble::${name} INTERFACE IMPORTED GLOBAL)
  target_include_directories(tumble::${name} SYSTEM INTERFACE "${include}")
  target_link_libraries(tumble::${name} INTERFACE ${ARGN})
endfunction()

function(tumble_pkg_config name package)
  if(NOT TARGET PkgConfig::tumble_pc_${name})
    pkg_check_modules(tumble_pc_${name} QUIET IMPORTED_TARGET GLOBAL ${package})
  endif()
  if(NOT tumble_pc_${name}_FOUND)
    message(FATAL_ERROR "Tumble needs the library '${package}' and pkg-config does not know it; ./tumble installs it")
  endif()
  add_library(tumble::${name} ALIAS PkgConfig::tumble_pc_${name})
endfunction()

if(prefix STREQUAL "system")
  message(STATUS "Tumble: using the system's Lua and Bullet; a host with a Lua or Bullet of its own may clash with them")
  tumble_pkg_config(lua lua5.4-c++)
  tumble_pkg_config(bullet bullet-float64)
elseif(EXISTS "${prefix}/lib/liblua.a" AND EXISTS "${prefix}/lib/libBulletDynamics.a")
  message(STATUS "Tumble: Lua and Bullet from ${prefix}")
  tumble_archive(lua "${prefix}/include/lua" "${prefix}/lib/liblua.a" m)
  # In this order: each library needs the ones after it.
  tumble_archive(bullet "${prefix}/include/bullet" "${prefix}/lib/libBulletDynamics.a"
    "${prefix}/lib/libBulletCollision.a" "${prefix}/lib/libLinearMath.a" Threads::Threads)
  target_compile_definitions(tumble::bullet INTERFACE BT_USE_DOUBLE_PRECISION)
else()
  message(FATAL_ERROR "TUMBLE_DEPENDENCIES is '${prefix}', which holds no lib/liblua.a; "
    "give what runtime/dependencies/build.sh prints, or nothing")
endif()

# ---- the system's libraries

tumble_pkg_config(sdl2 sdl2)
tumble_pkg_config(zip libzip)
tumble_pkg_config(zlib zlib)
tumble_pkg_config(vorbis vorbisfile)
tumble_pkg_config(eigen eigen3)
tumble_pkg_config(json nlohmann_json)

function(tumble_headers name header)
  find_path(tumble_${name}_include ${header} PATH_SUFFIXES ${ARGN} NO_CACHE)
  if(NOT tumble_${name}_include)
    message(FATAL_ERROR "Tumble needs the header '${header}'; ./tumble installs it")
  endif()
  add_library(tumble::${name} INTERFACE IMPORTED GLOBAL)
  target_include_directories(tumble::${name} SYSTEM INTERFACE "${tumble_${name}_include}")
endfunction()

tumble_headers(stb stb_image.h stb)
# Our own build of its header: the system's library of it draws in a copy of the picture reader.
tumble_headers(tinygltf tiny_gltf.h)
tumble_headers(cli11 CLI/CLI.hpp)

# Tests are written for version 2, one header, and a file that defines CATCH_CONFIG_MAIN. Version 3 is a library with its
# own main, as the definition TUMBLE_CATCH2_VERSION_3 says; catch2_version_3 holds the old header's name for it.
find_package(Catch2 QUIET)
if(NOT Catch2_FOUND)
  message(STATUS "Tumble: no Catch2, so the tests are not built; ./tumble installs it")
  set(TUMBLE_TESTS OFF)
elseif(Catch2_VERSION VERSION_LESS 3)
  tumble_headers(catch2 catch2/catch.hpp)
else()
  add_library(tumble::catch2 INTERFACE IMPORTED GLOBAL)
  target_link_libraries(tumble::catch2 INTERFACE Catch2::Catch2WithMain)
  target_include_directories(tumble::catch2 SYSTEM INTERFACE "${CMAKE_CURRENT_LIST_DIR}/catch2_version_3")
  target_compile_definitions(tumble::catch2 INTERFACE TUMBLE_CATCH2_VERSION_3)
endif()
