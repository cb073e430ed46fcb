// The shape of a path: a box around it, and the distance of a point. Lines, arcs and circles have a formula for it;
// helices and splines are searched.

const kSamplesOfTurn = 36;
const kSamplesOfCubic = 16;

const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const norm = (a) => Math.sqrt(dot(a, a));

// Around points, with a margin.
class Box {
  constructor(points, margin) {
    const corner = (extreme, side) => [0, 1, 2].map((axis) => extreme(...points.map((p) => p[axis])) + side * margin);
    this.low = corner(Math.min, -1);
    this.high = corner(Math.max, 1);
  }

  distance(point) {
    let square = 0;
    for (let axis = 0; axis < 3; axis += 1) {
      const off = Math.max(this.low[axis] - point[axis], 0, point[axis] - this.high[axis]);
      square += off * off;
    }
    return Math.sqrt(square);
  }
}

class LineShape {
  constructor(path) {
    this.start = path.start_mm;
    this.along = subtract(path.end_mm, path.start_mm);
    this.square = dot(this.along, this.along);
    this.box = new Box([path.start_mm, path.end_mm], 0);
  }

  distance(point) {
    const from = subtract(point, this.start);
    const share = this.square > 0 ? Math.min(Math.max(dot(from, this.along) / this.square, 0), 1) : 0;
    return norm([0, 1, 2].map((i) => from[i] - share * this.along[i]));
  }
}

class ArcShape {
  constructor(path) {
    this.path = path;
    this.x = subtract(path.start_mm, path.center_mm);
    this.y = cross(path.normal, this.x);
    this.box = new Box([path.center_mm], path.radius_mm);
  }

  distance(point) {
    const { center_mm: center, radius_mm: radius, normal } = this.path;
    const from = subtract(point, center);
    const [u, v] = [dot(from, this.x) / radius, dot(from, this.y) / radius];
    let angle = Math.atan2(v, u) / kRadPerDeg;
    if (angle < 0) angle += 360;
    if (angle <= this.path.angle_deg) return Math.hypot(Math.hypot(u, v) - radius, dot(from, normal));
    return Math.min(norm(subtract(point, this.path.start_mm)), norm(subtract(point, this.path.end_mm)));
  }
}

// A function that gives the point of a helix at an angle about its axis, and both derivatives by the angle.
function helixAt(path) {
  const x = subtract(path.start_mm, path.center_mm);
  const y = cross(path.normal, x);
  const rise = path.advance_mm / (path.angle_deg * kRadPerDeg);
  return (angle, out) => {
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    for (let i = 0; i < 3; i += 1) {
      const arm = c * x[i] + s * y[i];
      out[i] = path.center_mm[i] + arm + rise * angle * path.normal[i];
      out[3 + i] = c * y[i] - s * x[i] + rise * path.normal[i];
      out[6 + i] = -arm;
    }
  };
}

// The same for a spline. Its pieces are those of cosim/page/run_data.cpp, each over one unit of `u`.
function splineAt(cubics) {
  return (u, out) => {
    const piece = Math.min(Math.floor(u), cubics.length - 1);
    const t = u - piece;
    const [a, b, c, d] = cubics[piece];
    for (let i = 0; i < 3; i += 1) {
      out[i] = a[i] + t * (b[i] + t * (c[i] + t * d[i]));
      out[3 + i] = b[i] + t * (2 * c[i] + t * 3 * d[i]);
      out[6 + i] = 2 * c[i] + 6 * t * d[i];
    }
  };
}

// A curve at(u, out), which writes its point and both derivatives by u. It has pieces with the same range of u. A piece
// has samples, and a box, so that only pieces near a point are searched.
class SearchedShape {
  constructor(at, pieces, range, samples) {
    Object.assign(this, { at, range, samples, end: pieces * range, nearest: 0, place: new Float64Array(9) });
    this.pieces = Array.from({ length: pieces }, (_, piece) => this.sampled(piece));
    this.squares = new Float64Array(samples + 1);
    const corners = this.pieces.flatMap(({ box }) => [box.low, box.high]);
    this.box = new Box(corners, 0);
  }

  sampled(piece) {
    const points = Array.from({ length: this.samples + 1 }, (_, i) => {
      this.at((piece + i / this.samples) * this.range, this.place);
      return Array.from(this.place.subarray(0, 3));
    });
    const spacing = Math.max(...points.slice(1).map((point, i) => norm(subtract(point, points[i]))));
    return { points: Float64Array.from(points.flat()), spacing, box: new Box(points, spacing) };
  }

  distance(point) {
    const last = this.nearest;
    let least = this.search(last, point, Infinity);
    for (let piece = 0; piece < this.pieces.length; piece += 1) {
      if (piece === last || this.pieces[piece].box.distance(point) >= least) continue;
      const mm = this.search(piece, point, least);
      if (mm < least) [this.nearest, least] = [piece, mm];
    }
    return least;
  }

  // The distance of a point from a piece, or `least` if the piece is not nearer.
  search(piece, point, least) {
    const { points, spacing } = this.pieces[piece];
    const { squares, samples } = this;
    for (let i = 0, k = 0; i <= samples; i += 1, k += 3) {
      const [x, y, z] = [points[k] - point[0], points[k + 1] - point[1], points[k + 2] - point[2]];
      squares[i] = x * x + y * y + z * z;
    }
    for (let i = 0; i <= samples; i += 1) {
      if ((i > 0 && squares[i - 1] < squares[i]) || (i < samples && squares[i + 1] < squares[i])) continue;
      if (Math.sqrt(squares[i]) - spacing < least) least = Math.min(least, this.refined(piece + i / samples, point));
    }
    return least;
  }

  // The distance of a point from the curve between the neighbours of its nearest sample. Newton's method finds the
  // place where the curve is at a right angle to the point; it halves the range instead of leaving it.
  refined(sample, point) {
    const kMaxSteps = 40;
    const { place, range } = this;
    const step = range / this.samples;
    let u = sample * range;
    let [low, high] = [Math.max(u - step, 0), Math.min(u + step, this.end)];
    let least = Infinity;
    for (let i = 0; i < kMaxSteps; i += 1) {
      this.at(u, place);
      let [square, slope, speed, bend] = [0, 0, 0, 0];
      for (let k = 0; k < 3; k += 1) {
        const off = place[k] - point[k];
        square += off * off;
        slope += off * place[3 + k];
        speed += place[3 + k] * place[3 + k];
        bend += off * place[6 + k];
      }
      least = Math.min(least, square);
      if (slope > 0) high = u;
      else low = u;
      let next = u - slope / (speed + bend);
      if (!(next >= low && next <= high)) next = (low + high) / 2;
      if (Math.abs(next - u) < 1e-9 * range) break;
      u = next;
    }
    return Math.sqrt(least);
  }
}

function pathShape(path) {
  if (path.cubics_mm) return new SearchedShape(splineAt(path.cubics_mm), path.cubics_mm.length, 1, kSamplesOfCubic);
  if (path.radius_mm === undefined) return new LineShape(path);
  if (!path.advance_mm) return new ArcShape(path);
  const turns = Math.ceil(path.angle_deg / 360);
  return new SearchedShape(helixAt(path), turns, (path.angle_deg * kRadPerDeg) / turns, kSamplesOfTurn);
}
