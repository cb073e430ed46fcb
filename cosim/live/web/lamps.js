// Lamps: what the drives, switches and the controller say. Those of lines to the chip can be clicked.
const kHeldSwitches = ['home', 'limit_pos', 'limit_neg'];

class Lamps {
  constructor(parent, count, connection) {
    const box = panel(parent, 'lamps', 'Lamps');
    const grid = element(box, 'div', 'lamps');
    this.count = count;
    this.lamps = {};
    for (const [id, name, kind] of [
      ['drives', 'servo on', 'good'], ['alarm', 'alarm', 'bad'], ['estop', 'e-stop', 'bad'], ['moving', 'moving', 'busy'],
    ]) {
      this.lamps[id] = element(grid, 'span', `lamp ${kind}`);
      this.lamps[id].id = `lamp-${id}`;
      this.lamps[id].textContent = name;
    }
    this.axes = element(box, 'table', 'switches');
    row(this.axes, ['', ...Array.from({ length: count }, (_, joint) => `J${joint + 1}`)], 'th');
    this.rows = {};
    for (const [key, name, kind] of [
      ['servo', 'drive on', 'good'], ['in_position', 'in position', 'good'], ['drive_alarm', 'drive alarm', 'bad'],
      ['home', 'home switch', 'busy'], ['limit_pos', 'limit +', 'bad'], ['limit_neg', 'limit −', 'bad'],
    ]) {
      const line = row(this.axes, [name, ...new Array(count).fill('')]);
      this.rows[key] = Array.from(line.children).slice(1).map((cell) => element(cell, 'i', `dot ${kind}`));
    }
    for (const which of kHeldSwitches) this.addClicks(which, connection);
    this.lamps.estop.classList.add('click');
    this.lamps.estop.title = 'click: hold the line of the emergency stop, or let it go';
    this.lamps.estop.addEventListener('click', () => connection.send({ do: 'hold', which: 'estop' }));
    this.addOutputs(box, connection);
    this.addInputs(box, connection);
  }

  // A click holds a switch at its other level, or lets it go.
  addClicks(which, connection) {
    this.rows[which].forEach((dot, joint) => {
      dot.classList.add('click');
      dot.dataset.hold = `${which} ${joint + 1}`;
      dot.title = `${which} of axis ${joint + 1}; click: hold it at the other level, or let it go`;
      dot.addEventListener('click', () => connection.send({ do: 'hold', which, axis: joint + 1 }));
    });
  }

  addInputs(box, connection) {
    const line = element(box, 'div', 'outputs');
    element(line, 'span', 'label').textContent = 'tool inputs';
    this.inputs = Array.from({ length: 16 }, (_, bit) => {
      const key = button(line, String(bit + 1), `input ${bit + 1}: invert it`, () => connection.send({ do: 'input', pin: bit + 1 }));
      key.dataset.input = bit + 1;
      return key;
    });
  }

  // A click switches an output of the tool.
  addOutputs(box, connection) {
    const line = element(box, 'div', 'outputs');
    element(line, 'span', 'label').textContent = 'tool outputs';
    this.outputs = Array.from({ length: 16 }, (_, bit) => {
      const button = element(line, 'button', 'output');
      button.textContent = String(bit + 1);
      button.title = `output ${bit + 1}: switch it`;
      button.addEventListener('click', () => connection.command('set_output', bit + 1, button.classList.contains('on') ? 0 : 1));
      return button;
    });
  }

  show(state) {
    const { lamps } = state;
    const on = (id, lit) => this.lamps[id].classList.toggle('on', lit);
    on('drives', state.drives);
    on('alarm', state.alarm !== '');
    on('estop', state.state === 'estop' || lamps.estop || state.estop_pressed);
    on('moving', ['jog', 'move', 'run'].includes(state.state));
    for (const [key, dots] of Object.entries(this.rows)) {
      dots.forEach((dot, joint) => dot.classList.toggle('on', ((lamps[key] >> joint) & 1) === 1));
    }
    for (const which of kHeldSwitches) {
      this.rows[which].forEach((dot, joint) => dot.classList.toggle('held', ((state.held[which] >> joint) & 1) === 1));
    }
    this.lamps.estop.classList.toggle('held', state.held.estop);
    this.outputs.forEach((button, bit) => button.classList.toggle('on', ((lamps.outputs >> bit) & 1) === 1));
    this.inputs.forEach((button, bit) => button.classList.toggle('on', ((lamps.inputs >> bit) & 1) === 1));
  }
}

// A box of the page with a title.
function panel(parent, id, title) {
  const box = element(parent, 'section', 'panel');
  box.id = id;
  element(box, 'h2').textContent = title;
  return box;
}

function button(parent, text, title, act) {
  const made = element(parent, 'button');
  made.textContent = text;
  made.title = title;
  made.addEventListener('click', act);
  return made;
}
