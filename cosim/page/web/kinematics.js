// Forward kinematics of an arm: the frames of its links from the joint angles. Matrices are arrays of 16 numbers,
// column by column, as three.js has them.

const kRadPerDeg = Math.PI / 180;

function multiply(a, b) {
  const c = new Array(16);
  for (let column = 0; column < 4; column += 1) {
    for (let row = 0; row < 4; row += 1) {
      let sum = 0;
      for (let k = 0; k < 4; k += 1) sum += a[4 * k + row] * b[4 * column + k];
      c[4 * column + row] = sum;
    }
  }
  return c;
}

// The turn of a joint about z. `link`: Denavit-Hartenberg parameters.
function jointMatrix(link, jointDeg) {
  const theta = (link.sign * jointDeg + link.offset_deg) * kRadPerDeg;
  const [c, s] = [Math.cos(theta), Math.sin(theta)];
  return [c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
}

// From the turned joint to the frame at the end of the link.
function linkMatrix(link) {
  const alpha = link.alpha_deg * kRadPerDeg;
  const [c, s] = [Math.cos(alpha), Math.sin(alpha)];
  return [1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, link.a_mm, 0, link.d_mm, 1];
}

// A shift, after rotations about the fixed axes x, then y, then z.
function poseMatrix(pose) {
  const [r, p, y] = pose.rpy_deg.map((angle) => angle * kRadPerDeg);
  const [cr, sr, cp, sp, cy, sy] = [Math.cos(r), Math.sin(r), Math.cos(p), Math.sin(p), Math.cos(y), Math.sin(y)];
  return [
    cy * cp, sy * cp, -sp, 0,
    cy * sp * sr - sy * cr, sy * sp * sr + cy * cr, cp * sr, 0,
    cy * sp * cr + sy * sr, sy * sp * cr - cy * sr, cp * cr, 0,
    ...pose.xyz_mm, 1,
  ];
}

class Kinematics {
  // `arm`: the key `arm` of summary.json.
  constructor(arm) {
    this.links = arm.links;
    this.tool = poseMatrix(arm.tool);
  }

  // The frame of each link in the base: z is the axis of its joint, and x is the direction in which it continues. The
  // last one is the flange, to which the tool belongs.
  linkFrames(jointsDeg) {
    const frames = [];
    let frame = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    this.links.forEach((link, i) => {
      frames.push(multiply(frame, jointMatrix(link, jointsDeg[i])));
      frame = multiply(frames[i], linkMatrix(link));
    });
    frames.push(frame);
    return frames;
  }

  // Position of the tool centre point [mm].
  toolPoint(jointsDeg) {
    const frames = this.linkFrames(jointsDeg);
    return multiply(frames[frames.length - 1], this.tool).slice(12, 15);
  }
}
