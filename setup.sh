#!/bin/bash
# From a fresh Debian 12 to a running program. Safe to repeat: what is done already is not done again.
#
#   ./setup.sh run         install packages, build, run decks/hydrogen_plate and draw its pictures
#   ./setup.sh test        install packages, build, run all tests
#   ./setup.sh sanitize    install packages, build with address and undefined-behaviour sanitizers, run the tests with them
#   ./setup.sh benchmark   install packages, build, measure; writes build/benchmark.json and .md (--quick: tiny bodies)
#   ./setup.sh build       install packages, build
set -euo pipefail

readonly source_folder="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
build_folder="$source_folder/build"
sanitizers=""
readonly jobs="$(nproc)"

packages=(
  # compiler and build
  build-essential cmake ninja-build ccache pkg-config clang-format
  # distributed vectors, linear solvers, partition, files
  libopenmpi-dev openmpi-bin trilinos-all-dev libmumps-dev libptscotch-dev libhdf5-openmpi-dev libnetcdf-mpi-dev
  # a fast BLAS in place of the reference one, without threads of its own
  libopenblas0-serial
  # decks, functions, command line, text, search, random numbers
  libyaml-cpp-dev libtinyxml2-dev libmuparser-dev libcli11-dev libfmt-dev libnanoflann-dev librandom123-dev nlohmann-json3-dev
  # tests and benchmarks
  libgtest-dev libbenchmark-dev
  # meshes and pictures
  gmsh python3-gmsh python3 python3-numpy python3-scipy python3-h5py python3-meshio python3-netcdf4
  python3-matplotlib python3-contourpy python3-shapely python3-pil ffmpeg
)
# For one test, which is skipped without it: ParaView reads the results.
test_packages=(paraview python3-paraview)

usage() {
  sed -n '2,9s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
}

install_packages() { # names
  command -v dpkg-query >/dev/null || {
    echo "setup.sh: dpkg not found; this script installs Debian packages. Install these by hand: $*" >&2
    exit 1
  }
  local missing=() name
  for name in "$@"; do
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
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-remove --no-install-recommends "${missing[@]}"
}

build() { # targets; everything where none is named
  cmake -S "$source_folder" -B "$build_folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DPD_WARNINGS_AS_ERRORS=ON \
    -DPD_SANITIZE="$sanitizers"
  cmake --build "$build_folder" -j "$jobs" ${1:+--target "$@"}
}

run_main_job() {
  "$source_folder/decks/hydrogen_plate/run.sh"
  echo
  echo "Open results/hydrogen_plate/damage.png: the crack at four times. Beside it:"
  ls "$source_folder"/results/hydrogen_plate/*.png
}

run_tests() { # options of ctest
  # Open MPI refuses to start as root, as in a container, unless it is told twice.
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  ctest --test-dir "$build_folder" -j 2 --output-on-failure "$@"
}

run_sanitized_tests() {
  # Open MPI keeps memory until the process ends, which the search for leaks takes for a leak.
  export ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=print_stacktrace=1
  # Runs on four ranks only take long, pdmesh and pdplot are not compiled, and nobody installs this build.
  run_tests -L 'unit|plugin|own_model|cli|stability|verification' -E 'pdmesh|pdplot|installation|_np4'
}

case "${1:-}" in
  run | test | sanitize | benchmark | build) ;;
  -h | --help) usage; exit 0 ;;
  *) usage >&2; exit 2 ;;
esac
install_packages "${packages[@]}"
case "$1" in
  run) build pdrun; run_main_job ;;
  test)
    install_packages "${test_packages[@]}" || echo "setup.sh: no ${test_packages[*]}: their test will be skipped" >&2
    build
    run_tests
    ;;
  sanitize)
    build_folder="$source_folder/build-sanitize" sanitizers="address,undefined"
    build
    run_sanitized_tests
    ;;
  build) build ;;
  benchmark) build; "$source_folder/tests/benchmark/benchmark.py" "$build_folder" "${@:2}" ;;
esac
