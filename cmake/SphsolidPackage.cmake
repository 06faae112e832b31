# How USER-SPHSOLID is compiled: shared by the superbuild (CMakeLists.txt) and by the hook for other
# people's LAMMPS builds (USER-SPHSOLID.cmake).
#
#   sphsolid_lammps_version(<lammps root> <variable>)   release date as YYYYMMDD
#   sphsolid_register_styles(<lammps root>/cmake)       call before LAMMPS writes its style headers
#   sphsolid_add_package(<lammps root>)                 call when the target `lammps` exists
#
# Targets:
#   sphsolid_flags     INTERFACE  compiler flags of every file of ours, tests included
#   sphsolid_physics   INTERFACE  the headers that need no LAMMPS, with Eigen and the flags
#   sphsolid           OBJECT     the package; linked into liblammps and into the plugin
#   sphsolidplugin     MODULE     the package for an existing lmp, see doc

include_guard(GLOBAL)
include(CheckCXXCompilerFlag)
include(CheckCXXSourceCompiles)

get_filename_component(SPHSOLID_ROOT ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)
set_property(GLOBAL PROPERTY SPHSOLID_ROOT ${SPHSOLID_ROOT})

option(SPHSOLID_BUILD_PLUGIN "Build sphsolidplugin.so" ON)

# "native" makes a program for this machine only; a compiler that does not know it gets nothing.
set(SPHSOLID_ARCH_DEFAULT "")
if(NOT CMAKE_CROSSCOMPILING AND NOT MSVC)
  check_cxx_compiler_flag(-march=native SPHSOLID_HAVE_MARCH_NATIVE)
  if(SPHSOLID_HAVE_MARCH_NATIVE)
    set(SPHSOLID_ARCH_DEFAULT native)
  endif()
endif()
set(SPHSOLID_ARCH ${SPHSOLID_ARCH_DEFAULT} CACHE STRING
    "Instruction set (-march) of the USER-SPHSOLID sources: native, x86-64-v2, x86-64-v3 or empty")
set_property(CACHE SPHSOLID_ARCH PROPERTY STRINGS native x86-64-v2 x86-64-v3 "")

# ------------------------------------------------------------------------------------------------
function(sphsolid_lammps_version lammps_root result)
  file(STRINGS ${lammps_root}/src/version.h line REGEX "define LAMMPS_VERSION" LIMIT_COUNT 1)
  if(NOT line MATCHES "\"([0-9]+) ([A-Z][a-z][a-z])[a-z]* ([0-9][0-9][0-9][0-9])\"")
    message(FATAL_ERROR "Cannot read the LAMMPS version from ${lammps_root}/src/version.h")
  endif()
  set(day ${CMAKE_MATCH_1})
  set(month_name ${CMAKE_MATCH_2})
  set(year ${CMAKE_MATCH_3})
  set(months Jan Feb Mar Apr May Jun Jul Aug Sep Oct Nov Dec)
  list(FIND months ${month_name} month)
  math(EXPR date "${year} * 10000 + (${month} + 1) * 100 + ${day}")
  set(${result} ${date} PARENT_SCOPE)
endfunction()

# ------------------------------------------------------------------------------------------------
# LAMMPS collects its styles in global properties and writes style_*.h from them, so a folder
# registered beforehand is compiled in without any change to LAMMPS.
function(sphsolid_register_styles lammps_cmake_dir)
  get_property(root GLOBAL PROPERTY SPHSOLID_ROOT)
  include(${lammps_cmake_dir}/Modules/StyleHeaderUtils.cmake)
  RegisterStyles(${root}/src/USER-SPHSOLID)
endfunction()

