#!/usr/bin/env bash
# Tries the program of apps/packaging/portable.sh on a fresh Debian 11: the README's examples, the files that it writes, and
# drawing, which loads Mesa.
#
#   portable.sh ARCHIVE [PROGRAM]
#
# PROGRAM, a usual build, has to write the same bytes. Takes root, debootstrap and a network, and ends with status 77 where
# these are not there. The roots and logs are in ARCHIVE.test.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/roots.sh"
archive=$(realpath "$1")
program=${2:+$(realpath "$2")}
work=$archive.test
root=$work/root
mkdir -p "$work"
need_roots

fresh_root bullseye
tar -xzf "$archive" -C "$root/opt"
ln -s "/opt/$(basename "$archive" .tar.gz)/bin/whittle" "$root/usr/bin/whittle"
in_root sh -c 'ldd --version | head -n 1; whittle --version'
run_examples
if [ -n "$program" ]; then
  say "The same bytes as those of $program"
  in_root whittle simplify /examples/terrain.ply -o /examples/same.ply --ratio 20%
  "$program" simplify "$source_folder/data/terrain.ply" -o "$work/same.ply" --force --ratio 20%
  cmp "$work/same.ply" "$root/examples/same.ply"
fi

say "Drawing without Mesa says what is missing, and with it, draws"
draw=(whittle measure /examples/knot.ply /examples/small.ply --render 2 --render-image /examples/drawn.png)
if in_root "${draw[@]}" >"$work/no_mesa.log" 2>&1; then fail "it draws without Mesa"; fi
grep -q libegl1 "$work/no_mesa.log" || fail "it doesn't name libegl1 (log: $work/no_mesa.log)"
quietly "$work/mesa.log" in_root sh -c 'apt-get update && apt-get install --yes --no-install-recommends libegl1 libgl1-mesa-dri'
in_root "${draw[@]}"
[ -s "$root/examples/drawn.png" ] || fail "there is no picture"
say "Done: $archive runs on Debian 11"
