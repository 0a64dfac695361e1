// The run that the page can play: levels between the original and the result.
import {unit, unitPositions} from './surface.js';

/** Numbers without a known end. */
class Numbers {
  constructor(capacity) {
    this.array = new Uint32Array(Math.max(16, capacity));
    this.length = 0;
  }

  push(number) {
    if (this.length === this.array.length) {
      const larger = new Uint32Array(2 * this.array.length);
      larger.set(this.array);
      this.array = larger;
    }
    this.array[this.length++] = number;
  }
}

const none = 0xffffffff;

/** 0, 1, 2, 3, … stand for 0, −1, 1, −2, … */
const difference = (packed) => packed >>> 1 ^ -(packed & 1);

/** A level is the surface after so many steps. A step is a contraction, or a pass of polish. */
export class Recording {
  constructor(json, array, original) {
    this.nSteps = json.steps;
    this.levels = json.levels; // {faces, mean, max}, some of them
    this.coarse = new Uint32Array(0);
    this.borders = new Uint32Array(0);
    this.nonmanifold = new Uint32Array(0);
    this.refusals = [];
    this.distances = null;
    this.look = null;
    this.name = 'level of the run';
    this.note = '';
    this.version = 0;
    this.nVertices = original.nVertices;
    this.positions = original.unitPositions();
    this.faceCorners = original.corners.slice();
    this.isHidden = new Uint8Array(original.nFaces);
    this.step = 0;
    this.nContractions = 0;
    this.nEnds = 0;
    this.readSteps(json, array, original.positions);
    this.rehearse();
    this.corners = new Uint32Array(original.corners.length);
    this.listFaces();
  }

  readSteps(json, array, packedPositions) {
    const words = array(json.contractions, Uint32Array);
    const halves = new Uint16Array(words.buffer);
    const n = words.length / 4;
    this.removed = new Uint32Array(n);
    this.survivor = new Uint32Array(n);
    this.after = new Float32Array(3 * n);
    this.facesAfter = new Uint32Array(n + 1);
    this.facesAfter[0] = this.isHidden.length;
    for (let i = 0; i < this.faceCorners.length; i += 3) {
      if (!this.hasThreeCorners(i)) --this.facesAfter[0];
    }
    for (let i = 0; i < n; ++i) {
      this.removed[i] = words[4 * i];
      this.survivor[i] = this.removed[i] + difference(words[4 * i + 1]);
      for (let k = 0; k < 3; ++k) {
        const original = packedPositions[4 * this.survivor[i] + k];
        this.after[3 * i + k] = (original + difference(halves[8 * i + 4 + k]) & unit) / unit;
      }
      this.facesAfter[i + 1] = this.facesAfter[i] - halves[8 * i + 7];
    }
    const ends = array(json.ends, Uint32Array);
    const moves = array(json.moves, Uint32Array);
    const turns = array(json.turns, Uint32Array);
    this.ends = [];
    let firstMove = 0;
    let firstTurn = 0;
    for (let i = 0; i < ends.length; i += 3) {
      const end = {nContractions: ends[i], vertices: new Uint32Array(ends[i + 1]), positions: new Float32Array(3 * ends[i + 1]),
        faces: new Uint32Array(ends[i + 2]), corners: new Uint32Array(3 * ends[i + 2])};
      for (let k = 0; k < end.vertices.length; ++k, ++firstMove) {
        end.vertices[k] = moves[3 * firstMove];
        const packed = new Uint16Array(moves.buffer, 12 * firstMove + 4, 4);
        end.positions.set(unitPositions(packed), 3 * k);
      }
      for (let k = 0; k < end.faces.length; ++k, ++firstTurn) {
        end.faces[k] = turns[4 * firstTurn];
        end.corners.set(turns.subarray(4 * firstTurn + 1, 4 * firstTurn + 4), 3 * k);
      }
      this.ends.push(end);
    }
    this.hidings = array(json.hidings, Uint32Array); // step, face, whether it is hidden
    this.nHidings = 0;
  }

