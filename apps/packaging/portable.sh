#!/usr/bin/env bash
# Makes the program for Linux with glibc 2.29 or newer, as BUILD/whittle-VERSION-linux-MACHINE.tar.gz. All libraries are
# linked into it but glibc and GCC's libgcc_s, which every system has.
#
#   portable.sh [BUILD]     on Debian 12, as root or with sudo; BUILD is build/portable by default
#
# It is linked with Debian 11's glibc, as a program asks for symbols as new as those that it was linked with. Debian has
# no archives of OpenMesh and meshoptimizer: they are built of Debian's sources. tests/package/portable.sh tries it.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "$here/../.."
source apps/packages.sh
source apps/debian_sources.sh

# That of the newest math functions. README.md says it, too.
newest_glibc=2.29
mkdir -p "${1:-build/portable}"
build=$(cd "${1:-build/portable}" && pwd)
sources=$build/sources
archives=$build/archives
old=$build/debian11
jobs=$(nproc)

get_sources() {
  open_lists "$sources" "deb-src bookworm" "deb bullseye" &&
    apt_apart "$sources" source openmesh meshoptimizer &&
    apt_apart "$sources" download libc6/bullseye libc6-dev/bullseye libgcc-s1/bullseye
}

# The folder with Debian 11's glibc. Absolute links would lead out of it.
unpack_glibc() {
  local package link
  mkdir -p "$old"
  for package in "$sources"/*.deb; do dpkg-deb -x "$package" "$old"; done
  find "$old" -type l -lname '/*' -print0 | while IFS= read -r -d '' link; do
    ln -sfr "$old$(readlink "$link")" "$link"
  done
}

# build_archives SOURCE OPTION...
build_archives() {
  cmake -S "$1" -B "$1/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$archives" \
    -DCMAKE_POSITION_INDEPENDENT_CODE=ON "${@:2}"
  cmake --build "$1/build" --parallel "$jobs" --target install
}

# OpenMesh makes archives on Windows only.
openmesh_with_archives() {
  sed -i 's/vci_add_library (\(OpenMesh[A-Za-z]*\) SHARED /vci_add_library (\1 STATIC /' \
    "$sources"/openmesh-*/src/OpenMesh/{Core,Tools}/CMakeLists.txt
}

# Licences of what is linked in.
copy_licences() {
  local package
  mkdir -p "$1"
  cp apps/packaging/debian/copyright "$1/whittle"
  for package in libdraco-dev libjpeg-dev libmeshoptimizer-dev libopenmesh-dev libpng-dev libstdc++-12-dev libwebp-dev \
    libzstd-dev zlib1g-dev; do
    cp -L "/usr/share/doc/$package/copyright" "$1/${package%-dev}"
  done
}

install_packages "$build/packages.log" "${build_packages[@]}" dpkg-dev
install_npm "$build/npm-packages.log"

if [ ! -e "$build/archives.done" ]; then
  say "Getting the sources of OpenMesh and meshoptimizer, and Debian 11's glibc"
  rm -rf "$sources" "$archives" "$old"
  quietly "$build/sources.log" get_sources
  quietly "$build/glibc.log" unpack_glibc
  say "Building archives of OpenMesh and meshoptimizer"
  openmesh_with_archives
  quietly "$build/openmesh.log" build_archives "$sources"/openmesh-*/ -DBUILD_APPS=OFF
  quietly "$build/meshoptimizer.log" build_archives "$sources"/meshoptimizer-*/
  touch "$build/archives.done"
fi

say "Building the program"
machine=$(gcc -print-multiarch)
g++ -std=c++20 -O2 -fPIE -c apps/packaging/portable/old_glibc.cc -o "$build/old_glibc.o"
flags="--sysroot=$old -B$old/usr/lib/$machine -L$old/usr/lib/$machine -L$old/lib/$machine"
quietly "$build/configure.log" cmake --preset release -B "$build" -DWHITTLE_BUILD_TESTS=OFF \
  -DWHITTLE_STATIC_PROGRAM=ON -DCMAKE_PREFIX_PATH="$archives" -DCMAKE_EXE_LINKER_FLAGS="$build/old_glibc.o $flags"
if grep 'built without' "$build/configure.log" >&2; then fail "the archive is to have everything"; fi
quietly "$build/build.log" cmake --build "$build" --parallel "$jobs" --target whittle whittle_printed_files

version=$("$build/bin/whittle" --version | cut -d' ' -f2)
name=whittle-$version-linux-$(uname -m)
say "Checking what $name asks for"
libraries=$(objdump -p "$build/bin/whittle" | sed -n 's/^ *NEEDED *//p' | sort | tr '\n' ' ')
say "libraries: $libraries"
for library in $libraries; do
  case $library in
    libc.so.* | libm.so.* | libdl.so.* | libpthread.so.* | libgcc_s.so.* | ld-linux*) ;;
    *) fail "it needs $library" ;;
  esac
done
glibc=$(objdump -T "$build/bin/whittle" | grep -o 'GLIBC_[0-9.]*' | sort -Vu | tail -n 1)
say "$glibc"
[ "$(printf '%s\n' "${glibc#GLIBC_}" "$newest_glibc" | sort -V | tail -n 1)" = "$newest_glibc" ] ||
  fail "it needs $glibc, newer than $newest_glibc"

rm -rf "${build:?}/$name"
for component in program shell; do
  quietly "$build/install.log" cmake --install "$build" --component "$component" --prefix "$build/$name" --strip
done
cp LICENSE "$build/$name"
copy_licences "$build/$name/licences"
tar -C "$build" --owner=0 --group=0 --sort=name -czf "$build/$name.tar.gz" "$name"
say "Done: $build/$name.tar.gz"
