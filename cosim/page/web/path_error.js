// The distance of the tool from the paths of the moves, computed from the joint angles of the trace. Lines, arcs and
// circles only, and none on a conveyor.

const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = (a) => Math.hypot(...a);

function distanceToLine(path, point) {
  const along = subtract(path.end_mm, path.start_mm);
  const from = subtract(point, path.start_mm);
  const square = dot(along, along);
  const share = square > 0 ? Math.min(Math.max(dot(from, along) / square, 0), 1) : 0;
  return length(from.map((value, i) => value - share * along[i]));
}

function distanceToArc(path, point) {
  const x = subtract(path.start_mm, path.center_mm);
  const y = cross(path.normal, x);
  const from = subtract(point, path.center_mm);
  const [u, v] = [dot(from, x) / path.radius_mm, dot(from, y) / path.radius_mm];
  let angle = Math.atan2(v, u) / kRadPerDeg;
  if (angle < 0) angle += 360;
  if (angle <= Math.abs(path.angle_deg)) return Math.hypot(Math.hypot(u, v) - path.radius_mm, dot(from, path.normal));
  return Math.min(length(subtract(point, path.start_mm)), length(subtract(point, path.end_mm)));
}

function distanceToPath(path, point) {
  return path.radius_mm === undefined ? distanceToLine(path, point) : distanceToArc(path, point);
}

// Moves that follow each other without a stop form a chain; a point belongs to the nearest of its chain.
function pathChains(moves) {
  const chains = [];
  let open = null;
  for (const move of moves) {
    const usable = move.path && !move.path.through_mm && !move.path.advance_mm && !move.on_conveyor;
    if (!usable) {
      open = null;
      continue;
    }
    const ticks = move.taken_ticks === null ? move.duration_ticks : move.taken_ticks;
    if (!open) {
      open = { first: move.start_tick, last: 0, paths: [] };
      chains.push(open);
    }
    open.paths.push(move.path);
    open.last = move.start_tick + ticks;
    if (move.blended !== true) open = null;
  }
  return chains;
}

// The errors of encoders and set-points in each row, NaN outside of paths; null if there is nothing to measure.
function pathErrors(run) {
  if (!run.kinematics) return null;
  const chains = pathChains(run.summary.result.moves);
  if (chains.length === 0) return null;
  const nothing = () => new Float64Array(run.tick.length).fill(NaN);
  const errors = { encoder: nothing(), reference: nothing() };
  for (const chain of chains) {
    run.tick.forEach((tick, row) => {
      if (tick < chain.first || tick > chain.last) return;
      for (const side of ['encoder', 'reference']) {
        const point = run.kinematics.toolPoint(run.jointsAt(run[side], row));
        errors[side][row] = Math.min(...chain.paths.map((path) => distanceToPath(path, point)));
      }
    });
  }
  return errors;
}
