// Frames in the picture of the arm: those of the scenario, and the axes of the joints.

const kFrameShare = 0.09;  // length of an axis, of the reach
const kAxisColor = 0x8c959f;

// A text that always faces the viewer. `height`: of its letters, in the units of the scene.
function label(text, height) {
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('2d');
  context.font = kLabelFont;
  canvas.width = Math.ceil(context.measureText(text).width) + 8;
  canvas.height = kLabelPixels;
  context.font = kLabelFont;  // a new size of the canvas has reset it
  context.textBaseline = 'middle';
  context.fillStyle = '#656d76';
  context.fillText(text, 4, canvas.height / 2);
  const map = new THREE.CanvasTexture(canvas);
  map.minFilter = THREE.LinearFilter;
  const sprite = new THREE.Sprite(new THREE.SpriteMaterial({ map, transparent: true, depthTest: false }));
  sprite.scale.set((height * canvas.width) / canvas.height, height, 1);
  return sprite;
}

const kLabelPixels = 40;
const kLabelFont = '28px system-ui, "DejaVu Sans", sans-serif';

// The matrix of a frame [mm] in the units of the scene.
function placeAt(matrix, frame) {
  matrix.fromArray(frame);
  for (const shift of [12, 13, 14]) matrix.elements[shift] /= kMmPerUnit;
  return matrix;
}

// The groups of the links of an arm, and of its tool, at these angles.
function placeLinks(groups, kinematics, jointsDeg) {
  const frames = kinematics.linkFrames(jointsDeg);
  groups.forEach((group, i) => {
    placeAt(group.matrix, frames[i]);
    group.matrixWorldNeedsUpdate = true;
  });
}

// `frames`: the key `frames` of summary.json.
function addFrames(scene, frames, reach) {
  for (const frame of frames || []) {
    const group = new THREE.Group();
    group.matrixAutoUpdate = false;
    placeAt(group.matrix, poseMatrix(frame));
    group.add(new THREE.AxesHelper(reach * kFrameShare));
    const name = label(frame.name, reach * kFrameShare * 0.5);
    name.position.set(0, 0, -reach * kFrameShare * 0.35);
    group.add(name);
    scene.add(group);
  }
}

// The axis about which a link turns: z of its group.
function addJointAxis(group, size) {
  const points = [new THREE.Vector3(0, 0, -size), new THREE.Vector3(0, 0, size)];
  const material = new THREE.LineDashedMaterial({ color: kAxisColor, dashSize: size / 8, gapSize: size / 16 });
  group.add(new THREE.Line(new THREE.BufferGeometry().setFromPoints(points), material).computeLineDistances());
}
