# Finds out what this machine lacks and installs it with apt-get. Sourced by ./sphsolid and the scripts of tools.

# run <command> [arguments]: what all of them print before they do it
run() {
  echo "+ $*"
  "$@"
}

has_command() { command -v "$1" > /dev/null; }

# has_header <header>: can the compiler find it?
has_header() {
  echo "#include <$1>" | c++ -E -x c++ -I/usr/include/eigen3 - > /dev/null 2>&1
}

# Prints the Debian packages a build lacks: necessary ones with "need", others with "want".
missing_for_build() {
  has_command c++ || echo need g++
  has_command cmake || echo need cmake
  has_command ninja || has_command make || echo need ninja-build
  has_command xz || echo need xz-utils    # LAMMPS archives
  has_command python3 || echo need python3    # asked for by LAMMPS' own CMake script
  has_header Eigen/Core || echo need libeigen3-dev
  has_header gtest/gtest.h || echo need libgtest-dev
  has_header gmock/gmock.h || echo need libgmock-dev

  has_command ninja || echo want ninja-build
  has_command ccache || echo want ccache
  has_command mpicxx || echo want mpich libmpich-dev
  has_header png.h || echo want libpng-dev
  has_header zlib.h || echo want zlib1g-dev
  { has_command curl || has_command wget; } || echo want curl
  [[ -e /etc/ssl/certs/ca-certificates.crt || ! -d /etc/apt ]] || echo want ca-certificates
  # jpeglib.h needs other headers before it, so the compiler cannot be asked
  [[ -e /usr/include/jpeglib.h || ! -d /etc/apt ]] || echo want libjpeg-dev
}

# Sets PYTHON to one that has the modules the examples need; fails if there is none.
# The first python3 of the PATH may be another one than Debian's, without them.
choose_python() {
  local candidate
  for candidate in ${PYTHON:-} python3 /usr/bin/python3; do
    if "$candidate" -c 'import numpy, matplotlib' > /dev/null 2>&1; then
      PYTHON=$(command -v "$candidate")
      export PYTHON
      return 0
    fi
  done
  return 1
}

# Prints the Debian packages that the manual lacks.
missing_for_docs() {
  has_command sphinx-build || echo need python3-sphinx
}

# install_packages <package>...: fails without asking for anything where it may not install
install_packages() {
  local sudo=
  if ! has_command apt-get; then
    return 1
  elif [[ $(id -u) != 0 ]]; then
    { has_command sudo && sudo -n true 2> /dev/null; } || return 1
    sudo="sudo -n"
  fi
  local -a apt=($sudo env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300)
  compgen -G '/var/lib/apt/lists/*_Packages*' > /dev/null || run "${apt[@]}" -qq update
  run "${apt[@]}" install -y -qq --no-install-recommends "$@" && return 0
  # the lists of this machine may be older than what the mirror holds
  run "${apt[@]}" -qq update && run "${apt[@]}" install -y -qq --no-install-recommends "$@"
}

# need_packages build|python|docs: installs what is missing, or says what to install and stops
need_packages() {
  local lines needed all
  case $1 in
    build) lines=$(missing_for_build) ;;
    docs) lines=$(missing_for_docs) ;;
    *)
      choose_python && return 0
      lines="need python3 python3-numpy python3-matplotlib"
      ;;
  esac
  [[ -z $lines ]] && return 0
  all=$(sed -E 's/^(need|want) //' <<< "$lines" | tr ' ' '\n' | sort -u | tr '\n' ' ')
  needed=$(grep '^need' <<< "$lines" | sed 's/^need //' | tr '\n' ' ') || true

  if install_packages $all; then
    [[ $1 != python ]] || choose_python && return 0
    needed=$all
  fi
  if [[ -n $needed ]]; then
    echo "ERROR: this machine lacks programs or libraries that are needed. Please run" >&2
    echo "    apt-get install $all" >&2
    exit 1
  fi
  echo "Going on without $all(to have what they offer: apt-get install $all)"
}
