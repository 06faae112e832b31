#!/usr/bin/env bash
# Tests of tools/fetch_lammps.sh that need no network: test_fetch.sh <case>

set -u
fetch=$(dirname "$0")/../fetch_lammps.sh
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export SPHSOLID_CACHE=$folder/cache
# nothing answers there
export SPHSOLID_GITHUB=http://127.0.0.1:9 SPHSOLID_DEBIAN_MIRROR=http://127.0.0.1:9/debian
unset http_proxy https_proxy all_proxy HTTP_PROXY HTTPS_PROXY ALL_PROXY

# lammps_tree <folder> <release>
lammps_tree() {
  mkdir -p "$1/src" "$1/cmake" "$1/examples"
  echo "#define LAMMPS_VERSION \"$2\"" > "$1/src/version.h"
  touch "$1/cmake/CMakeLists.txt" "$1/examples/in.big"
}

# expect <what> <text>: the output of the script contains the text
expect() {
  grep -qF -- "$2" "$folder/out" && return
  echo "FAILED: $1: \"$2\" is not in"
  cat "$folder/out"
  exit 1
}

# call <expected status> [options]
call() {
  local expected=$1
  shift
  "$fetch" "$@" > "$folder/out" 2>&1
  local status=$?
  [[ $status == "$expected" ]] && return
  echo "FAILED: status $status instead of $expected"
  cat "$folder/out"
  exit 1
}

case $1 in
  cache_hit)    # the newest copy is taken, and nothing is said
    lammps_tree "$SPHSOLID_CACHE/lammps-20250204" "4 Feb 2025"
    lammps_tree "$SPHSOLID_CACHE/lammps-20260704" "4 Jul 2026"
    call 0
    [[ $(cat "$folder/out") == "$SPHSOLID_CACHE/lammps-20260704" ]] || expect folder lammps-20260704
    call 0 --version 20250204
    expect "asked-for version" "$SPHSOLID_CACHE/lammps-20250204"
    ;;
  nothing_works)    # each source is named, with a reason
    call 1
    expect cache "- $SPHSOLID_CACHE: no earlier download"
    for source in patch_4Jul2026 patch_4Feb2025; do
      expect official "- http://127.0.0.1:9/$source.tar.gz: "
    done
    if command -v apt-get > /dev/null && [[ -e /usr/share/keyrings/debian-archive-keyring.gpg ]]; then
      for source in forky sid trixie; do
        expect Debian "- Debian $source at http://127.0.0.1:9/debian: "
      done
    else
      expect Debian "- Debian's source archive: "
    fi
    [[ -z $(ls -A "$SPHSOLID_CACHE") ]] || { echo "FAILED: something is left behind" && exit 1; }
    ;;
  own_archive)    # with and without a folder of its own in the archive
    lammps_tree "$folder/lammps-mine" "4 Feb 2025"
    tar -C "$folder" -czf "$folder/a.tar.gz" lammps-mine
    tar -C "$folder/lammps-mine" -czf "$folder/b.tar.gz" cmake examples src
    for archive in a b; do
      rm -rf "$SPHSOLID_CACHE"
      sum=$(sha256sum "$folder/$archive.tar.gz" | cut -d ' ' -f 1)
      call 0 --url "file://$folder/$archive.tar.gz" --sha256 "$sum"
      unpacked=$SPHSOLID_CACHE/lammps-20250204-${sum:0:12}
      expect folder "$unpacked"
      [[ -f $unpacked/src/version.h ]] || expect unpacked src/version.h
      [[ ! -e $unpacked/examples ]] || expect "without examples" "no examples"
    done
    rm "$folder/b.tar.gz"    # the second time, no download is needed
    call 0 --url "file://$folder/b.tar.gz" --sha256 "$sum"
    expect folder "$unpacked"
    ;;
  wrong_checksum)
    lammps_tree "$folder/lammps-mine" "4 Feb 2025"
    tar -C "$folder" -czf "$folder/a.tar.gz" lammps-mine
    call 1 --url "file://$folder/a.tar.gz" --sha256 0123
    expect reason "not 0123"
    call 1 --url "file://$folder/a.tar.gz"
    expect reason "give its checksum too"
    ;;
  wrong_version)
    lammps_tree "$folder/lammps-mine" "4 Feb 2025"
    tar -C "$folder" -czf "$folder/a.tar.gz" lammps-mine
    call 1 --version 20260704 --url "file://$folder/a.tar.gz" \
      --sha256 "$(sha256sum "$folder/a.tar.gz" | cut -d ' ' -f 1)"
    expect reason "the archive holds LAMMPS 20250204, not 20260704"
    call 1 --version 19991231
    expect reason "not among the releases"
    ;;
  *)
    echo "unknown case $1"
    exit 2
    ;;
esac
