// What works in the background of the page: it holds the mesh. ../README.md has the messages.
import {MeshoptDecoder} from 'meshoptimizer';
import {WhittleError} from '../../whittle/errors.js';
import {Engine} from './engine.js';

const quiet = 1000; // milliseconds without a call, after which levels are measured: a call waits for the one that is

let compiled = null; // a promise
let engine = null;
let tell = () => {}; // of progress
let isMeasuring = null; // the id of the call whose levels are measured whenever nothing else is to be done
let lastCall = Promise.resolve();
let lastAnswer = 0; // when it was

/** \param text of WebAssembly: deflated, as base64 */
async function compile(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  await MeshoptDecoder.ready;
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return WebAssembly.compile(await new Response(stream).arrayBuffer());
}

async function bytesOf({name, file}) {
  const isPacked = name.toLowerCase().endsWith('.gz');
  const stream = isPacked ? file.stream().pipeThrough(new DecompressionStream('gzip')) : file.stream();
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

const unpackedName = (name) => name.replace(/\.gz$/i, '');

const calls = {
  async open({files, name}, onProgress) {
    isMeasuring = null;
    engine = null; // its memory is free before the next one is filled
    const fresh = new Engine(await compiled, onProgress);
    onProgress({stage: 'reading', fraction: 0, faces: 0});
    for (const one of files) fresh.files.set(unpackedName(one.name), await bytesOf(one));
    const facts = fresh.call('open_session', unpackedName(name));
    engine = fresh;
    return {...facts, bytes: files.find((one) => one.name === name).file.size};
  },
  levels() {
    engine.call('record_levels');
    return {page: engine.page()};
  },
  simplify({target, effort}) {
    const facts = engine.call('simplify_session', effort, target.faces ?? NaN, target.maxError ?? NaN);
    return {...facts, page: engine.page()};
  },
  measure() {
    return {error: engine.call('measure_result')};
  },
  write({format}) {
    const warnings = engine.call('write_result', format);
    return {files: engine.takeOutputs().map(({name, bytes}) => ({name, bytes: bytes.buffer})), warnings};
  },
};

const buffersOf = ({page, files}) => [...(page ? [page.bytes] : []), ...(files ?? []).map(({bytes}) => bytes)];

function fail(id, error) {
  engine = null; // no frame of WebAssembly has cleaned up: its memory is in any state
  isMeasuring = null;
  postMessage({id, error: {message: error.message, kind: error.kind ?? 'internal'}});
}

async function answer({id, call, ...given}) {
  try {
    tell = (progress) => postMessage({id, progress});
    if (call !== 'open' && engine === null) throw new WhittleError('no mesh is open');
    const result = await calls[call](given, (progress) => tell(progress));
    postMessage({id, result}, buffersOf(result));
  } catch (error) {
    fail(id, error);
  }
  lastAnswer = performance.now();
}

/** Measures a level, once nothing has been asked for a while. */
function measure(id) {
  setTimeout(() => {
    if (performance.now() - lastAnswer < quiet) return measure(id);
    lastCall = lastCall.then(() => measureNow(id));
  }, Math.max(0, lastAnswer + quiet - performance.now()));
}

function measureNow(id) {
  let point = null;
  try {
    tell = () => {};
    if (isMeasuring === id) point = engine.call('measure_next_level');
  } catch (error) {
    return fail(id, error);
  }
  if (point === null) return postMessage({id, result: {}});
  postMessage({id, point});
  measure(id);
}

onmessage = ({data}) => {
  if (data.wasm) {
    compiled = compile(data.wasm);
    compiled.catch(() => {}); // the first call gets the error
  } else if (data.call === 'curve') {
    isMeasuring = data.id;
    measure(data.id);
  } else {
    lastCall = lastCall.then(() => answer(data));
  }
};
