#!/usr/bin/env bash
# Builds the modules and their tests for another machine and runs the tests in an emulator; or builds the program
# same_bytes in many ways for this one. Installs the Debian packages that this takes.
#
#   bash tests/cross/run.sh aarch64 [OPTION OF ctest...]   64-bit ARM, in QEMU
#   bash tests/cross/run.sh windows [OPTION OF ctest...]   64-bit Windows, in Wine
#   bash tests/cross/run.sh x86                            GCC and Clang, with and without optimisation, vectors and AVX2
#
# The module whittle::openmesh and the program are left out. All is built in build/cross-MACHINE.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source apps/packages.sh

usage() { fail "usage: bash tests/cross/run.sh aarch64|windows|x86 [OPTION OF ctest...]"; }

machine=${1:-}
[ -n "$machine" ] || usage
shift
build=$PWD/build/cross-$machine
header_packages=(libeigen3-dev libnanoflann-dev libfast-float-dev)
own_packages=(cmake ninja-build googletest "${header_packages[@]}")

# Copies the files of header-only libraries to where the toolchain files look for them.
gather_headers() {
  dpkg -L "${header_packages[@]}" | grep -E '^/usr/(include|share|lib)/' | grep -v '^/usr/share/doc' |
    while IFS= read -r path; do
      if [ -f "$path" ]; then install -D --mode=644 "$path" "$build/headers$path"; fi
    done
}

# configure_other_machine OPTION...: also options for all tests of the modules.
configure_other_machine() {
  cmake -G Ninja -S . -B "$build" --toolchain "$PWD/tests/cross/$machine.cmake" -DCMAKE_BUILD_TYPE=Release \
    -DWHITTLE_CROSS_HEADERS="$build/headers" -DWHITTLE_GOOGLETEST=/usr/src/googletest -DWHITTLE_WARNINGS_AS_ERRORS=ON \
    -DWHITTLE_BUILD_OPENMESH=OFF -DWHITTLE_BUILD_APPS=OFF "$@"
}

test_other_machine() {
  say "Building for $machine"
  quietly "$build/headers.log" gather_headers
  quietly "$build/configure.log" configure_other_machine
  quietly "$build/build.log" cmake --build "$build"
  say "Running the tests in an emulator"
  ctest --test-dir "$build" --output-on-failure --parallel "$(nproc)" "$@"
}

# same_bytes_of FOLDER COMPILER FLAGS [OPTION OF cmake...]: builds same_bytes.
build_same_bytes() {
  local folder=$1 compiler=$2 flags=$3
  shift 3
  cmake -G Ninja -S . -B "$folder" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=None \
    -DCMAKE_CXX_FLAGS="$flags" -DWHITTLE_BUILD_APPS=OFF -DWHITTLE_BUILD_OPENMESH=OFF -DCMAKE_UNITY_BUILD=ON "$@" &&
    cmake --build "$folder" --target same_bytes
}

# check_same_bytes NAME COMPILER FLAGS [OPTION OF cmake...]: with this processor's registers, and with those of one
# without AVX2, for which the system's library has other functions, too.
check_same_bytes() {
  local folder=$build/$1 program=$build/$1/tests/same_bytes/same_bytes
  quietly "$folder.log" build_same_bytes "$folder" "${@:2}"
  printf '%-22s %s\n' "$1" "$("$program" | tail -n 1)"
  "$program" >/dev/null || n_failed=$((n_failed + 1))
  [[ $1 != *-O2 ]] && return
  printf '%-22s %s\n' "$1, without AVX2" "$(qemu-x86_64 -cpu Nehalem "$program" | tail -n 1)"
}

test_compilers() {
  local compiler level n_failed=0
  for compiler in g++-12 clang++-14; do
    for level in -O0 -O1 -O2 -O3; do
      check_same_bytes "$compiler$level" "$compiler" "$level"
      check_same_bytes "$compiler$level-scalar" "$compiler" "$level" -DWHITTLE_SCALAR=ON
    done
    check_same_bytes "$compiler-fused" "$compiler" "-O2 -march=haswell"
    check_same_bytes "$compiler-fast-math" "$compiler" "-O2 -ffast-math"
  done
  check_same_bytes g++-11 g++-11 -O2 # which has no shuffles, so it takes the scalar form by itself
  [ "$n_failed" = 0 ] || fail "$n_failed builds have other results"
}

case $machine in
  aarch64)
    install_packages "$build/packages.log" "${own_packages[@]}" g++-aarch64-linux-gnu qemu-user
    test_other_machine "$@"
    ;;
  windows)
    install_packages "$build/packages.log" "${own_packages[@]}" g++-mingw-w64-x86-64-posix wine wine64
    export WINEPREFIX=$build/wine WINEDEBUG=-all
    test_other_machine "$@"
    ;;
  x86)
    install_packages "$build/packages.log" "${own_packages[@]}" g++-12 clang-14 g++-11 qemu-user libgtest-dev libgmock-dev
    test_compilers
    ;;
  *) usage ;;
esac
