// What happened when: a lane for each kind of event, above the plots and with their time scale.

const cycleTime = (cycle) => cycle * kCycleSeconds;

function stateItems(run) {
  return run.states.map(({ row, state }, i) => ({
    from: run.time[row],
    to: i + 1 < run.states.length ? run.time[run.states[i + 1].row] : run.end,
    label: state,
    color: kStateColors[state] || '#d0d7de',
  }));
}

function moveItems(run) {
  const { faults } = run.summary.result;
  const moves = run.summary.result.moves.map((move) => {
    const ticks = move.taken_ticks === null ? move.duration_ticks : move.taken_ticks;
    const fault = move.taken_ticks === null && faults.find(({ tick }) => tick >= move.start_tick);
    const planned = run.timeOfTick(move.start_tick + ticks);
    return {
      from: run.timeOfTick(move.start_tick),
      to: fault ? Math.min(planned, cycleTime(fault.cycle)) : planned,
      label: `${commandName(move)}: ${move.kind}`,
      color: move.taken_ticks === null ? '#ffb77c' : '#7ee0a3',
      detail: `${move.command} ${move.kind}, ${ticks} ticks` + (move.taken_ticks === null ? ', not finished' : ''),
    };
  });
  const refused = run.summary.result.refused_moves.map((move) => ({
    from: cycleTime(move.cycle), label: 'refused', color: '#ff8182', detail: `${move.command}: ${move.text}`,
  }));
  return [...moves, ...refused];
}

// A move of the scenario by its index, as short as a lane needs it.
const commandName = (move) => (move.move === null ? move.command : move.move);

const kNoteColors = {
  line: '#afb8c1', message: '#0969da', alarm: '#cf222e', stopped: '#cf222e', paused: '#d4a72c', held: '#d4a72c', resumed: '#afb8c1',
  aborted: '#cf222e', ended: '#1a7f37',
};

function programItems(run) {
  return (run.summary.result.program || []).map(({ kind, line, file, text, cycle }) => ({
    from: cycleTime(cycle),
    label: kind === 'line' ? `${line}${text ? `: ${text}` : ''}` : text || kind,
    color: kNoteColors[kind],
    detail: `line ${line} of ${file}${kind === 'line' ? '' : ` ${kind}`}${text ? `: ${text}` : ''}`,
  }));
}

function faultItems(run) {
  const { result } = run.summary;
  const injected = result.injected_faults.map((fault) => ({
    from: cycleTime(fault.cycle),
    to: fault.released_cycle ? cycleTime(fault.released_cycle) : undefined,
    label: `injected: ${fault.kind}`, color: '#d4a72c', detail: fault.text,
  }));
  const seen = result.faults.map((fault) => ({
    from: cycleTime(fault.cycle), label: `fault: ${fault.cause}`, color: '#cf222e',
    detail: `fault ${fault.cause}${fault.axis ? `, axis ${fault.axis}` : ''}, tick ${fault.tick}, because of ${fault.because_of}`,
  }));
  return [...injected, ...seen];
}

function pinItems(run) {
  const { result } = run.summary;
  const items = (changes, name, color) =>
    (changes || []).map(({ pin, level, cycle }) => ({
      from: cycleTime(cycle), label: `${name} ${pin} = ${level}`, color, detail: `${name} ${pin} becomes ${level}`,
    }));
  return [...items(result.outputs, 'output', '#8250df'), ...items(result.inputs, 'input', '#1a7f37')];
}

function serialItems(run) {
  return run.serial.map(({ time, direction, text, error }) => ({
    from: time, label: text, color: error ? '#cf222e' : direction === 'rx' ? '#0969da' : '#bc4c00',
    detail: `${direction === 'rx' ? 'to' : 'from'} the controller: ${text}${error ? `, ${error}` : ''}`,
  }));
}

class Lanes {
  constructor(parent, run, timeline) {
    Object.assign(this, { run, timeline });
    this.lanes = [
      ['State', stateItems(run)], ['Program', programItems(run)], ['Moves', moveItems(run)],
      ['Faults', faultItems(run)], ['Pins', pinItems(run)], ['Serial', serialItems(run)],
    ].filter(([, items]) => items.length > 0);
    for (const [, items] of this.lanes) items.sort((one, other) => one.from - other.from);
    this.box = element(parent, 'section', 'lanes');
    this.box.id = 'lanes';
    this.canvas = element(this.box, 'canvas');
    this.canvas.style.height = `${this.lanes.length * kLaneHeight + kLaneFoot}px`;
    this.cursor = element(this.box, 'div', 'cursor');
    this.tip = element(this.box, 'div', 'tip');
    this.tip.hidden = true;
    this.canvas.addEventListener('mousemove', (event) => this.showTip(event));
    this.canvas.addEventListener('mouseleave', () => (this.tip.hidden = true));
    this.canvas.addEventListener('click', (event) => timeline.setTime(this.timeAt(event.offsetX)));
    this.canvas.addEventListener('wheel', (event) => zoomByWheel(event, timeline, this.timeAt(event.offsetX)));
    timeline.listen((change) => (change === 'window' ? this.draw() : this.placeCursor()));
    new ResizeObserver(() => this.draw()).observe(this.box);
    this.draw();
  }

