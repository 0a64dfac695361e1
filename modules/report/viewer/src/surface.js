// A mesh of the page. Coordinates are 0 … 1 along the longest side of the box around all meshes.

import {shareOfMax} from './distances.js';
import {Look} from './look.js';

export const unit = 65535;

/** A mesh that stays as it is. */
export class Surface {
  /** \param images of the page */
  constructor(json, array, images) {
    this.name = json.name;
    this.note = json.note;
    this.error = json.error; // {mean, max}, sampled, of a result; or null
    this.nVertices = json.vertices;
    this.nFaces = json.faces;
    this.nFacesOfFile = json.faces_of_file; // more, if a coarser level of it is shown
    this.positions = array(json.positions, Uint16Array); // four numbers a vertex, the last one 0
    const corners = array(json.corners, Uint32Array);
    this.look = json.look && new Look(json.look, array, corners, images); // or null: it has a shape alone
    this.corners = this.look?.verticesOf(corners) ?? corners;
    this.coarseWedges = array(json.coarse, Uint32Array); // of fewer faces; or empty
    this.coarse = this.look?.verticesOf(this.coarseWedges) ?? this.coarseWedges;
    this.borders = array(json.borders, Uint32Array);
    this.nonmanifold = array(json.nonmanifold, Uint32Array);
    this.refusals = json.refusals.map(({reason, pairs}) => ({reason, pairs: array(pairs, Uint32Array)}));
    this.distances = json.distances && new Distances(json.distances, array, this);
    this.version = 0;
  }

  /** Three numbers a vertex. */
  unitPositions() {
    return unitPositions(this.positions);
  }
}

/** A mesh, cut into smaller faces, with a distance at each vertex. */
class Distances {
  constructor(json, array, surface) {
    this.max = json.max; // model units
    this.usual = json.usual; // 99 % of the area is nearer, model units
    this.nFaces = json.faces;
    this.values = array(json.values, Uint8Array); // as packed_surface.cc packs signed distances
    this.nVertices = json.vertices;
    this.rounds = json.rounds;
    this.cuts = array(json.cuts, Uint8Array);
    this.surface = surface;
    this.isCut = false;
  }

  /** Makes `positions`, four numbers a vertex, the last one the signed distance: 1 and 65535 are `max` behind and in front. And `corners`. */
  cut() {
    if (this.isCut) return;
    this.isCut = true;
    this.positions = new Uint16Array(4 * this.nVertices);
    this.positions.set(this.surface.positions);
    this.nMade = this.surface.nVertices;
    this.corners = new Uint32Array(3 * this.nFaces);
    this.nCorners = 0;
    let open = fromLowest(this.surface.corners);
    let first = 0;
    for (const n of this.rounds) {
      open = this.cutRound(open, this.cuts.subarray(first, first + n));
      first += n;
    }
    for (const vertex of open) this.corners[this.nCorners++] = vertex;
    for (let v = 0; v < this.nVertices; ++v) this.positions[4 * v + 3] = 32768 + Math.round(32767 * shareOfMax(this.values[v], this));
  }

  /** \return the parts of faces that are cut */
  cutRound(open, cuts) {
    const middles = new Map();
    const parts = [];
    for (let f = 0; f < cuts.length; ++f) {
      const corners = [open[3 * f], open[3 * f + 1], open[3 * f + 2]];
      const cut = cuts[f];
      if (cut === 0) {
        for (const vertex of corners) this.corners[this.nCorners++] = vertex;
        continue;
      }
      const middle = corners.map((vertex, k) => cut >> k & 1 ? this.middle(middles, vertex, corners[(k + 1) % 3]) : -1);
      addParts(corners, middle, parts);
    }
    return parts;
  }

