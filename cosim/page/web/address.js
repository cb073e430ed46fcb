// The shown part of the run in the address of the page: report.html#time=0.12&from=0.1&to=0.2 [s]. So a link can lead to
// a moment, and a page that reloads itself stays where it is.

// What is as at first is left out: a page of a growing run shows the newest moment until the user looks elsewhere.
function addressText(timeline, preset) {
  const { time, window } = timeline;
  const first = firstShown(timeline, preset);
  const words = [];
  if (time !== first.time) words.push(`time=${time}`);
  if (window[0] !== first.from || window[1] !== first.to) words.push(`from=${window[0]}&to=${window[1]}`);
  return `#${words.join('&')}`;
}

function firstShown({ begin, end }, preset) {
  const { from, to, time } = preset || { from: begin, to: end, time: begin };
  const within = (value) => Math.min(Math.max(value, begin), end);
  return { from: within(from), to: within(to), time: within(time) };
}

// Shows the part that the address names, or else `preset`, or else the whole run.
function followAddress(timeline, address, preset) {
  const words = new URLSearchParams(address.slice(1));
  const number = (name) => (words.has(name) ? Number(words.get(name)) : NaN);
  const { from, to, time } = firstShown(timeline, preset);
  const or = (value, other) => (Number.isFinite(value) ? value : other);
  timeline.setWindow(or(number('from'), from), or(number('to'), to));
  timeline.setTime(or(number('time'), time));
}
