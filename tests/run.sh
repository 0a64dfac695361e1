#!/usr/bin/env bash
# Runs every check of the project, starting from a fresh Debian 12. Installs what it needs and checks the style. Builds
# everything with GCC, optimised, and the libraries with Clang under the sanitizers. Runs the tests of both. The logs of
# all steps are in build/run/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source apps/packages.sh
source tests/slow_tests.sh

logs=build/run
jobs=$(nproc)

configure() { quietly "$logs/configure-$1.log" cmake --preset "$1" "${@:2}"; }
build() { quietly "$logs/build-$1.log" cmake --build "build/$1" --parallel "$jobs"; }

check_format() {
  git ls-files -z '*.hh' '*.cc' | xargs -0 clang-format-14 --dry-run -Werror
}

# The sources of the modules and the program, several at a time, and the headers that they include. The rule against
# including sources is left out: that is how they come to be several.
check_tidy() {
  run-clang-tidy-14 -quiet -p build/tidy -j "$jobs" -checks=-bugprone-suspicious-include \
    -header-filter='/(modules|apps)/.*\.(hh|cc)$' "/unity_[^/]*\.cxx$"
}

started=$SECONDS
step() { say "[$(((SECONDS - started) / 60)) min] $*"; }

install_packages "$logs/packages.log" "${build_packages[@]}" clang-14 clang-format-14 clang-tidy-14 libclang-rt-14-dev doxygen groff-base pkg-config git chromium
command -v npm >/dev/null || install_packages "$logs/packages.log" nodejs npm

step "npm: what checks glTF files and drives the browser"
mkdir -p build/npm
cp tests/npm/package.json build/npm/
quietly "$logs/npm.log" npm install --prefix build/npm --no-package-lock --no-audit --no-fund

step "Format: clang-format on every tracked .hh and .cc"
quietly "$logs/format.log" check_format

# The modules and the program as users build them.
step "GCC: building everything optimised, warnings are errors"
configure release -DWHITTLE_UNITY_TESTS=ON
build release

step "Doxygen: the reference of the public headers, warnings are errors"
quietly "$logs/docs.log" cmake --build --preset docs

step "clang-tidy on the modules and the program, Clang's own warnings among its checks"
configure dev -B build/tidy -DCMAKE_CXX_COMPILER=clang++-14 -DCMAKE_UNITY_BUILD=ON -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DWHITTLE_BUILD_TESTS=OFF
quietly "$logs/tidy.log" check_tidy

# Without the program: it takes long to build and has few pointers.
step "Clang: building the libraries and their tests with asserts and sanitizers (address, undefined behaviour)"
configure asan -B build/clang -DCMAKE_CXX_COMPILER=clang++-14 -DWHITTLE_WARNINGS_AS_ERRORS=ON -DWHITTLE_BUILD_APPS=OFF -DCMAKE_UNITY_BUILD=ON
build clang
step "Clang: running the tests"
quietly "$logs/test-clang.log" ctest --test-dir build/clang --output-on-failure --parallel "$jobs" -E "$slow_tests"

step "GCC: running the tests"
ctest --preset release --parallel "$jobs"
