#!/usr/bin/env bash
# Fuzzes: bash tests/fuzz/run.sh MINUTES [TARGET…]
# Builds the fuzzers with Clang 14 in build/fuzz, and shares the time among the targets, all of them by default. Each
# starts from its corpus in tests/fuzz/corpus and from what it found in earlier runs (build/fuzz/grown). Inputs that
# break a promise go to build/fuzz/findings; the status is 1 if there are any.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

all_targets=(tests/fuzz/corpus/*)
all_targets=("${all_targets[@]##*/}")
minutes=${1:?usage: run.sh MINUTES [TARGET…]}
shift
targets=("$@")
[ ${#targets[@]} -gt 0 ] || targets=("${all_targets[@]}")
build=build/fuzz
seconds=$((minutes * 60 / ${#targets[@]}))

cmake --preset fuzz >/dev/null
cmake --build "$build" --target make_corpus "${targets[@]/#/fuzz_}"
mkdir -p "$build/findings"
# The last line of a run tells the number of executions and the time.
for target in "${targets[@]}"; do
  grown=$build/grown/$target
  [ -d "$grown" ] || "$build/tests/fuzz/make_corpus" "$target" "$grown"
  "$build/tests/fuzz/fuzz_$target" "$grown" "tests/fuzz/corpus/$target" -max_total_time="$seconds" -max_len=2048 \
    -timeout=10 -rss_limit_mb=2048 -malloc_limit_mb=256 -artifact_prefix="$build/findings/$target-" \
    -print_final_stats=1 </dev/null >"$build/$target.log" 2>&1 || true
  printf '%-12s %s\n' "$target" "$(grep -a '^Done\|number_of_executed_units\|SUMMARY' "$build/$target.log" | tr '\n' ' ')"
done
[ -z "$(ls "$build/findings")" ]
