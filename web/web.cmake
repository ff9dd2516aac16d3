# What takes time is compiled for speed, the rest for a small file.
foreach(library geometry space delaunay raster)
  target_compile_options(sightline_${library} PRIVATE -O2)
endforeach()

# The page's core: what of the shell needs no window, no figure and no other program, and the page's own functions.
# SPDX-License-Identifier: GPL-3.0-or-later
sightline_library(sightline_read FOLDERS core/scene/read EXCEPT "/assimp_" PUBLIC sightline_scene)
target_sources(sightline_read PRIVATE web/core/no_assimp.cpp)

sightline_library(sightline_desk FOLDERS shell/desk shell/lesson EXCEPT "/launch[.]cpp"
                  PUBLIC sightline_core sightline_read)
target_sources(sightline_desk PRIVATE web/core/no_programs.cpp shell/export/save.cpp shell/export/handout.cpp
                                      web/core/no_figures.cpp
                                      shell/pane/side_by_side.cpp)
target_compile_definitions(sightline_desk PRIVATE SIGHTLINE_EXAMPLES="/examples")
sightline_library(sightline_panels FOLDERS shell/panels PUBLIC sightline_desk)
sightline_library(sightline_commands FOLDERS shell/commands PUBLIC sightline_panels)

file(GLOB page_sources CONFIGURE_DEPENDS web/core/*.cpp)
list(FILTER page_sources EXCLUDE REGEX "/no_[a-z]+[.]cpp$")
add_executable(sightline_page ${page_sources})
set_target_properties(sightline_page PROPERTIES OUTPUT_NAME sightline)
target_link_libraries(sightline_page PRIVATE sightline_commands)
target_link_options(sightline_page PRIVATE -Oz --no-entry -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=2GB -sMODULARIZE=1
                    -sEXPORT_NAME=sightline -sENVIRONMENT=web,worker,node -sEXPORTED_FUNCTIONS=_malloc,_free
                    -sEXPORTED_RUNTIME_METHODS=FS,UTF8ToString,stringToUTF8,lengthBytesUTF8 -sFORCE_FILESYSTEM=1)

# The list of hashes, and the exact predicates at their limits: for node.
foreach(program golden_hashes predicates)
  if(program STREQUAL golden_hashes)
    add_executable(web_${program} tests/run/golden_hashes.cpp tests/run/golden_hashes_main.cpp)
  else()
    add_executable(web_${program} web/tests/${program}.cpp)
  endif()
  target_link_libraries(web_${program} PRIVATE sightline_core)
  target_link_options(web_${program} PRIVATE -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=4GB -sNODERAWFS=1
                      -sENVIRONMENT=node -sEXIT_RUNTIME=1)
endforeach()