# ------------------------------------------------------------------------------------------------
function(sphsolid_add_flags lmp_version)
  add_library(sphsolid_flags INTERFACE)
  target_compile_features(sphsolid_flags INTERFACE cxx_std_17)
  # EIGEN_MAX_ALIGN_BYTES: Eigen's idea of alignment follows the instruction set. LAMMPS packages
  # that use Eigen are compiled for another one, and the linker merges the functions of both, so
  # both have to agree on the baseline.
  target_compile_definitions(sphsolid_flags INTERFACE SPHSOLID_LMP_VERSION=${lmp_version}
                                                      EIGEN_MAX_ALIGN_BYTES=16)

  # Vectorisable, yet every number independent of the number of ranks and of where arrays lie in
  # memory: no fused multiply-add, no scalar steps before a vector loop until its stores are aligned
  # (they change the order of sums from run to run), and never -ffast-math.
  set(flags $<$<NOT:$<CONFIG:Debug>>:-O3>)
  set(CMAKE_REQUIRED_FLAGS -Werror)    # some compilers only warn of what they do not know
  foreach(flag -fno-math-errno -fno-trapping-math -ffp-contract=off -fno-semantic-interposition
               --param=vect-max-peeling-for-alignment=0)
    string(MAKE_C_IDENTIFIER "SPHSOLID_HAVE${flag}" have)
    check_cxx_compiler_flag(${flag} ${have})
    if(${have})
      list(APPEND flags ${flag})
    endif()
  endforeach()
  unset(CMAKE_REQUIRED_FLAGS)
  if(SPHSOLID_ARCH)
    string(TOUPPER "SPHSOLID_HAVE_MARCH_${SPHSOLID_ARCH}" have)
    string(MAKE_C_IDENTIFIER ${have} have)
    check_cxx_compiler_flag(-march=${SPHSOLID_ARCH} ${have})
    if(NOT ${have})
      message(FATAL_ERROR "The compiler does not accept -march=${SPHSOLID_ARCH}: "
                          "set SPHSOLID_ARCH to something else, or to nothing")
    endif()
    list(APPEND flags -march=${SPHSOLID_ARCH})
    if(SPHSOLID_ARCH STREQUAL "native")
      # What "native" means here becomes part of the command line, so that ccache does not take
      # objects made on a machine with another processor.
      execute_process(COMMAND ${CMAKE_CXX_COMPILER} -march=native -dM -E -x c++ /dev/null
                      OUTPUT_VARIABLE macros ERROR_QUIET)
      string(SHA1 machine "${macros}")
      string(SUBSTRING ${machine} 0 8 machine)
      target_compile_definitions(sphsolid_flags INTERFACE SPHSOLID_MACHINE=0x${machine})
    endif()
    set(set_name ${SPHSOLID_ARCH})
  else()
    set(set_name "the compiler's default")
  endif()

  # as sph_solid_native.h decides
  string(MAKE_C_IDENTIFIER "SPHSOLID_EIGHT_LANES_${SPHSOLID_ARCH}" eight)
  set(CMAKE_REQUIRED_FLAGS ${flags})
  list(FILTER CMAKE_REQUIRED_FLAGS INCLUDE REGEX "^-march")
  check_cxx_source_compiles("
    #if !defined(__AVX512F__) || !defined(__AVX512DQ__)
    #error four lanes
    #endif
    int main() { return 0; }" ${eight})
  unset(CMAKE_REQUIRED_FLAGS)
  set_property(GLOBAL PROPERTY SPHSOLID_EIGHT_LANES ${${eight}})
  set(lanes four)
  if(${eight})
    set(lanes eight)
  endif()
  message(STATUS "USER-SPHSOLID instruction set: ${set_name}, ${lanes} doubles in a vector")
  target_compile_options(sphsolid_flags INTERFACE ${flags})
endfunction()

# ------------------------------------------------------------------------------------------------
# `lmp -h` lists the packages of lmpinstalledpkgs.h, which LAMMPS rewrites at each configuration.
# lammps.cpp gets a copy of ours with one more name, written only when it changes: editing LAMMPS'
# own file would recompile lammps.cpp after every configuration.
function(sphsolid_list_package lammps_root)
  get_target_property(lammps_binary_dir lammps BINARY_DIR)
  file(READ ${lammps_binary_dir}/styles/lmpinstalledpkgs.h text)
  string(REGEX REPLACE "(NULL|nullptr)\n}" "\"USER-SPHSOLID\",\n  \\1\n}" text "${text}")
  set(folder ${lammps_binary_dir}/sphsolid)
  file(CONFIGURE OUTPUT ${folder}/lmpinstalledpkgs.h CONTENT "${text}" @ONLY)
  set_property(SOURCE ${lammps_root}/src/lammps.cpp TARGET_DIRECTORY lammps
               APPEND PROPERTY INCLUDE_DIRECTORIES ${folder})
endfunction()

# ------------------------------------------------------------------------------------------------
function(sphsolid_add_package lammps_root)
  get_property(root GLOBAL PROPERTY SPHSOLID_ROOT)
  set(package_dir ${root}/src/USER-SPHSOLID)

  find_package(Eigen3 3.3 REQUIRED NO_MODULE)
  sphsolid_lammps_version(${lammps_root} lmp_version)
  sphsolid_add_flags(${lmp_version})
  add_library(sphsolid_physics INTERFACE)
  target_include_directories(sphsolid_physics INTERFACE ${package_dir})
  target_link_libraries(sphsolid_physics INTERFACE Eigen3::Eigen sphsolid_flags)

  file(GLOB sources CONFIGURE_DEPENDS ${package_dir}/*.cpp)

  # An object library instead of more sources of `lammps`: it can have flags of its own, and the
  # plugin uses the same objects. It is compiled like LAMMPS itself, whose headers are not checked
  # for warnings.
  add_library(sphsolid OBJECT ${sources})
  get_target_property(lammps_standard lammps CXX_STANDARD)
  set_target_properties(sphsolid PROPERTIES POSITION_INDEPENDENT_CODE ON
                        CXX_STANDARD ${lammps_standard} CXX_EXTENSIONS OFF)
  target_link_libraries(sphsolid PRIVATE sphsolid_physics)
  target_include_directories(sphsolid SYSTEM PRIVATE
    $<FILTER:$<TARGET_PROPERTY:lammps,INCLUDE_DIRECTORIES>,EXCLUDE,/USER-SPHSOLID$>)
  target_compile_definitions(sphsolid PRIVATE $<TARGET_PROPERTY:lammps,COMPILE_DEFINITIONS>)
  target_compile_options(sphsolid PRIVATE
                         $<$<CXX_COMPILER_ID:GNU,Clang>:-Wall;-Wextra;-Wsuggest-override>)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # false alarms from the compiler's own AVX-512 headers
    target_compile_options(sphsolid PRIVATE -Wno-maybe-uninitialized)
  endif()
  if(BUILD_MPI)
    target_link_libraries(sphsolid PRIVATE MPI::MPI_CXX)
  else()
    target_link_libraries(sphsolid PRIVATE mpi_stubs)
  endif()
  if(BUILD_OMP)
    target_link_libraries(sphsolid PRIVATE OpenMP::OpenMP_CXX)
  endif()

  target_sources(lammps PRIVATE $<TARGET_OBJECTS:sphsolid>)
  target_include_directories(lammps PRIVATE ${package_dir})
  sphsolid_list_package(${lammps_root})

  if(SPHSOLID_BUILD_PLUGIN)
    sphsolid_add_plugin(${package_dir}/plugin/sphsolid_plugin.cpp)
  endif()
endfunction()

# ------------------------------------------------------------------------------------------------
# LAMMPS' own symbols come from the program that loads the plugin; linking liblammps here would put
# a second LAMMPS into it. nodelete: LAMMPS may close the plugin before it deletes our atom style.
function(sphsolid_add_plugin source)
  get_target_property(lammps_standard lammps CXX_STANDARD)
  add_library(sphsolidplugin MODULE ${source} $<TARGET_OBJECTS:sphsolid>)
  foreach(property INCLUDE_DIRECTORIES COMPILE_DEFINITIONS COMPILE_OPTIONS)
    set_property(TARGET sphsolidplugin PROPERTY ${property} $<TARGET_PROPERTY:sphsolid,${property}>)
  endforeach()
  target_link_libraries(sphsolidplugin PRIVATE $<TARGET_PROPERTY:sphsolid,LINK_LIBRARIES>)
  set_target_properties(sphsolidplugin PROPERTIES
    PREFIX "" SUFFIX ".so" LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}
    CXX_STANDARD ${lammps_standard} CXX_EXTENSIONS OFF)
  if(APPLE)
    target_link_options(sphsolidplugin PRIVATE "LINKER:-undefined,dynamic_lookup")
  else()
    target_link_options(sphsolidplugin PRIVATE "LINKER:-z,nodelete")
  endif()
endfunction()
