// Fewer rows for a plot without losing a peak.

// Rows [time, value...] of the series between two row numbers. If there are more than two for each of `bins`, each bin
// has two rows: the smallest and the largest value of each series in it, in the order in which they come.
function decimate(time, series, first, last, bins) {
  const rows = [];
  const count = last - first + 1;
  if (count <= 2 * bins) {
    for (let row = first; row <= last; row += 1) rows.push([time[row], ...series.map((values) => values[row])]);
    return rows;
  }
  for (let bin = 0; bin < bins; bin += 1) {
    const begin = first + Math.floor((bin * count) / bins);
    const end = first + Math.floor(((bin + 1) * count) / bins);
    const upper = [time[begin]];
    const lower = [time[Math.floor((begin + end) / 2)]];
    for (const values of series) {
      let least = begin;
      let most = begin;
      for (let row = begin; row < end; row += 1) {
        if (values[row] < values[least] || Number.isNaN(values[least])) least = row;
        if (values[row] > values[most] || Number.isNaN(values[most])) most = row;
      }
      upper.push(values[Math.min(least, most)]);
      lower.push(values[Math.max(least, most)]);
    }
    rows.push(upper, lower);
  }
  return rows;
}