  hasThreeCorners(i) {
    const {faceCorners} = this;
    return faceCorners[i] !== faceCorners[i + 1] && faceCorners[i + 1] !== faceCorners[i + 2] &&
      faceCorners[i + 2] !== faceCorners[i];
  }

  /** Goes through all steps and back, to find out what undoes them. */
  rehearse() {
    const n = this.removed.length;
    this.renamed = new Numbers(6 * n);
    this.firstRenamed = new Uint32Array(n + 1);
    this.before = new Float32Array(3 * n);
    this.first = new Uint32Array(this.nVertices);
    this.next = new Uint32Array(this.faceCorners.length);
    this.listCorners();
    while (this.step < this.nSteps) {
      if (this.isEndNext()) {
        this.endPass(true);
      } else {
        this.findRenamed();
        this.contract();
      }
    }
    this.renamed = this.renamed.array;
    this.first = this.next = null;
    this.goTo(0);
  }

  /** The corners at each vertex. */
  listCorners() {
    this.first.fill(none);
    for (let c = 0; c < this.faceCorners.length; ++c) {
      if (this.hasThreeCorners(c - c % 3)) this.listCorner(this.faceCorners[c], c);
    }
  }

  listCorner(vertex, corner) {
    this.next[corner] = this.first[vertex];
    this.first[vertex] = corner;
  }

  findRenamed() {
    const i = this.nContractions;
    const removed = this.removed[i];
    const survivor = this.survivor[i];
    this.before.set(this.positions.subarray(3 * survivor, 3 * survivor + 3), 3 * i);
    this.firstRenamed[i] = this.renamed.length;
    let corner = this.first[removed];
    this.first[removed] = none;
    while (corner !== none) {
      const next = this.next[corner];
      if (this.hasThreeCorners(corner - corner % 3)) {
        this.renamed.push(corner);
        this.listCorner(survivor, corner);
      }
      corner = next;
    }
    this.firstRenamed[i + 1] = this.renamed.length;
  }

  isEndNext() {
    return this.nEnds < this.ends.length && this.ends[this.nEnds].nContractions === this.nContractions;
  }

  isEndLast() {
    return this.nEnds > 0 && this.ends[this.nEnds - 1].nContractions === this.nContractions;
  }

  rename(i, vertex) {
    const renamed = this.renamed.array ?? this.renamed;
    for (let k = this.firstRenamed[i]; k < this.firstRenamed[i + 1]; ++k) this.faceCorners[renamed[k]] = vertex;
  }

  contract() {
    const i = this.nContractions;
    this.rename(i, this.survivor[i]);
    this.positions.set(this.after.subarray(3 * i, 3 * i + 3), 3 * this.survivor[i]);
    this.hide();
    ++this.nContractions;
    ++this.step;
  }

  undoContraction() {
    const i = --this.nContractions;
    --this.step;
    this.undoHiding();
    this.positions.set(this.before.subarray(3 * i, 3 * i + 3), 3 * this.survivor[i]);
    this.rename(i, this.removed[i]);
  }

  /** Exchanges what a pass of polish has with what there is. */
  exchange(end) {
    for (let k = 0; k < end.vertices.length; ++k) {
      for (let d = 0; d < 3; ++d) {
        const v = 3 * end.vertices[k] + d;
        const position = this.positions[v];
        this.positions[v] = end.positions[3 * k + d];
        end.positions[3 * k + d] = position;
      }
    }
    for (let k = 0; k < end.faces.length; ++k) {
      for (let d = 0; d < 3; ++d) {
        const c = 3 * end.faces[k] + d;
        const vertex = this.faceCorners[c];
        this.faceCorners[c] = end.corners[3 * k + d];
        end.corners[3 * k + d] = vertex;
      }
    }
  }

  endPass(isFirstTime = false) {
    const end = this.ends[this.nEnds++];
    this.hide();
    this.exchange(end);
    ++this.step;
    if (isFirstTime && end.faces.length > 0) this.listCorners();
  }

