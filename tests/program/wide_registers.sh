#!/usr/bin/env bash
# wide_registers.sh OBJDUMP PROGRAM: code that uses AVX2 calls no code that doesn't, but after clearing the upper halves of
# the registers. Else each of the instructions for 128 bits that follow waits for the one before: this once made
# `--effort fast` four times slower, when the compiler left a lambda of one line without inlining.
set -euo pipefail
objdump=$1
program=$2

"$objdump" --disassemble --demangle --no-show-raw-insn "$program" | awk '
  /^[0-9a-f]+ </ { name = $0; is_dirty = 0; next }
  /%ymm/ { is_dirty = 1; n_wide++ }
  /vzeroupper|vzeroall/ { is_dirty = 0 }
  /[ \t]call / && is_dirty {
    sub(/^.*call +[0-9a-f]+ /, "")
    calls["  " name "\n    calls " $0]++
  }
  END {
    if (!n_wide) { print "no code uses AVX2: is this the right program?"; exit 1 }
    for (call in calls) { print call; failed = 1 }
    if (failed) print "mark what is called WHITTLE_INLINE or WHITTLE_INLINE_LAMBDA (compiler.hh)"
    exit failed
  }'
