// Sliders as in Hu 2012, Figure 4: by the angles of the joints, or by the place of the hand. They move a shadow of the
// arm; the arm itself moves when asked to, or after each change with `follow`. The program computes both directions.
const kSliderHair = 0.1;  // deg

class Hand {
  constructor(parent, hello, connection, arm, drive) {
    Object.assign(this, { connection, arm, drive });
    this.six = hello.family === 'six_r';
    const box = panel(parent, 'hand', 'Sliders');
    const text = element(box, 'p', 'hint');
    text.textContent = 'They move the orange shadow. Choose how, then let the arm follow.';
    // A target at the limit itself may be a part of a pulse beyond it.
    this.joints = hello.arm.axes.map((axis, joint) =>
      this.add(box, `J${joint + 1}`, axis.min_deg + kSliderHair, axis.max_deg - kSliderHair, '°', 0.1, () => this.fromJoints(), kJointColors[joint]));
    this.hand = hello.arm.links ? this.addHand(box, hello) : [];
    this.why = element(box, 'p', 'why');
    this.solutions = element(box, 'div', 'solutions');
    const keys = element(box, 'div', 'keys');
    button(keys, 'Go: joints', 'all joints together to the shadow (MOVJ)', () => this.go('joints')).id = 'go-joints';
    button(keys, 'Go: line', 'the tool straight to the shadow (MOVL)', () => this.go('line')).id = 'go-line';
    button(keys, 'To the arm', 'the shadow back to the arm', () => this.follow(this.latest)).id = 'to-arm';
    const label = element(keys, 'label', 'check');
    this.follows = element(label, 'input');
    Object.assign(this.follows, { type: 'checkbox', id: 'follows' });
    label.append(' arm follows');
    connection.listen('forward', (answer) => this.onForward(answer));
    connection.listen('inverse', (answer) => this.onInverse(answer));
    connection.listen('error', () => { this.asked = null; });
    this.shadow = null;
  }

  add(box, name, min, max, unit, step, act, color) {
    const input = slider(box, name, min, max, 0, (value) => `${value.toFixed(1)} ${unit}`, step);
    input.dataset.axis = name;
    input.parentElement.firstChild.style.color = color || '';
    input.addEventListener('input', act);
    input.addEventListener('change', () => { this.wants = this.follows.checked; });
    return input;
  }

  addHand(box, hello) {
    const reach = hello.arm.links.reduce((sum, link) => sum + Math.hypot(link.a_mm, link.d_mm), 0) +
      Math.hypot(...hello.arm.tool.xyz_mm);
    const far = Math.ceil(reach / 50) * 50;
    const places = ['x', 'y', 'z'].map((name) => this.add(box, name, -far, far, 'mm', 0.5, () => this.fromHand()));
    if (!this.six) return places;
    const turns = ['roll', 'pitch', 'yaw'].map((name) => this.add(box, name, -180, 180, '°', 0.1, () => this.fromHand()));
    return [...places, ...turns];
  }

  // The shadow as it is, or where the arm stands.
  get start() {
    return this.shadow || this.latest.joints_deg;
  }

  fromJoints() {
    this.why.textContent = '';
    this.listSolutions([], null);
    this.setShadow(this.joints.map((input) => Number(input.value)), []);
    this.ask({ do: 'forward', joints_deg: this.shadow });
  }

  fromHand() {
    const values = this.hand.map((input) => Number(input.value));
    const question = { do: 'inverse', xyz_mm: values.slice(0, 3), from_deg: this.start };
    if (this.six) question.rpy_deg = values.slice(3);
    this.ask(question);
  }

  // One question at a time; of those that come meanwhile the last one.
  ask(question) {
    if (this.asked) {
      this.next = question;
      return;
    }
    this.asked = question;
    this.connection.send(question);
  }

  answered() {
    this.asked = null;
    const { next } = this;
    this.next = null;
    if (next) this.ask(next);
  }

  onForward(answer) {
    this.tool = answer;
    this.setHand(answer);
    this.answered();
  }

  onInverse(answer) {
    this.why.textContent = answer.why_not ? `Not there: ${answer.why_not}.` : '';
    const chosen = answer.selected === null ? null : answer.solutions[answer.selected];
    this.listSolutions(answer.solutions, answer.selected);
    if (chosen) {
      this.tool = null;
      this.setShadow(chosen.joints_deg, this.others(answer.solutions, answer.selected));
      this.setJoints(chosen.joints_deg);
    } else {
      this.wants = false;
      if (this.shadow) this.setShadow(this.shadow, this.others(answer.solutions, null));
    }
    this.answered();
  }

  others(solutions, selected) {
    return solutions.filter((one, i) => i !== selected).map((one) => one.joints_deg);
  }

  listSolutions(solutions, selected) {
    this.solutions.replaceChildren();
    solutions.forEach((one, i) => {
      const name = ['shoulder', 'elbow', 'wrist'].map((part) => one[part]).filter(Boolean).join(', ');
      const pick = button(this.solutions, name, one.why_not || one.joints_deg.map((deg) => deg.toFixed(1)).join('  '), () => {
        this.setShadow(one.joints_deg, this.others(solutions, i));
        this.setJoints(one.joints_deg);
        this.listSolutions(solutions, i);
        this.wants = this.follows.checked;
      });
      pick.classList.toggle('chosen', i === selected);
      pick.disabled = !one.within_limits;
    });
  }

  setShadow(joints, others) {
    this.shadow = joints;
    this.arm.showShadow(joints, others);
  }

  setJoints(joints) {
    this.joints.forEach((input, i) => { input.value = joints[i]; input.show(); });
  }

  setHand(tool) {
    const values = [...tool.xyz_mm, ...tool.rpy_deg];
    this.hand.forEach((input, i) => { input.value = values[i]; input.show(); });
  }

  go(path) {
    if (!this.shadow) return;
    if (path === 'joints') this.drive.moveJoints(this.shadow);
    else if (this.tool) this.drive.moveLine(this.tool);
    else this.drive.moveLine({ xyz_mm: this.handValues(0), rpy_deg: this.handValues(3) });
  }

  handValues(first) {
    return this.hand.slice(first, first + 3).map((input) => Number(input.value));
  }

  // Back to the arm.
  follow(state) {
    this.shadow = null;
    this.tool = null;
    this.why.textContent = '';
    this.listSolutions([], null);
    this.arm.showShadow(null, []);
    if (!state) return;
    this.setJoints(state.joints_deg);
    if (state.tool) this.setHand(state.tool);
  }

  show(state) {
    this.latest = state;
    if (!this.shadow && !this.asked) {
      this.setJoints(state.joints_deg);
      if (state.tool) this.setHand(state.tool);
    }
    if (this.wants && state.state === 'ready' && this.shadow && !this.asked) {
      this.wants = false;
      this.drive.moveJoints(this.shadow);
    }
  }
}
