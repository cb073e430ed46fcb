// The arm of the report, at the angles that come now: with a trail of the tool, a shadow that shows where it would go,
// and the other solutions of a place of the hand.
const kTrailPoints = 900;
const kShadowColor = 0xe16f24;
const kGhostColor = 0x8c959f;

class LiveArm extends ArmView {
  // `meshes`: as cosim/page/arm_meshes.cpp writes them.
  constructor(parent, arm, meshes) {
    const kinematics = arm.links ? new Kinematics(arm) : null;
    super(parent, { kinematics, meshes, summary: { arm, result: { moves: [] } } }, { listen() {} });
    if (!this.renderer) return;
    this.count = arm.axes.length;
    this.shadow = new ShadowArm(this, kShadowColor, 0.45);
    this.ghosts = [];
  }

  get keepsPicture() {
    return false;
  }

  addPaths() {
    const zero = new Array(this.run.kinematics.links.length).fill(0);
    const point = new THREE.Vector3(...this.run.kinematics.toolPoint(zero)).divideScalar(kMmPerUnit);
    this.bounds = new THREE.Box3(point.clone(), point.clone());
    this.drawn = this.bounds;
    this.trailPoints = new Float32Array(3 * kTrailPoints);
    this.trailLength = 0;
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(this.trailPoints, 3));
    geometry.setDrawRange(0, 0);
    this.trail = new THREE.Line(geometry, new THREE.LineBasicMaterial({ color: 0x0969da }));
    this.trail.frustumCulled = false;
    this.scene.add(this.trail);
    const legend = element(this.box, 'div', 'legend');
    for (const [name, color] of [['tool', '#0969da'], ['shadow', '#e16f24'], ['other solutions', '#8c959f']]) {
      const entry = element(legend, 'span');
      entry.textContent = `― ${name}`;
      entry.style.color = color;
    }
  }

  addButtons() {
    const parent = element(this.box, 'div', 'views');
    const view = (name, direction) => {
      const button = element(parent, 'button');
      button.textContent = name;
      button.title = `look at the arm: ${name}`;
      button.addEventListener('click', () => this.lookAlong(direction));
    };
    view('arm', [0.56, -0.73, 0.39]);
    view('front', [1, 0, 0.05]);
    view('side', [0, -1, 0.05]);
    view('top', [0.001, -0.001, 1]);
  }

  lookAlong(direction) {
    const zero = this.run.kinematics.linkFrames(new Array(this.run.kinematics.links.length).fill(0));
    const heights = [0, ...zero.map((frame) => frame[14] / kMmPerUnit)];
    const center = new THREE.Vector3(0, 0, (Math.min(...heights) + Math.max(...heights)) / 2);
    this.controls.target.copy(center);
    const along = new THREE.Vector3(...direction).normalize();
    this.camera.position.copy(center).addScaledVector(along, this.reach * 2.1);
    this.controls.update();
    this.render();
  }

  // The angles that the encoders show, and those of the set-points.
  show(jointsDeg, setDeg) {
    if (!this.renderer) return;
    this.joints = jointsDeg;
    this.set = setDeg;
    this.addToTrail(this.run.kinematics.toolPoint(jointsDeg));
    this.pose();
  }

  clearTrail() {
    this.trailLength = 0;
  }

  addToTrail(point) {
    const last = 3 * (this.trailLength - 1);
    const moved = this.trailLength === 0 ||
      Math.hypot(...point.map((mm, i) => mm / kMmPerUnit - this.trailPoints[last + i])) > 2e-4;
    if (!moved) return;
    if (this.trailLength === kTrailPoints) this.trailPoints.copyWithin(0, 3);
    else this.trailLength += 1;
    point.forEach((mm, i) => { this.trailPoints[3 * (this.trailLength - 1) + i] = mm / kMmPerUnit; });
    this.trail.geometry.attributes.position.needsUpdate = true;
    this.trail.geometry.setDrawRange(0, this.trailLength);
  }

  pose() {
    const { kinematics } = this.run;
    const joints = this.joints || new Array(kinematics.links.length).fill(0);
    placeLinks(this.links, kinematics, joints);
    this.target.position.set(...kinematics.toolPoint(this.set || joints)).divideScalar(kMmPerUnit);
    this.render();
  }

  lookAtArm() {
    this.lookAlong([0.56, -0.73, 0.39]);
  }

  showShadow(jointsDeg, others) {
    if (!this.renderer) return;
    this.shadow.show(jointsDeg);
    while (this.ghosts.length < others.length) this.ghosts.push(new ShadowArm(this, kGhostColor, 0.22));
    this.ghosts.forEach((ghost, i) => ghost.show(others[i] || null));
    this.render();
  }
}

// A second picture of the arm that one can look through.
class ShadowArm {
  constructor(view, color, opacity) {
    this.kinematics = view.run.kinematics;
    this.links = view.run.kinematics.links.map((link, i) => view.addLink(link, i));
    this.links.push(view.addTool());
    for (const group of this.links) {
      group.visible = false;
      group.traverse((part) => {
        if (!part.isMesh) return;
        part.material = part.material.clone();
        part.material.color.setHex(color);
        Object.assign(part.material, { transparent: true, opacity, depthWrite: false });
      });
    }
  }

  // null: not at all.
  show(jointsDeg) {
    for (const group of this.links) group.visible = jointsDeg !== null;
    if (jointsDeg) placeLinks(this.links, this.kinematics, jointsDeg);
  }
}
