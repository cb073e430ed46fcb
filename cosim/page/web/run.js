// The run as arrays over the rows of its trace, with what follows from them.

// Derivative of the given order by the time, by central differences. Rows without neighbours have no value.
const kWeights = {
  1: [[-1, -0.5], [1, 0.5]],
  2: [[-1, 1], [0, -2], [1, 1]],
  3: [[-1, -1], [0, 3], [1, -3], [2, 1]],
};

function meanStep(time) {
  const last = time.length - 1;
  return last > 0 ? (time[last] - time[0]) / last : 1;
}

// How far a derivative may be off because its values are rounded to so many digits.
function derivativeRounding(digits, time, order) {
  const most = kWeights[order].reduce((sum, [, weight]) => sum + Math.abs(weight), 0);
  return (most * 0.5 * 10 ** -digits) / meanStep(time) ** order;
}

function derivative(values, time, order) {
  const weights = kWeights[order];
  const last = values.length - 1;
  const scale = 1 / meanStep(time) ** order;
  const result = new Float64Array(values.length).fill(NaN);
  for (let row = 1; row + (order === 3 ? 2 : 1) <= last; row += 1) {
    let sum = 0;
    for (const [shift, weight] of weights) sum += weight * values[row + shift];
    result[row] = sum * scale;
  }
  return result;
}

// The rows at which the set-points step: at a fault they stop at once, and after it they begin again where the arm is.
function stepRows(states) {
  const changes = states.filter(({ state }, i) => i > 0 && (state === 'fault' || states[i - 1].state === 'fault'));
  return changes.map(({ row }) => row);
}

// Without the derivatives over a step, which may be one row earlier or later than the state.
function withoutSteps(values, steps) {
  for (const step of steps) values.fill(NaN, Math.max(step - 3, 0), step + 3);
  return values;
}

// Speed of a point in three coordinates.
function pointSpeed(points, time, steps) {
  const [x, y, z] = points.map((values) => derivative(values, time, 1));
  return withoutSteps(x.map((speed, row) => Math.hypot(speed, y[row], z[row])), steps);
}

class Run {
  // `data`: what cosim/page/run_data.cpp writes.
  constructor(data) {
    this.summary = data.summary;
    this.serial = data.serial;
    this.errors = data.errors;
    this.programs = data.programs;
    this.meshes = data.meshes;
    this.page = data.page;
    const columns = new Map(data.trace.columns.map((column) => [column.name, column]));
    const numbers = (name) => (columns.has(name) ? decodeColumn(columns.get(name)) : null);
    this.tick = numbers('tick');
    this.time = numbers('time_s');
    this.states = data.trace.states.map(([row, state]) => ({ row, state }));
    this.axisCount = data.summary.result.final_joint_deg.length;
    this.axes = data.summary.arm ? data.summary.arm.axes : null;
    this.ofJoints = (suffix) =>
      Array.from({ length: this.axisCount }, (_, joint) => numbers(`j${joint + 1}_${suffix}`));
    this.reference = this.ofJoints('ref_deg');
    this.encoder = this.ofJoints('enc_deg');
    this.counts = this.ofJoints('enc_counts');
    this.pinPulses = this.ofJoints('pin_pulses');
    this.steps = stepRows(this.states);
    const ofReference = (order) =>
      this.reference.map((values) => withoutSteps(derivative(values, this.time, order), this.steps));
    this.speed = ofReference(1);
    this.acceleration = ofReference(2);
    this.accelerationRounding = derivativeRounding(columns.get('j1_ref_deg').digits, this.time, 2);
    this.jerk = ofReference(3);
    this.following = this.reference.map((values, joint) =>
      values.map((value, row) => value - this.encoder[joint][row]),
    );
    this.pulsesPerTick = this.pinPulses.map((values) =>
      values.map((value, row) => (row === 0 ? NaN : (value - values[row - 1]) / (this.tick[row] - this.tick[row - 1]))),
    );
    this.load = data.load ? coreLoad(data.load, this.time.length) : null;
    this.other = data.other ? new OtherRun(data.other, this) : null;
    this.kinematics = data.summary.arm && data.summary.arm.links ? new Kinematics(data.summary.arm) : null;
    const sides = () => ({ reference: this.toolPoints(this.reference), encoder: this.toolPoints(this.encoder) });
    this.tool = this.kinematics ? sides() : null;
    this.toolSpeed = this.tool ? pointSpeed(this.tool.reference, this.time, this.steps) : null;
  }

  // x, y and z of the tool in mm, in the base.
  toolPoints(side) {
    const points = [0, 1, 2].map(() => new Float64Array(this.time.length));
    for (let row = 0; row < this.time.length; row += 1) {
      this.kinematics.toolPoint(this.jointsAt(side, row)).forEach((mm, axis) => (points[axis][row] = mm));
    }
    return points;
  }

  get begin() {
    return this.time[0];
  }

  get end() {
    return this.time[this.time.length - 1];
  }

  // The last row that is not after this time.
  rowAt(time) {
    let low = 0;
    let high = this.time.length - 1;
    while (low < high) {
      const middle = Math.ceil((low + high) / 2);
      if (this.time[middle] <= time) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  timeOfTick(tick) {
    return this.time[0] + (tick - this.tick[0]) * kTickSeconds;
  }

  jointsAt(side, row) {
    return side.map((values) => values[row]);
  }
}

// What each core did: cycles of a tick in which it was awake, and on the bus; each value is the largest since the row
// before. Null if the file does not belong to the trace.
function coreLoad(data, rows) {
  const columns = new Map(data.columns.map((column) => [column.name, decodeColumn(column)]));
  const ofCores = (suffix) => [0, 1].map((core) => columns.get(`core${core}_${suffix}`));
  const load = { awake: ofCores('awake_cycles'), bus: ofCores('bus_cycles') };
  return [...load.awake, ...load.bus].every((values) => values && values.length === rows) ? load : null;
}

const kTickSeconds = 50e-6;
const kCycleSeconds = 20e-9;

// A run to compare with: a golden, or the first one of `armature compare`. Its values in the rows of the shown run; NaN
// where it has no row with that tick.
class OtherRun {
  constructor(data, run) {
    this.name = data.name;
    this.shown = data.shown;  // the name of the run that is compared with it; empty: none
    const columns = new Map(data.trace.columns.map((column) => [column.name, decodeColumn(column)]));
    const rowOfTick = new Map();
    columns.get('tick').forEach((tick, row) => rowOfTick.set(tick, row));
    const matched = (name) => {
      const values = columns.get(name);
      return run.tick.map((tick) => (values && rowOfTick.has(tick) ? values[rowOfTick.get(tick)] : NaN));
    };
    const joints = Array.from({ length: run.axisCount }, (_, joint) => `j${joint + 1}`);
    this.encoder = joints.map((joint) => matched(`${joint}_enc_deg`));
    this.deviation = joints.map((joint, i) =>
      matched(`${joint}_enc_counts`).map((counts, row) => run.counts[i][row] - counts),
    );
    const differs = (counts) => counts !== 0 && !Number.isNaN(counts);
    const rows = this.deviation.map((values) => values.findIndex(differs));
    const row = Math.min(...rows.filter((found) => found >= 0));
    // The row, joint and counts of the first deviation; null: there is none.
    const joint = rows.indexOf(row);
    this.first = joint < 0 ? null : { row, joint, counts: this.deviation[joint][row] };
  }
}
