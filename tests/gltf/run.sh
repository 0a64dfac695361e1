#!/usr/bin/env bash
# run.sh WHITTLE DATA NODE_MODULES FOLDER: writes glTF files of test meshes into FOLDER, geomorphs among them, and validates
# them.
# Exit status 77: there is no Node.js or no validator.
set -euo pipefail
whittle=$1 data=$2 node_modules=$3 folder=$4

if ! command -v node >/dev/null; then
  echo "skipped: Node.js is not installed"
  exit 77
fi
if [ ! -d "$node_modules/gltf-validator" ]; then
  echo "skipped: npm's package gltf-validator is not in $node_modules"
  exit 77
fi

rm -rf "$folder"
mkdir -p "$folder"
for mesh in knot.ply terrain.ply cubes.obj bracket.stl; do
  name=${mesh%.*}
  "$whittle" simplify "$data/$mesh" -o "$folder/$name.ply" --ratio 20% --record "$folder/$name.rec" --quiet
  "$whittle" geomorph "$folder/$name.rec" -o "$folder/geomorph_$name.glb" --quiet
  "$whittle" convert "$data/$mesh" "$folder/$name.glb" --quiet
  "$whittle" simplify "$data/$mesh" -o "$folder/$name.gltf" --ratio 20% --quiet
done
# Vertices with colours, and some whose faces have no area, so that their normals are zero.
cat >"$folder/colored.off" <<'OFF'
COFF
6 4 0
0 0 0  1 0 0 1
1 0 0  0 1 0 1
0 1 0  0 0 1 1
1 1 0  1 1 0 0.5
2 2 2  1 1 1 1
3 3 3  1 1 1 1
3 0 1 2
3 2 1 3
3 3 4 5
3 0 4 5
OFF
"$whittle" simplify "$folder/colored.off" -o "$folder/colored.ply" --faces 1 --record "$folder/colored.rec" --quiet
"$whittle" geomorph "$folder/colored.rec" -o "$folder/geomorph_colored.glb" --quiet
"$whittle" convert "$folder/colored.off" "$folder/colored.glb" --quiet
node "$(dirname "$0")/validate.cjs" "$node_modules" "$folder"/*.glb "$folder"/*.gltf
