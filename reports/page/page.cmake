# SPDX-License-Identifier: GPL-3.0-or-later
# Bundles the script of the page (reports/page/) and gives it to mdana_reports. Without npm, or where its
# packages cannot be had, the build goes on: MDANA_PAGE_SCRIPTS=AUTO leaves the pages static.
set(MDANA_PAGE_SCRIPTS AUTO CACHE STRING "Interactive pages, bundled by npm (AUTO: if it is found)")
set_property(CACHE MDANA_PAGE_SCRIPTS PROPERTY STRINGS AUTO ON OFF)

# Copies the files of `source` to `place` and installs the packages there that its package-lock.json locks.
# Sets `why` to what keeps it from that, else to nothing.
function(mdana_npm source place why)
  set(${why} "" PARENT_SCOPE)
  find_program(NODE_PROGRAM NAMES node nodejs)
  find_program(NPM_PROGRAM npm)
  mark_as_advanced(NODE_PROGRAM NPM_PROGRAM)
  if(NOT NODE_PROGRAM OR NOT NPM_PROGRAM)
    set(${why} "npm is not installed" PARENT_SCOPE)
    return()
  endif()
  execute_process(COMMAND ${NODE_PROGRAM} --version OUTPUT_VARIABLE version OUTPUT_STRIP_TRAILING_WHITESPACE)
  string(REGEX REPLACE "^v" "" version "${version}")
  if(version VERSION_LESS 18)
    set(${why} "node is ${version}, and 18 is needed" PARENT_SCOPE)
    return()
  endif()
  file(GLOB files CONFIGURE_DEPENDS ${source}/*.json ${source}/*.mjs)
  foreach(file IN LISTS files)
    get_filename_component(name ${file} NAME)
    configure_file(${file} ${place}/${name} COPYONLY)
  endforeach()
  file(SHA256 ${source}/package-lock.json lock)
  if(EXISTS ${place}/installed-${lock})
    return()
  endif()
  execute_process(COMMAND ${NPM_PROGRAM} ci --ignore-scripts --no-audit --no-fund --fetch-retries=1
                          --fetch-timeout=20000
                  WORKING_DIRECTORY ${place} TIMEOUT 300 RESULT_VARIABLE failed
                  OUTPUT_VARIABLE told ERROR_VARIABLE told)
  if(failed)
    file(WRITE ${place}/npm.log "${told}")
    set(${why} "npm could not install its packages, see ${place}/npm.log" PARENT_SCOPE)
    return()
  endif()
  file(TOUCH ${place}/installed-${lock})
endfunction()

set(page_place ${PROJECT_BINARY_DIR}/page)
if(MDANA_PAGE_SCRIPTS STREQUAL OFF)
  set(static_because "MDANA_PAGE_SCRIPTS is OFF")
else()
  mdana_npm(${PROJECT_SOURCE_DIR}/reports/page ${page_place} static_because)
endif()

if(NOT static_because)
  message(STATUS "Pages of reports: interactive")
  file(GLOB page_sources CONFIGURE_DEPENDS reports/page/source/*.js)
  add_custom_command(OUTPUT ${page_place}/page_script.cpp
    COMMAND ${NODE_PROGRAM} build.mjs ${PROJECT_SOURCE_DIR}/reports/page/source page_script.cpp
    WORKING_DIRECTORY ${page_place} DEPENDS ${page_sources} ${page_place}/build.mjs
    COMMENT "Bundling the script of the page" VERBATIM)
  target_sources(mdana_reports PRIVATE ${page_place}/page_script.cpp)
elseif(MDANA_PAGE_SCRIPTS STREQUAL AUTO OR MDANA_PAGE_SCRIPTS STREQUAL OFF)
  message(STATUS "Pages of reports: static (${static_because})")
  target_sources(mdana_reports PRIVATE reports/page/static.cpp)
else()
  message(FATAL_ERROR "MDANA_PAGE_SCRIPTS is ON, but ${static_because}")
endif()
