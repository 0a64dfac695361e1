#!/usr/bin/env bash
# Compiles and runs the programs of consumer/ with many settings: no warnings, and always the same results.
#
#   matrix.sh FOLDER [PREFIX [COMPILER...]]
#
# FOLDER takes the build files. With PREFIX all compilers use that installation. Otherwise each compiler builds and
# installs Whittle itself, which takes minutes. Default compilers: g++-12 and clang++-14, if installed.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source_folder=$(cd "$here/../.." && pwd)

folder=$1
given_prefix=${2:-}
compilers=("${@:3}")
if [ ${#compilers[@]} = 0 ]; then compilers=(g++-12 clang++-14); fi
mkdir -p "$folder"

warnings=(-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror)
# Settings that a user may compile with: name, flags, programs. OpenMesh's own headers need RTTI.
configurations=(
  "c++20|-std=c++20 -O1|plain with_openmesh"
  "c++23|-std=c++2b -O0|plain with_openmesh"
  "no-rtti|-std=c++20 -O0 -fno-rtti|plain"
  "fast-math|-std=c++20 -O1 -ffast-math|plain with_openmesh"
)
# Functions of headers that are not inlined, with arithmetic that rounds otherwise: the library must not use them.
if grep -qw fma /proc/cpuinfo; then
  configurations+=("fused|-std=c++20 -O1 -fno-inline -mfma -ffp-contract=fast|plain")
fi

# flags_of PACKAGE...: include flags; headers of other projects give no warnings.
flags_of() { pkg-config --cflags "$@" | sed -E 's/-I([^ ]*eigen3)/-isystem \1/g'; }

# install_with COMPILER: builds Whittle and installs it in FOLDER/COMPILER/prefix.
install_with() {
  local build=$folder/$1/build
  cmake -S "$source_folder" -B "$build" -G Ninja -DCMAKE_CXX_COMPILER="$1" -DCMAKE_BUILD_TYPE=Release \
    -DWHITTLE_BUILD_APPS=OFF -DWHITTLE_BUILD_TESTS=OFF -DCMAKE_INSTALL_PREFIX="$folder/$1/prefix" >"$folder/$1.log"
  cmake --build "$build" --target install >>"$folder/$1.log"
}

# compile_and_run COMPILER PREFIX NAME FLAGS PROGRAM: prints the program's output.
compile_and_run() {
  local compiler=$1 prefix=$2 name=$3 program=$5
  local -a flags
  read -ra flags <<<"$4"
  local binary=$folder/$compiler-$name-$program
  local pkgconfig
  pkgconfig=$(dirname "$(find "$prefix" -name whittle.pc)")
  # shellcheck disable=SC2046 # flags are words
  PKG_CONFIG_PATH=$pkgconfig \
    "$compiler" "${flags[@]}" "${warnings[@]}" $(PKG_CONFIG_PATH=$pkgconfig flags_of whittle) \
    "$here/consumer/$program.cc" -o "$binary" $(libraries_of "$pkgconfig" "$program") &&
    "$binary"
}

libraries_of() {
  if [ "$2" = with_openmesh ]; then printf -- '-lOpenMeshTools -lOpenMeshCore '; fi
  PKG_CONFIG_PATH=$1 pkg-config --libs whittle
}

declare -A expected=()
n_failed=0

# check COMPILER PREFIX CONFIGURATION PROGRAM: compiles, runs, and compares the output with that of the first run.
check() {
  local program=$4 name flags said
  IFS='|' read -r name flags _ <<<"$3"
  if ! said=$(compile_and_run "$1" "$2" "$name" "$flags" "$program"); then
    said='failed'
    n_failed=$((n_failed + 1))
  elif [ "${expected[$program]:=$said}" != "$said" ]; then
    printf 'The next result differs from: %s\n' "${expected[$program]}"
    n_failed=$((n_failed + 1))
  fi
  printf '%-34s %s\n' "$1 $name $program" "$said"
}

for compiler in "${compilers[@]}"; do
  if ! command -v "$compiler" >/dev/null; then
    printf '%s is not there\n' "$compiler"
    continue
  fi
  prefix=$given_prefix
  if [ -z "$prefix" ]; then
    mkdir -p "$folder/$compiler"
    install_with "$compiler"
    prefix=$folder/$compiler/prefix
  fi
  for configuration in "${configurations[@]}"; do
    for program in ${configuration##*|}; do
      check "$compiler" "$prefix" "$configuration" "$program"
    done
  done
done
if [ "$n_failed" != 0 ]; then
  printf '%d failed or differ\n' "$n_failed" >&2
  exit 1
fi
