# shellcheck shell=bash
# Sourced by run.sh and site.sh: what a test in Chromium takes. Sets `chromium`.

skip() {
  echo "skipped: $*"
  exit 77
}

# need_chromium NODE_MODULES: ends the test where Node.js, playwright-core or Chromium is missing.
need_chromium() {
  command -v node >/dev/null || skip "Node.js is not installed"
  [ -d "$1/playwright-core" ] || skip "npm's package playwright-core is not in $1"
  chromium=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || skip "Chromium is not installed"
}
