// The module of WebAssembly: loading it, calling it, and what its errors become.

import {WhittleError, asWhittleError, errorOf, textAt} from './errors.js';

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
        throw errorOf(textAt(memory(), type), textAt(memory(), what));
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

function call(running, use, listener) {
  const outer = onProgress;
  onProgress = listener;
  try {
    return use(running.exports);
  } catch (error) {
    throw asWhittleError(error);
  } finally {
    onProgress = outer;
  }
}

/**
 * Calls `use` with the exports of an instance, which is dropped when anything goes wrong: no frame of WebAssembly has
 * cleaned up then.
 */
export function withEngine(use, listener = null) {
  const running = instance ?? newInstance();
  instance = null;
  const result = call(running, use, listener);
  running.exports.end();
  if (running.exports.memory.buffer.byteLength <= keptBytes) instance = running;
  return result;
}

/** An instance that keeps what it holds from call to call. */
export class OwnEngine {
  #running = newInstance();

  use(use, listener = null) {
    if (this.#running === null) throw new WhittleError('an earlier call has failed', 'internal');
    const running = this.#running;
    this.#running = null; // as in `withEngine`
    const result = call(running, use, listener);
    this.#running = running;
    return result;
  }
}
