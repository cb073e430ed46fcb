// The time bar: shows the session as it was at any moment, and lets it go on from there.
class Past {
  constructor(parent, connection) {
    Object.assign(this, { connection, asked: null, next: null });
    const box = element(parent, 'section', 'past');
    box.id = 'past';
    this.bar = element(box, 'input');
    Object.assign(this.bar, { type: 'range', min: 0, max: 0, step: 0.001, value: 0, id: 'time-bar' });
    this.bar.title = 'drag it: the session as it was at that moment';
    this.bar.addEventListener('input', () => this.look(Number(this.bar.value)));
    this.text = element(box, 'output');
    this.live = button(box, 'Go on from here', 'what came after this moment is dropped', () => connection.send({ do: 'live' }));
    this.live.id = 'go-live';
    this.end = button(box, 'Back to the end', 'nothing is dropped', () => this.toEnd());
    this.end.id = 'to-end';
    connection.listen('hello', () => { this.asked = null; });
    connection.listen('error', () => { this.asked = null; });
  }

  // One moment at a time; of those that are chosen meanwhile the last one.
  look(time) {
    if (this.asked !== null) {
      this.next = time;
      return;
    }
    this.asked = this.jumps;
    this.connection.send({ do: 'look', t_s: Math.min(time, this.endTime) });
  }

  answered() {
    const { next } = this;
    this.asked = null;
    this.next = null;
    if (next !== null) this.look(next);
  }

  toEnd() {
    this.next = null;
    this.look(this.endTime);
    this.connection.send({ do: 'live' });
  }

  show(state) {
    const { bar, t } = state;
    this.endTime = bar.end_s;
    this.jumps = bar.jumps;
    if (this.asked !== null && bar.jumps !== this.asked) this.answered();
    this.bar.max = bar.end_s;
    if (!bar.looking) this.bar.value = bar.end_s;
    const past = `${t.toFixed(3)} s of ${bar.end_s.toFixed(3)} s${bar.on_the_way ? ' …' : ''}`;
    this.text.textContent = bar.looking ? past : 'live';
    this.live.disabled = !bar.looking;
    this.end.disabled = !bar.looking;
    document.body.dataset.looking = bar.looking ? 'yes' : 'no';
  }
}
