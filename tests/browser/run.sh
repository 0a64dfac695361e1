#!/usr/bin/env bash
# run.sh WHITTLE DATA NODE_MODULES FOLDER SCRIPT: writes pages of test meshes into FOLDER and runs a script of this folder
# (look.cjs or use.cjs) that tries them in Chromium. Exit status 77: there is no Node.js, no playwright-core or no Chromium.
set -euo pipefail
whittle=$1 data=$2 node_modules=$3 folder=$4 script=$5

source "$(dirname "$0")/chromium.sh"
need_chromium "$node_modules"

rm -rf "$folder"
mkdir -p "$folder"
"$whittle" simplify "$data/blob.obj" -o "$folder/blob.ply" --faces 60 --record "$folder/blob.rec" --json "$folder/blob.json" --quiet
"$whittle" report "$data/blob.obj" "$folder/blob.rec" -o "$folder/recording.html" --run "$folder/blob.json" --quiet
"$whittle" report "$folder/blob.rec" -o "$folder/blob.rec.html" --quiet
# Every level that the slider of the page stops at, and its number of faces as `replay` has it.
"$whittle" replay "$folder/blob.rec" --steps 0:1:1001 -o "$folder/level_{i}.off" --json "$folder/levels.json" --quiet
rm "$folder"/level_*.off
# Flipped edges, polish on the way, and faces that join.
"$whittle" simplify "$data/cubes.obj" -o "$folder/cubes.ply" --faces 40 --cost quadric --threshold auto --record "$folder/cubes.rec" --quiet
"$whittle" report "$data/cubes.obj" "$folder/cubes.rec" -o "$folder/joined.html" --quiet
"$whittle" simplify "$data/terrain.ply" -o "$folder/terrain.ply" --ratio 10% --effort best --record "$folder/terrain.rec" --quiet
"$whittle" report "$data/terrain.ply" "$folder/terrain.rec" -o "$folder/flipped.html" --quiet
for name in cubes terrain; do
  "$whittle" replay "$folder/$name.rec" --steps 0:1:51 -o "$folder/level_{i}.off" --json "$folder/${name}_levels.json" --quiet
done
rm "$folder"/level_*.off
"$whittle" simplify "$data/knot.ply" -o "$folder/knot.ply" --ratio 2% --quiet
"$whittle" report "$data/knot.ply" "$folder/knot.ply" -o "$folder/errors.html" --quiet
"$whittle" simplify "$data/nonmanifold.obj" -o "$folder/nonmanifold.ply" --face-ratio 70% --quiet
"$whittle" report "$data/nonmanifold.obj" "$folder/nonmanifold.ply" -o "$folder/nonmanifold.html" --quiet
"$whittle" simplify "$data/cubes.obj" -o "$folder/least.ply" --faces 20 --topology keep --page "$folder/why.html" --quiet 2>/dev/null
# Levels of detail, and a mesh alone.
"$whittle" lod "$data/blob.obj" -o "$folder/lod_{i}.ply" --ratios .3,.1 --quiet
"$whittle" report "$data/blob.obj" "$folder/lod_0.ply" "$folder/lod_1.ply" -o "$folder/levels.html" --quiet
"$whittle" report "$data/nonmanifold.obj" -o "$folder/one.html" --quiet
# A name with markup, in both of its contexts.
cp "$data/cubes.obj" "$folder/<img src=x onerror=alert(1)><script>alert(2)<script>.obj"
"$whittle" report "$folder/<img src=x onerror=alert(1)><script>alert(2)<script>.obj" -o "$folder/markup.html" --quiet
# Textures, colours and normals.
node "$(dirname "$0")/textured_files.cjs" "$folder"
"$whittle" simplify "$folder/square.gltf" -o "$folder/small.glb" --faces 2 --page "$folder/gltf.html" --quiet
"$whittle" simplify "$folder/square.gltf" -o "$folder/recorded.glb" --faces 2 --record "$folder/square.rec" --quiet
"$whittle" report "$folder/square.gltf" "$folder/square.rec" -o "$folder/square.rec.html" --quiet
"$whittle" report "$folder/square.gltf" "$folder/shifted.gltf" -o "$folder/shifted.html" --quiet
for name in square.obj fine.obj broken.obj coloured.ply; do
  "$whittle" simplify "$folder/$name" -o "$folder/small_$name" --faces 2 --quiet
  "$whittle" report "$folder/$name" "$folder/small_$name" -o "$folder/$name.html" --quiet
done
node "$(dirname "$0")/$script" "$node_modules" "$chromium" "$folder"
