#!/usr/bin/env bash
# Makes the Debian packages and tries them on a fresh Debian 12: lintian, installing the program with one call of apt, the
# README's examples, and a project that uses the libraries.
#
#   debian.sh [BUILD]
#
# BUILD is the folder of apps/packaging/debian.sh, default build/packages, or of another complete build. Takes root,
# debootstrap, lintian and a network, and ends with status 77 where these are not there. The roots and logs are in
# BUILD/debian.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/roots.sh"

build=$(cd "${1:-$source_folder/build/packages}" && pwd)
work=$build/debian
root=$work/root
consumer=/source/tests/package/consumer # in the root

need_roots cpack lintian

# install LOG PACKAGE...: names, or files in /packages of the root.
install() { quietly "$work/$1.log" in_root apt-get install --yes "${@:2}"; }

# use_libraries FOLDER OPTION...: builds consumer/ by find_package.
use_libraries() {
  quietly "$work/configure-$1.log" in_root cmake -S "$consumer" -B "/$1" -DCMAKE_BUILD_TYPE=Release "${@:2}"
  quietly "$work/build-$1.log" in_root cmake --build "/$1"
}

say "Making the packages"
rm -rf "$work"/*.deb
mkdir -p "$work"
(cd "$build" && quietly "$work/cpack.log" cpack -B "$work/cpack")
mv "$work"/cpack/*.deb "$work"
rm -rf "$work/cpack"
packages=("$work"/whittle_*.deb "$work"/libwhittle-dev_*.deb)
ls -l "${packages[@]}"

say "lintian: errors and warnings fail"
lintian --allow-root --tag-display-limit 0 --fail-on error,warning "${packages[@]}" || fail "lintian found something"

fresh_root bookworm
mkdir "$root/packages"
cp "${packages[@]}" "$root/packages"
mkdir -p "$root$consumer" "$root/source/apps/examples"
cp "$here"/consumer/* "$root$consumer"
cp "$source_folder/apps/examples/torus.hh" "$root/source/apps/examples" # the programs of consumer/ include it
quietly "$work/update.log" in_root apt-get update

say "Installing the program"
install program "./packages/$(basename "${packages[0]}")"
in_root whittle --version
for file in bash-completion/completions/whittle zsh/vendor-completions/_whittle fish/vendor_completions.d/whittle.fish \
  doc/whittle/copyright; do
  [ -s "$root/usr/share/$file" ] || fail "the package has no share/$file"
done
run_examples

say "Using the libraries, with nothing but what they depend on"
install libraries --no-install-recommends "./packages/$(basename "${packages[1]}")" cmake make g++ pkg-config
use_libraries plain_libraries -DUSE_OPENMESH=OFF
in_root /plain_libraries/plain >"$work/plain.txt"
# shellcheck disable=SC2016 # the shell in the root expands them
in_root sh -ec 'c++ -std=c++20 -O1 $0/plain.cc -o /by_pkg_config $(pkg-config --cflags --libs whittle)' "$consumer"
in_root /by_pkg_config | diff "$work/plain.txt" -

say "Using the libraries, with what they recommend"
in_root dpkg-query -W -f '${Recommends}' libwhittle-dev | tr -d ' ' | tr ',' '\n' >"$work/recommended.txt"
mapfile -t recommended <"$work/recommended.txt"
install recommended "${recommended[@]}"
use_libraries all_libraries
in_root /all_libraries/plain | diff "$work/plain.txt" -
in_root /all_libraries/with_openmesh
say "Done: the packages are in $work"
