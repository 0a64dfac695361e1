// What runs in the worker: one call, its progress, and its result or error.
import {ready} from './engine.js';
import {lod, simplify} from './simplify.js';

const inNode = typeof process === 'object' && process.versions?.node !== undefined;
const port = inNode
  ? (await import(/* @vite-ignore */ /* webpackIgnore: true */ 'node:worker_threads')).parentPort
  : self;

function buffersOf(value, found = new Set()) {
  if (ArrayBuffer.isView(value)) found.add(value.buffer);
  else if (typeof value === 'object' && value !== null) for (const part of Object.values(value)) buffersOf(part, found);
  return found;
}

async function answer({mesh, targets, options, tellsProgress}) {
  try {
    await ready;
    const onProgress = tellsProgress
      ? (stage, fraction, faces) => void port.postMessage({stage, fraction, faces})
      : undefined;
    const result = targets ? lod(mesh, targets, {...options, onProgress}) : simplify(mesh, {...options, onProgress});
    port.postMessage({result}, [...buffersOf(result)]);
  } catch (error) {
    port.postMessage({error: {message: error.message, kind: error.kind ?? 'internal'}});
  }
}

if (inNode) port.on('message', answer);
else port.onmessage = ({data}) => answer(data);
