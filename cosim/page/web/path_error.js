// The distance of the tool from the paths of the moves, computed from the joint angles of the trace. What is measured
// when, is the same as in cosim/report/measure/path_error.hpp.

// Moves that are blended. Successive points of a side, encoders or set-points, are mostly near the same path.
class PathChain {
  constructor() {
    this.paths = [];
    this.nearest = { encoder: 0, reference: 0 };
  }

  add(move) {
    const ticks = move.taken_ticks === null ? move.duration_ticks : move.taken_ticks;
    this.paths.push({ first: move.start_tick, shape: pathShape(move.path) });
    this.last = move.start_tick + ticks;
  }

  get first() {
    return this.paths[0].first;
  }

  // From the nearest path that has begun.
  distance(side, tick, point) {
    const last = this.nearest[side];
    let least = this.paths[last].shape.distance(point);
    for (let i = 0; i < this.paths.length && this.paths[i].first <= tick; i += 1) {
      const { shape } = this.paths[i];
      if (i === last || shape.box.distance(point) >= least) continue;
      const mm = shape.distance(point);
      if (mm < least) [this.nearest[side], least] = [i, mm];
    }
    return least;
  }
}

// On a conveyor there is none, because the belt moves the path.
function pathChains(moves) {
  const chains = [];
  let onPath = false;
  for (const move of moves) {
    if (move.kind === 'dwell') continue;
    const wasOnPath = onPath;
    onPath = Boolean(move.path) && !move.on_conveyor;
    if (onPath && !(move.continues && wasOnPath)) chains.push(new PathChain());
    if (onPath) chains[chains.length - 1].add(move);
    else if (wasOnPath) chains[chains.length - 1].last = Math.min(chains[chains.length - 1].last, move.start_tick - 1);
  }
  return chains;
}

// The errors of encoders and set-points in each row, NaN where there is none. `unmeasured`: moves whose paths are not
// measured. `waits`: the encoders begin a path later than the set-points. Null if no move has a path.
function pathErrors(run) {
  const { moves } = run.summary.result;
  if (!run.kinematics || !moves.some((move) => move.path)) return null;
  const nothing = () => new Float64Array(run.tick.length).fill(NaN);
  const unmeasured = moves.filter((move) => move.on_conveyor);
  const errors = { encoder: nothing(), reference: nothing(), unmeasured, waits: false };
  const toolPoint = (side, row) => run.kinematics.toolPoint(run.jointsAt(run[side], row));
  const memory = run.summary.arm.memory_ticks;
  const chains = pathChains(moves);
  let [oldest, begun] = [0, 0];  // chains that a drive may still respond to: from the first, and before the second
  let foreign = -Infinity;  // the last tick in which set-points moved outside of paths
  let span = 0;
  run.tick.forEach((tick, row) => {
    while (span + 1 < run.states.length && run.states[span + 1].row <= row) span += 1;
    while (begun < chains.length && chains[begun].first <= tick) begun += 1;
    if (run.states[span].state === 'fault') {
      oldest = begun;
      foreign = tick;
    }
    while (oldest < begun && tick - chains[oldest].last > memory) oldest += 1;
    const near = chains.slice(oldest, begun);
    const current = near.length > 0 && tick <= near[near.length - 1].last ? near[near.length - 1] : null;
    if (current) errors.reference[row] = current.distance('reference', tick, toolPoint('reference', row));
    else if (row > 0 && run.reference.some((values) => values[row] !== values[row - 1])) foreign = tick;
    const settled = tick - foreign > memory;
    if (current && !settled) errors.waits = true;
    if (near.length === 0 || !settled) return;
    const point = toolPoint('encoder', row);
    errors.encoder[row] = Math.min(...near.map((chain) => chain.distance('encoder', tick, point)));
  });
  return errors;
}

// What the curves of the errors do not show, and why. Null if they show all.
function pathErrorNote({ unmeasured, waits }) {
  const kMaxNames = 8;
  const sentences = [];
  if (unmeasured.length > 0) {
    const names = unmeasured.slice(0, kMaxNames).map((move) => move.command).join(', ');
    const more = unmeasured.length > kMaxNames ? ` and ${unmeasured.length - kMaxNames} more` : '';
    sentences.push(`Not measured, because the path moves with the conveyor: ${names}${more}.`);
  }
  if (waits) sentences.push('After a move without a path, encoders are measured when the drives have settled.');
  return sentences.length > 0 ? sentences.join(' ') : null;
}
