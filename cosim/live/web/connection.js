// The WebSocket to the program. From startBeats() on it sends something every 100 ms: without that for a second the
// program stops the arm.
const kBeatMs = 100;
const kAgainMs = 1000;

class Connection {
  constructor() {
    this.listeners = { hello: [], state: [], forward: [], inverse: [], error: [], status: [] };
    this.status = 'connecting';
    this.open();
  }

  // Call it once, when the page has been shown. Drawing the first picture can block it for seconds.
  startBeats() {
    setInterval(() => this.send({ do: 'beat' }), kBeatMs);
  }

  open() {
    this.busy = false;
    this.socket = new WebSocket(`ws://${location.host}${location.pathname}socket`);
    this.socket.addEventListener('message', (event) => this.receive(JSON.parse(event.data)));
    this.socket.addEventListener('close', () => {
      this.tell('status', this.busy ? 'busy' : 'lost');
      setTimeout(() => this.open(), kAgainMs);
    });
  }

  receive(message) {
    if (message.busy) {
      this.busy = true;
      return;
    }
    if (message.hello) this.tell('status', 'open');
    for (const kind of ['hello', 'forward', 'inverse', 'error']) {
      if (message[kind] !== undefined) this.tell(kind, message[kind]);
    }
    if (message.t !== undefined) this.tell('state', message);
  }

  tell(kind, what) {
    if (kind === 'status') this.status = what;
    for (const listener of this.listeners[kind]) listener(what);
  }

  listen(kind, listener) {
    this.listeners[kind].push(listener);
  }

  send(message) {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(message));
  }

  // A command of the pendant's protocol by its name.
  command(name, parameter = 0, payload = 0) {
    this.send({ do: 'send', command: name, parameter, payload });
  }
}
