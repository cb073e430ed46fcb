// Curves over time, drawn by dygraphs. All plots show the same part of the run and the same time.

// What a plot shows: a unit, a function that returns a curve for each joint or one curve, and optionally a second kind
// of curves (dashed), limits of each joint, how far rounding may move a value, whether a step of the set-points is
// left out, and a note above the curves. The rows of another run (`dotted`, and the curves of a plot with `ofOther`) are joined across the rows that it does not have.
function plotList(run) {
  const limits = (low, high) => (run.axes ? run.axes.map((axis) => [low(axis), high(axis)]) : null);
  const both = (key) => limits((axis) => (axis[key] === null ? null : -axis[key]), (axis) => axis[key]);
  const list = [
    {
      id: 'position', title: 'Position', unit: 'deg', curves: run.reference, dashed: run.encoder,
      dotted: run.other && run.other.encoder, limits: limits((axis) => axis.min_deg, (axis) => axis.max_deg),
    },
    { id: 'speed', title: 'Speed', unit: 'deg/s', curves: run.speed, limits: both('max_speed_deg_s'), steps: true },
    {
      id: 'acceleration', title: 'Acceleration', unit: 'deg/s²', curves: run.acceleration,
      limits: both('max_accel_deg_s2'), rounding: run.accelerationRounding, steps: true,
    },
    { id: 'jerk', title: 'Jerk', unit: 'deg/s³', curves: run.jerk, limits: null, steps: true },
    {
      id: 'following', title: 'Following error', unit: 'deg', curves: run.following,
      limits: both('following_error_deg'),
    },
    { id: 'pulses', title: 'Pulses per tick', unit: 'pulses', curves: run.pulsesPerTick, limits: null },
  ];
  if (run.tool) list.push(...toolPlots(run));
  if (run.load) {
    const names = ['core 0', 'core 1'];
    // Core 0 must sleep when the tick ends: it is woken a cycle after the trigger. Core 1 may compute all the time.
    const budget = [[0, run.summary.result.tick_cycles - 1.5], [null, null]];
    list.push({
      id: 'budget', title: 'Computing in a tick', unit: 'cycles', curves: run.load.awake, names, limits: budget,
    });
    list.push({ id: 'bus', title: 'Bus use in a tick', unit: 'cycles', curves: run.load.bus, names, limits: null });
  }
  const error = pathErrors(run);
  if (error) {
    list.push({
      id: 'path-error', title: 'Path error', unit: 'mm', curves: [error.encoder], dashed: [error.reference],
      names: ['encoders'], limits: null, note: pathErrorNote(error),
    });
  }
  if (run.other && run.other.first) {
    list.push({
      id: 'deviation', title: `Deviation from ${run.other.name}`, unit: 'counts', curves: run.other.deviation,
      ofOther: true, limits: null,
    });
  }
  return list;
}

function toolPlots(run) {
  return [
    {
      id: 'tool', title: 'Tool', unit: 'mm', curves: run.tool.reference, dashed: run.tool.encoder,
      names: ['x', 'y', 'z'], limits: null,
    },
    {
      id: 'tool-speed', title: 'Tool speed', unit: 'mm/s', curves: [run.toolSpeed], names: ['set-points'],
      limits: null, steps: true,
    },
  ];
}

class Plot {
  constructor(parent, what, run, timeline, selection) {
    Object.assign(this, { what, run, timeline, selection });
    this.box = element(parent, 'section', 'plot');
    this.box.id = `plot-${what.id}`;
    const head = element(this.box, 'header');
    element(head, 'h3').textContent = `${what.title} [${what.unit}]`;
    this.readout = element(head, 'div', 'readout');
    const notes = [what.note, what.steps && run.steps.length > 0 && kStepNote].filter(Boolean);
    if (notes.length > 0) element(this.box, 'p', 'note').textContent = notes.join(' ');
    this.area = element(this.box, 'div', 'area');
    this.series = [];
    this.styles = {};
    this.names = [];
    this.add(what.curves, '', what.ofOther ? kJoined : {});
    if (what.dashed) this.add(what.dashed, ' enc', { strokePattern: [4, 3], strokeWidth: 1 });
    if (what.dotted) this.add(what.dotted, ' other', { ...kJoined, ...kDotted });
    this.graph = new Dygraph(this.area, this.rows(), this.options());
    this.cursor = element(this.area, 'div', 'cursor');
    this.selection.listen(() => this.show());
    timeline.listen((change) => (change === 'window' ? this.show() : this.placeCursor()));
    this.area.addEventListener('wheel', (event) => zoomByWheel(event, timeline, this.graph.toDataXCoord(event.offsetX)));
    this.show();
  }

