#!/usr/bin/env bash
# Builds the modules and their tests for another machine and runs the tests in an emulator; or builds the program
# same_bytes in many ways for this one. Installs the Debian packages that this takes.
#
#   bash tests/cross/run.sh aarch64 [OPTION OF ctest...]   64-bit ARM, in QEMU
#   bash tests/cross/run.sh windows [OPTION OF ctest...]   64-bit Windows, in Wine
#   bash tests/cross/run.sh windows-program                the program for 64-bit Windows, in Wine (windows_program.sh)
#   bash tests/cross/run.sh x86                            GCC and Clang, with and without optimisation, vectors and AVX2
#
# The module whittle::openmesh and the program are left out but for `windows-program`. All is built in
# build/cross-MACHINE.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source apps/packages.sh
source apps/debian_sources.sh

usage() { fail "usage: bash tests/cross/run.sh aarch64|windows|windows-program|x86 [OPTION OF ctest...]"; }

machine=${1:-}
[ -n "$machine" ] || usage
shift
build=$PWD/build/cross-$machine
libraries=$build/libraries # where the toolchain files look for them
header_packages=(libeigen3-dev libnanoflann-dev libfast-float-dev libxxhash-dev nlohmann-json3-dev)
own_packages=(cmake ninja-build googletest "${header_packages[@]}")

# The libraries that are headers alone serve any machine.
gather_headers() {
  dpkg -L "${header_packages[@]}" | grep -E '^/usr/(include|share|lib)/' | grep -v '^/usr/share/doc' |
    while IFS= read -r path; do
      if [ -f "$path" ]; then install -D --mode=644 "$path" "$libraries$path"; fi
    done
}

# zlib, the one library that isn't: Debian's package for that machine.
gather_zlib() {
  local from
  case $machine in
    aarch64)
      apt_options=(-o APT::Architecture=arm64 -o APT::Architectures=arm64)
      open_lists "$build/apt" "deb bookworm"
      apt_apart "$build/apt" download zlib1g-dev
      dpkg -x "$build"/apt/zlib1g-dev*.deb "$build/zlib"
      from=$build/zlib/usr
      ;;
    windows | windows-program) from=/usr/x86_64-w64-mingw32 ;;
  esac
  find "$from" \( -name zlib.h -o -name zconf.h \) -exec install -D --mode=644 -t "$libraries/usr/include" {} +
  find "$from" -name libz.a -exec install -D --mode=644 -t "$libraries/usr/lib" {} +
}

gather_libraries() {
  gather_headers
  gather_zlib
}

# OpenMesh for Windows, of Debian's sources, which it makes an archive of there.
build_openmesh() {
  local sources=$build/sources
  open_lists "$sources" "deb-src bookworm" &&
    apt_apart "$sources" source openmesh &&
    cmake -G Ninja -S "$sources"/openmesh-*/ -B "$sources/build" --toolchain "$PWD/tests/cross/windows.cmake" \
      -DWHITTLE_CROSS_LIBRARIES="$libraries" -DCMAKE_BUILD_TYPE=Release -DBUILD_APPS=OFF \
      -DCMAKE_INSTALL_PREFIX="$libraries/usr" &&
    cmake --build "$sources/build" --target install &&
    touch "$build/openmesh.done"
}

# Of the libraries that are optional none is there, so the program has no reports, pictures or compressed glTF. Warnings
# are no errors: GCC 12 reports copies of too many bytes inside of std::string that there aren't.
configure_windows_program() {
  cmake -G Ninja -S . -B "$build" --toolchain "$PWD/tests/cross/windows.cmake" -DCMAKE_BUILD_TYPE=Release \
    -DWHITTLE_CROSS_LIBRARIES="$libraries" -DWHITTLE_BUILD_REPORT=OFF -DWHITTLE_BUILD_RENDER=OFF \
    -DWHITTLE_BUILD_TESTS=OFF -DCMAKE_UNITY_BUILD=ON
}

