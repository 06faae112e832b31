# Where the LAMMPS source tree comes from. In this order:
#
#   -D LAMMPS_SOURCE_DIR=<folder>    a LAMMPS source tree of yours; it is never written to
#   an earlier download              in ${SPHSOLID_CACHE:-${XDG_CACHE_HOME:-~/.cache}/sphsolid}
#   a download                       tools/fetch_lammps.sh lists the sources and verifies the archive
#
# Options of the download:
#   -D SPHSOLID_LAMMPS_VERSION=<YYYYMMDD>   one release only (default: the newest that can be had)
#   -D SPHSOLID_LAMMPS_URL=<url>            an archive of your choice, together with
#   -D SPHSOLID_LAMMPS_SHA256=<checksum>    its checksum

set(LAMMPS_SOURCE_DIR "" CACHE PATH "LAMMPS source tree; empty: use or fetch a copy in the cache folder")
set(SPHSOLID_LAMMPS_VERSION "" CACHE STRING "LAMMPS release to fetch, YYYYMMDD; empty: the newest")
set(SPHSOLID_LAMMPS_URL "" CACHE STRING "Archive to fetch LAMMPS from, with SPHSOLID_LAMMPS_SHA256")
set(SPHSOLID_LAMMPS_SHA256 "" CACHE STRING "Checksum of the archive at SPHSOLID_LAMMPS_URL")
mark_as_advanced(SPHSOLID_LAMMPS_URL SPHSOLID_LAMMPS_SHA256)

function(sphsolid_find_lammps result)
  if(LAMMPS_SOURCE_DIR)
    get_filename_component(folder "${LAMMPS_SOURCE_DIR}" ABSOLUTE BASE_DIR ${CMAKE_BINARY_DIR})
    foreach(root IN ITEMS ${folder} ${folder}/..)    # <lammps>/src is accepted as well
      if(EXISTS ${root}/src/version.h AND EXISTS ${root}/cmake/CMakeLists.txt)
        get_filename_component(root ${root} ABSOLUTE)
        set(${result} ${root} PARENT_SCOPE)
        return()
      endif()
    endforeach()
    message(FATAL_ERROR "LAMMPS_SOURCE_DIR=${LAMMPS_SOURCE_DIR} is not a LAMMPS source tree: "
                        "src/version.h and cmake/CMakeLists.txt are not there")
  endif()

  # a build folder stays with the tree it began with, whatever is in the cache folder meanwhile
  set(request "${SPHSOLID_LAMMPS_VERSION} ${SPHSOLID_LAMMPS_URL} ${SPHSOLID_LAMMPS_SHA256}")
  if(request STREQUAL SPHSOLID_LAMMPS_REQUEST AND EXISTS ${SPHSOLID_LAMMPS_ROOT}/src/version.h)
    set(${result} ${SPHSOLID_LAMMPS_ROOT} PARENT_SCOPE)
    return()
  endif()

  set(command ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../tools/fetch_lammps.sh)
  if(SPHSOLID_LAMMPS_VERSION)
    list(APPEND command --version ${SPHSOLID_LAMMPS_VERSION})
  endif()
  if(SPHSOLID_LAMMPS_URL)
    list(APPEND command --url ${SPHSOLID_LAMMPS_URL} --sha256 "${SPHSOLID_LAMMPS_SHA256}")
  endif()
  execute_process(COMMAND ${command} OUTPUT_VARIABLE root OUTPUT_STRIP_TRAILING_WHITESPACE
                  RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "There is no LAMMPS source tree to build (see above). If you have one, "
                        "pass -D LAMMPS_SOURCE_DIR=<folder>")
  endif()
  set(SPHSOLID_LAMMPS_REQUEST ${request} CACHE INTERNAL "What SPHSOLID_LAMMPS_ROOT was the answer to")
  set(${result} ${root} PARENT_SCOPE)
endfunction()
