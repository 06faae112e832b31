#!/usr/bin/env bash
# Prints the folder of a LAMMPS source tree, fetching it first where there is none in the cache.
#
#   tools/fetch_lammps.sh [--version YYYYMMDD] [--url URL --sha256 SUM]
#
# Without --version the newest release that can be had is taken. Sources, in this order:
#   1. an earlier download in the cache folder
#   2. the archive given by --url, if it has the checksum given by --sha256; then no other is tried
#   3. the official archive of the release, if it has the checksum pinned below
#   4. Debian's source archive, whose signature apt checks
# The folder goes to standard output, everything else to standard error.
#
# Environment: SPHSOLID_CACHE          cache folder, default ${XDG_CACHE_HOME:-~/.cache}/sphsolid
#              SPHSOLID_GITHUB         base address of the official archives
#              SPHSOLID_DEBIAN_MIRROR  Debian mirror, default the one this machine uses

set -u -o pipefail

# Releases known to work, newest first: the LAMMPS tag, its checksum, the Debian suites that may hold it.
# The checksums are those that the Spack package manager records for the tag archives of LAMMPS.
release_dates=(20260704 20250204)
declare -A tag=([20260704]=patch_4Jul2026 [20250204]=patch_4Feb2025)
declare -A checksum=(
  [20260704]=be9deffba169d140c337fd29570d3f5469332ece7e77280cce998f6caaad5534
  [20250204]=a4cb0a58451d47ac31ee3e1f148d92f445298d6e27f2d06f161b9b4168d79eb1)
declare -A suites=([20260704]="forky sid" [20250204]="trixie")

