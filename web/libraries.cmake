# The libraries of headers that the core uses, for a compiler that must not see the system's other headers: links to
# their folders, in a folder of their own.
# SPDX-License-Identifier: GPL-3.0-or-later
set(links ${PROJECT_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${links})
foreach(folder CGAL boost glm nlohmann)
  if(NOT EXISTS /usr/include/${folder})
    message(FATAL_ERROR "/usr/include/${folder} is missing: ./run web installs it")
  endif()
  file(CREATE_LINK /usr/include/${folder} ${links}/${folder} SYMBOLIC)
endforeach()
foreach(library CGAL::CGAL glm::glm nlohmann_json::nlohmann_json)
  add_library(${library} INTERFACE IMPORTED)
  target_include_directories(${library} SYSTEM INTERFACE ${links})
endforeach()
target_compile_options(CGAL::CGAL INTERFACE -include ${PROJECT_SOURCE_DIR}/web/core/rounding.h)
add_compile_options(-Wno-bitwise-instead-of-logical)  # without branches on purpose
