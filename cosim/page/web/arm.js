// The arm in three dimensions: links at the encoder positions, and the paths of the tool. Drawn by three.js.

const kMmPerUnit = 1000;

class ArmView {
  constructor(parent, run, timeline) {
    Object.assign(this, { run, timeline });
    this.box = element(parent, 'section', 'arm');
    this.box.id = 'arm';
    if (!run.kinematics) {
      element(this.box, 'p').textContent = 'The robot file has no [kinematics], so there is no picture of the arm.';
      return;
    }
    try {
      this.renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: this.keepsPicture });
    } catch (error) {
      element(this.box, 'p').textContent = 'This browser has no WebGL, so there is no picture of the arm.';
      return;
    }
    this.renderer.setPixelRatio(window.devicePixelRatio || 1);
    this.box.appendChild(this.renderer.domElement);
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(35, 1, 0.01, 50);
    this.camera.up.set(0, 0, 1);
    this.addSurroundings();
    this.showColors();
    this.addPaths();
    this.addArm();
    addFrames(this.scene, this.run.summary.frames, this.reach);
    this.controls = new THREE.OrbitControls(this.camera, this.renderer.domElement);
    this.controls.addEventListener('change', () => this.render());
    this.addButtons();
    this.lookAtArm();
    timeline.listen((change) => change === 'time' && this.pose());
    darkRoom.addEventListener('change', () => {
      this.showColors();
      this.render();
    });
    new ResizeObserver(() => this.resize()).observe(this.box);
    this.resize();
  }

  // The picture can be saved or copied after it was drawn. That costs a copy in each frame.
  get keepsPicture() {
    return true;
  }

  addSurroundings() {
    this.floor = new THREE.GridHelper(2, 20, 0x8c959f, 0xd0d7de);
    this.floor.rotation.x = Math.PI / 2;
    this.floor.material.transparent = true;
    this.scene.add(this.floor);
    this.scene.add(new THREE.AxesHelper(0.15));
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x8c959f, 0.9));
    const sun = new THREE.DirectionalLight(0xffffff, 0.6);
    sun.position.set(1, -1, 2);
    this.scene.add(sun);
  }

  showColors() {
    this.renderer.setClearColor(pageColor('--box'));
    this.floor.material.opacity = darkRoom.matches ? 0.25 : 1;
  }

  addPaths() {
    const sides = [['set-points', 'reference', '#e16f24'], ['encoders', 'encoder', '#0969da']];
    const paths = sides.map(([, side]) => toolPath(this.run, this.run.tool[side]));
    this.bounds = new THREE.Box3();
    for (const { points } of paths.flat()) for (const point of points) this.bounds.expandByPoint(point);
    const planned = plannedBounds(this.run);
    this.drawn = planned.isEmpty() ? this.bounds : planned;
    const size = this.drawn.getSize(new THREE.Vector3()).length();
    paths.forEach((pieces, i) => pieces.forEach((piece) => this.scene.add(pathLine(piece, sides[i][2], size))));
    this.addLegend(sides, paths.flat().some(({ way }) => way));
  }

  addLegend(sides, hasWays) {
    const legend = element(this.box, 'div', 'legend');
    for (const [name, , color] of [...sides, ...(hasWays ? [['┄ ways between cuts', '', pageColor('--soft')]] : [])]) {
      const entry = element(legend, 'span');
      entry.textContent = name.startsWith('┄') ? name : `― ${name}`;
      entry.style.color = color;
    }
  }

  addArm() {
    const lengths = this.run.kinematics.links.map((link) => Math.hypot(link.a_mm, link.d_mm) / kMmPerUnit);
    this.reach = lengths.reduce((sum, size) => sum + size, 0);
    this.thickness = this.reach * 0.028;
    this.meshes = new ArmMeshes(this.run.meshes, this.run.kinematics);
    if (this.meshes.problem) element(this.box, 'p').textContent = this.meshes.problem;
    this.base = new THREE.Group();
    if (this.meshes.base) addMesh(this.base, this.meshes.base, kMetalColor);
    this.scene.add(this.base);
    this.links = this.run.kinematics.links.map((link, i) => this.addLink(link, i));
    this.links.push(this.addTool());
    this.target = new THREE.Mesh(
      new THREE.SphereBufferGeometry(this.thickness * 0.35, 16, 12), new THREE.MeshBasicMaterial({ color: 0xe16f24 }));
    this.scene.add(this.target);
  }

  // A capsule between two points, a part of a link.
  bar(group, from, to, radius, color) {
    const along = new THREE.Vector3().subVectors(to, from);
    const size = along.length();
    if (size < 1e-6) return;
    const material = surface(color);
    const mesh = new THREE.Mesh(new THREE.CylinderBufferGeometry(radius, radius, size, 24), material);
    mesh.position.copy(from).addScaledVector(along, 0.5);
    mesh.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), along.normalize());
    group.add(mesh);
    for (const at of [from, to]) {
      const end = new THREE.Mesh(new THREE.SphereBufferGeometry(radius, 24, 16), material);
      end.position.copy(at);
      group.add(end);
    }
  }

  // A flat cylinder about the axis of a joint.
  joint(group, radius) {
    const shape = new THREE.CylinderBufferGeometry(radius * 1.3, radius * 1.3, radius * 2.8, 32);
    const mesh = new THREE.Mesh(shape, surface(kMetalColor));
    mesh.rotation.x = Math.PI / 2;
    group.add(mesh);
  }

  // A link turns about z of the frame before it: it goes along z, then along x. The tool is the last one.
  addLink(link, i) {
    const group = new THREE.Group();
    group.matrixAutoUpdate = false;
    const corner = new THREE.Vector3(0, 0, link.d_mm / kMmPerUnit);
    const end = new THREE.Vector3(link.a_mm / kMmPerUnit, 0, corner.z);
    const radius = this.thickness * (1.15 - 0.11 * i);
    addJointAxis(group, radius * 4);
    if (this.meshes.links[i]) {
      addMesh(group, this.meshes.links[i], kJointColors[i]);
    } else {
      this.joint(group, radius);
      this.bar(group, new THREE.Vector3(), corner, radius, kJointColors[i]);
      this.bar(group, corner, end, radius * 0.8, kJointColors[i]);
    }
    this.scene.add(group);
    return group;
  }

  addTool() {
    const group = new THREE.Group();
    group.matrixAutoUpdate = false;
    const tip = new THREE.Vector3(...this.run.summary.arm.tool.xyz_mm).divideScalar(kMmPerUnit);
    this.bar(group, new THREE.Vector3(), tip, this.thickness * 0.25, 0x1f2328);
    group.add(new THREE.AxesHelper(this.thickness * 2.5));
    this.scene.add(group);
    return group;
  }

  pose() {
    const row = this.run.rowAt(this.timeline.time);
    placeLinks(this.links, this.run.kinematics, this.run.jointsAt(this.run.encoder, row));
    const commanded = this.run.kinematics.toolPoint(this.run.jointsAt(this.run.reference, row));
    this.target.position.set(...commanded).divideScalar(kMmPerUnit);
    this.render();
  }

  addButtons() {
    const parent = element(this.box, 'div', 'views');
    for (const [name, look] of [['arm', () => this.lookAtArm()], ['path', () => this.lookAtPath()]]) {
      const button = element(parent, 'button');
      button.textContent = name;
      button.title = `look at the ${name}`;
      button.addEventListener('click', look);
    }
  }

  // From the front and from above, at this distance.
  lookFrom(center, distance) {
    const visible = distance > this.reach / 4;  // nearer, the arm would hide the path
    for (const group of [this.base, ...this.links]) group.visible = visible;
    this.controls.target.copy(center);
    this.camera.position.copy(center).addScaledVector(new THREE.Vector3(0.56, -0.73, 0.39), distance);
    this.target.scale.setScalar(distance / this.reach / 2);
    this.controls.update();
    this.render();
  }

  lookAtArm() {
    const center = new THREE.Vector3(0, 0, this.reach * 0.3).lerp(this.bounds.getCenter(new THREE.Vector3()), 0.35);
    this.lookFrom(center, this.reach * 1.75);
  }

  lookAtPath() {
    const size = this.drawn.getSize(new THREE.Vector3()).length();
    this.lookFrom(this.drawn.getCenter(new THREE.Vector3()), Math.max(size * 1.7, 0.02));
  }

  resize() {
    const { clientWidth, clientHeight } = this.box;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.pose();
  }

  render() {
    this.renderer.render(this.scene, this.camera);
  }
}
