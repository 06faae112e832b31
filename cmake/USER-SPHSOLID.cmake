# Adds USER-SPHSOLID to a LAMMPS build of your own, without any change to LAMMPS:
#
#   cmake -S <lammps>/cmake -B build -D CMAKE_PROJECT_lammps_INCLUDE=<here>/USER-SPHSOLID.cmake ...
#
# CMake reads this file right after LAMMPS' project() command. The styles are registered now, the
# target follows when LAMMPS' own script has ended.

include_guard(GLOBAL)
if(CMAKE_PROJECT_NAME STREQUAL "sphsolid")
  return()    # our own superbuild does this already
endif()

include(${CMAKE_CURRENT_LIST_DIR}/SphsolidPackage.cmake)
get_filename_component(SPHSOLID_HOOK_LAMMPS_ROOT ${CMAKE_CURRENT_SOURCE_DIR} DIRECTORY)
sphsolid_register_styles(${CMAKE_CURRENT_SOURCE_DIR})
cmake_language(EVAL CODE
  "cmake_language(DEFER CALL sphsolid_add_package [[${SPHSOLID_HOOK_LAMMPS_ROOT}]])")