  middle(middles, a, b) {
    const key = Math.min(a, b) * 0x4000000 + Math.max(a, b);
    const known = middles.get(key);
    if (known !== undefined) return known;
    const made = this.nMade++;
    const {positions} = this;
    for (let d = 0; d < 3; ++d) positions[4 * made + d] = positions[4 * a + d] + positions[4 * b + d] + 1 >> 1;
    middles.set(key, made);
    return made;
  }
}

/** The faces, each from its lowest vertex on. */
function fromLowest(corners) {
  const rotated = new Uint32Array(corners.length);
  for (let i = 0; i < corners.length; i += 3) {
    let k = 0;
    if (corners[i + 1] < corners[i + k]) k = 1;
    if (corners[i + 2] < corners[i + k]) k = 2;
    for (let d = 0; d < 3; ++d) rotated[i + d] = corners[i + (k + d) % 3];
  }
  return rotated;
}

/** The parts of a face; `middle` has a vertex, or −1, on the edge from each corner on. As in distance_map.cc. */
function addParts(corners, middle, parts) {
  const nCut = middle.filter((m) => m >= 0).length;
  let i = 0;
  if (nCut === 1) while (middle[i] < 0) ++i;
  if (nCut === 2) while (middle[(i + 2) % 3] >= 0) ++i;
  const [a, b, c] = [corners[i], corners[(i + 1) % 3], corners[(i + 2) % 3]];
  const [ab, bc, ca] = [middle[i], middle[(i + 1) % 3], middle[(i + 2) % 3]];
  if (nCut === 1) parts.push(a, ab, c, ab, b, c);
  if (nCut === 2) parts.push(ab, b, bc, a, ab, bc, a, bc, c);
  if (nCut === 3) parts.push(a, ab, ca, ab, b, bc, bc, c, ca, ab, bc, ca);
}

export function unitPositions(packed) {
  const positions = new Float32Array(packed.length / 4 * 3);
  for (let i = 0, j = 0; i < packed.length; i += 4) {
    positions[j++] = packed[i] / unit;
    positions[j++] = packed[i + 1] / unit;
    positions[j++] = packed[i + 2] / unit;
  }
  return positions;
}

/** The edges between vertices of which the lower one comes first: all edges of a surface that is oriented, but some of
    its borders. */
export function edgesOf(corners, nCorners) {
  const edges = new Uint32Array(2 * nCorners);
  let n = 0;
  for (let i = 0; i < nCorners; i += 3) {
    const a = corners[i];
    const b = corners[i + 1];
    const c = corners[i + 2];
    if (a < b) { edges[n++] = a; edges[n++] = b; }
    if (b < c) { edges[n++] = b; edges[n++] = c; }
    if (c < a) { edges[n++] = c; edges[n++] = a; }
  }
  return edges.subarray(0, n);
}

/** The number of faces at each vertex, plus one at a border: its number of edges, where the surface is manifold. */
export function valences(corners, nCorners, nVertices) {
  const counts = new Uint16Array(nVertices);
  const turns = new Int32Array(nVertices); // 0 where faces go all around
  for (let i = 0; i < nCorners; i += 3) {
    for (let k = 0; k < 3; ++k) {
      const v = corners[i + k];
      ++counts[v];
      turns[v] += corners[i + (k + 1) % 3] - corners[i + (k + 2) % 3];
    }
  }
  for (let v = 0; v < nVertices; ++v) if (counts[v] > 0 && turns[v] !== 0) ++counts[v];
  return counts;
}

/** Twice the radius of the inscribed circle over that of the circumscribed one: 0 … 1, 1 is equilateral. */
export function radiusRatio(positions, a, b, c) {
  const side = (p, q) => Math.hypot(positions[3 * p] - positions[3 * q], positions[3 * p + 1] - positions[3 * q + 1],
    positions[3 * p + 2] - positions[3 * q + 2]);
  const x = side(a, b);
  const y = side(b, c);
  const z = side(c, a);
  const product = x * y * z;
  return product > 0 ? Math.max(0, (y + z - x) * (z + x - y) * (x + y - z) / product) : 0;
}
