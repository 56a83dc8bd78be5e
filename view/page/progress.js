// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures become better while nothing changes: small while the scene turns, then whole, then with more samples.

const sampleSteps = [1, 2, 4]; // per pixel and axis
const restAfter = 120;         // milliseconds without a movement
const goodTime = 90, wasteTime = 35; // milliseconds of a frame in movement

class Progression {
  /** `request(size, samples, moving)` is what to ask for, `show(frame, moving)` what to do with it. */
  constructor({ size, request, show, fail }) {
    Object.assign(this, { size, request, show, fail, version: 0, step: 0, part: 4, looping: false });
  }

  /** Something has changed, and may go on to change. */
  change(moving = false) {
    this.version++;
    this.step = moving ? -1 : 0;
    if (this.running && this.running.step >= 0) this.running.abort.abort();
    this.loop();
  }

  async loop() {
    if (this.looping) return;
    this.looping = true;
    while (this.step < sampleSteps.length) {
      try {
        await this.draw();
      } catch (error) {
        if (error.replaced) continue;
        this.fail(error);
        break;
      }
    }
    this.looping = false;
  }

  async draw() {
    const { version, step } = this, moving = step < 0;
    this.running = { step, abort: new AbortController() };
    const begun = performance.now();
    const size = this.size().map((side) => Math.max(1, Math.round(moving ? side / this.part : side)));
    const request = this.request(size, moving ? 1 : sampleSteps[step], moving);
    const frame = await askFrame(request, this.running.abort.signal);
    this.running = null;
    if (!moving && version !== this.version) return;
    if (moving) this.adapt(performance.now() - begun);
    this.show(frame, moving);
    if (moving && version === this.version) await new Promise((done) => setTimeout(done, restAfter));
    if (version === this.version) this.step = step + 1;
  }

  /** As many pixels as a fluent movement allows. */
  adapt(milliseconds) {
    this.milliseconds = milliseconds;
    if (milliseconds > goodTime && this.part < 8) this.part *= 2;
    else if (milliseconds < wasteTime && this.part > 1) this.part /= 2;
  }
}
