// The text of the program beside the arm. The line that moves the arm is highlighted, and a mark shows the line that core 1
// reads, which is ahead of the arm. A click on a line shows the moment at which the arm begins it.

// The line of a program that gave this move: its number and its file. Null for any other command.
function programLine(command) {
  const found = /^line (\d+) of (.*)$/.exec(command);
  return found && { line: Number(found[1]), file: found[2] };
}

const lineKey = (file, line) => `${file}:${line}`;

// What the program did when, as { time, end, key } in the order of time: moves of the arm, and lines that core 1 reads.
function programSteps(run) {
  const { moves, program } = run.summary.result;
  const steps = { moved: [], read: [] };
  for (const move of moves) {
    const from = programLine(move.command);
    if (!from) continue;
    const ticks = move.taken_ticks === null ? move.duration_ticks : move.taken_ticks;
    const start = run.timeOfTick(move.start_tick);
    steps.moved.push({ time: start, end: start + ticks * kTickSeconds, key: lineKey(from.file, from.line) });
  }
  for (const { kind, line, file, cycle } of program || []) {
    steps.read.push({ time: cycleTime(cycle), end: Infinity, key: lineKey(file, line), last: kind === 'ended' });
  }
  for (const list of Object.values(steps)) list.sort((one, other) => one.time - other.time);
  return steps;
}

// The last step that has begun; null if there is none, or if it is over.
function stepAt(steps, time) {
  let low = 0;
  let high = steps.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (steps[middle].time <= time) low = middle + 1;
    else high = middle;
  }
  const step = steps[low - 1];
  return step && !step.last && time < step.end ? step : null;
}

class ProgramText {
  constructor(parent, run, timeline) {
    Object.assign(this, { timeline, lines: new Map(), times: new Map(), shown: {} });
    this.steps = programSteps(run);
    for (const { key, time } of [...this.steps.moved, ...this.steps.read]) {
      if (!this.times.has(key)) this.times.set(key, []);
      this.times.get(key).push(time);
    }
    // A line that moves the arm is shown where the arm begins it, not where core 1 reads it.
    const moving = new Map();
    for (const { key, time } of this.steps.moved) moving.set(key, [...(moving.get(key) || []), time]);
    for (const [key, times] of moving) this.times.set(key, times);
    const box = element(parent, 'section', 'program');
    box.id = 'program';
    element(box, 'h3').textContent = 'Program';
    element(box, 'p', 'note').textContent = kProgramNote;
    this.scroller = element(box, 'div', 'text');
    for (const program of run.programs) this.addProgram(program, run.programs.length > 1);
    timeline.listen((change) => change === 'time' && this.show());
    this.show();
  }

  addProgram({ name, text, problem }, named) {
    if (named) element(this.scroller, 'h4').textContent = name;
    if (problem) element(this.scroller, 'p', 'note').textContent = problem;
    if (problem) return;
    const list = element(this.scroller, 'ol');
    text.replace(/\r?\n$/, '').split(/\r?\n/).forEach((words, i) => {
      const key = lineKey(name, i + 1);
      const line = element(list, 'li');
      element(line, 'code').textContent = words;
      this.lines.set(key, line);
      if (!this.times.has(key)) return;
      line.className = 'link';
      line.addEventListener('click', () => this.goTo(key));
    });
  }

  // The next moment at which the line begins, or the first one behind the last.
  goTo(key) {
    const times = this.times.get(key);
    const next = times.find((time) => time > this.timeline.time + kTickSeconds / 2);
    this.timeline.setTime(next === undefined ? times[0] : next);
  }

  show() {
    const moved = stepAt(this.steps.moved, this.timeline.time);
    const read = stepAt(this.steps.read, this.timeline.time);
    this.mark('moves', moved);
    this.mark('reads', read);
    this.scrollTo(this.lines.get((moved || read || {}).key));
  }

  mark(name, step) {
    const line = step ? this.lines.get(step.key) : undefined;
    if (this.shown[name] === line) return;
    if (this.shown[name]) this.shown[name].classList.remove(name);
    if (line) line.classList.add(name);
    this.shown[name] = line;
  }

  // Only the box scrolls, not the page.
  scrollTo(line) {
    if (!line || this.seen === line) return;
    this.seen = line;
    const { scrollTop, clientHeight } = this.scroller;
    if (line.offsetTop < scrollTop || line.offsetTop + line.offsetHeight > scrollTop + clientHeight) {
      this.scroller.scrollTop = line.offsetTop - clientHeight / 3;
    }
  }
}

const kProgramNote = 'Blue: the arm moves. ▸: core 1 reads, ahead of it. A click on a line shows its moment.';
