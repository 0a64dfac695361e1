#!/usr/bin/env bash
# site.sh SITE NODE_MODULES: tries the site of the target docs in Chromium. Exit status 77: something for that is missing.
set -euo pipefail
site=$1 node_modules=$2

skip() {
  echo "skipped: $*"
  exit 77
}
[ -f "$site/index.html" ] || skip "there is no $site/index.html; build the target docs"
command -v node >/dev/null || skip "Node.js is not installed"
[ -d "$node_modules/playwright-core" ] || skip "npm's package playwright-core is not in $node_modules"
chromium=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || skip "Chromium is not installed"
node "$(dirname "$0")/site.cjs" "$node_modules" "$chromium" "$site"
