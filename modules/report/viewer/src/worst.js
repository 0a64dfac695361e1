// The place with the largest error.
import {Vector3} from 'three';
import {unit} from './surface.js';

/** Of a mesh that has distances. \return {value, point, normal}: model units, the place, and which way the surface faces */
export function worstOfSurface({distances}) {
  distances.cut();
  const {positions, corners, nVertices, max} = distances;
  let worst = 0;
  for (let v = 1; v < nVertices; ++v) {
    if (Math.abs(positions[4 * v + 3] - 32768) > Math.abs(positions[4 * worst + 3] - 32768)) worst = v;
  }
  const at = (v) => new Vector3().fromArray(positions, 4 * v).divideScalar(unit);
  return {value: Math.abs(positions[4 * worst + 3] - 32768) / 32767 * max, point: at(worst), normal: normalAt(worst, corners, corners.length, at)};
}

/** Of a recording's level, whose vertices have been measured. */
export function worstOfLevel(recording, errors) {
  const {corners, nFaces, shownPositions} = recording;
  let worst = corners[0];
  for (let i = 0; i < 3 * nFaces; ++i) if (errors.values[corners[i]] > errors.values[worst]) worst = corners[i];
  const at = (v) => new Vector3().fromArray(shownPositions, 3 * v);
  return {value: errors.values[worst] * errors.max, point: at(worst), normal: normalAt(worst, corners, 3 * nFaces, at)};
}

/** The sum of the normals of the faces at a vertex, by their area; towards the eye if there is none. */
function normalAt(vertex, corners, nCorners, at) {
  const normal = new Vector3();
  for (let i = 0; i < nCorners; i += 3) {
    const [a, b, c] = [corners[i], corners[i + 1], corners[i + 2]];
    if (a !== vertex && b !== vertex && c !== vertex) continue;
    const begin = at(a);
    normal.add(at(b).sub(begin).cross(at(c).sub(begin)));
  }
  return normal.lengthSq() > 0 ? normal.normalize() : new Vector3(0, 0, 1);
}
