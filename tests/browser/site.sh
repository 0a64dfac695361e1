#!/usr/bin/env bash
# site.sh SITE NODE_MODULES: tries the site of the target docs in Chromium. Exit status 77: something for that is missing.
set -euo pipefail
site=$1 node_modules=$2

source "$(dirname "$0")/chromium.sh"
[ -f "$site/index.html" ] || skip "there is no $site/index.html; build the target docs"
need_chromium "$node_modules"
node "$(dirname "$0")/site.cjs" "$node_modules" "$chromium" "$site"
