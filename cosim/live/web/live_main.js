// Puts the page together when the program has said what arm it has. The arm is drawn in each frame. Numbers, sliders and
// lamps change less often: nobody reads a number that stands for 1/60 s, and each new text costs a layout of the page.
const kPanelsEveryMs = 50;

function showLive() {
  const connection = new Connection();
  const place = (id) => document.getElementById(id);
  const status = new Status(place('top'), connection);
  let latest = null;
  let parts = null;
  let drawn = { t: 0 };  // the state that the arm shows
  let shown = null;      // the one that the panels show
  let panelsAt = 0;

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

  function show(now) {
    requestAnimationFrame(show);
    if (!latest || !parts) return;
    if (latest !== drawn) showArm();
    if (latest === shown || now - panelsAt < kPanelsEveryMs) return;
    panelsAt = now;
    shown = latest;
    window.live.state = latest;
    for (const part of [status, parts.past, parts.lamps, parts.drive, parts.jog, parts.hand, parts.program, parts.messages]) part.show(latest);
    if (!document.body.dataset.ready) afterNextFrame(() => connection.startBeats());
    document.body.dataset.ready = 'yes';
  }

  // When the picture of this frame is on the screen.
  function afterNextFrame(act) {
    requestAnimationFrame(() => requestAnimationFrame(act));
  }

  function showArm() {
    if (latest.t < drawn.t) parts.arm.clearTrail();
    drawn = latest;
    parts.arm.show(latest.joints_deg, latest.set_deg);
  }

  connection.listen('hello', (hello) => {
    if (!parts) parts = build(hello);
    window.live = { connection, status, ...parts };
  });
  connection.listen('state', (state) => {
    latest = state;
    window.live.states = (window.live.states || 0) + 1;
    if (parts) parts.plots.add(state);
  });
  requestAnimationFrame(show);
}

showLive();
