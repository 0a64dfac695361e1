// What goes wrong in a module of WebAssembly, as errors of JavaScript.

/** What Whittle refuses, and what it can't do. `kind` is 'invalid', 'memory' or 'internal'. */
export class WhittleError extends Error {
  constructor(message, kind = 'invalid') {
    super(message);
    this.name = 'WhittleError';
    this.kind = kind;
  }
}

/** A text of the module, up to its 0. */
export function textAt(memory, at) {
  const bytes = new Uint8Array(memory.buffer);
  return new TextDecoder().decode(bytes.slice(at, bytes.indexOf(0, at)));
}

/** \param type the mangled name of an exception's type */
export function errorOf(type, what) {
  if (/bad_alloc|length_error/.test(type)) return new WhittleError('out of memory', 'memory');
  return new WhittleError(what, /invalid_argument|runtime_error|parse_error|ReadError|WriteError|UnsupportedMesh/.test(type) ? 'invalid' : 'internal');
}

/** What a call of a module has thrown. */
export function asWhittleError(error) {
  if (error instanceof WebAssembly.RuntimeError) return new WhittleError(`the module failed: ${error.message}`, 'internal');
  if (error instanceof RangeError && /stack/i.test(error.message)) return new WhittleError('out of stack', 'memory');
  return error;
}
