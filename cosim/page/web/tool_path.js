// The path of the tool in the picture of the arm: cuts are solid lines, the ways between them are thin and dashed.

const kMaxPathPoints = 20000;
const kWayOpacity = 0.55;
const kDashesAcross = 60;  // the drawn paths

// Which rows are only a way to the next cut: a rapid, a joint move, or no move at all. None of a run without a cut.
function wayRows(run) {
  const isCut = (move) => Boolean(move.path) && !move.rapid;
  const moves = [...run.summary.result.moves].sort((one, other) => one.start_tick - other.start_tick);
  if (!moves.some(isCut)) return () => false;
  const ways = new Uint8Array(run.time.length);
  let next = 0;
  run.tick.forEach((tick, row) => {
    while (next < moves.length && moves[next].start_tick <= tick) next += 1;
    const move = moves[next - 1];
    const ticks = move && (move.taken_ticks === null ? move.duration_ticks : move.taken_ticks);
    ways[row] = !move || tick > move.start_tick + ticks || !isCut(move);
  });
  return (row) => ways[row] === 1;
}

// The path of one side of run.tool in pieces { way, points }. A piece begins where the one before it ends.
function toolPath(run, side) {
  const step = Math.max(1, Math.ceil(run.time.length / kMaxPathPoints));
  const isWay = wayRows(run);
  const pieces = [];
  for (let row = 0; row < run.time.length; row += step) {
    const point = new THREE.Vector3(...side.map((values) => values[row])).divideScalar(kMmPerUnit);
    const piece = pieces[pieces.length - 1];
    const way = isWay(row);
    if (piece) piece.points.push(point);
    if (!piece || piece.way !== way) pieces.push({ way, points: [point] });
  }
  return pieces.filter(({ points }) => points.length > 1);
}

// `size`: of what is drawn, for the length of the dashes.
function pathLine({ way, points }, color, size) {
  const dash = size / kDashesAcross;
  const material = way
    ? new THREE.LineDashedMaterial({ color, dashSize: dash, gapSize: dash, transparent: true, opacity: kWayOpacity })
    : new THREE.LineBasicMaterial({ color });
  const line = new THREE.Line(new THREE.BufferGeometry().setFromPoints(points), material);
  return way ? line.computeLineDistances() : line;
}

// The box around the paths of the moves. Empty if there are none.
function plannedBounds(run) {
  const bounds = new THREE.Box3();
  for (const { path } of run.summary.result.moves) {
    if (!path) continue;
    const points = [path.start_mm, path.end_mm, ...(path.through_mm || [])];
    if (path.radius_mm) for (const side of [-1, 1]) points.push(path.center_mm.map((mm) => mm + side * path.radius_mm));
    for (const point of points) bounds.expandByPoint(new THREE.Vector3(...point).divideScalar(kMmPerUnit));
  }
  return bounds;
}
