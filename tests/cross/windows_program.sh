#!/usr/bin/env bash
# windows_program.sh WHITTLE_EXE WHITTLE FOLDER: runs the program for Windows in Wine, and this machine's beside it. Both
# write the same bytes. FOLDER takes the files. Names have umlauts and spaces, paths a drive and backslashes, lines CRLF.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source apps/packages.sh
exe=$(realpath "$1") native=$(realpath "$2")
rm -rf "$3"
mkdir -p "$3"
folder=$(realpath "$3")
data=$PWD/data

# on_windows ARGUMENT...: what it says is in said.txt, as Linux has lines.
on_windows() {
  if ! wine "$exe" "$@" >"$folder/said.raw" 2>"$folder/errors.raw" </dev/null; then
    cat "$folder/errors.raw" >&2
    fail "failed in Wine: whittle $*"
  fi
  tr -d '\r' <"$folder/said.raw" >"$folder/said.txt"
}

# same FILE FILE
same() { cmp "$1" "$2" || fail "Windows writes other bytes: $1"; }

mkdir -p "$folder/Größe ä" "$folder/native"
cp "$data/knot.ply" "$folder/Größe ä/Knäuel.ply"
sed 's/$/\r/' "$data/blob.obj" >"$folder/crlf.obj"
drive_path="Z:$(tr / '\\' <<<"$folder")"

say "version and help"
on_windows --version
[ "$(cat "$folder/said.txt")" = "$("$native" --version)" ] || fail "the versions differ"
on_windows simplify --help
"$native" simplify --help | diff - "$folder/said.txt"

say "simplify, with umlauts and spaces in the names"
for effort in fast normal best; do
  on_windows simplify "$folder/Größe ä/Knäuel.ply" -o "$folder/Größe ä/kleiner_$effort.ply" --ratio 10% --effort "$effort"
  "$native" simplify "$data/knot.ply" -o "$folder/native/$effort.ply" --ratio 10% --effort "$effort" --quiet
  same "$folder/Größe ä/kleiner_$effort.ply" "$folder/native/$effort.ply"
done

say "simplify, with a drive letter and backslashes"
on_windows simplify "$drive_path\\crlf.obj" -o "$drive_path\\from_crlf.obj" --faces 100
"$native" simplify "$folder/crlf.obj" -o "$folder/native/from_crlf.obj" --faces 100 --quiet
same "$folder/from_crlf.obj" "$folder/native/from_crlf.obj"

say "convert, to each format"
for format in obj ply stl off glb; do
  on_windows convert "$folder/crlf.obj" "$folder/crlf_out.$format"
  "$native" convert "$folder/crlf.obj" "$folder/native/crlf_out.$format" --quiet
  same "$folder/crlf_out.$format" "$folder/native/crlf_out.$format"
done

say "measure and info"
on_windows measure "$data/knot.ply" "$folder/Größe ä/kleiner_normal.ply"
"$native" measure "$data/knot.ply" "$folder/native/normal.ply" >"$folder/native/measure.txt"
diff <(grep -v kleiner "$folder/said.txt") <(grep -v normal.ply "$folder/native/measure.txt")
on_windows info "$folder/crlf.obj"
"$native" info "$folder/crlf.obj" | diff - "$folder/said.txt"

say "files that others name, with umlauts"
mkdir -p "$folder/Größe ä/Ziel" "$folder/native/Ziel"
on_windows convert "$folder/crlf.obj" "$folder/Größe ä/Körper.gltf"
"$native" convert "$folder/crlf.obj" "$folder/native/Körper.gltf" --quiet
same "$folder/Größe ä/Körper.bin" "$folder/native/Körper.bin"
on_windows simplify "$folder/Größe ä/Körper.gltf" -o "$folder/Größe ä/Ziel/{stem}_klein.gltf" --faces 100
"$native" simplify "$folder/native/Körper.gltf" -o "$folder/native/Ziel/{stem}_klein.gltf" --faces 100 --quiet
for name in gltf bin; do same "$folder/Größe ä/Ziel/Körper_klein.$name" "$folder/native/Ziel/Körper_klein.$name"; done
printf 'newmtl Grün\r\nmap_Kd Bilder\\Grün.png\r\n' >"$folder/Größe ä/Stoffe ü.mtl"
mkdir -p "$folder/Größe ä/Bilder"
base64 -d >"$folder/Größe ä/Bilder/Grün.png" \
  <<<iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==
{ printf 'mtllib Stoffe ü.mtl\r\n' && cat "$folder/crlf.obj"; } >"$folder/Größe ä/Stück.obj"
on_windows simplify "$folder/Größe ä/Stück.obj" -o "$folder/Größe ä/Ziel/Stück.obj" --faces 100
for name in "Stoffe ü.mtl" Bilder/Grün.png; do same "$folder/Größe ä/Ziel/$name" "$folder/Größe ä/$name"; done

say "in the place of the input, and what is refused"
cp "$data/knot.ply" "$folder/Größe ä/ersetzt ö.ply"
on_windows simplify "$folder/Größe ä/ersetzt ö.ply" -o "$drive_path\\Größe ä\\ersetzt ö.ply" --ratio 10% --force
same "$folder/Größe ä/ersetzt ö.ply" "$folder/native/normal.ply"
status=0
wine "$exe" convert "$folder/Größe ä/Körper.gltf" "$drive_path\\Größe ä\\Körper.bin" --output-format stl \
  2>"$folder/errors.raw" || status=$?
expected=0
"$native" convert "$folder/native/Körper.gltf" "$folder/native/Körper.bin" --output-format stl \
  2>"$folder/native/errors.txt" || expected=$?
[ "$expected" != 0 ] && [ "$status" = "$expected" ] || fail "exit status $status instead of $expected"
grep -q 'Körper.bin: .*needs this file' "$folder/errors.raw" || fail "$(cat "$folder/errors.raw")"

say "bytes through standard input and output"
wine "$exe" convert - - --input-format ply --output-format stl <"$data/knot.ply" >"$folder/piped.stl"
"$native" convert - - --input-format ply --output-format stl <"$data/knot.ply" >"$folder/native/piped.stl"
same "$folder/piped.stl" "$folder/native/piped.stl"

say "a file that isn't there"
status=0
wine "$exe" info "$folder/weg ü.ply" 2>"$folder/errors.raw" || status=$?
expected=0
"$native" info "$folder/weg ü.ply" 2>"$folder/native/errors.txt" || expected=$?
[ "$status" = "$expected" ] || fail "exit status $status instead of $expected"
grep -q 'weg ü.ply' "$folder/errors.raw" || fail "the message doesn't name the file"
say "Done: all as on this machine"
