#!/usr/bin/env bash
# live.sh WHITTLE DATA NODE_MODULES FOLDER: has Chromium follow the page of `simplify --live`. Exit status 77: there is
# no Node.js, no playwright-core or no Chromium.
set -euo pipefail
whittle=$1 data=$2 node_modules=$3 folder=$4

source "$(dirname "$0")/chromium.sh"
need_chromium "$node_modules"

rm -rf "$folder"
mkdir -p "$folder"
node "$(dirname "$0")/live.cjs" "$node_modules" "$chromium" "$whittle" "$data/knot.ply" "$folder"
