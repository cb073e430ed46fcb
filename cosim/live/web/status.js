// The head of the page, and what was said.
class Status {
  constructor(parent, connection) {
    this.state = element(parent, 'span', 'state');
    this.state.id = 'state';
    this.title = element(parent, 'h1');
    this.facts = element(parent, 'div', 'facts');
    this.clock = this.fact('simulated');
    this.factor = this.fact('× real time');
    this.does = this.fact('now');
    this.why = element(parent, 'p', 'problem');
    this.why.id = 'problem';
    const stop = button(parent, 'EMERGENCY STOP', 'stop the arm at once', () => connection.send({ do: 'estop' }));
    stop.id = 'estop';
    connection.listen('status', (status) => this.showStatus(status));
    connection.listen('error', (text) => this.say(text));
    this.showStatus(connection.status);
  }

  fact(name) {
    const box = element(this.facts, 'div');
    element(box, 'small').textContent = name;
    return element(box, 'output');
  }

  showStatus(status) {
    document.body.dataset.status = status;
    const texts = {
      connecting: 'connecting …', open: '', lost: 'The program has ended, or does not answer.',
      busy: 'Another page has the arm. This one takes over when it is closed.',
    };
    this.why.textContent = texts[status];
    if (status !== 'open') {
      this.state.textContent = status === 'busy' ? 'busy' : 'no connection';
      this.state.dataset.state = 'off';
    }
  }

  say(text) {
    this.why.textContent = text;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => { if (document.body.dataset.status === 'open') this.why.textContent = ''; }, 5000);
  }

  // The last state may be drawn after the connection was lost.
  show(state) {
    if (document.body.dataset.status !== 'open') return;
    this.state.textContent = state.alarm && state.state === 'alarm' ? `alarm: ${state.alarm}` : state.state;
    this.state.dataset.state = state.state;
    this.clock.textContent = `${state.t.toFixed(2)} s`;
    this.factor.textContent = state.factor.toFixed(2);
    this.does.textContent = state.command || state.motion;
  }
}

// The last messages of the pendant and events of the controller.
class Messages {
  constructor(parent) {
    const box = panel(parent, 'messages', 'Messages');
    this.pendant = element(box, 'ul', 'log');
    element(box, 'h2').textContent = 'Events';
    this.events = element(box, 'ul', 'log');
  }

  show(state) {
    this.fill(this.pendant, state.messages);
    this.fill(this.events, state.events);
  }

  fill(list, lines) {
    const text = lines.join('\n');
    if (list.shown === text) return;
    list.shown = text;
    list.replaceChildren();
    for (const line of lines.slice().reverse()) element(list, 'li').textContent = line;
  }
}
