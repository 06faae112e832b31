#!/usr/bin/env bash
# Builds LAMMPS with the package in one of the other ways the manual describes, and runs the same
# small scene with it as with the ordinary build: the numbers have to be the same.
#
#   tools/test/route.sh <route> <ordinary build folder> <folder to build in>
#
#   hook     LAMMPS' own CMake script, with cmake/USER-SPHSOLID.cmake
#   plugin   a LAMMPS without the package that loads sphsolidplugin.so of the ordinary build
#   oldest   the superbuild with the oldest LAMMPS that is supported
#   serial   the superbuild without MPI and OpenMP
#
# With -objects after the name, only our own sources are compiled, which takes a minute.

set -Eeuo pipefail    # E: the trap below also sees a failure inside run()
route=$1
ordinary=$(cd "$2" && pwd)
mkdir -p "$3"
folder=$(cd "$3" && pwd)
root=$(cd "$(dirname "$0")/../.." && pwd)
jobs=${JOBS:-$(nproc)}
scene=$root/tools/test/in.smoke
trap 'tail -n 30 "$folder"/*.log >&2' ERR    # stdout may be one of these logs

source "$root/tools/packages.sh"    # run()

cached() { sed -n "s/^$1:[A-Z]*=//p" "$ordinary/CMakeCache.txt"; }

# the numbers a scene prints
numbers() { "$@" -in "$scene" -log none | awk '/^ *Step/ { on = 1 } /^Loop time/ { on = 0 } on'; }

lammps=$(cached SPHSOLID_LAMMPS_ROOT)
generator=$(cached CMAKE_GENERATOR)
# the same options as the superbuild, so that ccache has most objects already
options=(-G "$generator" -D CMAKE_BUILD_TYPE=Release -D PKG_SPH=on -D PKG_MACHDYN=on -D PKG_PLUGIN=on)
[[ -d $lammps/src/GRAPHICS ]] && options+=(-D PKG_GRAPHICS=on)
command -v ccache > /dev/null && options+=(-D CMAKE_CXX_COMPILER_LAUNCHER=ccache)

case $route in
  hook)
    run cmake -S "$lammps/cmake" -B "$folder" "${options[@]}" \
      -D CMAKE_PROJECT_lammps_INCLUDE="$root/cmake/USER-SPHSOLID.cmake" > "$folder/configure.log"
    run cmake --build "$folder" --parallel "$jobs" > "$folder/build.log"
    program=("$folder/lmp")
    ;;
  plugin)
    run cmake -S "$lammps/cmake" -B "$folder" "${options[@]}" > "$folder/configure.log"
    run cmake --build "$folder" --parallel "$jobs" > "$folder/build.log"
    program=(env LAMMPS_PLUGIN_PATH="$folder/plugins" "$folder/lmp")
    mkdir -p "$folder/plugins"
    cp "$ordinary/sphsolidplugin.so" "$folder/plugins/"
    ;;
  oldest | oldest-objects | serial | serial-objects)
    if [[ $route == oldest* ]]; then
      superbuild=(-D LAMMPS_SOURCE_DIR="$("$root/tools/fetch_lammps.sh" --version 20250204)")
    else
      superbuild=(-D LAMMPS_SOURCE_DIR="$lammps" -D BUILD_MPI=off -D BUILD_OMP=off)
    fi
    run cmake -S "$root" -B "$folder" -G "$generator" "${superbuild[@]}" \
      -D SPHSOLID_BUILD_TESTS=off > "$folder/configure.log"
    if [[ $route == *-objects ]]; then
      run cmake --build "$folder" --parallel "$jobs" --target sphsolidplugin > "$folder/build.log"
      echo "$route: compiled"
      exit 0
    fi
    run cmake --build "$folder" --parallel "$jobs" --target programs > "$folder/build.log"
    program=("$folder/lmp")
    ;;
  *)
    echo "unknown route $route" >&2
    exit 2
    ;;
esac

numbers "$ordinary/lmp" > "$folder/ordinary.txt"
numbers "${program[@]}" > "$folder/route.txt"
if [[ ! -s $folder/ordinary.txt ]] || ! diff "$folder/ordinary.txt" "$folder/route.txt"; then
  echo "FAILED: $route gives other numbers than the ordinary build"
  exit 1
fi
echo "$route: the same numbers as the ordinary build"
