// The time that all parts of the page show, the part of the run that they show, and playing.

// The page scrolls by the wheel, so a plot zooms by it with Ctrl, as by two fingers on a touchpad.
function zoomByWheel(event, timeline, time) {
  if (!event.ctrlKey) return;
  event.preventDefault();
  timeline.zoom(time, 1.25 ** Math.sign(event.deltaY));
}

class Timeline {
  constructor(begin, end) {
    this.begin = begin;
    this.end = end;
    this.time = begin;
    this.window = [begin, end];
    this.pointed = null;  // the time below the mouse, of which the plots show the values
    this.speed = 1;
    this.listeners = [];
    this.frame = null;
  }

  // `listener(what)` is called after each change; `what` is 'time', 'window' or 'pointed'.
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

  pointAt(time) {
    this.pointed = time;
    this.tell('pointed');
  }

  // Shows a part that is `factor` times as long, with the same time at the same place.
  zoom(time, factor) {
    const [from, to] = this.window;
    this.setWindow(time - (time - from) * factor, time + (to - time) * factor);
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
