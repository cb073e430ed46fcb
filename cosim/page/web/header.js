// The head of the page: what was run and how it ended.
function showHeader(parent, run) {
  const { summary } = run;
  const { result } = summary;
  const verdict = element(parent, 'span', result.passed ? 'verdict passed' : 'verdict failed');
  verdict.id = 'verdict';
  verdict.textContent = result.interrupted ? 'INTERRUPTED' : result.passed ? 'PASSED' : 'FAILED';
  element(parent, 'h1').textContent = summary.scenario;
  element(parent, 'p', 'description').textContent = summary.description;
  const facts = element(parent, 'dl');
  const fact = (name, value) => {
    const box = element(facts, 'div');
    element(box, 'dt').textContent = name;
    element(box, 'dd').textContent = value;
  };
  fact('robot', summary.robot);
  fact('outcome', result.outcome);
  fact('golden', result.golden_text || result.golden);
  if (run.other && run.other.shown) fact('this run', run.other.shown);
  if (run.other) fact('compared with', run.other.name);
  fact('simulated', `${result.simulated_s.toFixed(6)} s, ${result.ticks} ticks`);
  fact('variant, engine', `${summary.variant}, ${summary.engine}`);
  fact('worst tick', `${result.worst_tick_cycles} of ${result.tick_cycles} cycles`);
  fact('underruns', String(result.underruns));
  fact('seed', String(summary.seed));
  if (summary.overrides.length > 0) fact('--set', summary.overrides.join(' '));
  fact('armature', summary.tool_version);
  fact('sha256', result.sha256);
  const reason = failureOf(run);
  if (reason) element(parent, 'p', 'failure').textContent = reason;
}

// Why the run failed: the error that ended it, or the first difference from the golden, or the expectations that it
// missed. Empty if it passed.
function failureOf(run) {
  const { result } = run.summary;
  if (result.passed) return '';
  if (result.failure) return result.failure;
  const missed = (result.expectations || []).filter(({ met }) => !met);
  const reasons = missed.slice(0, kMaxReasons).map(({ key, expected, got }) => `${key}: expected ${expected}, got ${got}`);
  if (missed.length > kMaxReasons) reasons.push(`and ${missed.length - kMaxReasons} more`);
  if (result.golden === 'differs') reasons.unshift(result.golden_text, ...firstDifference(run));
  return reasons.join('; ');
}

function firstDifference({ other, tick }) {
  if (!other || !other.first) return [];
  const { row, joint, counts } = other.first;
  return [`J${joint + 1} deviates by ${counts} counts in tick ${tick[row]}`];
}

const kMaxReasons = 3;
