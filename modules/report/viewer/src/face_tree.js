// The faces of a surface in a tree of boxes: which is nearest to a point, and where a ray meets one.
import {Triangle, Vector3} from 'three';
import {unit} from './surface.js';

const mostOfLeaf = 4; // faces
const mostOpen = 128; // Each cut halves a box of 16-bit numbers or a number of faces: the tree is less deep.
const noFace = -1;

/** Lengths are those of the grid that the page rounds positions to. */
export class FaceTree {
  /** \param surface a Surface */
  constructor({positions, corners, nFaces}) {
    this.order = new Uint32Array(nFaces); // the faces of a node follow each other
    this.coordinates = new Float32Array(9 * nFaces); // of the corners of each face, in the same order
    this.first = new Uint32Array(2 * nFaces); // of each node: its first face, or the first of its two children
    this.count = new Uint32Array(2 * nFaces); // of its faces; 0 if it has children
    this.boxes = new Float32Array(12 * nFaces); // of each node: least x, y, z, then greatest
    this.nNodes = 0;
    this.open = new Uint32Array(mostOpen);
    this.openBounds = new Float64Array(mostOpen);
    this.toPoint = new ToPoint(this);
    this.alongRay = new AlongRay(this);
    this.face = noFace; // that was found last
    this.triangle = new Triangle();
    this.closest = new Vector3();
    this.building = this.build(positions, corners);
  }

  /** Builds what is not built yet, and yields after each small part of the work. */
  *finish() {
    while (!this.building.next().done) yield;
  }

  *build(positions, corners) {
    const middles = middlesOf(positions, corners, this.order.length);
    yield;
    yield* this.split(middles);
    yield* this.copyCoordinates(positions, corners);
    for (let node = this.nNodes; node-- > 0;) { // children before their parents
      if (this.count[node] > 0) this.boundFaces(node); else this.boundChildren(node);
      if (node % 4096 === 0) yield;
    }
  }

  /** Splits nodes until they are small. */
  *split(middles) {
    for (let f = 0; f < this.order.length; ++f) this.order[f] = f;
    this.addNode(0, this.order.length);
    for (let node = 0; node < this.nNodes; ++node) {
      const n = this.count[node];
      if (n <= mostOfLeaf) continue;
      const begin = this.first[node];
      const middle = this.partition(middles, begin, begin + n);
      this.first[node] = this.nNodes;
      this.count[node] = 0;
      this.addNode(begin, middle - begin);
      this.addNode(middle, begin + n - middle);
      if (n > 1000 || node % 256 === 0) yield;
    }
  }

  addNode(first, count) {
    this.first[this.nNodes] = first;
    this.count[this.nNodes++] = count;
  }

  /** Puts faces on one side of the middle of the box around them before the others. \return the first of these */
  partition(middles, begin, end) {
    const {order} = this;
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    for (let i = begin; i < end; ++i) {
      for (let d = 0; d < 3; ++d) {
        const x = middles[3 * order[i] + d];
        if (x < low[d]) low[d] = x;
        if (x > high[d]) high[d] = x;
      }
    }
    const sides = high.map((x, d) => x - low[d]);
    const axis = sides.indexOf(Math.max(...sides));
    const middle = (low[axis] + high[axis]) / 2;
    let last = end;
    let i = begin;
    while (i < last) {
      const face = order[i];
      if (middles[3 * face + axis] < middle) {
        ++i;
      } else {
        order[i] = order[--last];
        order[last] = face;
      }
    }
    return i > begin ? i : begin + end >> 1; // all are in one place
  }

  *copyCoordinates(positions, corners) {
    const {order, coordinates} = this;
    for (let i = 0; i < order.length; ++i) {
      for (let k = 0; k < 3; ++k) {
        const v = 4 * corners[3 * order[i] + k];
        for (let d = 0; d < 3; ++d) coordinates[9 * i + 3 * k + d] = positions[v + d];
      }
      if (i % 4096 === 0) yield;
    }
  }

  boundFaces(node) {
    const {boxes, coordinates} = this;
    const begin = 9 * this.first[node];
    const end = begin + 9 * this.count[node];
    for (let d = 0; d < 3; ++d) {
      let low = Infinity;
      let high = -Infinity;
      for (let i = begin + d; i < end; i += 3) {
        low = Math.min(low, coordinates[i]);
        high = Math.max(high, coordinates[i]);
      }
      boxes[6 * node + d] = low;
      boxes[6 * node + 3 + d] = high;
    }
  }

