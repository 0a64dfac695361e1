#!/usr/bin/env bash
# bash tests/run.sh         every check of the project, starting from a fresh Debian 12. Installs what it needs and checks
#                           the style. Builds everything with GCC, optimised, and the libraries with Clang under the
#                           sanitizers. Runs the tests of both.
# bash tests/run.sh quick   only what GCC builds, and without the slow tests
# The logs of all steps are in build/run/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source apps/packages.sh

mode=${1:-whole}
case $mode in whole | quick) ;; *) fail "usage: bash tests/run.sh [quick]" ;; esac
logs=build/run
jobs=$(nproc)

configure() { quietly "$logs/configure-$1.log" cmake --preset "$1" "${@:2}"; }
build() { quietly "$logs/build-$1.log" cmake --build "build/$1" --parallel "$jobs"; }

check_format() {
  git ls-files -z '*.hh' '*.cc' | xargs -0 clang-format-14 --dry-run -Werror
}

# The sources of the modules and the program, and the headers that they include. All sources of a library are read as one,
# as reading headers takes longest. The rule against including sources is left out, therefore.
check_tidy() {
  run-clang-tidy-14 -quiet -p build/tidy -j "$jobs" -checks=-bugprone-suspicious-include \
    -header-filter='/(modules|apps)/.*\.(hh|cc)$' "/unity_[^/]*\.cxx$"
}

started=$SECONDS
step() { say "[$(((SECONDS - started) / 60)) min] $*"; }

packages=("${build_packages[@]}")
if [ "$mode" = whole ]; then
  packages+=(clang-14 clang-format-14 clang-tidy-14 libclang-rt-14-dev doxygen cmark-gfm groff-base pkg-config git chromium)
fi
install_packages "$logs/packages.log" "${packages[@]}"
command -v npm >/dev/null || install_packages "$logs/packages.log" nodejs npm

if [ "$mode" = quick ]; then
  step "GCC: building everything optimised"
  configure release -DWHITTLE_UNITY_TESTS=ON
  build release
  step "GCC: running all tests but the slow ones"
  ctest --preset release --parallel "$jobs" --label-exclude slow
  exit
fi

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

step "Doxygen: the site of pages and reference, warnings are errors"
quietly "$logs/docs.log" cmake --build --preset docs

step "clang-tidy on the modules and the program, Clang's own warnings among its checks"
configure dev -B build/tidy -DCMAKE_CXX_COMPILER=clang++-14 -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0 \
  -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DWHITTLE_BUILD_TESTS=OFF
quietly "$logs/tidy.log" check_tidy

# Without the program: it takes long to build and has few pointers.
step "Clang: building the libraries and their tests with asserts and sanitizers (address, undefined behaviour)"
configure asan -B build/clang -DCMAKE_CXX_COMPILER=clang++-14 -DWHITTLE_WARNINGS_AS_ERRORS=ON -DWHITTLE_BUILD_APPS=OFF -DCMAKE_UNITY_BUILD=ON \
  -DCMAKE_UNITY_BUILD_BATCH_SIZE=24
build clang
step "Clang: running the tests"
quietly "$logs/test-clang.log" ctest --test-dir build/clang --output-on-failure --parallel "$jobs" --label-exclude slow

step "GCC: running the tests"
ctest --preset release --parallel "$jobs"