  undoEnd() {
    --this.step;
    this.exchange(this.ends[--this.nEnds]);
    this.undoHiding();
  }

  hide() {
    for (; 3 * this.nHidings < this.hidings.length && this.hidings[3 * this.nHidings] === this.step; ++this.nHidings) {
      this.isHidden[this.hidings[3 * this.nHidings + 1]] = this.hidings[3 * this.nHidings + 2];
    }
  }

  undoHiding() {
    for (; this.nHidings > 0 && this.hidings[3 * this.nHidings - 3] === this.step; --this.nHidings) {
      this.isHidden[this.hidings[3 * this.nHidings - 2]] = 1 - this.hidings[3 * this.nHidings - 1];
    }
  }

  goTo(step) {
    while (this.step < step) this.isEndNext() ? this.endPass() : this.contract();
    while (this.step > step) this.isEndLast() ? this.undoEnd() : this.undoContraction();
  }

  /** The corners of the faces that are there, in `corners`; there are `nFaces`. */
  listFaces() {
    const {faceCorners, corners, isHidden} = this;
    let n = 0;
    for (let i = 0, f = 0; i < faceCorners.length; i += 3, ++f) {
      const a = faceCorners[i];
      const b = faceCorners[i + 1];
      const c = faceCorners[i + 2];
      if (isHidden[f] || a === b || b === c || c === a) continue;
      corners[n++] = a;
      corners[n++] = b;
      corners[n++] = c;
    }
    this.nFaces = n / 3;
    ++this.version;
  }

  /** The level after so many contractions, passes of polish right after them included. */
  stepAfter(nContractions) {
    let nEnds = 0;
    while (nEnds < this.ends.length && this.ends[nEnds].nContractions <= nContractions) ++nEnds;
    return nContractions + nEnds;
  }

  /** \param share of the contractions, 0 … 1 */
  stepAt(share) {
    return this.stepAfter(Math.round(Math.min(1, Math.max(0, share)) * this.removed.length));
  }

  /** The first level of so few faces, or the last one. */
  stepOfFaces(nFaces) {
    let low = 0;
    let high = this.removed.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.facesAfter[middle] > nFaces) low = middle + 1; else high = middle;
    }
    return this.stepAfter(low);
  }

  /** Whether vertices can move from one level to the other: polish between them flips no edge. */
  isMovement(from, to) {
    for (let i = 0; i < this.ends.length; ++i) {
      const step = this.ends[i].nContractions + i;
      if (step >= from && step < to && this.ends[i].faces.length > 0) return false;
    }
    return true;
  }

  /** Where the vertices of a level are, and where those are that they go into at a later one. */
  movement(from, to) {
    this.goTo(to);
    const into = new Uint32Array(this.nVertices);
    for (let v = 0; v < into.length; ++v) into[v] = v;
    const end = this.nContractions;
    const last = this.positions.slice();
    this.goTo(from);
    for (let i = end; i-- > this.nContractions;) into[this.removed[i]] = into[this.survivor[i]];
    const goal = new Float32Array(last.length);
    for (let v = 0; v < into.length; ++v) goal.set(last.subarray(3 * into[v], 3 * into[v] + 3), 3 * v);
    return {from, to, start: this.positions.slice(), goal};
  }

  /** The mean and greatest error at a number of faces, between those that are known, on logarithmic scales. */
  errorAt(nFaces) {
    const levels = this.levels;
    if (levels.length === 0) return null;
    const i = levels.findIndex((level) => level.faces <= nFaces);
    if (i < 0) return levels[levels.length - 1];
    if (i === 0 || levels[i].faces === nFaces) return levels[i];
    const [a, b] = [levels[i - 1], levels[i]];
    const t = Math.log(a.faces / nFaces) / Math.log(a.faces / b.faces);
    const between = (x, y) => x > 0 && y > 0 ? x ** (1 - t) * y ** t : x + t * (y - x);
    return {faces: nFaces, mean: between(a.mean, b.mean), max: between(a.max, b.max)};
  }
}
