#!/bin/bash
# From a fresh Debian 12 to a running program. Safe to repeat: what is done already is not done again.
#
#   ./setup.sh run         install packages, build, run decks/hydrogen_plate and draw its pictures
#   ./setup.sh test        install packages, build, run all tests
#   ./setup.sh benchmark   install packages, build, measure; writes build/benchmark.json (--quick: tiny bodies)
#   ./setup.sh build       install packages, build
set -euo pipefail

readonly source_folder="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
readonly build_folder="$source_folder/build"
readonly jobs="$(nproc)"

packages=(
  # compiler and build
  build-essential cmake ninja-build ccache pkg-config clang-format
  # distributed vectors, linear solvers, partition, files
  libopenmpi-dev openmpi-bin trilinos-all-dev libptscotch-dev libhdf5-openmpi-dev
  # decks, functions, command line, text, search, random numbers
  libyaml-cpp-dev libmuparser-dev libcli11-dev libfmt-dev libnanoflann-dev librandom123-dev nlohmann-json3-dev
  # tests and benchmarks
  libgtest-dev libbenchmark-dev
  # meshes and pictures
  gmsh python3 python3-numpy python3-scipy python3-h5py python3-meshio python3-matplotlib python3-pil
)

usage() {
  sed -n '2,8s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
}

install_packages() {
  command -v dpkg-query >/dev/null || {
    echo "setup.sh: dpkg not found; this script installs Debian packages. Install these by hand: ${packages[*]}" >&2
    exit 1
  }
  local missing=() name
  for name in "${packages[@]}"; do
    [[ "$(dpkg-query -W -f '${db:Status-Status}\n' "$name" 2>/dev/null | sort -u)" == installed ]] || missing+=("$name")
  done
  ((${#missing[@]})) || return 0
  echo "setup.sh: installing ${missing[*]}"
  local as_root=()
  if ((EUID != 0)); then
    command -v sudo >/dev/null || {
      echo "setup.sh: not root and no sudo. Let an administrator run: apt-get install ${missing[*]}" >&2
      exit 1
    }
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"
}

build() { # targets; everything where none is named
  cmake -S "$source_folder" -B "$build_folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DPD_WARNINGS_AS_ERRORS=ON
  cmake --build "$build_folder" -j "$jobs" ${1:+--target "$@"}
}

run_main_job() {
  "$source_folder/decks/hydrogen_plate/run.sh"
  echo
  echo "Open results/hydrogen_plate/damage.png: the crack at four times. Beside it:"
  ls "$source_folder"/results/hydrogen_plate/*.png
}

run_tests() {
  # Open MPI refuses to start as root, as in a container, unless it is told twice.
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  ctest --test-dir "$build_folder" -j 2 --output-on-failure
}

case "${1:-}" in
  run | test | benchmark | build) ;;
  -h | --help) usage; exit 0 ;;
  *) usage >&2; exit 2 ;;
esac
install_packages
case "$1" in
  run) build pdrun; run_main_job ;;
  test) build; run_tests ;;
  build) build ;;
  benchmark) build; "$source_folder/tests/benchmark/benchmark.py" "$build_folder" "${@:2}" ;;
esac
