// The distance of the tool from the paths of the moves, as cosim/page/path_error.cpp has measured it.

// The errors of encoders and set-points in each row, NaN where there is none. `unmeasured`: moves whose paths are not
// measured. `waits`: the encoders begin a path later than the set-points. Null if no move has a path.
function pathErrors(run) {
  if (!run.errors) return null;
  const measured = (column) => decodeColumn(column).map((mm) => (mm < 0 ? NaN : mm));
  const [encoder, reference] = [measured(run.errors.encoder), measured(run.errors.reference)];
  const unmeasured = run.summary.result.moves.filter((move) => move.on_conveyor);
  const waits = encoder.some((mm, row) => Number.isNaN(mm) && !Number.isNaN(reference[row]));
  return { encoder, reference, unmeasured, waits };
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
