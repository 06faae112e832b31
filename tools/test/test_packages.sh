#!/usr/bin/env bash
# Tests of tools/packages.sh on a pretended machine: test_packages.sh <case>

set -euo pipefail
source "$(dirname "$0")/../packages.sh"

installed="apt-get c++ cmake ninja xz python3 ccache mpicxx curl"
user=0
has_command() { [[ " $installed " == *" $1 "* ]]; }
has_header() { return 0; }
id() { echo $user; }
declare -F run > /dev/null || { echo "FAILED: who sources packages.sh has no run()" && exit 1; }
run() { echo "+ $*"; }
fail() { echo "FAILED: $1" && exit 1; }

case $1 in
  installs_as_root)
    installed="apt-get c++ ninja xz python3 ccache mpicxx curl"
    out=$(need_packages build)
    [[ $out == *"+ env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 install "*" cmake"* ]] || fail "$out"
    [[ $out != *sudo* ]] || fail "$out"
    ;;
  says_what_to_install)    # neither root nor sudo
    installed="apt-get c++ ninja xz python3 ccache mpicxx curl"
    user=1000
    out=$(need_packages build 2>&1) && fail "it should have stopped"
    [[ $out == *"apt-get install "*cmake* ]] || fail "$out"
    # what is only useful does not stop anybody
    installed="apt-get c++ cmake ninja xz python3 mpicxx curl"
    out=$(need_packages build) || fail "it should have gone on"
    [[ $out == *"Going on without ccache"* ]] || fail "$out"
    ;;
  docs)    # Sphinx is asked for by the manual only
    out=$(need_packages docs)
    [[ $out == *"apt-get -o DPkg::Lock::Timeout=300 install "*python3-sphinx* && $out != *cmake* ]] || fail "$out"
    installed+=" sphinx-build"
    out=$(need_packages docs)
    [[ -z $out ]] || fail "$out"
    ;;
  nothing_missing)
    has_header() { return 0; }
    out=$(missing_for_build | grep -v -e libjpeg-dev -e ca-certificates) || true
    [[ -z $out ]] || fail "$out"
    ;;
  *)
    fail "unknown case $1"
    ;;
esac
