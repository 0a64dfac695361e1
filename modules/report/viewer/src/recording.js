// A recorded run that the page plays: levels between the original and the result.
import {unit, unitPositions} from './surface.js';

/** A growing list of numbers. */
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
const nAtOnce = 256; // steps of which it is looked at the clock

/** 0, 1, 2, 3, … stand for 0, −1, 1, −2, … */
const difference = (packed) => packed >>> 1 ^ -(packed & 1);

/** Level k is the surface after k steps. A step is a contraction, or a pass of polish. */
export class Recording {
  constructor(json, array, original) {
    this.nSteps = json.steps;
    this.levels = json.levels; // {faces, mean, max}, measured levels
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
    this.shownPositions = this.positions; // between two levels, others
    this.faceCorners = original.corners.slice();
    this.isHidden = new Uint8Array(original.nFaces);
    this.step = 0;
    this.nContractions = 0;
    this.nEnds = 0;
    this.readSteps(json, array, original.positions);
    this.corners = new Uint32Array(original.corners.length);
  }

  /** Comes before all else, takes long, and yields after each part of the work. */
  *prepare() {
    yield* this.buildIndex();
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
    this.visibility = array(json.visibility, Uint32Array); // step, face, whether it is hidden
    this.nVisibilityChanges = 0;
  }

  hasThreeCorners(i) {
    const {faceCorners} = this;
    return faceCorners[i] !== faceCorners[i + 1] && faceCorners[i + 1] !== faceCorners[i + 2] &&
      faceCorners[i + 2] !== faceCorners[i];
  }

  /** Goes through all steps and back, and fills the undo log. */
  *buildIndex() {
    const n = this.removed.length;
    this.undoCorners = new Numbers(6 * n);
    this.firstUndoCorner = new Uint32Array(n + 1);
    this.undoPositions = new Float32Array(3 * n);
    this.first = new Uint32Array(this.nVertices);
    this.next = new Uint32Array(this.faceCorners.length);
    this.listCorners();
    while (this.step < this.nSteps) {
      if (this.isEndNext()) {
        this.endPass(true);
      } else {
        this.logCorners();
        this.contract();
      }
      if (this.step % nAtOnce === 0) yield;
    }
    this.undoCorners = this.undoCorners.array;
    this.first = this.next = null;
    this.goTo(0);
  }

  /** Lists the corners at each vertex. */
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

  logCorners() {
    const i = this.nContractions;
    const removed = this.removed[i];
    const survivor = this.survivor[i];
    this.undoPositions.set(this.positions.subarray(3 * survivor, 3 * survivor + 3), 3 * i);
    this.firstUndoCorner[i] = this.undoCorners.length;
    let corner = this.first[removed];
    this.first[removed] = none;
    while (corner !== none) {
      const next = this.next[corner];
      if (this.hasThreeCorners(corner - corner % 3)) {
        this.undoCorners.push(corner);
        this.listCorner(survivor, corner);
      }
      corner = next;
    }
    this.firstUndoCorner[i + 1] = this.undoCorners.length;
  }

  isEndNext() {
    return this.nEnds < this.ends.length && this.ends[this.nEnds].nContractions === this.nContractions;
  }

  isEndLast() {
    return this.nEnds > 0 && this.ends[this.nEnds - 1].nContractions === this.nContractions;
  }

  setCorners(i, vertex) {
    const corners = this.undoCorners.array ?? this.undoCorners;
    for (let k = this.firstUndoCorner[i]; k < this.firstUndoCorner[i + 1]; ++k) this.faceCorners[corners[k]] = vertex;
  }

  contract() {
    const i = this.nContractions;
    this.setCorners(i, this.survivor[i]);
    this.positions.set(this.after.subarray(3 * i, 3 * i + 3), 3 * this.survivor[i]);
    this.applyVisibility();
    ++this.nContractions;
    ++this.step;
  }

  undoContraction() {
    const i = --this.nContractions;
    --this.step;
    this.undoVisibility();
    this.positions.set(this.undoPositions.subarray(3 * i, 3 * i + 3), 3 * this.survivor[i]);
    this.setCorners(i, this.removed[i]);
  }

