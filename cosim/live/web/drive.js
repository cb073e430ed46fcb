// Drives, alarms, the speed of moves, and taught points.
const kResetParameter = 0x5a;
const kResetPayload = 0x0e5709;

class Drive {
  constructor(parent, count, connection) {
    Object.assign(this, { connection, count });
    this.points = [];
    const box = panel(parent, 'drive', 'Arm');
    const keys = element(box, 'div', 'keys');
    this.servo = button(keys, 'Servo on', 'switch the drives', () => this.switchServo());
    this.servo.id = 'servo';
    button(keys, 'Stop', 'brake, and drop what the arm would do', () => connection.command('stop')).id = 'stop';
    button(keys, 'Reset', 'end the emergency stop, acknowledge the alarm', () => this.reset()).id = 'reset';
    button(keys, 'Home', 'search the home position of all axes', () => connection.command('home', 2 ** count - 1));
    this.override = slider(box, 'override', 1, 100, 100, (percent) => `${percent} %`);
    this.override.id = 'override';
    this.override.title = 'share of the speed of moves and programs';
    this.override.addEventListener('change', () => connection.command('speed_override', 0, 100 * Number(this.override.value)));
    this.speed = slider(box, 'move at', 1, 100, 20, (percent) => `${percent} %`);
    this.speed.id = 'move-speed';
    this.speed.title = 'speed of moves to points, as a share of the largest';
    const head = element(box, 'div', 'points-head');
    button(head, 'Teach', 'remember where the arm is', () => this.teach()).id = 'teach';
    this.hint = element(head, 'span', 'hint');
    this.hint.textContent = 'no taught points';
    this.list = element(box, 'table', 'points');
  }

  switchServo() {
    this.connection.command('servo', this.on ? 0 : 1);
  }

  reset() {
    if (this.state === 'estop') this.connection.command('estop_reset', kResetParameter, kResetPayload);
    this.connection.command('reset_alarm');
  }

  teach() {
    if (!this.latest) return;
    this.points.push({ name: `P${this.points.length + 1}`, joints: this.latest.joints_deg, tool: this.latest.tool });
    this.hint.textContent = '';
    this.listPoints();
  }

  // MOVC goes through the point that was chosen as via.
  listPoints() {
    this.list.replaceChildren();
    for (const point of this.points) {
      const line = element(this.list, 'tr');
      element(line, 'td').textContent = point.name;
      element(line, 'td', 'place').textContent = point.joints.map((deg) => deg.toFixed(1)).join('  ');
      const keys = element(line, 'td');
      button(keys, 'MOVJ', `all joints together to ${point.name}`, () => this.moveJoints(point.joints));
      const straight = button(keys, 'MOVL', `the tool straight to ${point.name}`, () => this.moveLine(point.tool));
      straight.disabled = !point.tool;
      const arc = button(keys, 'MOVC', `the tool on an arc through the via point to ${point.name}`, () => this.moveArc(point.tool));
      arc.disabled = !point.tool || !this.via || this.via === point;
      const via = button(keys, 'via', `MOVC of the other points goes through ${point.name}`, () => this.chooseVia(point));
      via.classList.toggle('chosen', this.via === point);
      via.disabled = !point.tool;
    }
  }

  moveJoints(joints) {
    this.connection.send({ do: 'move', path: 'joints', joints_deg: joints, speed_percent: Number(this.speed.value) });
  }

  chooseVia(point) {
    this.via = this.via === point ? null : point;
    this.listPoints();
  }

  moveArc(tool) {
    const speed = Number(this.speed.value);
    this.connection.send({ do: 'move', path: 'arc', via_mm: this.via.tool.xyz_mm, ...tool, speed_percent: speed });
  }

  moveLine(tool) {
    this.connection.send({ do: 'move', path: 'line', ...tool, speed_percent: Number(this.speed.value) });
  }

  show(state) {
    this.latest = state;
    this.on = state.drives;
    this.state = state.state;
    this.servo.textContent = this.on ? 'Servo off' : 'Servo on';
    this.servo.classList.toggle('on', this.on);
  }
}
