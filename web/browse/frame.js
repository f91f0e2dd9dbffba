// Draws what has changed, once per frame of the screen.

const pause = 120; // milliseconds

export class Frame {
  constructor() {
    /** @type {Set<() => boolean | void>} */
    this.waiting_ = new Set();
    this.asked_ = false;
    this.later_ = new Set();
  }

  /** Calls `draw` soon, a few times a second at most: for what is costly and may follow a drag late. */
  later(draw) {
    if (this.later_.has(draw)) return;
    this.later_.add(draw);
    setTimeout(() => {
      this.later_.delete(draw);
      this.request(draw);
    }, pause);
  }

  /** Calls `draw` in the next frame, and again as long as it returns true. */
  request(draw) {
    this.waiting_.add(draw);
    if (this.asked_) return;
    this.asked_ = true;
    requestAnimationFrame(() => this.run_());
  }

  run_() {
    this.asked_ = false;
    const now = [...this.waiting_];
    this.waiting_.clear();
    for (const draw of now) {
      if (draw() === true) this.request(draw);
    }
  }
}
