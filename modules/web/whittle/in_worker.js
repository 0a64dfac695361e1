// The same calls on another thread, which goes on drawing meanwhile.
import {WhittleError} from './errors.js';

const cancelled = () => new DOMException('cancelled', 'AbortError');

async function newWorker() {
  if (typeof Worker === 'function') return new Worker(new URL('./worker.js', import.meta.url), {type: 'module'});
  const threads = await import(/* @vite-ignore */ /* webpackIgnore: true */ 'node:worker_threads');
  return new threads.Worker(new URL('./worker.js', import.meta.url));
}

function listen(worker, onMessage, onError) {
  if (worker.on) {
    worker.on('message', onMessage);
    worker.on('error', onError);
  } else {
    worker.onmessage = ({data}) => onMessage(data);
    worker.onerror = (event) => onError(new WhittleError(event.message ?? 'the worker failed to start', 'internal'));
  }
}

/** `simplify`, or `lod` where `targets` are given, in a worker of its own. index.d.ts has the details. */
export async function simplifyInWorker(mesh, options = {}, {signal, onProgress, targets} = {}) {
  if (signal?.aborted) throw cancelled();
  const worker = await newWorker();
  try {
    return await new Promise((resolve, reject) => {
      const abort = () => reject(cancelled());
      if (signal?.aborted) return abort();
      signal?.addEventListener('abort', abort, {once: true});
      const answer = (message) => {
        if (message.error) reject(new WhittleError(message.error.message, message.error.kind));
        else if (message.result) resolve(message.result);
        else {
          try {
            onProgress(message.stage, message.fraction, message.faces);
          } catch (error) {
            reject(error);
          }
        }
      };
      listen(worker, answer, reject);
      worker.postMessage({mesh, targets, options, tellsProgress: Boolean(onProgress)});
    });
  } finally {
    worker.terminate();
  }
}