  boundChildren(node) {
    const {boxes} = this;
    const a = 6 * this.first[node];
    for (let d = 0; d < 3; ++d) {
      boxes[6 * node + d] = Math.min(boxes[a + d], boxes[a + 6 + d]);
      boxes[6 * node + 3 + d] = Math.max(boxes[a + 3 + d], boxes[a + 9 + d]);
    }
  }

  /** The distance of a point. It takes less time if the last one was nearby. */
  distance({x, y, z}) {
    const {toPoint} = this;
    [toPoint.x, toPoint.y, toPoint.z] = [x, y, z];
    return Math.sqrt(this.search(toPoint));
  }

  /** The same of a point whose coordinates are 0 … 1 along the longest side. */
  distanceOfUnit(x, y, z) {
    return this.distance({x: unit * x, y: unit * y, z: unit * z});
  }

  /** Puts a point that is nearly on the surface onto it: where a ray to it first meets it, or else where it is closest. */
  putOnSurface(point, begin) {
    const {alongRay} = this;
    alongRay.begin.copy(begin);
    alongRay.direction.subVectors(point, begin);
    const times = this.search(alongRay);
    if (times < Infinity) {
      point.copy(begin).addScaledVector(alongRay.direction, times);
    } else {
      this.distance(point);
      this.putOnFace(this.face, point);
    }
  }

  putOnFace(face, point) {
    const {triangle, coordinates} = this;
    triangle.a.fromArray(coordinates, 9 * face);
    triangle.b.fromArray(coordinates, 9 * face + 3);
    triangle.c.fromArray(coordinates, 9 * face + 6);
    triangle.closestPointToPoint(point, this.closest);
    if (Number.isFinite(this.closest.x)) point.copy(this.closest); // the face has an area
  }

  /** Finds the face with the least measure. \param query ToPoint or AlongRay \return its measure, Infinity if there is none */
  search(query) {
    const {openBounds, open, first, count} = this;
    let least = this.face === noFace ? Infinity : query.ofFace(this.face);
    if (least === Infinity) this.face = noFace;
    let nOpen = this.openNode(0, query.ofBox(0), 0, least);
    while (nOpen > 0) {
      const node = open[--nOpen];
      if (openBounds[nOpen] >= least) continue;
      if (count[node] > 0) least = this.leastOfLeaf(node, query, least);
      else nOpen = this.openChildren(first[node], query, nOpen, least);
    }
    return least;
  }

  leastOfLeaf(node, query, least) {
    for (let f = this.first[node]; f < this.first[node] + this.count[node]; ++f) {
      const measure = query.ofFace(f);
      if (measure >= least) continue;
      least = measure;
      this.face = f;
    }
    return least;
  }

  /** Of two children, the one with the lower bound comes next. \return the number of open nodes */
  openChildren(a, query, nOpen, least) {
    const ofA = query.ofBox(a);
    const ofB = query.ofBox(a + 1);
    if (ofA < ofB) return this.openNode(a, ofA, this.openNode(a + 1, ofB, nOpen, least), least);
    return this.openNode(a + 1, ofB, this.openNode(a, ofA, nOpen, least), least);
  }

  openNode(node, bound, nOpen, least) {
    if (bound >= least) return nOpen;
    this.open[nOpen] = node;
    this.openBounds[nOpen] = bound;
    return nOpen + 1;
  }
}

/** Measures squared distances to a point. */
class ToPoint {
  constructor({boxes, coordinates}) {
    Object.assign(this, {boxes, coordinates, x: 0.5, y: 0.5, z: 0.5});
  }

  ofBox(node) {
    const {boxes, x, y, z} = this;
    const i = 6 * node;
    const dx = Math.max(boxes[i] - x, 0, x - boxes[i + 3]);
    const dy = Math.max(boxes[i + 1] - y, 0, y - boxes[i + 4]);
    const dz = Math.max(boxes[i + 2] - z, 0, z - boxes[i + 5]);
    return dx * dx + dy * dy + dz * dz;
  }