  add(curves, suffix, style) {
    curves.forEach((values, joint) => {
      const name = this.nameOf(joint) + suffix;
      this.series.push({ values, joint, joined: style.connectSeparatedPoints });
      this.names.push(name);
      this.styles[name] = { color: kJointColors[joint], strokeWidth: 1.6, ...style };
    });
  }

  nameOf(curve) {
    return this.what.names ? this.what.names[curve] : `J${curve + 1}`;
  }

  shown(joint) {
    return Boolean(this.what.names) || this.selection.joints[joint];
  }

  rows() {
    const [from, to] = this.timeline.window;
    const first = this.run.rowAt(from);
    const last = Math.min(this.run.rowAt(to) + 1, this.run.time.length - 1);
    const bins = Math.max(200, Math.min(this.area.clientWidth, 2000));
    const curves = this.series.map(({ values }) => values);
    const rows = decimate(this.run.time, curves, first, last, bins);
    const rowOf = (row) => [this.run.time[row], ...curves.map((values) => values[row])];
    const before = this.nextJoined(first, -1);
    const after = this.nextJoined(last, 1);
    if (before < first) rows.unshift(rowOf(before));
    if (after > last) rows.push(rowOf(after));
    this.series.forEach(({ joined }, curve) => {
      if (joined) rows.forEach((row) => { row[curve + 1] = Number.isNaN(row[curve + 1]) ? null : row[curve + 1]; });
    });
    return rows;
  }

  // The nearest row in this direction to which joined curves lead; if there is none, the row itself.
  nextJoined(row, step) {
    const curve = this.series.find(({ joined }) => joined);
    if (!curve) return row;
    let at = row;
    while (at >= 0 && at < this.run.time.length && Number.isNaN(curve.values[at])) at += step;
    return at >= 0 && at < this.run.time.length ? at : row;
  }

  options() {
    return {
      labels: ['time', ...this.names],
      series: this.styles,
      legend: 'never',
      xRangePad: 0,
      dateWindow: this.timeline.window.slice(),
      highlightCircleSize: 0,
      ...this.colors(),
      axes: {
        x: { axisLabelFormatter: (time) => `${Number(time.toPrecision(10))} s`, axisLabelWidth: 70 },
        y: { axisLabelWidth: kPlotMargin, axisLabelFormatter: (value) => axisText(value) },
      },
      underlayCallback: (canvas, area, graph) => {
        this.drawLimits(canvas, area, graph);
        if (this.what.steps) this.drawSteps(canvas, area, graph);
      },
      drawCallback: (graph, initial) => {
        if (!initial && !this.updating) this.timeline.setWindow(...graph.xAxisRange());
      },
      clickCallback: (event, time) => this.timeline.setTime(time),
      highlightCallback: (event, time) => this.timeline.pointAt(time),
      unhighlightCallback: () => this.timeline.pointAt(null),
    };
  }

  colors() {
    return { gridLineColor: pageColor('--grid'), axisLineColor: pageColor('--soft') };
  }

  show() {
    this.updating = true;
    this.graph.updateOptions({
      ...this.colors(),
      file: this.rows(),
      dateWindow: this.timeline.window.slice(),
      visibility: this.series.map(({ joint }) => this.shown(joint)),
    });
    this.updating = false;
    this.placeCursor();
  }

