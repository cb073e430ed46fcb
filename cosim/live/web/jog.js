// Jogs: the arm moves while a button is held down. The page repeats the jog; when it stops doing so, so does the arm.
const kJogEveryMs = 50;
const kSystems = ['joints', 'base', 'tool', 'user frame'];
const kToolAxes = ['X', 'Y', 'Z', 'Rx', 'Ry', 'Rz'];

class Jog {
  constructor(parent, count, connection) {
    Object.assign(this, { connection, count });
    this.system = 0;
    const box = panel(parent, 'jog', 'Jog');
    const choice = element(box, 'div', 'choice');
    this.systems = kSystems.map((name, system) => button(choice, name, `jog in coordinates: ${name}`, () => this.choose(system)));
    this.speed = slider(box, 'speed', 1, 100, 20, (percent) => `${percent} %`);
    this.speed.id = 'jog-speed';
    this.rows = Array.from({ length: 6 }, (_, axis) => this.addRow(box, axis));
    for (const event of ['blur', 'pagehide']) window.addEventListener(event, () => this.release());
    window.addEventListener('pointerup', () => this.release());
    window.addEventListener('pointercancel', () => this.release());
    document.addEventListener('visibilitychange', () => this.release());
    this.choose(0);
  }

  addRow(box, axis) {
    const line = element(box, 'div', 'jog-row');
    const name = element(line, 'span', 'name');
    const minus = this.addKey(line, axis, -1);
    const value = element(line, 'output');
    const plus = this.addKey(line, axis, 1);
    return { line, name, minus, value, plus };
  }

  addKey(line, axis, sign) {
    const key = element(line, 'button', 'key');
    key.textContent = sign > 0 ? '+' : '−';
    key.title = 'hold it down';
    key.dataset.jog = `${axis}${sign > 0 ? '+' : '-'}`;
    key.addEventListener('pointerdown', (event) => event.button === 0 && this.press(key, axis, sign));
    key.addEventListener('pointerleave', () => this.release());
    key.addEventListener('contextmenu', (event) => event.preventDefault());
    key.addEventListener('keydown', (event) => {
      if ((event.key === ' ' || event.key === 'Enter') && !event.repeat) this.press(key, axis, sign);
    });
    key.addEventListener('keyup', () => this.release());
    return key;
  }

  press(key, axis, sign) {
    this.release();
    this.connection.send({ do: 'release' });
    const jog = () => this.connection.send({ do: 'jog', system: this.system, axis, percent: sign * Number(this.speed.value) });
    jog();
    this.held = { key, timer: setInterval(jog, kJogEveryMs) };
    key.classList.add('held');
  }

  release() {
    if (!this.held) return;
    clearInterval(this.held.timer);
    this.held.key.classList.remove('held');
    this.held = null;
    this.connection.send({ do: 'release' });
  }

  choose(system) {
    this.release();
    this.system = system;
    this.systems.forEach((one, i) => one.classList.toggle('chosen', i === system));
    this.rows.forEach(({ line, name }, axis) => {
      line.hidden = axis >= this.count;
      name.textContent = system === 0 ? `J${axis + 1}` : kToolAxes[axis];
      name.style.color = system === 0 ? kJointColors[axis] : '';
    });
  }

  show(state) {
    this.rows.forEach(({ value }, axis) => {
      const tool = state.tool ? [...state.tool.xyz_mm, ...state.tool.rpy_deg] : null;
      const number = this.system === 0 ? state.joints_deg[axis] : tool && tool[axis];
      const unit = this.system === 0 || axis >= 3 ? '°' : 'mm';
      value.textContent = number === undefined || number === null ? '–' : `${number.toFixed(2)} ${unit}`;
    });
  }
}

// A slider with its name and its value.
function slider(parent, name, min, max, value, text, step = 1) {
  const line = element(parent, 'label', 'slider-row');
  element(line, 'span', 'name').textContent = name;
  const input = element(line, 'input');
  Object.assign(input, { type: 'range', min, max, step, value });
  const shown = element(line, 'output');
  input.show = () => { shown.textContent = text(Number(input.value)); };
  input.addEventListener('input', input.show);
  input.show();
  return input;
}
