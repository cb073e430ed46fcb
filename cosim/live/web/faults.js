// Faults by a click: the kinds, keys and ranges are those that the program names.
class Faults {
  constructor(parent, kinds, connection) {
    Object.assign(this, { kinds, connection });
    const box = panel(parent, 'faults', 'Faults');
    const line = element(box, 'div', 'keys');
    this.choice = element(line, 'select');
    this.choice.title = 'kind of the fault';
    for (const { kind } of kinds) element(this.choice, 'option').textContent = kind;
    this.choice.addEventListener('change', () => this.list());
    button(line, 'Cause', 'the fault begins now', () => this.cause()).id = 'cause';
    this.text = element(box, 'p');
    this.keys = element(box, 'div');
    this.list();
  }

  get chosen() {
    return this.kinds[this.choice.selectedIndex];
  }

  choose(kind) {
    this.choice.value = kind;
    this.list();
  }

  list() {
    this.text.textContent = `${this.chosen.text}.`;
    this.keys.replaceChildren();
    this.fields = this.chosen.keys.map((key) => this.addField(key));
  }

  addField(key) {
    const line = element(this.keys, 'label');
    line.title = key.text;
    element(line, 'span').textContent = key.key.replaceAll('_', ' ');
    const field = element(line, key.choices ? 'select' : 'input');
    if (key.choices) for (const choice of key.choices) element(field, 'option').textContent = choice;
    else {
      Object.assign(field, { type: 'number', step: key.whole ? 1 : 'any' });
      if (key.min !== null) field.min = key.min;
      if (key.max !== null) field.max = key.max;
    }
    field.value = key.value;
    element(line, 'small').textContent = key.unit;
    return field;
  }

  cause() {
    const fault = { kind: this.chosen.kind };
    this.chosen.keys.forEach((key, i) => {
      const { value } = this.fields[i];
      fault[key.key] = key.choices ? value : Number(value);
    });
    this.connection.send({ do: 'fault', fault });
  }
}
