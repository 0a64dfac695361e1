#!/usr/bin/env bash
# Every check of the project, from a fresh Debian 12 on: installs what it takes, checks the style, builds everything with
# GCC optimised and the libraries with Clang under the sanitizers, and runs the tests of both. The logs of all steps are in build/run/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source apps/packages.sh

logs=build/run
jobs=$(nproc)

configure() { quietly "$logs/configure-$1.log" cmake --preset "$1" "${@:2}"; }
build() { quietly "$logs/build-$1.log" cmake --build "build/$1" --parallel "$jobs"; }

check_format() {
  git ls-files -z '*.hh' '*.cc' | xargs -0 clang-format-14 --dry-run -Werror
}

# The sources of the modules and the program; headers are checked where they are included.
check_tidy() {
  run-clang-tidy-14 -quiet -p build/release -j "$jobs" "^$PWD/(modules|apps/whittle)/.*\.cc$"
}

started=$SECONDS
step() { say "[$(((SECONDS - started) / 60)) min] $*"; }

install_packages "$logs/packages.log" "${build_packages[@]}" clang-14 clang-format-14 clang-tidy-14 libclang-rt-14-dev doxygen pkg-config git

step "Format: clang-format on every tracked .hh and .cc"
quietly "$logs/format.log" check_format

step "GCC: building everything optimised, warnings are errors"
configure release
build release

step "Doxygen: the reference of the public headers, warnings are errors"
quietly "$logs/docs.log" cmake --build --preset docs

step "clang-tidy on the modules and the program, Clang's own warnings among its checks"
quietly "$logs/tidy.log" check_tidy

# Without the program: what it adds to the libraries is long in building and short of pointers.
step "Clang: building the libraries and their tests with asserts and sanitizers (address, undefined behaviour)"
configure asan -B build/clang -DCMAKE_CXX_COMPILER=clang++-14 -DWHITTLE_WARNINGS_AS_ERRORS=ON -DWHITTLE_BUILD_APPS=OFF
build clang
# Without what takes minutes there: comparisons on real meshes in OpenMesh's connectivity, the bunny over and over, what is
# measured on large meshes, brute force on the larger ones of several shapes, and distances measured over and over.
step "Clang: running the tests"
quietly "$logs/test-clang.log" ctest --test-dir build/clang --output-on-failure --parallel "$jobs" -E '^(Accuracy|Package)\.|(StockArithmetic|DriverAgreement)OnRealMesh|BunnyInvariance|ContractionOrder.*/(knot406|insideoutblob|noisysphere2|blob2|sphere2|terrain11)( |$)|SurfaceDistance\.(ScalesWithTheUnit|DoesNotDependOnThePlace|ConvergesAtAny)|(FitsSmoothSurfaces|LessenTheError|ErrsLessThanPlainQuadrics)$'

step "GCC: running the tests"
ctest --preset release --parallel "$jobs"
