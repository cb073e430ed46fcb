// Puts the page together.
function showReport() {
  const run = new Run(JSON.parse(document.getElementById('run').textContent));
  const timeline = new Timeline(run.begin, run.end);
  const selection = new Selection(run.axisCount);
  const place = (id) => document.getElementById(id);
  showHeader(place('head'), run);
  new TimeBar(place('bar'), run, timeline, selection);
  const lanes = new Lanes(place('plots'), run, timeline);
  showMarks(place('plots'), run);
  const plots = plotList(run).map((what) => new Plot(place('plots'), what, run, timeline, selection));
  const arm = new ArmView(place('side'), run, timeline);
  const program = run.programs.length > 0 ? new ProgramText(place('side'), run, timeline) : null;
  showExpectations(place('side'), run);
  showMoves(place('side'), run, timeline);
  followKeys(run, timeline);
  darkRoom.addEventListener('change', () => timeline.tell('window'));
  followAddress(timeline, location.hash, run.page.shown);
  if (run.page.digest) watchReport(place('head'), run.page, timeline);
  document.body.dataset.ready = 'yes';
  // For tests and for the console of the browser.
  window.report = { run, timeline, plots, lanes, arm, program, selection, pathErrors, wayRows };
}

showReport();
