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
  fact('simulated', `${result.simulated_s.toFixed(6)} s, ${result.ticks} ticks`);
  fact('variant, engine', `${summary.variant}, ${summary.engine}`);
  fact('worst tick', `${result.worst_tick_cycles} of ${result.tick_cycles} cycles`);
  fact('underruns', String(result.underruns));
  fact('seed', String(summary.seed));
  if (summary.overrides.length > 0) fact('--set', summary.overrides.join(' '));
  fact('armature', summary.tool_version);
  fact('sha256', result.sha256);
  if (result.failure) element(parent, 'p', 'failure').textContent = result.failure;
}
