// What the keyboard does, and what the marks in the plots mean.

const kHint = 'Space plays. Left and right step a row of the trace, with Shift ten. A click shows a moment, drag zooms, ' +
  'Ctrl and the wheel too; a double click shows all.';

function showMarks(parent, run) {
  const box = element(parent, 'p', 'marks');
  const entry = (mark, text) => {
    const one = element(box, 'span');
    element(one, 'i', mark);
    element(one, 'span').textContent = text;
  };
  const of = run.other && run.other.shown ? ` of ${run.other.shown}` : '';
  entry('line', `set-points${of}`);
  entry('line dashed', `encoders${of}`);
  if (run.other) entry('line dotted', of ? `encoders of ${run.other.name}` : run.other.name);
  entry('line limit', 'limit of a joint');
  entry('pink', 'beyond the limits of the shown joints');
  element(box, 'span', 'hint').textContent = kHint;
}

// Elements with keys of their own keep them.
function followKeys(run, timeline) {
  const step = (rows) => {
    const row = Math.min(Math.max(run.rowAt(timeline.time) + rows, 0), run.time.length - 1);
    timeline.setTime(run.time[row]);
  };
  document.addEventListener('keydown', (event) => {
    if (event.target.closest('input, button, select, textarea') || event.ctrlKey || event.metaKey || event.altKey) return;
    const rows = event.shiftKey ? 10 : 1;
    if (event.key === ' ') timeline.playing ? timeline.stop() : timeline.play();
    else if (event.key === 'ArrowLeft') step(-rows);
    else if (event.key === 'ArrowRight') step(rows);
    else return;
    event.preventDefault();
  });
}
