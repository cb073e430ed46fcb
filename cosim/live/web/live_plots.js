// The joints over the last seconds.
const kShownSeconds = 10;
const kPlotEveryMs = 100;
const kRowEverySeconds = 1 / 30;

class LivePlots {
  constructor(parent, count) {
    this.rows = { position: [], speed: [] };
    this.last = null;
    this.plots = {
      position: this.plot(parent, 'position', 'Position', 'deg', count),
      speed: this.plot(parent, 'speed', 'Speed', 'deg/s', count),
    };
    setInterval(() => this.draw(), kPlotEveryMs);
  }

  plot(parent, id, title, unit, count) {
    const box = element(parent, 'section', 'plot');
    box.id = `live-${id}`;
    const head = element(box, 'header');
    element(head, 'h3').textContent = `${title} [${unit}]`;
    const readout = element(head, 'div', 'readout');
    const area = element(box, 'div', 'area');
    const labels = ['time', ...Array.from({ length: count }, (_, joint) => `J${joint + 1}`)];
    const values = labels.slice(1).map((label, joint) => {
      const value = element(readout, 'span');
      value.style.color = kJointColors[joint];
      return value;
    });
    const graph = new Dygraph(area, [new Array(count + 1).fill(0)], {
      labels,
      colors: kJointColors.slice(0, count),
      strokeWidth: 1.6,
      legend: 'never',
      xRangePad: 0,
      highlightCircleSize: 0,
      interactionModel: {},
      includeZero: true,
      gridLineColor: pageColor('--grid'),
      axisLineColor: '#8c959f',
      axes: {
        x: { axisLabelFormatter: (time) => `${Number(time.toPrecision(8))} s`, axisLabelWidth: 70, pixelsPerLabel: 90 },
        y: { axisLabelWidth: 54 },
      },
    });
    return { graph, values };
  }

  add(state) {
    if (this.last && state.t < this.last.t) this.goBack(state.t);
    const { last } = this;
    if (last && state.t - last.t < kRowEverySeconds) return;
    const position = [state.t, ...state.joints_deg];
    const step = last ? state.t - last.t : 0;
    const speed = step > 0 ? state.joints_deg.map((deg, i) => (deg - last.joints[i]) / step) : state.joints_deg.map(() => 0);
    this.rows.position.push(position);
    this.rows.speed.push([state.t, ...speed]);
    for (const rows of Object.values(this.rows)) {
      while (rows.length > 0 && rows[0][0] < state.t - kShownSeconds) rows.shift();
    }
    this.last = { t: state.t, joints: state.joints_deg };
  }

  // To an earlier time, or to another session.
  goBack(time) {
    for (const kind of Object.keys(this.rows)) this.rows[kind] = this.rows[kind].filter((row) => row[0] < time);
    this.last = null;
  }

  draw() {
    if (!this.last || document.hidden) return;
    const end = Math.max(this.last.t, kShownSeconds);
    for (const [kind, { graph, values }] of Object.entries(this.plots)) {
      const rows = this.rows[kind];
      graph.updateOptions({ file: rows, dateWindow: [end - kShownSeconds, end] });
      const now = rows[rows.length - 1];
      values.forEach((value, joint) => { value.textContent = `J${joint + 1} ${now[joint + 1].toFixed(2)}`; });
    }
  }
}
