// Goes through a recording.

const fastest = 64;

/** Where the slider is, 0 … 1, is the place in the recording. */
export class Player {
  /** \param show is called with the recording and the positions of this moment */
  constructor(recording, show) {
    this.recording = recording;
    this.show = show;
    this.place = 1;
    this.speed = 1; // the whole recording takes 10 s
    this.direction = 0; // 1, −1, or 0: it stands still
    this.isContinuous = false;
    this.isByFaces = false;
    this.nStops = 1000;
    this.movement = null;
    this.lastStepMs = 0;
  }

  /** The level at a place. */
  stepOf(place) {
    const {recording} = this;
    if (!this.isByFaces) return recording.stepAt(place);
    const {facesAfter} = recording;
    const first = facesAfter[0];
    const last = Math.max(1, facesAfter[facesAfter.length - 1]);
    if (place <= 0) return recording.stepAfter(0);
    if (place >= 1) return recording.nSteps;
    return recording.stepOfFaces(Math.round(first * (last / first) ** place));
  }

  goTo(place) {
    const begin = performance.now();
    this.place = Math.min(1, Math.max(0, place));
    if (this.isContinuous) this.goBetween(); else this.goToStep(this.stepOf(this.place));
    this.lastStepMs = performance.now() - begin;
  }

  goToStep(step) {
    const {recording} = this;
    if (step !== recording.step || this.shownStep !== step) {
      recording.goTo(step);
      recording.listFaces();
    }
    this.shownStep = step;
    this.movement = null;
    this.show(recording.positions);
  }

  /** Where the slider is at a number of contractions. */
  placeOf(nContractions) {
    const {facesAfter, removed} = this.recording;
    if (!this.isByFaces) return removed.length > 0 ? nContractions / removed.length : 1;
    const first = facesAfter[0];
    const last = Math.max(1, facesAfter[facesAfter.length - 1]);
    return first > last ? Math.log(Math.max(last, facesAfter[nContractions]) / first) / Math.log(last / first) : 1;
  }

  /** Stands still at the first level with at most so many faces. */
  goToFaces(nFaces) {
    const {recording} = this;
    this.stopAt(this.placeOf(recording.contractionsOfFaces(nFaces)));
  }

  /** The level at a place; between two levels, where vertices move from one to the other, a number between theirs. */
  levelAt(place) {
    if (!this.isContinuous) return this.stepOf(place);
    const {from, to, share} = this.between(place);
    return from + share * (to - from);
  }

  /** Two levels, and the share of the way between them that has been gone at a place. */
  between(place) {
    const stops = this.nStops / 10;
    const stop = Math.min(stops - 1, Math.floor(place * stops));
    const share = place * stops - stop;
    const from = this.stepOf(stop / stops);
    const to = this.stepOf((stop + 1) / stops);
    const isThere = share >= 1 || from >= to;
    return {from, to, share: isThere ? 1 : this.recording.isMovement(from, to) ? share : 0};
  }

  /** Lets the vertices of a level move to where the next one has them. */
  goBetween() {
    const {recording} = this;
    const {from, to, share} = this.between(this.place);
    if (share >= 1) return this.goToStep(to);
    if (share <= 0) return this.goToStep(from);
    if (this.movement?.from !== from || this.movement?.to !== to) {
      this.movement = recording.movement(from, to);
      recording.listFaces();
      this.shownStep = from;
      this.positions = new Float32Array(recording.positions.length);
    }
    const {start, goal} = this.movement;
    for (let i = 0; i < start.length; ++i) this.positions[i] = start[i] + share * (goal[i] - start[i]);
    this.show(this.positions);
  }

  /** Stands still at a place. */
  stopAt(place) {
    this.direction = 0;
    this.goTo(place);
  }

  /** Stands still at the next stop on or back where there is something else to see. \param n 1 or −1 */
  stepBy(n) {
    const shown = this.levelAt(this.place);
    let stop = Math.round(this.place * this.nStops) + n;
    while (stop > 0 && stop < this.nStops && this.levelAt(stop / this.nStops) === shown) stop += n;
    this.stopAt(stop / this.nStops);
  }

  setSpeed(speed) {
    this.speed = Math.min(fastest, Math.max(1 / fastest, speed));
  }

  isFastest() {
    return this.speed >= fastest;
  }

  isSlowest() {
    return this.speed <= 1 / fastest;
  }

  /** Whether it has come to where it can't go on in a direction. */
  isAtEnd(direction) {
    return direction > 0 ? this.place >= 1 : this.place <= 0;
  }

  /** \param seconds since the last moment \return whether it goes on */
  advance(seconds) {
    if (this.direction === 0) return false;
    this.goTo(this.place + this.direction * this.speed * seconds / 10);
    if (this.isAtEnd(this.direction)) this.direction = 0;
    return this.direction !== 0;
  }

  /** Plays, or stands still if it plays in this direction. From the end it starts over. */
  play(direction) {
    this.direction = this.direction === direction ? 0 : direction;
    if (this.direction !== 0 && this.isAtEnd(direction)) this.place = direction > 0 ? 0 : 1;
  }
}
