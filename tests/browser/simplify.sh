#!/usr/bin/env bash
# simplify.sh PAGE WHITTLE DATA NODE_MODULES FOLDER: has Chromium use the page that simplifies. Exit status 77: there is no
# Node.js, no playwright-core or no Chromium.
set -euo pipefail
page=$1 whittle=$2 data=$3 node_modules=$4 folder=$5

source "$(dirname "$0")/chromium.sh"
need_chromium "$node_modules"

rm -rf "$folder"
mkdir -p "$folder"
node "$(dirname "$0")/simplify.cjs" "$node_modules" "$chromium" "$page" "$data/knot.ply" "$whittle" "$folder"
