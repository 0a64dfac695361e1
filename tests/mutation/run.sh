#!/usr/bin/env bash
# Changes one token of the modules at a time and sees whether the tests notice.
#
#   bash tests/mutation/run.sh [SEED [N [SECONDS]]]     N changes (100), drawn at random from SEED (1)
#
# Works on a copy of the last commit, in build/mutation/SEED, and never on the sources themselves. Needs Python 3 and
# what `bash tests/run.sh` installs. Takes about a minute a change. The last lines count the changes that were caught
# and list the others; results.txt in that folder has all. A run that was stopped goes on if it is started again; to
# begin anew, remove the folder. Several seeds may run at a time: they build in turn. Changes that take more than
# SECONDS (240) to build are left out, most of them in headers of whittle::openmesh; others are drawn for them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

seed=${1:-1}
number=${2:-100}
seconds=${3:-240}
folder=$PWD/build/mutation/$seed

mkdir -p "$folder"
[ -d "$folder/tree" ] || git clone --quiet . "$folder/tree"
(cd "$folder/tree" && cmake --preset release -DWHITTLE_TEST_MESHES="$folder/none" >"$folder/configure.log")
exec python3 -B tests/mutation/mutate.py --seed "$seed" --number "$number" --seconds "$seconds" --folder "$folder"
