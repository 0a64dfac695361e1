#!/usr/bin/env bash
# firefox.sh WHITTLE DATA NODE_MODULES FOLDER [SIMPLIFIER]: writes a page of a recording into FOLDER and tries it, and the page
# that simplifies if there is one, in Debian's Firefox.
# Exit status 77: there is no Node.js, puppeteer-core, Firefox or Xvfb.
set -euo pipefail
whittle=$1 data=$2 node_modules=$3 folder=$4 simplifier=${5:-}

source "$(dirname "$0")/chromium.sh"
command -v node >/dev/null || skip "Node.js is not installed"
[ -d "$node_modules/puppeteer-core" ] || skip "npm's package puppeteer-core is not in $node_modules"
firefox=$(command -v firefox-esr || command -v firefox) || skip "Firefox is not installed"
command -v xvfb-run >/dev/null || skip "Xvfb is not installed" # without a window Firefox has no WebGL

rm -rf "$folder"
mkdir -p "$folder"
"$whittle" simplify "$data/blob.obj" -o "$folder/blob.ply" --faces 60 --page "$folder/blob.html" --quiet
HOME=$folder xvfb-run --auto-servernum node "$(dirname "$0")/firefox.cjs" "$node_modules" "$firefox" "$folder/blob.html" ${simplifier:+"$simplifier" "$data/blob.obj"}
