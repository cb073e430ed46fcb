// The bar with the time: play, speed, slider, joints.
class TimeBar {
  constructor(parent, run, timeline, selection) {
    Object.assign(this, { timeline });
    this.playButton = element(parent, 'button', 'play');
    element(this.playButton, 'span', 'glyph');  // drawn by the style, because not every font has it
    this.playButton.addEventListener('click', () => (timeline.playing ? timeline.stop() : timeline.play()));
    this.slider = element(parent, 'input', 'slider');
    Object.assign(this.slider, { type: 'range', min: 0, max: kSliderSteps, step: 1, id: 'slider', title: 'time' });
    this.slider.addEventListener('input', () => this.slide());
    this.text = element(parent, 'output', 'time');
    this.speed = element(parent, 'input', 'speed');
    Object.assign(this.speed, { type: 'number', min: 0.0001, step: 'any', value: 0.25, title: 'times the real time' });
    this.speed.addEventListener('input', () => this.setSpeed());
    element(parent, 'span').textContent = '× real time';
    const all = element(parent, 'button', 'all');
    all.textContent = 'whole run';
    all.addEventListener('click', () => timeline.showAll());
    this.addJoints(element(parent, 'span', 'joints'), run, selection);
    timeline.listen(() => this.show());
    this.setSpeed();
    this.show();
  }

  addJoints(parent, run, selection) {
    const chips = run.reference.map((_, joint) => {
      const chip = element(parent, 'button', 'joint');
      chip.textContent = `J${joint + 1}`;
      chip.title = 'alone; with shift: more or fewer';
      chip.style.borderColor = kJointColors[joint];
      chip.addEventListener('click', (event) => selection.choose(joint, event.shiftKey));
      return chip;
    });
    const show = () => chips.forEach((chip, joint) => chip.classList.toggle('off', !selection.joints[joint]));
    selection.listen(show);
  }

  setSpeed() {
    const speed = Number(this.speed.value);
    if (speed > 0) this.timeline.speed = speed;
  }

  slide() {
    const [from, to] = this.timeline.window;
    this.timeline.setTime(from + (Number(this.slider.value) / kSliderSteps) * (to - from));
  }

  show() {
    const [from, to] = this.timeline.window;
    this.slider.value = Math.round(((this.timeline.time - from) / (to - from)) * kSliderSteps);
    this.text.textContent = secondsText(this.timeline.time);
    this.playButton.classList.toggle('playing', this.timeline.playing);
    this.playButton.title = this.timeline.playing ? 'stop (space)' : 'play (space)';
  }
}

const kSliderSteps = 10000;
