// Only in a report of `armature watch` or `armature report --follow`: looks at the file beside the page for a newer report,
// and shows it.
//
// A page from a file cannot read other files, but it can run a script. The script calls reportChanged() with the digest of
// the report that is there, and with the error that prevents a newer one.
function watchReport(parent, { digest, shown: preset }, timeline) {
  const note = element(parent, 'p', 'failure');
  note.id = 'watch';
  window.reportChanged = (now) => {
    note.textContent = now.problem;
    if (now.digest === digest) return;
    location.hash = addressText(timeline, preset);
    location.reload();
  };
  let asked = 0;
  setInterval(() => {
    const script = element(document.head, 'script');
    const done = () => script.remove();
    Object.assign(script, { onload: done, onerror: done, src: `reload.js?${(asked += 1)}` });
  }, kReloadPause);
}

const kReloadPause = 500;  // [ms]