  get width() {
    return this.canvas.clientWidth - kPlotLeft - kPlotRight;
  }

  pixel(time) {
    const [from, to] = this.timeline.window;
    return kPlotLeft + ((time - from) / (to - from)) * this.width;
  }

  timeAt(pixel) {
    const [from, to] = this.timeline.window;
    return from + ((pixel - kPlotLeft) / this.width) * (to - from);
  }

  draw() {
    const ratio = window.devicePixelRatio || 1;
    const { clientWidth, clientHeight } = this.canvas;
    this.canvas.width = clientWidth * ratio;
    this.canvas.height = clientHeight * ratio;
    const canvas = this.canvas.getContext('2d');
    canvas.scale(ratio, ratio);
    canvas.font = '11px sans-serif';
    canvas.textBaseline = 'middle';
    this.drawn = [];
    this.textColor = pageColor('--text');
    this.lanes.forEach(([name, items], lane) => {
      const y = lane * kLaneHeight;
      canvas.fillStyle = pageColor(lane % 2 ? '--ground' : '--box');
      canvas.fillRect(kPlotLeft, y, this.width, kLaneHeight);
      canvas.fillStyle = this.textColor;
      canvas.textAlign = 'right';
      canvas.fillText(name, kPlotLeft - 8, y + kLaneHeight / 2);
      canvas.save();
      canvas.beginPath();
      canvas.rect(kPlotLeft, y, this.width, kLaneHeight);
      canvas.clip();
      const shown = this.shownItems(items);
      const begins = shown.map((item) => this.pixel(item.from));
      this.barEnd = 0;
      shown.forEach((item, i) => this.drawItem(canvas, item, y, begins[i + 1] || Infinity));
      canvas.restore();
    });
    this.placeCursor();
  }

  shownItems(items) {
    const [from, to] = this.timeline.window;
    return items.filter((item) => item.from <= to && (item.to === undefined ? item.from : item.to) >= from);
  }

  // A label ends before `next`, where the next item begins.
  drawItem(canvas, item, y, next) {
    const left = this.pixel(item.from);
    const right = item.to === undefined ? left + 3 : Math.max(this.pixel(item.to), left + 2);
    canvas.fillStyle = item.color;
    canvas.fillRect(left, y + 3, right - left - 1, kLaneHeight - 6);
    const textWidth = canvas.measureText(item.label).width;
    const begin = Math.max(left, kPlotLeft);
    canvas.textAlign = 'left';
    const isMoment = item.to === undefined;
    if (!isMoment) this.barEnd = Math.max(this.barEnd, right);
    canvas.fillStyle = this.barEnd > left ? kBarTextColor : this.textColor;
    const [place, end] = isMoment ? [left + 6, next - 2] : [begin + 4, Math.min(right, next) - 4];
    const labelled = place + textWidth < end;
    if (labelled) canvas.fillText(item.label, place, y + kLaneHeight / 2);
    const margin = isMoment ? 3 : 0;
    this.drawn.push({ item, y, left: left - margin, right: right + margin, labelled });
  }

  showTip(event) {
    const { offsetX, offsetY } = event;
    const found = this.drawn.filter(
      ({ y, left, right }) => offsetY >= y && offsetY < y + kLaneHeight && offsetX >= left && offsetX <= right,
    );
    this.tip.hidden = found.length === 0;
    if (this.tip.hidden) return;
    const { item } = found[found.length - 1];
    const end = item.to === undefined ? '' : ` – ${secondsText(item.to)}`;
    this.tip.textContent = `${secondsText(item.from)}${end}: ${item.detail || item.label}`;
    this.tip.style.left = `${Math.min(offsetX + 12, this.canvas.clientWidth - 260)}px`;
    this.tip.style.top = `${offsetY + 14}px`;
  }

  placeCursor() {
    const { time } = this.timeline;
    const [from, to] = this.timeline.window;
    this.cursor.hidden = time < from || time > to;
    this.cursor.style.left = `${this.pixel(time)}px`;
  }
}

const kBarTextColor = '#1f2328';  // bars are light, in a dark room too
const kLaneHeight = 24;
const kLaneFoot = 4;
// The edges of a plot: dygraphs' own spaces beside its numbers and at its right.
const kPlotLeft = kPlotMargin + 6;
const kPlotRight = 5;

function secondsText(time) {
  return `${time.toFixed(6)} s`;
}
