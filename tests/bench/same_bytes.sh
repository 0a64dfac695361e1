#!/usr/bin/env bash
# Compares two versions of the program byte for byte: outputs, vertex maps, reports (without times and memory), messages
# and exit codes.
#
#   bash tests/bench/same_bytes.sh OLD NEW [--settings FILE] MESH...
#
# OLD and NEW are programs. Each line of FILE is one set of options of `whittle simplify`; '#' begins a comment. The
# default sets cover all efforts and the engine's options. Prints each difference. The exit status is 1 if there is one.
set -euo pipefail

old=$(realpath "$1")
new=$(realpath "$2")
shift 2
settings=$(dirname "${BASH_SOURCE[0]}")/same_bytes_settings.txt
if [ "${1:-}" = --settings ]; then
  settings=$2
  shift 2
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# run PROGRAM NAME MESH OPTION...: stores all output in $folder/NAME*.
run() {
  local program=$1 name=$2 mesh=$3 status=0
  shift 3
  (cd "$folder" && "$program" simplify "$mesh" -o "$name.ply" --map "$name.map" --json "$name.json" --force "$@" >"$name.out" 2>"$name.err") || status=$?
  echo "$status" >"$folder/$name.status"
  touch "$folder/$name.ply" "$folder/$name.map" "$folder/$name.json"
  # These may differ: times, memory, and the name of the output.
  perl -0pi -e 's/"seconds": \{.*?\}/"seconds": {}/s; s/"peak_rss_bytes": \d+/"peak_rss_bytes": 0/' "$folder/$name.json"
  perl -pi -e "s/\\b$name\\b/result/g; s/in [0-9.]+ m?s\$/in TIME/" "$folder/$name.json" "$folder/$name.err"
}

n_runs=0
n_differing=0
for mesh in "$@"; do
  mesh=$(realpath "$mesh")
  while IFS= read -r line; do
    line=${line%%#*}
    read -r -a options <<<"$line"
    [ ${#options[@]} = 0 ] && continue
    run "$old" old "$mesh" "${options[@]}"
    run "$new" new "$mesh" "${options[@]}"
    n_runs=$((n_runs + 1))
    for kind in ply map json err status; do
      cmp -s "$folder/old.$kind" "$folder/new.$kind" && continue
      echo "DIFFERS: $(basename "$mesh") ${options[*]}: $kind"
      diff "$folder/old.$kind" "$folder/new.$kind" 2>/dev/null | head -n 4 | cut -c 1-200 | grep -av '^Binary' || true
      n_differing=$((n_differing + 1))
    done
    rm -f "$folder"/old.* "$folder"/new.*
  done <"$settings"
done
echo "$n_runs runs of each, $n_differing differences"
[ "$n_differing" = 0 ]
