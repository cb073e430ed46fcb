// Tables below the plots: the expectations of the scenario, and the moves.

const onePinPerLine = (text) => text.replace(/, (?=pin \d+ = )/g, '\n');

function showExpectations(parent, run) {
  const results = run.summary.result.expectations || [];
  const box = element(parent, 'section', 'table');
  box.id = 'expectations';
  element(box, 'h3').textContent = 'Expectations';
  if (results.length === 0) {
    element(box, 'p').textContent = 'The scenario states none.';
    return;
  }
  const table = element(box, 'table');
  row(table, ['', 'key', 'wanted', 'measured', 'margin'], 'th');
  for (const result of results) {
    const margin = result.margin === null ? '' : numberText(result.margin);
    const [wanted, got] = [result.expected, result.got].map(onePinPerLine);
    const line = row(table, [result.met ? '✓' : '✗', result.key, wanted, got, margin]);
    line.className = result.met ? 'met' : 'missed';
  }
}

function showMoves(parent, run, timeline) {
  const { moves } = run.summary.result;
  if (moves.length === 0) return;
  const box = element(parent, 'section', 'table');
  element(box, 'h3').textContent = 'Moves';
  element(box, 'p', 'note').textContent = 'A click on a move shows its beginning.';
  const table = element(box, 'table');
  row(table, ['move', 'kind', 'start', 'planned', 'taken', 'blended'], 'th');
  const ticks = (count) => (count === null ? 'not finished' : `${(count * kTickSeconds).toFixed(4)} s`);
  for (const move of moves) {
    const start = run.timeOfTick(move.start_tick);
    const blended = move.blended === null ? '' : move.blended ? 'yes' : 'no';
    const times = [`${start.toFixed(4)} s`, ticks(move.duration_ticks), ticks(move.taken_ticks)];
    const line = row(table, [String(commandName(move)), move.kind, ...times, blended]);
    line.className = 'link';
    line.addEventListener('click', () => timeline.setTime(start));
  }
}