test_windows_program() {
  say "Building the program for Windows, and for this machine"
  quietly "$build/libraries.log" gather_libraries
  [ -e "$build/openmesh.done" ] || quietly "$build/openmesh.log" build_openmesh
  quietly "$build/configure.log" configure_windows_program
  quietly "$build/build.log" cmake --build "$build" --target whittle
  quietly "$build/configure-native.log" cmake --preset demo
  quietly "$build/build-native.log" cmake --build --preset demo
  say "Running it in Wine"
  bash tests/cross/windows_program.sh "$build/bin/whittle.exe" build/demo/bin/whittle "$build/runs"
}

configure_other_machine() {
  cmake -G Ninja -S . -B "$build" --toolchain "$PWD/tests/cross/$machine.cmake" -DCMAKE_BUILD_TYPE=Release \
    -DWHITTLE_CROSS_LIBRARIES="$libraries" -DWHITTLE_GOOGLETEST=/usr/src/googletest -DWHITTLE_WARNINGS_AS_ERRORS=ON \
    -DWHITTLE_BUILD_OPENMESH=OFF -DWHITTLE_BUILD_APPS=OFF -DWHITTLE_BUILD_REPORT=OFF -DWHITTLE_BUILD_RENDER=OFF -DCMAKE_UNITY_BUILD=ON
}

# Wine's services would keep the output of the program open that starts them, and its test would never end.
start_wine() {
  mkdir -p "$WINEPREFIX"
  trap 'wineserver --kill' EXIT
  wineserver --persistent
  quietly "$build/wine.log" wineboot --init
}

test_other_machine() {
  say "Building for $machine"
  quietly "$build/libraries.log" gather_libraries
  quietly "$build/configure.log" configure_other_machine
  quietly "$build/build.log" cmake --build "$build"
  say "Running the tests in an emulator"
  ctest --test-dir "$build" --output-on-failure --parallel "$(nproc)" "$@"
}

# build_same_bytes FOLDER COMPILER FLAGS [OPTION OF cmake...]: builds same_bytes.
build_same_bytes() {
  local folder=$1 compiler=$2 flags=$3
  shift 3
  cmake -G Ninja -S . -B "$folder" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=None \
    -DCMAKE_CXX_FLAGS="$flags" -DWHITTLE_BUILD_APPS=OFF -DWHITTLE_BUILD_OPENMESH=OFF -DWHITTLE_BUILD_REPORT=OFF -DWHITTLE_BUILD_RENDER=OFF -DCMAKE_UNITY_BUILD=ON "$@" &&
    cmake --build "$folder" --target same_bytes
}

# check_same_bytes NAME COMPILER FLAGS [OPTION OF cmake...]: with this processor's registers, and with those of one
# without AVX2, for which the system's library has other functions, too.
check_same_bytes() {
  local folder=$build/$1 program=$build/$1/tests/same_bytes/same_bytes
  quietly "$folder.log" build_same_bytes "$folder" "${@:2}"
  run_same_bytes "$1" "$program"
  if [[ $1 = *-O2 ]]; then run_same_bytes "$1, no AVX2" qemu-x86_64 -cpu Nehalem "$program"; fi
}

# run_same_bytes NAME COMMAND...: prints its last line, and counts failures.
run_same_bytes() {
  local said
  said=$("${@:2}") || n_failed=$((n_failed + 1))
  printf '%-24s %s\n' "$1" "${said##*$'\n'}"
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
    install_packages "$build/packages.log" "${own_packages[@]}" g++-mingw-w64-x86-64-posix libz-mingw-w64-dev wine wine64
    export WINEPREFIX=$build/wine WINEDEBUG=-all
    start_wine
    test_other_machine "$@"
    ;;
  windows-program)
    header_packages+=(libcli11-dev)
    install_packages "$build/packages.log" "${program_packages[@]}" g++-mingw-w64-x86-64-posix libz-mingw-w64-dev wine wine64 \
      dpkg-dev
    export WINEPREFIX=$build/wine WINEDEBUG=-all
    start_wine
    test_windows_program
    ;;
  x86)
    install_packages "$build/packages.log" "${own_packages[@]}" g++-12 clang-14 g++-11 qemu-user libgtest-dev libgmock-dev
    test_compilers
    ;;
  *) usage ;;
esac
