// Whether the view moves, and whether drawing all of it takes too long then.

const slow = 1000 / 30; // milliseconds a frame
const rest = 200; // milliseconds without a movement

export class Motion {
  /** \param onRest is called when a movement has ended, with whether frames were drawn quickly */
  constructor(onRest) {
    this.onRest = onRest;
    this.isMoving = false;
    this.isSlow = false;
    this.lastFrame = null;
    this.nSlow = 0;
  }

  /** The view moves. */
  goOn() {
    this.isMoving = true;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.end(), rest);
  }

  end() {
    if (!this.isMoving) return;
    clearTimeout(this.timer);
    this.isMoving = false;
    this.lastFrame = null;
    this.onRest(this.isSlow);
  }

  /** \return whether the frame is to be drawn quickly */
  beginFrame() {
    if (!this.isMoving) return false;
    const now = performance.now();
    if (this.lastFrame !== null) {
      this.nSlow = now - this.lastFrame > slow ? this.nSlow + 1 : 0;
      if (this.nSlow >= 1) this.isSlow = true;
    }
    this.lastFrame = now;
    return this.isSlow;
  }
}