  /** Source: Quilez: distance functions (https://iquilezles.org/articles/triangledistance). */
  ofFace(face) {
    const c = this.coordinates;
    const i = 9 * face;
    const [px, py, pz] = [this.x - c[i], this.y - c[i + 1], this.z - c[i + 2]];
    const [ux, uy, uz] = [c[i + 3] - c[i], c[i + 4] - c[i + 1], c[i + 5] - c[i + 2]];
    const [vx, vy, vz] = [c[i + 6] - c[i], c[i + 7] - c[i + 1], c[i + 8] - c[i + 2]];
    const [nx, ny, nz] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    const nn = nx * nx + ny * ny + nz * nz;
    if (nn > 0) {
      // p = s u + t v + h n
      const s = (nx * (py * vz - pz * vy) + ny * (pz * vx - px * vz) + nz * (px * vy - py * vx)) / nn;
      const t = (nx * (uy * pz - uz * py) + ny * (uz * px - ux * pz) + nz * (ux * py - uy * px)) / nn;
      if (s >= 0 && t >= 0 && s + t <= 1) {
        const height = px * nx + py * ny + pz * nz;
        return height * height / nn;
      }
    }
    return Math.min(segmentDistanceSq(px, py, pz, ux, uy, uz), segmentDistanceSq(px, py, pz, vx, vy, vz),
      segmentDistanceSq(px - ux, py - uy, pz - uz, vx - ux, vy - uy, vz - uz));
  }
}

/** Measures how many times its direction a ray goes until it meets something; Infinity if it doesn't. */
class AlongRay {
  constructor({boxes, coordinates}) {
    Object.assign(this, {boxes, coordinates, begin: new Vector3(), direction: new Vector3()});
  }

  ofBox(node) {
    const {boxes, begin, direction} = this;
    const i = 6 * node;
    const ax = (boxes[i] - begin.x) / direction.x;
    const bx = (boxes[i + 3] - begin.x) / direction.x;
    const ay = (boxes[i + 1] - begin.y) / direction.y;
    const by = (boxes[i + 4] - begin.y) / direction.y;
    const az = (boxes[i + 2] - begin.z) / direction.z;
    const bz = (boxes[i + 5] - begin.z) / direction.z;
    const enters = Math.max(Math.min(ax, bx), Math.min(ay, by), Math.min(az, bz));
    const leaves = Math.min(Math.max(ax, bx), Math.max(ay, by), Math.max(az, bz));
    return enters > leaves || leaves < 0 ? Infinity : Math.max(enters, 0);
  }

  /** Source: Möller and Trumbore: Fast, Minimum Storage Ray/Triangle Intersection (1997). */
  ofFace(face) {
    const c = this.coordinates;
    const i = 9 * face;
    const {x: dx, y: dy, z: dz} = this.direction;
    const [px, py, pz] = [this.begin.x - c[i], this.begin.y - c[i + 1], this.begin.z - c[i + 2]];
    const [ux, uy, uz] = [c[i + 3] - c[i], c[i + 4] - c[i + 1], c[i + 5] - c[i + 2]];
    const [vx, vy, vz] = [c[i + 6] - c[i], c[i + 7] - c[i + 1], c[i + 8] - c[i + 2]];
    const [mx, my, mz] = [dy * vz - dz * vy, dz * vx - dx * vz, dx * vy - dy * vx];
    const [nx, ny, nz] = [py * uz - pz * uy, pz * ux - px * uz, px * uy - py * ux];
    const determinant = ux * mx + uy * my + uz * mz;
    if (determinant === 0) return Infinity;
    const s = (px * mx + py * my + pz * mz) / determinant;
    const t = (dx * nx + dy * ny + dz * nz) / determinant;
    if (!(s >= 0 && t >= 0 && s + t <= 1)) return Infinity;
    const times = (vx * nx + vy * ny + vz * nz) / determinant;
    return times >= 0 ? times : Infinity;
  }
}

/** Of each face, the sum of its corners. */
function middlesOf(positions, corners, nFaces) {
  const middles = new Float32Array(3 * nFaces);
  for (let i = 0; i < 3 * nFaces; i += 3) {
    const [a, b, c] = [4 * corners[i], 4 * corners[i + 1], 4 * corners[i + 2]];
    for (let d = 0; d < 3; ++d) middles[i + d] = positions[a + d] + positions[b + d] + positions[c + d];
  }
  return middles;
}

/** From p to a segment from the origin to u. */
function segmentDistanceSq(px, py, pz, ux, uy, uz) {
  const uu = ux * ux + uy * uy + uz * uz;
  const t = uu > 0 ? Math.min(1, Math.max(0, (px * ux + py * uy + pz * uz) / uu)) : 0;
  const [dx, dy, dz] = [px - t * ux, py - t * uy, pz - t * uz];
  return dx * dx + dy * dy + dz * dz;
}
