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

  /** Lets the vertices of a level move to where the next one has them. */
  goBetween() {
    const {recording} = this;
    const stops = this.nStops / 10;
    const stop = Math.min(stops - 1, Math.floor(this.place * stops));
    const share = this.place * stops - stop;
    const from = this.stepOf(stop / stops);
    const to = this.stepOf((stop + 1) / stops);
    if (share >= 1 || from >= to) return this.goToStep(to);
    if (share <= 0 || !recording.isMovement(from, to)) return this.goToStep(from);
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

  /** One stop on or back, and stands still there. */
  stepBy(n) {
    this.direction = 0;
    this.goTo((Math.round(this.place * this.nStops) + n) / this.nStops);
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
