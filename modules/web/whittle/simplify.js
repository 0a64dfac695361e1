// Whittle's own calls: a mesh of arrays, options, and a mesh of arrays.
import {OwnEngine, withEngine} from './engine.js';
import {WhittleError} from './errors.js';
import {readMesh, writeMesh} from './mesh.js';
import {setOptions} from './options.js';

const stops = ['target', 'cost', 'error', 'exhausted', 'cancelled'];

function readReport(engine) {
  const [verticesBefore, facesBefore, stop, maxCost, error, contractions, folded] = new Float64Array(
    engine.memory.buffer,
    engine.report(),
    7,
  );
  return {
    verticesBefore,
    facesBefore,
    stop: stops[stop],
    maxCost,
    provenError: error < 0 ? null : error,
    contractions,
    foldedTextureFaces: folded,
  };
}

/** The result, with what is told of it. */
function readResult(engine, written) {
  const result = readMesh(engine, written, 0);
  const copy = (Type, at, n) => new Type(engine.memory.buffer, at, n).slice();
  result.vertexMap = copy(Int32Array, engine.vertex_map(), written.positions.length / 3);
  result.faceOrigins = copy(Uint32Array, engine.face_origins(), result.indices.length / 3);
  return {...result, report: readReport(engine)};
}

function begin(engine, mesh, options, onProgress) {
  const written = writeMesh(engine, mesh, Boolean(onProgress));
  setOptions(engine, options);
  return written;
}

/** Simplifies a mesh: index.d.ts has what it takes and gives. */
export function simplify(mesh, options = {}) {
  const {onProgress, ...own} = options;
  return withEngine((engine) => {
    const written = begin(engine, mesh, own, onProgress);
    engine.simplify();
    const result = readResult(engine, written);
    const hasCount = ['facesLeft', 'verticesLeft', 'ratio', 'faceRatio'].some((name) => own[name] != null);
    return {...result, met: result.report.stop === 'target' || !hasCount};
  }, onProgress ?? null);
}

/** Levels of detail out of one run, the finest first. \param targets facesLeft or faceRatios, descending */
export function lod(mesh, targets, options = {}) {
  const {onProgress, ...own} = options;
  const nFaces = (mesh.indices?.length ?? mesh.positions.length / 3) / 3;
  const counts =
    targets.facesLeft ?? targets.faceRatios?.map((ratio) => Math.floor(ratio * nFaces * (1 + 4 * Number.EPSILON)));
  if (!counts || counts.length === 0) throw new WhittleError('lod: give facesLeft or faceRatios, at least one of them');
  return withEngine((engine) => {
    const written = begin(engine, mesh, own, onProgress);
    for (const count of counts) engine.level(count);
    engine.simplify();
    return Array.from({length: engine.n_results()}, (_, i) => readMesh(engine, written, i));
  }, onProgress ?? null);
}

/** A run whose levels can be had without running again: index.d.ts has the details. */
export class Recording {
  #engine = new OwnEngine();
  #written;

  /** `record` makes one. */
  constructor(mesh, options) {
    const {onProgress, ...own} = options;
    this.last = this.#engine.use((engine) => {
      this.#written = begin(engine, mesh, own, onProgress);
      engine.record();
      return readResult(engine, this.#written);
    }, onProgress ?? null);
  }

  level({facesLeft, verticesLeft}) {
    if ((facesLeft === undefined) === (verticesLeft === undefined)) {
      throw new WhittleError('level: give facesLeft or verticesLeft, one of them');
    }
    const n = facesLeft ?? verticesLeft;
    if (!(Number.isSafeInteger(n) && n >= 0)) throw new WhittleError(`level: '${n}' is no whole number from 0 on`);
    return this.#engine.use((engine) => {
      engine.take_level(n, verticesLeft === undefined ? 0 : 1);
      return readResult(engine, this.#written);
    });
  }
}

/** Simplifies and keeps all levels. */
export const record = (mesh, options = {}) => new Recording(mesh, options);
