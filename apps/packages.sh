# Sourced by apps/demo.sh and tests/run.sh: saying what is done, and installing the Debian packages it takes.

# What building the program takes, and what reports, pictures and the tests take beside.
program_packages=(g++ cmake ninja-build libopenmesh-dev libeigen3-dev libnanoflann-dev libcli11-dev libfast-float-dev
  nlohmann-json3-dev zlib1g-dev libzstd-dev libxxhash-dev libmeshoptimizer-dev libdraco-dev)
build_packages=("${program_packages[@]}" libwebp-dev libpng-dev libjpeg-dev libegl-dev libgl-dev libgl1-mesa-dri
  libgtest-dev libgmock-dev)

# What the npm package takes: Clang and libraries for WebAssembly.
web_packages=(clang-19 lld-19 libc++-19-dev-wasm32 libc++abi-19-dev-wasm32 libclang-rt-19-dev-wasm32 wasi-libc binaryen)

say() { printf '== %s\n' "$*"; }

fail() {
  printf 'error: %s\n' "$*" >&2
  exit 1
}

# quietly LOG COMMAND...: the output goes to LOG; the end of it is shown when the command fails.
quietly() {
  local log=$1
  shift
  mkdir -p "$(dirname "$log")"
  if ! "$@" >"$log" 2>&1 </dev/null; then
    tail -n 60 "$log" >&2
    fail "failed: $* (all of its output: $log)"
  fi
}

is_installed() { [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

as_root() {
  if [ "$(id -u)" = 0 ]; then
    env DEBIAN_FRONTEND=noninteractive "$@"
  else
    sudo env DEBIAN_FRONTEND=noninteractive "$@"
  fi
}

# install_packages LOG PACKAGE...: those that are missing; without any, nothing is asked of the network.
install_packages() {
  local log=$1 package
  local -a missing=()
  shift
  if ! command -v dpkg-query >/dev/null; then
    say "Packages: this isn't Debian, so these have to be there already: $*"
    return 0
  fi
  for package in "$@"; do
    is_installed "$package" || missing+=("$package")
  done
  if [ ${#missing[@]} = 0 ]; then
    say "Packages: all there"
    return 0
  fi
  if [ "$(id -u)" != 0 ] && ! command -v sudo >/dev/null; then
    fail "packages are missing and there is neither root nor sudo; install: ${missing[*]}"
  fi
  say "Packages: installing ${missing[*]}"
  quietly "$log" as_root apt-get update
  quietly "$log" as_root apt-get install --yes --no-install-recommends "${missing[@]}"
}

# install_npm LOG: whatever npm is there is taken, as Debian's conflicts with the one that comes with a newer Node.js.
install_npm() { command -v npm >/dev/null || install_packages "$1" npm ca-certificates; }
