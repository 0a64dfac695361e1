// Whether the view moves, and how much of it can be drawn in time then.

const slow = 1000 / 30; // milliseconds a frame
const nSlowFrames = 3; // of a roughness, after which it is not enough
const rest = 200; // milliseconds without a movement

/** How roughly a moving view is drawn: 0 as it rests; 1 with fewer faces, and a pixel for each of the screen; 2 with fewer
    pixels, too. */
const roughest = 2;

export class Motion {
  /** \param onRest is called when a movement has ended, with whether frames were drawn roughly */
  constructor(onRest) {
    this.onRest = onRest;
    this.isMoving = false;
    this.roughness = 0; // that is needed here
    this.lastFrame = null;
    this.nSlow = 0;
  }

  /** It is known, before anything moves, that all of it can't be drawn in time. */
  expectSlow() {
    this.roughness = roughest; // each change makes the picture anew, which takes several frames
  }

  /** The view moves. */
  goOn() {
    this.isMoving = true;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.end(), rest);
  }

  stop() {
    clearTimeout(this.timer);
    this.isMoving = false;
  }

  end() {
    if (!this.isMoving) return;
    this.stop();
    this.lastFrame = null;
    this.onRest(this.roughness > 0);
  }

  /** \return how roughly the frame is to be drawn */
  beginFrame() {
    if (!this.isMoving) return 0;
    const now = performance.now();
    if (this.lastFrame !== null) {
      this.nSlow = now - this.lastFrame > slow ? this.nSlow + 1 : 0;
      if (this.nSlow >= (this.roughness === 0 ? 1 : nSlowFrames)) {
        this.roughness = Math.min(roughest, this.roughness + 1);
        this.nSlow = 0;
      }
    }
    this.lastFrame = now;
    return this.roughness;
  }
}
