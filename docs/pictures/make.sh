#!/usr/bin/env bash
# make.sh WHITTLE [MESHES]: draws the pictures of the README and the docs again. Needs ImageMagick.
# MESHES is a folder with the real meshes of two pictures, ankylosaurus.obj and bones.off; without it these stay as they are.
set -euo pipefail
whittle=$(realpath "$1") meshes=${2:-}
docs=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
data=$docs/../../data
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# draw NAME MESH SIZE VIEW: one mesh.
draw() { "$whittle" report "$2" --png "$work/$1.png" --png-size "$3" --view "plain,$4" --quiet; }
# simplified NAME MESH OPTION...: a mesh in the work folder.
simplified() { "$whittle" simplify "$2" -o "$work/$1.ply" "${@:3}" --quiet --force; }

# row NAME SIZE VIEW MESH...: meshes side by side, as docs/pictures/NAME.png.
row() {
  local name=$1 size=$2 view=$3 mesh i=0
  local -a cells=()
  for mesh in "${@:4}"; do
    draw "$name$i" "$mesh" "$size" "$view"
    cells+=("$work/$name$i.png")
    i=$((i + 1))
  done
  montage "${cells[@]}" -tile "$i"x1 -geometry +0+0 "$docs/$name.png"
}

knot=$data/knot.ply
simplified knot_10 "$knot" --ratio 10%
simplified knot_2 "$knot" --ratio 2%
draw a "$knot" 420x380 edges=off
draw b "$work/knot_10.ply" 420x380 edges=on
draw c "$work/knot_2.ply" 420x380 edges=on
montage "$work"/{a,b,c}.png -tile 3x1 -geometry +0+0 "$docs/knot.png"

"$whittle" report "$knot" "$work/knot_2.ply" --png "$docs/error.png" --png-size 1260x520 --view colour=error --quiet

[ -n "$meshes" ] || exit 0

foot=$meshes/bones.off
simplified foot_apart "$foot" --faces 210 --effort fast
simplified foot_joined "$foot" --faces 210 --threshold auto --effort fast
row foot 420x240 edges=on,zoom=1.6 "$foot" "$work/foot_apart.ply" "$work/foot_joined.ply"

# Plain, valence and isotropic in columns.
ankylosaurus=$meshes/ankylosaurus.obj
cells=()
for share in 50% 20% 1% 0.5%; do
  case $share in 50% | 20%) weight=0.5 ;; *) weight=4 ;; esac
  i=0
  for options in "" "--valence $weight" "--isotropic 1 --valence 0.5"; do
    # shellcheck disable=SC2086 # the options are words
    simplified cell "$ankylosaurus" --face-ratio $share --effort fast $options
    draw "cell_${share}_$i" "$work/cell.ply" 530x360 edges=on,up=z,turn=-60,zoom=1.4
    cells+=("$work/cell_${share}_$i.png")
    i=$((i + 1))
  done
done
montage "${cells[@]}" -tile 3x4 -geometry +0+0 "$docs/ankylosaurus.png"
