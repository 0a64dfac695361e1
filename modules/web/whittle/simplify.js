// Whittle's own calls: a mesh of arrays, options, and a mesh of arrays.
import {withEngine} from './engine.js';
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
    const result = readMesh(engine, written, 0);
    const report = readReport(engine);
    const copy = (Type, at, n) => new Type(engine.memory.buffer, at, n).slice();
    result.vertexMap = copy(Int32Array, engine.vertex_map(), mesh.positions.length / 3);
    result.faceOrigins = copy(Uint32Array, engine.face_origins(), result.indices.length / 3);
    const hasCount = ['facesLeft', 'verticesLeft', 'ratio', 'faceRatio'].some((name) => own[name] != null);
    return {...result, report, met: report.stop === 'target' || !hasCount};
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
