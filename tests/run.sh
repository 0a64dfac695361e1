#!/usr/bin/env bash
# bash tests/run.sh         every check of the project, starting from a fresh Debian 12. Installs what it needs and checks
#                           the style. Builds everything with GCC, optimised, and the libraries with Clang under the
#                           sanitizers. Runs the tests of both.
# bash tests/run.sh quick   the unit tests of what is changed since the last commit, built with GCC; without any change,
#                           those of the modules core, engine and simplify
# The logs of all steps are in build/run/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source apps/packages.sh

mode=${1:-whole}
case $mode in whole | quick) ;; *) fail "usage: bash tests/run.sh [quick]" ;; esac
logs=build/run
jobs=$(nproc)

# With ccache, what was compiled before, in this folder or another, is not compiled again. Each compiler has to be told
# something for its precompiled headers, then.
cached=()
for_gcc=
for_clang=
if command -v ccache >/dev/null; then
  cached=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  for_gcc=-fpch-preprocess
  for_clang="-Xclang -fno-pch-timestamp"
  export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=pch_defines,time_macros
fi

# configure_by FLAGS BUILD PRESET [OPTION...]: build/BUILD. Where mold is there, it links.
configure_by() {
  local linker=
  if command -v mold >/dev/null; then linker=-fuse-ld=mold; fi
  CXXFLAGS="${CXXFLAGS:-} $1" LDFLAGS="${LDFLAGS:-} $linker" \
    quietly "$logs/configure-$2.log" cmake --preset "$3" -B "build/$2" "${cached[@]}" "${@:4}"
}
configure_release() { configure_by "$for_gcc" release release -DWHITTLE_UNITY_TESTS=ON "$@"; }
configure_clang() {
  configure_by "$for_clang" "$@" -DCMAKE_CXX_COMPILER=clang++-14 -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0
}
build() { quietly "$logs/build-$1.log" cmake --build "build/$1" --parallel "$jobs"; }

# The environment in which the Python package is built and tested: build/python-env. It fails where PyPI isn't reached.
make_python_env() {
  local pip=build/python-env/bin/pip
  python3 -m venv build/python-env &&
    "$pip" install --quiet --disable-pip-version-check -r tests/python/requirements.txt
}

check_format() {
  git ls-files -z '*.hh' '*.cc' | xargs -0 clang-format-14 --dry-run -Werror
}

# The sources of the modules and the program, and the headers that they include. All sources of a library are read as one,
# as reading headers takes longest. The rule against including sources is left out, therefore.
check_tidy() {
  run-clang-tidy-14 -quiet -p build/tidy -j "$jobs" -checks=-bugprone-suspicious-include \
    -header-filter='/(modules|apps)/.*\.(hh|cc)$' "/unity_[^/]*\.cxx$"
}

# The folders of tests of what is changed since the last commit. Modules without unit tests are tested by the program's.
changed_folders() {
  local folder
  { git diff --name-only HEAD && git ls-files --others --exclude-standard; } |
    sed -nE 's#^(modules|tests/unit)/([^/]+)/.*#unit/\2#p; s#^(apps/whittle|tests/(cli|program))/.*#cli#p' |
    while IFS= read -r folder; do
      if [ -d "tests/$folder" ]; then echo "$folder"; else echo cli; fi
    done | sort -u
}

run_quick() {
  local folder
  local -a folders targets
  mapfile -t folders < <(changed_folders)
  if [ ${#folders[@]} = 0 ]; then folders=(unit/core unit/engine unit/simplify); fi
  targets=(test_structure "${folders[@]/%//all}")
  targets=("${targets[@]/#unit/tests/unit}")
  targets=("${targets[@]/#cli/tests/cli}")
  step "GCC: building the tests of ${folders[*]}"
  configure_release
  quietly "$logs/build-quick.log" cmake --build build/release --parallel "$jobs" --target "${targets[@]}"
  for folder in structure "${folders[@]}"; do
    step "Running the tests of tests/$folder but the slow ones"
    quietly "$logs/test-${folder##*/}.log" ctest --test-dir "build/release/tests/$folder" --output-on-failure \
      --parallel "$jobs" --label-exclude slow
    tail -n 3 "$logs/test-${folder##*/}.log"
  done
}

started=$SECONDS
step() { say "[$(((SECONDS - started) / 60)) min] $*"; }

packages=("${build_packages[@]}" git mold)
with_python=(-DWHITTLE_PYTHON=OFF)
if [ "$mode" = whole ]; then
  packages+=(clang-14 clang-format-14 clang-tidy-14 libclang-rt-14-dev doxygen cmark-gfm groff-base pkg-config chromium
    firefox-esr xvfb xauth python3-dev python3-numpy python3-venv blender python3-paraview "${web_packages[@]}")
fi
install_packages "$logs/packages.log" "${packages[@]}"
install_npm "$logs/npm-packages.log"

if [ "$mode" = quick ]; then
  run_quick
  exit
fi

step "npm: what checks glTF files, drives the browser and stands beside the npm package"
mkdir -p build/npm
cp tests/npm/package.json build/npm/
quietly "$logs/npm.log" npm install --prefix build/npm --no-package-lock --no-audit --no-fund

step "Python: what its package and the tests take, from PyPI"
if make_python_env >"$logs/python.log" 2>&1; then
  with_python=(-DWHITTLE_PYTHON=ON -DPython_EXECUTABLE="$PWD/build/python-env/bin/python")
  build/python-env/bin/pip install --quiet --disable-pip-version-check -r tests/python/libraries.txt >>"$logs/python.log" 2>&1 ||
    say "skipped: the meshes of other Python libraries, as PyPI doesn't give all of them ($logs/python.log)"
else
  say "skipped: the Python package, as PyPI isn't reached ($logs/python.log)"
fi

step "Format: clang-format on every tracked .hh and .cc"
quietly "$logs/format.log" check_format

# The modules and the program as users build them.
step "GCC: building everything optimised, warnings are errors"
configure_release "${with_python[@]}" -DWHITTLE_WEB=ON
build release

step "Doxygen: the site of pages and reference, warnings are errors"
quietly "$logs/docs.log" cmake --build --preset docs

step "clang-tidy on the modules and the program, Clang's own warnings among its checks"
configure_clang tidy dev -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DWHITTLE_BUILD_TESTS=OFF
quietly "$logs/tidy.log" check_tidy

# Without the program: it takes long to build and has few pointers. As a subfolder of another project, so that this is
# tried, too.
step "Clang: building the libraries and their tests with asserts and sanitizers (address, undefined behaviour)"
configure_clang clang asan -S tests/package/consumer -DWHITTLE_FOLDER="$PWD" -DWHITTLE_WARNINGS_AS_ERRORS=ON \
  -DWHITTLE_BUILD_TESTS=ON -DWHITTLE_BUILD_REPORT=ON -DWHITTLE_BUILD_RENDER=ON
build clang
step "Clang: running the tests"
quietly "$logs/test-clang.log" ctest --test-dir build/clang --output-on-failure --parallel "$jobs" --label-exclude slow

step "GCC: running the tests"
ctest --preset release --parallel "$((jobs + 1))" # those in a browser wait now and then
