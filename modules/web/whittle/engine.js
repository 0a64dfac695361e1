// The module of WebAssembly: loading it, calling it, and what its errors become.

/** What Whittle refuses, and what it can't do. `kind` is 'invalid', 'memory' or 'internal'. */
export class WhittleError extends Error {
  constructor(message, kind = 'invalid') {
    super(message);
    this.name = 'WhittleError';
    this.kind = kind;
  }
}

const notReady = 'whittle is not loaded yet: await ready first';
const keptBytes = 64 << 20; // an instance with more memory is dropped after its call, which gives the memory back

let compiled = null;
let instance = null;
let onProgress = null;

async function compile() {
  const url = new URL('./whittle.wasm', import.meta.url);
  if (url.protocol === 'file:') {
    const {readFile} = await import(/* @vite-ignore */ /* webpackIgnore: true */ 'node:fs/promises');
    return WebAssembly.compile(await readFile(url));
  }
  const response = await fetch(url);
  if (!response.ok) throw new WhittleError(`${url} isn't there: ${response.status}`, 'internal');
  return WebAssembly.compile(await response.arrayBuffer());
}

/** Settles when the module is loaded; calls before throw. */
export const ready = compile().then((module) => {
  compiled = module;
});
ready.catch(() => {}); // whoever awaits it gets the error

export function textAt(memory, at) {
  const bytes = new Uint8Array(memory.buffer);
  return new TextDecoder().decode(bytes.slice(at, bytes.indexOf(0, at)));
}

function importsOf(memory) {
  const system = {
    clock_time_get(clock, precision, at) {
      new DataView(memory().buffer).setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
      return 0;
    },
    proc_exit() {
      throw new WhittleError('the module has ended', 'internal');
    },
  };
  return {
    wasi_snapshot_preview1: new Proxy(system, {get: (calls, name) => calls[name] ?? (() => 8)}), // 8: no such file
    whittle: {
      raise(type, what) {
        const kind = textAt(memory(), type);
        const text = textAt(memory(), what);
        if (/bad_alloc|length_error/.test(kind)) throw new WhittleError('out of memory', 'memory');
        throw new WhittleError(text, kind.includes('invalid_argument') ? 'invalid' : 'internal');
      },
      progress(fraction, stage, faces) {
        if (onProgress(stage === 1 ? 'polishing' : 'decimating', fraction, faces) === false) {
          throw new DOMException('cancelled', 'AbortError');
        }
      },
    },
  };
}

function newInstance() {
  if (compiled === null) throw new WhittleError(notReady);
  const made = new WebAssembly.Instance(
    compiled,
    importsOf(() => made.exports.memory),
  );
  made.exports._initialize();
  return made;
}

/**
 * Calls `use` with the exports of an instance, which is dropped when anything goes wrong: no frame of WebAssembly has
 * cleaned up then.
 */
export function withEngine(use, listener = null) {
  const running = instance ?? newInstance();
  instance = null;
  const outer = onProgress;
  onProgress = listener;
  try {
    const result = use(running.exports);
    running.exports.end();
    if (running.exports.memory.buffer.byteLength <= keptBytes) instance = running;
    return result;
  } catch (error) {
    if (error instanceof WebAssembly.RuntimeError) {
      throw new WhittleError(`the module failed: ${error.message}`, 'internal');
    }
    if (error instanceof RangeError && /stack/i.test(error.message)) throw new WhittleError('out of stack', 'memory');
    throw error;
  } finally {
    onProgress = outer;
  }
}
