// Puts the page together when the program has said what arm it has, and shows each state in the next frame.
function showLive() {
  const connection = new Connection();
  const place = (id) => document.getElementById(id);
  const status = new Status(place('top'), connection);
  let latest = null;
  let parts = null;
  let shown = 0;  // time of the state that is shown

  function build(hello) {
    const count = hello.arm.axes.length;
    place('view').replaceChildren();
    place('pendant').replaceChildren();
    const [left, right] = [0, 1].map(() => element(place('pendant'), 'div', 'column'));
    status.title.textContent = hello.scenario;
    status.title.title = hello.description;
    const arm = new LiveArm(place('view'), hello.arm, hello.meshes);
    const past = new Past(place('view'), connection);
    const plots = new LivePlots(place('view'), count);
    const lamps = new Lamps(place('view'), count, connection);
    const drive = new Drive(left, count, connection);
    const jog = new Jog(right, count, connection);
    const hand = new Hand(left, hello, connection, arm, drive);
    const program = new Program(right, hello.programs, connection);
    const faults = new Faults(left, hello.faults, connection);
    const messages = new Messages(right);
    return { arm, past, plots, lamps, drive, jog, hand, program, faults, messages };
  }

  function show() {
    requestAnimationFrame(show);
    if (!latest || !parts) return;
    const state = latest;
    latest = null;
    if (state.t < shown) parts.arm.clearTrail();
    shown = state.t;
    parts.arm.show(state.joints_deg, state.set_deg);
    for (const part of [status, parts.past, parts.lamps, parts.drive, parts.jog, parts.hand, parts.program, parts.messages]) part.show(state);
    document.body.dataset.ready = 'yes';
  }

  connection.listen('hello', (hello) => {
    if (!parts) parts = build(hello);
    window.live = { connection, status, ...parts };
  });
  connection.listen('state', (state) => {
    latest = state;
    window.live.state = state;
    window.live.states = (window.live.states || 0) + 1;
    if (parts) parts.plots.add(state);
  });
  requestAnimationFrame(show);
}

showLive();
