// The shown part of the run in the address of the page: report.html#time=0.12&from=0.1&to=0.2 [s]. So a link can lead to
// a moment, and a page that reloads itself stays where it is.

function addressText(timeline) {
  const { time, window } = timeline;
  return `#time=${time}&from=${window[0]}&to=${window[1]}`;
}

// Shows the part that the address names, or else `preset`, or else the whole run.
function followAddress(timeline, address, preset) {
  const words = new URLSearchParams(address.slice(1));
  const number = (name) => (words.has(name) ? Number(words.get(name)) : NaN);
  const { from, to, time } = preset || { from: timeline.begin, to: timeline.end, time: timeline.begin };
  const or = (value, other) => (Number.isFinite(value) ? value : other);
  timeline.setWindow(or(number('from'), from), or(number('to'), to));
  timeline.setTime(or(number('time'), time));
}
