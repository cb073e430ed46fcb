// The time that all parts of the page show, the part of the run that they show, and playing.
class Timeline {
  constructor(begin, end) {
    this.begin = begin;
    this.end = end;
    this.time = begin;
    this.window = [begin, end];
    this.speed = 1;
    this.listeners = [];
    this.frame = null;
  }

  // `listener(what)` is called after each change; `what` is 'time' or 'window'.
  listen(listener) {
    this.listeners.push(listener);
  }

  tell(what) {
    for (const listener of this.listeners) listener(what);
  }

  setTime(time) {
    this.time = Math.min(Math.max(time, this.begin), this.end);
    this.tell('time');
  }

  setWindow(from, to) {
    const window = [Math.max(from, this.begin), Math.min(to, this.end)];
    if (!(window[1] > window[0])) return;
    if (window[0] === this.window[0] && window[1] === this.window[1]) return;
    this.window = window;
    this.tell('window');
  }

  showAll() {
    this.setWindow(this.begin, this.end);
  }

  get playing() {
    return this.frame !== null;
  }

  // Plays the shown part at `speed` times the simulated time, from its beginning if the time is at its end.
  play() {
    if (this.playing) return;
    if (this.time >= this.window[1] || this.time < this.window[0]) this.setTime(this.window[0]);
    let before = null;
    const step = (now) => {
      this.frame = requestAnimationFrame(step);
      const passed = before === null ? 0 : ((now - before) / 1000) * this.speed;
      before = now;
      const next = this.time + passed;
      if (next >= this.window[1]) this.stop();
      this.setTime(Math.min(next, this.window[1]));
    };
    this.frame = requestAnimationFrame(step);
    this.tell('time');
  }

  stop() {
    if (!this.playing) return;
    cancelAnimationFrame(this.frame);
    this.frame = null;
    this.tell('time');
  }
}
