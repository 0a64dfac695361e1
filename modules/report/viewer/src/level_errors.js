// How far the vertices of a recording's level are from the original, for colours while it plays.

const budget = 10; // milliseconds at once
const nBetweenLooks = 32; // measured vertices until it looks at the clock

export class LevelErrors {
  /** \param scale `max` and `usual`, in model units, as in the distances of a surface
      \param tree of the original \param step of the grid, in model units */
  constructor(recording, {max, usual}, tree, step) {
    Object.assign(this, {recording, max, usual, tree, step});
    this.values = new Float32Array(recording.nVertices); // shares of `max`
    this.at = new Float32Array(3 * recording.nVertices).fill(NaN); // where each was measured, 0 … 1
    this.cursor = 0; // the corner to go on with
    this.isReady = false; // the tree is
  }

  /** Measures vertices that have moved, until its time is over. \return whether any were */
  update(positions) {
    if (!this.isReady) return false;
    const {corners, nFaces} = this.recording;
    const n = 3 * nFaces;
    const end = performance.now() + budget;
    let nMeasured = 0;
    for (let i = 0; i < n; ++i) {
      if (this.cursor >= n) this.cursor = 0;
      if (!this.measure(corners[this.cursor++], positions)) continue;
      if (++nMeasured % nBetweenLooks === 0 && performance.now() > end) break;
    }
    return nMeasured > 0;
  }

  /** Measures all, and yields after each part of the work. \pre the tree is ready */
  *finish(positions) {
    this.isReady = true;
    while (this.update(positions)) yield;
  }

  /** \return whether it had to be measured */
  measure(vertex, positions) {
    const {at} = this;
    const i = 3 * vertex;
    const [x, y, z] = [positions[i], positions[i + 1], positions[i + 2]];
    if (at[i] === x && at[i + 1] === y && at[i + 2] === z) return false;
    [at[i], at[i + 1], at[i + 2]] = [x, y, z];
    this.values[vertex] = Math.min(1, this.tree.distanceOfUnit(x, y, z) * this.step / this.max || 0);
    return true;
  }
}
