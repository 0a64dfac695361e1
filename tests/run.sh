#!/usr/bin/env bash
# Every check of the project, from a fresh Debian 12 on: installs what it takes, checks the style, builds with both
# compilers and runs the tests of each, under the sanitizers too. The logs of all steps are in build/run/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source apps/packages.sh

logs=build/run
jobs=$(nproc)

configure() { quietly "$logs/configure-$1.log" cmake --preset "$1" "${@:2}"; }
build() { quietly "$logs/build-$1.log" cmake --build "build/$1" --parallel "$jobs"; }

# Without the comparison with OpenMesh, whose decimater takes minutes on the dragon when it is not optimised.
test_quietly() {
  quietly "$logs/test-$1.log" ctest --test-dir "build/$1" --output-on-failure --parallel "$jobs" -E '^Accuracy\.'
}

check_format() {
  git ls-files -z '*.hh' '*.cc' | xargs -0 clang-format-14 --dry-run -Werror
}

# The sources of the modules and the program; headers are checked where they are included.
check_tidy() {
  run-clang-tidy-14 -quiet -p build/clang -j "$jobs" "^$PWD/(modules|apps)/.*\.cc$"
}

started=$SECONDS
step() { say "[$(((SECONDS - started) / 60)) min] $*"; }

install_packages "$logs/packages.log" "${build_packages[@]}" libmeshoptimizer-dev clang-14 clang-format-14 clang-tidy-14 git

step "Format: clang-format on every tracked .hh and .cc"
quietly "$logs/format.log" check_format

step "GCC: building everything optimised, warnings are errors"
configure release
build release

# With asserts and little optimised, so that this one also finds what only another compiler's choices show.
step "Clang: building everything, warnings are errors"
configure dev -B build/clang -DCMAKE_CXX_COMPILER=clang++-14
build clang
step "Clang: running the tests"
test_quietly clang

step "clang-tidy on the modules and the program"
quietly "$logs/tidy.log" check_tidy

step "Sanitizers: building with asserts, address and undefined-behaviour checks"
configure asan
build asan
step "Sanitizers: running the tests"
test_quietly asan

step "Running the tests of the optimised build"
ctest --preset release --parallel "$jobs"
