// An instance of the page's module, with its files.
import {MeshoptDecoder} from 'meshoptimizer';
import {asWhittleError, errorOf, textAt} from '../../whittle/errors.js';
import {MemoryFiles} from './memory_files.js';

const outputs = 'out'; // the folder of what is written, as in session.cc
const noSuchCall = 52; // ENOSYS

/** Unpacks data of a glTF file within the memory. \return 1, or 0 if they are damaged */
function decoded({buffer}, {to, count, stride, from, size}, mode, filter) {
  try {
    const target = new Uint8Array(buffer, to, count * stride);
    MeshoptDecoder.decodeGltfBuffer(target, count, stride, new Uint8Array(buffer, from, size), mode, filter);
    return 1;
  } catch {
    return 0;
  }
}

export class Engine {
  /** \param compiled the module \param onProgress is called with {stage, fraction, faces} */
  constructor(compiled, onProgress) {
    const memory = () => this.calls.memory;
    this.files = new MemoryFiles(memory);
    const textOf = (at, length) => new TextDecoder().decode(new Uint8Array(memory().buffer, at, length).slice());
    const system = {
      ...this.files.imports(),
      clock_time_get: (clock, precision, to) => {
        new DataView(memory().buffer).setBigUint64(to, BigInt(Math.round(performance.now() * 1e6)), true);
        return 0;
      },
      environ_sizes_get: (n, size) => {
        for (const to of [n, size]) new DataView(memory().buffer).setUint32(to, 0, true);
        return 0;
      },
      environ_get: () => 0,
    };
    const instance = new WebAssembly.Instance(compiled, {
      wasi_snapshot_preview1: new Proxy(system, {get: (calls, name) => calls[name] ?? (() => noSuchCall)}),
      whittle: {
        raise: (type, what) => {
          throw errorOf(textAt(memory(), type), textAt(memory(), what));
        },
        decode_meshopt: (to, count, stride, from, size, mode, filter) => decoded(memory(), {to, count, stride, from, size}, textAt(memory(), mode), textAt(memory(), filter)),
        stage: (fraction, stage, length, faces) => onProgress({stage: textOf(stage, length), fraction, faces}),
      },
    });
    this.calls = instance.exports;
    this.calls._initialize();
  }

  /** Calls a function of the module. \param text that it takes, if any \return its answer, if any */
  call(name, text, ...numbers) {
    try {
      if (text !== undefined) this.setText(text);
      const at = this.calls[name](...numbers);
      return at === undefined ? undefined : JSON.parse(textAt(this.calls.memory, at));
    } catch (error) {
      throw asWhittleError(error);
    }
  }

  setText(text) {
    const bytes = new TextEncoder().encode(text);
    const at = this.calls.text_of(bytes.length);
    new Uint8Array(this.calls.memory.buffer, at, bytes.length).set(bytes);
  }

  /** What the viewer shows. */
  page() {
    const json = this.call('page_json');
    const [at, length] = [this.calls.page_bytes(), this.calls.n_page_bytes()];
    return {json, bytes: this.calls.memory.buffer.slice(at, at + length)};
  }

  takeOutputs() {
    return this.files.take(outputs);
  }
}
