// The shapes of the parts of the arm, as cosim/page/arm_meshes.cpp writes them.

const kMetalColor = 0x6e7781;  // of base and joints

class ArmMeshes {
  // `meshes`: null if the robot has none. A file gives each part as the arm stands with all joints at 0.
  constructor(meshes, kinematics) {
    this.problem = meshes ? meshes.problem : '';
    const zero = kinematics.linkFrames(new Array(kinematics.links.length).fill(0));
    this.base = meshes && meshes.base ? meshGeometry(meshes.base) : null;
    this.links = kinematics.links.map((link, i) => {
      const mesh = meshes && meshes.links[i];
      return mesh ? meshGeometry(mesh).applyMatrix(linkFromBase(zero[i])) : null;
    });
  }
}

// Corners in the units of the scene.
function meshGeometry(mesh) {
  const axes = [mesh.x, mesh.y, mesh.z].map(decodeColumn);
  const corners = new Float32Array(3 * mesh.x.rows);
  axes.forEach((values, axis) => values.forEach((mm, i) => { corners[3 * i + axis] = mm / kMmPerUnit; }));
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(corners, 3));
  geometry.setIndex(new THREE.BufferAttribute(Uint32Array.from(decodeIntegers(mesh.triangles)), 1));
  return geometry;
}

// From the base to a link whose frame is this one [mm].
function linkFromBase(frame) {
  return new THREE.Matrix4().getInverse(placeAt(new THREE.Matrix4(), frame));
}

// The material of all parts of an arm.
function surface(color, more = {}) {
  return new THREE.MeshStandardMaterial({ color, roughness: 0.6, metalness: 0.1, ...more });
}

function addMesh(group, geometry, color) {
  group.add(new THREE.Mesh(geometry, surface(color, { flatShading: true, side: THREE.DoubleSide })));
}
