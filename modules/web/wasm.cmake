# Links whittle.wasm: cmake -D… -P wasm.cmake. OBJECTS, OUTPUT, LINKER, WASM_OPT, BUILTINS, SYSROOT are given.
file(STRINGS ${OBJECTS} objects)
execute_process(
  COMMAND ${LINKER} -m wasm32 -L${SYSROOT}/lib/wasm32-wasi ${SYSROOT}/lib/wasm32-wasi/crt1-reactor.o --entry _initialize
          ${objects} -lc++ -lc++abi -lwasi-emulated-getpid -lc ${BUILTINS} --gc-sections --strip-debug --lto-O2 -z stack-size=1048576 --stack-first
          --max-memory=4294967296 -o ${OUTPUT}.linked
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(
  COMMAND ${WASM_OPT} --enable-simd --enable-bulk-memory --enable-nontrapping-float-to-int --enable-sign-ext
          --enable-mutable-globals -Os --strip-producers --strip-debug ${OUTPUT}.linked -o ${OUTPUT}
  COMMAND_ERROR_IS_FATAL ANY)