cache=${SPHSOLID_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/sphsolid}
github=${SPHSOLID_GITHUB:-https://github.com/lammps/lammps/archive}
wanted= url= sum=
work=
tried=()

say() { echo "-- $*" >&2; }
failed() { tried+=("$1"); say "  no: $1"; }

# ------------------------------------------------------------------------------------------------
# downloads

# download <url> <file>: gives up on a server that does not answer or stalls
download() {
  if command -v curl > /dev/null; then
    curl --fail --location --silent --show-error --connect-timeout 15 --retry 1 \
      --speed-limit 1000 --speed-time 30 --max-time 3600 --output "$2" "$1" 2> "$work/reason"
  elif command -v wget > /dev/null; then
    wget --no-verbose --tries=2 --timeout=30 --output-document="$2" "$1" 2> "$work/reason"
  else
    echo "neither curl nor wget is installed" > "$work/reason"
    return 1
  fi
}

reason() { grep -v '^$' "$work/reason" | tail -n 1 | cut -c -160; }

# from_url <url> <sha256>: leaves $work/archive
from_url() {
  say "fetching $1"
  if ! download "$1" "$work/archive"; then
    failed "$1: $(reason)"
    return 1
  fi
  local got
  got=$(sha256sum "$work/archive" | cut -d ' ' -f 1)
  if [[ $got != "$2" ]]; then
    failed "$1: its SHA256 is $got, not $2"
    return 1
  fi
}

# ------------------------------------------------------------------------------------------------
# Debian. apt runs with folders of its own, so neither root nor a change to this machine is needed.

debian_mirror() {
  local found
  if [[ -n ${SPHSOLID_DEBIAN_MIRROR:-} ]]; then
    echo "$SPHSOLID_DEBIAN_MIRROR"
    return
  fi
  # the main archive of this machine, not its security, updates or backports suites
  found=$(apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(ORIGIN) $(LABEL)' \
    'Created-By: Packages' 2> /dev/null |
    awk '$1 ~ /security/ || $2 ~ /-/ { next }
         $3 == "Debian" && $4 == "Debian" { print $1; exit }
         $3 !~ /Debian/ && $1 ~ /\/debian\/?$/ { print $1; exit }')
  echo "${found:-http://deb.debian.org/debian}"
}

debian_keyring() {
  local file
  for file in /usr/share/keyrings/debian-archive-keyring.{gpg,pgp}; do
    [[ -r $file ]] && echo "$file" && return
  done
  return 1
}

# apt_folder <folder> <source line>: an apt of its own. Check-Valid-Until: the index of a mirror that lags
# behind will do. The version is fixed, and the signature is checked all the same.
apt_folder() {
  local dir=$1
  mkdir -p "$dir/lists/partial" "$dir/cache/archives/partial" "$dir/download"
  echo "$2" > "$dir/sources.list"
  {
    apt-config dump 2> /dev/null | grep -E '^Acquire::(http|https|Proxy)'    # proxies of this machine
    cat << END_OF_CONF
Dir::Etc::Main "/dev/null";
Dir::Etc::Parts "/dev/null";
Dir::Etc::sourcelist "$dir/sources.list";
Dir::Etc::sourceparts "/dev/null";
Dir::Etc::preferencesparts "/dev/null";
Dir::State "$dir";
Dir::State::Lists "$dir/lists";
Dir::State::status "/dev/null";
Dir::Cache "$dir/cache";
APT::Sandbox::User "root";
Acquire::Languages "none";
Acquire::Check-Valid-Until "false";
Acquire::Retries "1";
Acquire::http::Timeout "20";
Acquire::https::Timeout "20";
END_OF_CONF
  } > "$dir/apt.conf"
}

# from_suite <folder of apt> <YYYYMMDD> <what to call the suite>: leaves $work/archive
from_suite() {
  local dir=$1 date=$2 version why file
  local -x APT_CONFIG=$dir/apt.conf
  say "looking for LAMMPS $date in $3"
  # apt calls a server that does not answer a warning
  timeout 300 apt-get -qq update > /dev/null 2> "$work/reason"
  version=$(apt-cache showsrc lammps 2> /dev/null |
    awk -v date="$date" '$1 == "Version:" && index($2, date) == 1 { print $2; exit }')
  if [[ -z $version ]]; then
    why=$(grep '^[WE]:' "$work/reason" | head -n 1 | cut -c -160)
    failed "$3: ${why:-it has no lammps $date}"
    return 1
  fi
  say "fetching lammps $version"
  if ! (cd "$dir/download" && timeout 3600 apt-get -qq source --download-only --tar-only \
    "lammps=$version" > /dev/null 2> "$work/reason"); then
    failed "$3: $(reason)"
    return 1
  fi
  for file in "$dir"/download/lammps_*.orig.tar.*; do
    [[ $file == *.asc ]] || mv "$file" "$work/archive"
  done
  return 0
}

# from_debian <YYYYMMDD>: leaves $work/archive
from_debian() {
  local date=$1 keyring suite mirror dir
  if ! command -v apt-get > /dev/null || ! command -v apt-cache > /dev/null; then
    failed "Debian's source archive: this machine has no apt"
    return 1
  fi
  if ! keyring=$(debian_keyring); then
    failed "Debian's source archive: /usr/share/keyrings/debian-archive-keyring.gpg is missing (package debian-archive-keyring)"
    return 1
  fi
  mirror=$(debian_mirror)
  for suite in ${suites[$date]}; do    # one index at a time: each is ten megabytes
    dir=$work/apt-$suite
    apt_folder "$dir" "deb-src [signed-by=$keyring] $mirror $suite main"
    from_suite "$dir" "$date" "Debian $suite at $mirror" && return
  done
  return 1
}

# ------------------------------------------------------------------------------------------------
# version_of <folder>: release date of a LAMMPS source tree, nothing if it is none
version_of() {
  [[ -f $1/src/version.h && -f $1/cmake/CMakeLists.txt ]] || return 1
  local text
  text=$(sed -n 's/.*LAMMPS_VERSION "\(.*\)".*/\1/p' "$1/src/version.h")
  date -d "$text" +%Y%m%d 2> /dev/null
}

# unpack <date>: puts what a build needs of $work/archive into the cache; date may be empty
unpack() {
  local top folder=$work/tree name found final
  mkdir "$folder"
  top=$(tar -tf "$work/archive" 2> /dev/null | head -n 1 || true)
  top=${top#./}
  case $top in    # the archive has a folder of its own, or not
    *lammps*/*) top=${top%%/*}/ ;;
    *) top= ;;
  esac
  local -a leave_out=()
  for name in examples potentials bench tools doc/src doc/utils doc/doxygen doc/graphviz \
    doc/Manual.pdf unittest/force-styles/tests; do
    leave_out+=("--exclude=$top$name" "--exclude=./$top$name")
  done
  if ! tar -xf "$work/archive" --no-same-owner -C "$folder" --anchored "${leave_out[@]}" 2> "$work/reason"; then
    failed "unpacking: $(reason)"
    return 1
  fi
  folder=$folder/${top%/}
  mkdir -p "$folder/bench" "$folder/potentials"    # named by the install rules of LAMMPS
  found=$(version_of "$folder") || {
    failed "the archive holds no LAMMPS source tree"
    return 1
  }
  if [[ -n $1 && $found != "$1" ]]; then
    failed "the archive holds LAMMPS $found, not $1"
    return 1
  fi
  final=$cache/lammps-$found${sum:+-${sum:0:12}}    # an archive of your own gets a folder of its own
  # a rename is all or nothing; if another process was quicker, its copy is as good
  mv -T "$folder" "$final" 2> /dev/null || version_of "$final" > /dev/null || {
    failed "cannot write to $final"
    return 1
  }
  say "LAMMPS $found is now in $final"
  echo "$final"
}

# ------------------------------------------------------------------------------------------------
while [[ $# -gt 0 ]]; do
  case $1 in
    --version) wanted=$2 ;;
    --url) url=$2 ;;
    --sha256) sum=$2 ;;
    *) echo "fetch_lammps.sh: unknown option $1" >&2 && exit 2 ;;
  esac
  shift 2
done

if [[ -n $wanted && -z $url && -z ${tag[$wanted]:-} && ! -d $cache/lammps-$wanted ]]; then
  echo "ERROR: LAMMPS $wanted is not among the releases that can be fetched: ${release_dates[*]}" >&2
  exit 1
fi
[[ -n $wanted ]] && release_dates=("$wanted")

if [[ -n $sum ]]; then
  for folder in "$cache"/lammps-*-"${sum:0:12}"; do
    if version_of "$folder" > /dev/null; then
      echo "$folder"
      exit 0
    fi
  done
fi
if [[ -z $url ]]; then
  for date in "${release_dates[@]}"; do
    if version_of "$cache/lammps-$date" > /dev/null; then
      echo "$cache/lammps-$date"
      exit 0
    fi
  done
  failed "$cache: no earlier download"
fi

mkdir -p "$cache" && work=$(mktemp -d "$cache/.fetch.XXXXXX") || {
  echo "ERROR: cannot write to the cache folder $cache" >&2
  exit 1
}
trap 'rm -rf "$work"' EXIT

if [[ -n $url ]]; then
  if [[ -z $sum ]]; then
    failed "$url: give its checksum too (SPHSOLID_LAMMPS_SHA256)"
  elif from_url "$url" "$sum" && unpack "$wanted"; then
    exit 0
  fi
else
  for date in "${release_dates[@]}"; do
    for source in official debian; do
      rm -rf "$work"/*
      case $source in
        official) from_url "$github/${tag[$date]}.tar.gz" "${checksum[$date]}" ;;
        debian) from_debian "$date" ;;
      esac && unpack "$date" && {
        [[ $date == "${release_dates[0]}" ]] ||
          say "LAMMPS ${release_dates[0]} could not be had: this is the older release $date"
        exit 0
      }
    done
  done
fi

{
  echo "ERROR: no LAMMPS source tree could be found or fetched. Tried:"
  printf '  - %s\n' "${tried[@]}"
} >&2
exit 1