  /** Swaps the positions and corners of a pass of polish with the current ones. */
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
    this.applyVisibility();
    this.exchange(end);
    ++this.step;
    if (isFirstTime && end.faces.length > 0) this.listCorners();
  }

  undoEnd() {
    --this.step;
    this.exchange(this.ends[--this.nEnds]);
    this.undoVisibility();
  }

  applyVisibility() {
    const {visibility} = this; // step, face, whether it is hidden
    for (let i = 3 * this.nVisibilityChanges; i < visibility.length && visibility[i] === this.step; i += 3) {
      this.isHidden[visibility[i + 1]] = visibility[i + 2];
      ++this.nVisibilityChanges;
    }
  }

  undoVisibility() {
    const {visibility} = this;
    for (let i = 3 * this.nVisibilityChanges - 3; i >= 0 && visibility[i] === this.step; i -= 3) {
      this.isHidden[visibility[i + 1]] = 1 - visibility[i + 2];
      --this.nVisibilityChanges;
    }
  }

  /** What is shown, for a FaceTree: four numbers a vertex, in steps of the grid. */
  onGrid() {
    const positions = new Float32Array(4 * this.nVertices);
    for (let v = 0; v < this.nVertices; ++v) {
      for (let d = 0; d < 3; ++d) positions[4 * v + d] = unit * this.shownPositions[3 * v + d];
    }
    return {positions, corners: this.corners, nFaces: this.nFaces};
  }

  goTo(step) {
    while (this.step < step) this.isEndNext() ? this.endPass() : this.contract();
    while (this.step > step) this.isEndLast() ? this.undoEnd() : this.undoContraction();
  }

  *goToEnd() {
    while (this.step < this.nSteps) {
      this.goTo(Math.min(this.nSteps, this.step + nAtOnce));
      yield;
    }
  }

  /** Fills `corners` and `nFaces` with the visible faces. */
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

  /** The level after nContractions contractions, and after a pass of polish that follows them. */
  stepAfter(nContractions) {
    let nEnds = 0;
    while (nEnds < this.ends.length && this.ends[nEnds].nContractions <= nContractions) ++nEnds;
    return nContractions + nEnds;
  }

  /** \param share of the contractions, 0 … 1 */
  stepAt(share) {
    return this.stepAfter(Math.round(Math.min(1, Math.max(0, share)) * this.removed.length));
  }

  /** The first level with at most nFaces faces, or the last one. */
  stepOfFaces(nFaces) {
    return this.stepAfter(this.contractionsOfFaces(nFaces));
  }

  /** The contractions up to it. */
  contractionsOfFaces(nFaces) {
    let low = 0;
    let high = this.removed.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.facesAfter[middle] > nFaces) low = middle + 1; else high = middle;
    }
    return low;
  }

  /** Whether vertices can move from one level to the other: polish between them flips no edge. */
  isMovement(from, to) {
    for (let i = 0; i < this.ends.length; ++i) {
      const step = this.ends[i].nContractions + i;
      if (step >= from && step < to && this.ends[i].faces.length > 0) return false;
    }
    return true;
  }

  /** The positions of a level's vertices, and the positions of their survivors at a later level. */
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

  /** The contractions up to the level with the fewest faces whose largest error is at most `limit`, by `errorAt`; null if
      all measured levels are farther. */
  contractionsWithin(limit) {
    const {levels, facesAfter} = this;
    const i = levels.findLastIndex(({max}) => max <= limit);
    if (i < 0) return null;
    let enough = this.contractionsOfFaces(levels[i].faces);
    let tooMany = i + 1 < levels.length ? this.contractionsOfFaces(levels[i + 1].faces) : enough + 1;
    while (tooMany - enough > 1) {
      const middle = enough + tooMany >> 1;
      if (this.errorAt(facesAfter[middle]).max <= limit) enough = middle; else tooMany = middle;
    }
    return enough;
  }

  /** The mean and largest error at a number of faces, interpolated between measured levels on logarithmic scales. */
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
