#!/usr/bin/env bash
# Makes the Debian packages, whittle_*.deb and libwhittle-dev_*.deb.
#
#   debian.sh [BUILD]     on Debian 12, as root or with sudo; BUILD, where the packages come, is build/packages by default
#
# It installs what building takes. tests/package/debian.sh tries the packages.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source apps/packages.sh

mkdir -p "${1:-build/packages}"
build=$(cd "${1:-build/packages}" && pwd)
install_packages "$build/packages.log" "${build_packages[@]}" dpkg-dev file
install_npm "$build/npm-packages.log"

say "Building (a few minutes the first time)"
quietly "$build/configure.log" cmake --preset release -B "$build" -DWHITTLE_BUILD_TESTS=OFF -DCMAKE_INSTALL_PREFIX=/usr
if grep 'built without' "$build/configure.log" >&2; then fail "a package is to have everything"; fi
quietly "$build/build.log" cmake --build "$build" --parallel "$(nproc)"
quietly "$build/cpack.log" cpack --config "$build/CPackConfig.cmake" -B "$build"
say "Done:" "$build"/*.deb
