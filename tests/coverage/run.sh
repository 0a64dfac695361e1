#!/usr/bin/env bash
# Measures which lines of modules/ the tests run: bash tests/coverage/run.sh [OPTION OF ctest...]
# Builds the libraries and their tests with Clang 14 in build/coverage and runs the tests, among them the replay of the
# fuzz corpora, but not those that take minutes. Prints the share of lines that ran, for each module and for all. The
# lines that didn't run are in build/coverage/uncovered.txt, as FILE:FIRST-LAST. The status is 1 below 95 %.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source apps/packages.sh

build=build/coverage
least_percent=95

run_tests() {
  rm -rf "$build/profiles"
  LLVM_PROFILE_FILE=$PWD/$build/profiles/%m.profraw ctest --test-dir "$build" --output-on-failure \
    --parallel "$(nproc)" --label-exclude slow "$@"
}

# Writes "FILE:LINE:RUNS" for every line of modules/ that has code. A template has instances in many programs, so the
# lines of all programs are counted together. Clang warns of functions that one program has and never calls.
count_lines() {
  local -a programs others
  mapfile -t programs < <(find "$build" -path '*/CMakeFiles' -prune -o -type f -executable -print)
  others=("${programs[@]:1}")
  llvm-profdata-14 merge "$build"/profiles/*.profraw -o "$build/all.profdata"
  llvm-cov-14 export -format=lcov -instr-profile="$build/all.profdata" "${programs[0]}" "${others[@]/#/-object=}" |
    awk -F '[:,]' '
      /^SF:/ { in_modules = match($2, /modules\/[a-z]+\/(include|src)\//); file = substr($2, RSTART) }
      /^DA:/ && in_modules { runs[file ":" $2] += $3 }
      END { for (line in runs) print line ":" runs[line] }' | sort -t : -k 1,1 -k 2,2n
}

# Ranges of lines that didn't run. A range goes on over one or two lines without code.
list_uncovered() {
  awk -F : '
    function finish() { if (first) print file ":" first (last > first ? "-" last : ""); first = 0 }
    $1 != file || $2 > last + 3 { finish(); file = $1 }
    $3 > 0 { finish() }
    $3 == 0 { if (!first) first = $2; last = $2 }
    END { finish() }'
}

# A row for each folder of modules/, and one for all of them.
print_table() {
  awk -F '[:/]' -v least="$least_percent" '
    function row(name) { printf "%-10s %6d of %6d lines %7.2f %%\n", name, ran[name], n[name], 100 * ran[name] / n[name] }
    $2 != module { if (module) row(module); module = $2 }
    { n[module]++; n["total"]++ }
    $NF > 0 { ran[module]++; ran["total"]++ }
    END { row(module); row("total"); exit (100 * ran["total"] < least * n["total"]) }'
}

install_packages "$build/packages.log" "${build_packages[@]}" clang-14 llvm-14 libclang-rt-14-dev
say "Building the libraries and their tests"
quietly "$build/configure.log" cmake --preset coverage
quietly "$build/build.log" cmake --build "$build" --parallel "$(nproc)"
say "Running the tests"
quietly "$build/test.log" run_tests "$@"
count_lines >"$build/lines.txt" 2>"$build/llvm-cov.log"
list_uncovered <"$build/lines.txt" >"$build/uncovered.txt"
print_table <"$build/lines.txt"
