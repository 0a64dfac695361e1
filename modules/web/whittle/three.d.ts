import type {BufferGeometry} from 'three';
import type {OnProgress, SimplifyOptions, WorkerControl} from './index.js';

/**
 * A simplified copy of a geometry, with an index. All attributes go along, interleaved and normalized ones, too:
 * normals, uv, colours, skin, and morph targets; groups keep their materials. Await `ready` before.
 * @throws WhittleError for a geometry with instances or a drawRange, and as `simplify`
 */
export function simplifyGeometry(
  geometry: BufferGeometry,
  options: SimplifyOptions & {onProgress?: OnProgress},
): BufferGeometry;

/** The same in a worker. */
export function simplifyGeometryInWorker(
  geometry: BufferGeometry,
  options: SimplifyOptions,
  control?: WorkerControl,
): Promise<BufferGeometry>;
