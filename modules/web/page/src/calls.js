// The worker that reads, simplifies and writes meshes, one call after the other, and measures levels between them.

/** A call has failed. `kind`: 'invalid' (what was given), 'memory', 'internal' */
export class CallError extends Error {
  constructor({message, kind}) {
    super(message);
    this.kind = kind;
  }
}

/** Somebody has ended a call. */
export class Cancelled extends Error {}

export class Calls {
  /** \param script of the worker \param wasm base64 text of what it runs, which only the worker unpacks */
  constructor(script, wasm) {
    this.url = URL.createObjectURL(new Blob([script], {type: 'text/javascript'}));
    this.wasm = wasm;
    this.worker = null;
    this.mesh = null; // that the worker has open
    this.memory = null; // another object whenever the worker forgets what it has made
    this.nCalls = 0;
    this.sent = new Map(); // calls that have not ended, by id
    this.last = Promise.resolve(); // settles when all calls so far have ended
  }

  /** \param mesh {files, name} \param listeners of this and of all calls: {signal, onProgress, onPoint}
      \return {facts, page}: what is known of it, and its recording for the viewer */
  open(mesh, listeners) {
    return this.inTurn(() => this.openNow(mesh, listeners), listeners);
  }

  /** A call about a mesh, which a worker that hasn't it opens before. */
  call(mesh, name, about, listeners) {
    return this.inTurn(async () => {
      if (this.mesh !== mesh) await this.openNow(mesh, listeners);
      return this.send(name, about, listeners);
    }, listeners);
  }

  /** Measures levels whenever the worker has nothing else to do: no call waits for it. It ends as cancelled if the worker
      forgets the mesh meanwhile. */
  async measure(mesh, onPoint) {
    const [listeners, sent] = [{onPoint}, {}];
    await this.inTurn(async () => {
      if (this.mesh !== mesh) await this.openNow(mesh, listeners);
      sent.memory = this.memory;
      sent.end = this.send('curve', {}, listeners);
      sent.end.catch(() => {}); // it is awaited below
    }, listeners);
    await sent.end;
    if (this.memory !== sent.memory) throw new Cancelled();
  }

  /** Runs after all calls before. One that is cancelled while it waits ends at once. */
  inTurn(run, {signal}) {
    const turn = this.last.then(() => {
      if (signal?.aborted) throw new Cancelled();
      return run();
    });
    this.last = turn.catch(() => {});
    const cancelled = new Promise((_, reject) => signal?.addEventListener('abort', () => reject(new Cancelled()), {once: true}));
    return Promise.race([turn, cancelled]);
  }

  async openNow(mesh, listeners) {
    this.forget();
    const facts = await this.send('open', mesh, listeners);
    const {page} = await this.send('levels', {}, listeners);
    this.mesh = mesh;
    this.memory = {};
    return {facts, page};
  }

  /** The worker has forgotten all. */
  forget() {
    this.mesh = null;
    this.memory = null;
  }

  /** What ends a call by force takes the worker with it, and all of its calls. */
  drop() {
    this.worker?.terminate();
    this.worker = null;
    this.forget();
    for (const {end} of [...this.sent.values()]) end(new Cancelled());
  }

  start() {
    this.worker = new Worker(this.url);
    this.worker.onmessage = ({data: {id, progress, point, error, result}}) => {
      const {onProgress, onPoint, end} = this.sent.get(id) ?? {};
      if (!end) return; // it was cancelled
      if (progress) return onProgress(progress);
      if (point) return onPoint(point);
      if (error) this.forget();
      end(error && new CallError(error), result);
      if (error && error.kind !== 'invalid') this.drop(); // its memory may be full
    };
    this.worker.onerror = (event) => {
      event.preventDefault();
      const error = new CallError({message: event.message || 'the worker has ended', kind: 'internal'});
      for (const {end} of [...this.sent.values()]) end(error);
      this.drop();
    };
    this.worker.postMessage({wasm: this.wasm});
  }

  send(call, about, {signal, onProgress = () => {}, onPoint = () => {}}) {
    if (!this.worker) this.start();
    const id = ++this.nCalls;
    return new Promise((resolve, reject) => {
      const cancel = () => this.drop();
      const end = (error, result) => {
        this.sent.delete(id);
        signal?.removeEventListener('abort', cancel);
        if (error) reject(error); else resolve(result);
      };
      this.sent.set(id, {onProgress, onPoint, end});
      signal?.addEventListener('abort', cancel);
      this.worker.postMessage({id, call, ...about});
    });
  }
}
