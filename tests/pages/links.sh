#!/usr/bin/env bash
# links.sh SITE: checks every link, anchor and picture of the site that the target docs makes. Exit status 77: it isn't built.
set -euo pipefail
[ -f "$1/index.html" ] || { echo "skipped: there is no $1/index.html; build the target docs"; exit 77; }
links=$(cd "$(dirname "$0")" && pwd)/links.awk
cd "$1"
find . -type f | awk -f "$links"
