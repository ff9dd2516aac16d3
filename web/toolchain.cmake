# How the core is compiled for browsers: by Debian's Emscripten, which is clang with a C++ library of its own.
# SPDX-License-Identifier: GPL-3.0-or-later
set(EMSCRIPTEN_ROOT_PATH /usr/share/emscripten CACHE PATH "Where Emscripten lies")
include(${EMSCRIPTEN_ROOT_PATH}/cmake/Modules/Platform/Emscripten.cmake)

# What its library lacks comes before everything else. Exceptions are those of WebAssembly: without a call per frame.
# No -msimd128: with it clang 14 compiles a cross product in core/scene/make/generator_jungle.cpp to another number.
# WebAssembly only rounds to nearest: CGAL has to be told, or its filters answer wrongly (rounding.h stops the compiler
# where it was not).
set(CMAKE_CXX_FLAGS_INIT "-fwasm-exceptions -include ${CMAKE_CURRENT_LIST_DIR}/core/missing.h \
-DCGAL_ALWAYS_ROUND_TO_NEAREST=1 -DCGAL_DISABLE_GMP=1 -DCGAL_DISABLE_MPFR=1 -DCGAL_USE_BOOST_MP=1")
set(CMAKE_CXX_FLAGS_RELEASE "-Oz -DNDEBUG -fno-threadsafe-statics" CACHE STRING "")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-fwasm-exceptions")
