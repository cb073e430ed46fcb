// Programs: load, run, hold, step, breakpoints; the line that the arm executes.
class Program {
  constructor(parent, programs, connection) {
    Object.assign(this, { connection });
    this.programs = programs.slice();
    const box = panel(parent, 'program', 'Program');
    const line = element(box, 'div', 'keys');
    this.choice = element(line, 'select');
    this.choice.title = 'program';
    this.choice.addEventListener('change', () => this.list());
    this.file = element(line, 'input');
    Object.assign(this.file, { type: 'file', accept: '.jbi,.ngc,.nc,.gcode', hidden: true });
    this.file.addEventListener('change', () => this.open());
    button(line, 'Open…', 'a .jbi, .ngc, .nc or .gcode file of this computer', () => this.file.click());
    button(line, 'Load', 'send it to the controller over the serial line', () => this.load()).id = 'load';
    const keys = element(box, 'div', 'keys');
    const start = (mode) => () => connection.send({ do: 'run', mode, line: 0 });
    button(keys, 'Run', 'run the program', start(0)).id = 'run';
    button(keys, 'Step', 'run one line', () => (this.held ? connection.command('step') : start(1)())).id = 'step';
    button(keys, 'Hold', 'brake on the path', () => connection.command('hold')).id = 'hold';
    button(keys, 'Resume', 'continue', () => connection.command('resume')).id = 'resume';
    button(keys, 'Abort', 'end the program', () => connection.command('abort')).id = 'abort';
    this.status = element(box, 'p', 'hint');
    this.listing = element(box, 'ol', 'listing');
    this.fillChoice();
  }

  fillChoice() {
    this.choice.replaceChildren();
    for (const { name } of this.programs) element(this.choice, 'option').textContent = name;
    this.choice.selectedIndex = this.programs.length - 1;
    this.list();
  }

  get chosen() {
    return this.programs[this.choice.selectedIndex];
  }

  async open() {
    const [file] = this.file.files;
    if (!file) return;
    this.programs.push({ name: file.name, text: await file.text() });
    this.file.value = '';
    this.fillChoice();
  }

  load() {
    if (this.chosen) this.connection.send({ do: 'load', name: this.chosen.name, text: this.chosen.text });
  }

  list() {
    this.listing.replaceChildren();
    this.lines = (this.chosen ? this.chosen.text.replace(/\n$/, '').split(/\r?\n/) : []).map((text, i) => {
      const line = element(this.listing, 'li');
      line.textContent = text;
      line.title = 'click: breakpoint';
      line.addEventListener('click', () => this.connection.send({ do: 'breakpoint', line: i + 1 }));
      return line;
    });
    this.shown = 0;
  }

  show(state) {
    const { program } = state;
    this.held = state.state === 'hold';
    const name = program.name || 'none was sent';
    this.status.textContent = `controller: ${name}${program.loading ? ', loading' : ''}, ${program.state}`;
    const here = this.chosen && program.name === this.chosen.name;
    const current = here ? program.line : 0;
    if (current !== this.shown) {
      this.lines.forEach((line, i) => line.classList.toggle('current', i + 1 === current));
      if (this.lines[current - 1]) {
        this.listing.scrollTop = this.lines[current - 1].offsetTop - this.listing.offsetTop - this.listing.clientHeight / 2;
      }
      this.shown = current;
    }
    const stops = here ? program.breakpoints : [];
    this.lines.forEach((line, i) => line.classList.toggle('stop', stops.includes(i + 1)));
  }
}