  // The forbidden ranges of the shown joints, and the times at which a set-point is inside them.
  drawLimits(canvas, area, graph) {
    const { limits, curves } = this.what;
    if (!limits) return;
    const shown = limits.filter(([low, high], joint) => this.shown(joint) && low !== null && high !== null);
    if (shown.length === 0) return;
    this.drawLimitsOfJoints(canvas, area, graph);
    const top = graph.toDomYCoord(Math.max(...shown.map(([, high]) => high)));
    const bottom = graph.toDomYCoord(Math.min(...shown.map(([low]) => low)));
    canvas.fillStyle = kLimitColor;
    if (top > area.y) canvas.fillRect(area.x, area.y, area.w, Math.min(top, area.y + area.h) - area.y);
    const floor = area.y + area.h;
    if (bottom < floor) canvas.fillRect(area.x, Math.max(bottom, area.y), area.w, floor - Math.max(bottom, area.y));
    canvas.fillStyle = kViolationColor;
    const [from, to] = this.timeline.window.map((time) => this.run.rowAt(time));
    curves.forEach((_, joint) => {
      if (!this.shown(joint)) return;
      for (let row = from; row <= to; row += 1) {
        if (this.isBeyond(joint, row)) canvas.fillRect(graph.toDomXCoord(this.run.time[row]), area.y, 1.5, area.h);
      }
    });
  }

  // A thin line at each limit, in the colour of the joint.
  drawLimitsOfJoints(canvas, area, graph) {
    canvas.save();
    canvas.setLineDash([6, 6]);
    canvas.globalAlpha = 0.6;
    this.what.limits.forEach((range, joint) => {
      if (!this.shown(joint)) return;
      canvas.strokeStyle = kJointColors[joint];
      for (const limit of range) {
        if (limit === null) continue;
        const y = graph.toDomYCoord(limit);
        if (y < area.y || y > area.y + area.h) continue;
        canvas.beginPath();
        canvas.moveTo(area.x, y);
        canvas.lineTo(area.x + area.w, y);
        canvas.stroke();
      }
    });
    canvas.restore();
  }

  drawSteps(canvas, area, graph) {
    const [from, to] = this.timeline.window;
    canvas.fillStyle = kStepColor;
    for (const row of this.run.steps) {
      const time = this.run.time[row];
      if (time >= from && time <= to) canvas.fillRect(graph.toDomXCoord(time) - 1, area.y, 2, area.h);
    }
  }

  isBeyond(joint, row) {
    const { limits, curves, rounding } = this.what;
    const [low, high] = limits[joint];
    if (low === null || high === null) return false;
    const hair = Math.max((high - low) * kLimitHair, rounding || 0);
    const value = curves[joint][row];
    return value > high + hair || value < low - hair;
  }

  placeCursor() {
    const { time, pointed } = this.timeline;
    const [from, to] = this.timeline.window;
    this.cursor.hidden = time < from || time > to;
    this.cursor.style.left = `${this.graph.toDomXCoord(time)}px`;
    const row = this.run.rowAt(pointed === null ? time : pointed);
    this.readout.replaceChildren();
    if (pointed !== null) element(this.readout, 'span', 'pointed').textContent = secondsText(this.run.time[row]);
    this.what.curves.forEach((values, joint) => {
      if (!this.shown(joint)) return;
      const value = element(this.readout, 'span');
      value.style.color = kJointColors[joint];
      value.textContent = `${this.nameOf(joint)} ${numberText(this.what.ofOther ? latest(values, row) : values[row])}`;
    });
  }
}

const kJoined = { connectSeparatedPoints: true };  // null joins, NaN is a gap
const kDotted = { strokePattern: [1, 3], strokeWidth: 2, color: '#57606a' };
const kStepNote = 'Grey line: a fault begins or ends, and the set-points step. No derivative of a step is shown.';
const kPlotMargin = 84;  // of the numbers beside a plot [px], as in page.css
const kLimitHair = 1e-4;  // of the range: the peaks of derivatives of rounded values

// Without an exponent, and with a space between thousands at which no line ends.
function axisText(value) {
  return Number(value.toPrecision(6)).toLocaleString('en').replaceAll(',', '\u202f');
}

// The last value that is not after this row.
function latest(values, row) {
  let at = row;
  while (at > 0 && Number.isNaN(values[at])) at -= 1;
  return values[at];
}

function numberText(value) {
  if (Number.isNaN(value)) return '–';
  if (Math.abs(value) < 5e-5) return '0';
  const size = Math.abs(value);
  if (Number.isInteger(value)) return value.toFixed(0);
  return value.toFixed(size >= 1000 ? 0 : size >= 10 ? 2 : 4);
}
