// Vectors, matrices and the walls of the room. Matrices have their sixteen numbers column by column, as the engine has them.
const V = {
  add: (a, b) => a.map((x, i) => x + b[i]),
  less: (a, b) => a.map((x, i) => x - b[i]),
  times: (a, s) => a.map(x => x * s),
  dot: (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0),
  cross: (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]],
  length: a => Math.sqrt(V.dot(a, a)),
  unit: a => V.times(a, 1 / V.length(a)),
};

function product(a, b) {
  const c = new Float64Array(16);
  for (let column = 0; column < 4; ++column)
    for (let row = 0; row < 4; ++row)
      for (let k = 0; k < 4; ++k) c[4 * column + row] += a[4 * k + row] * b[4 * column + k];
  return c;
}

const transformed = (a, v) => [0, 1, 2, 3].map(row => a[row] * v[0] + a[4 + row] * v[1] + a[8 + row] * v[2] + a[12 + row] * v[3]);

// The inverse of a Lorentz transform: g A^T g.
function inverse(a) {
  const b = new Float64Array(16);
  for (let column = 0; column < 4; ++column)
    for (let row = 0; row < 4; ++row)
      b[4 * column + row] = a[4 * row + column] * ((row === 0) === (column === 0) ? 1 : -1);
  return b;
}

// The boost to a frame that moves with gamma beta = u.
function boost(u) {
  const gamma = Math.sqrt(1 + V.dot(u, u)), b = new Float64Array(16);
  b[0] = gamma;
  for (let i = 0; i < 3; ++i) {
    b[1 + i] = b[4 * (1 + i)] = u[i];
    for (let j = 0; j < 3; ++j) b[4 * (1 + j) + 1 + i] = (i === j ? 1 : 0) + (u[i] * u[j]) / (gamma + 1);
  }
  return b;
}

// A rotation with these three columns, as a transform of events.
function rotation(x, y, z) {
  const r = new Float64Array(16);
  r[0] = 1;
  [x, y, z].forEach((axis, i) => r.set(axis, 4 * (1 + i) + 1));
  return r;
}

// The transform aFromB nearest to what mixing two left: a boost by its u, after the rotation that is left.
function nearestLorentz(mixed) {
  const u = Array.from(mixed.slice(1, 4));
  const rest = product(inverse(boost(u)), mixed);
  const x = V.unit(Array.from(rest.slice(5, 8)));
  let y = Array.from(rest.slice(9, 12));
  y = V.unit(V.less(y, V.times(x, V.dot(x, y))));
  return product(boost(u), rotation(x, y, V.cross(x, y)));
}

const kNear_m = 0.03, kFar_m = 5000, kNearestToWall_m = 1e-3;

function frustum(left, right, bottom, top) {
  const m = new Float64Array(16);
  m[0] = (2 * kNear_m) / (right - left);
  m[5] = (2 * kNear_m) / (top - bottom);
  m[8] = (right + left) / (right - left);
  m[9] = (top + bottom) / (top - bottom);
  m[10] = -(kFar_m + kNear_m) / (kFar_m - kNear_m);
  m[11] = -1;
  m[14] = (-2 * kFar_m * kNear_m) / (kFar_m - kNear_m);
  return m;
}

// Takes axes right, up and towards the eye to those of the room, the other way round.
function toAxes(right, up, towards) {
  const m = new Float64Array(16);
  [right, up, towards].forEach((axis, row) => axis.forEach((value, i) => { m[4 * i + row] = value; }));
  m[15] = 1;
  return m;
}

function moved(m, by) {
  const shift = new Float64Array(16);
  shift[0] = shift[5] = shift[10] = shift[15] = 1;
  shift.set(by, 12);
  return product(m, shift);
}

// The projection of a wall for an eye of the room (Kooima, 2009); null from behind it. Places are given from where
// seen places are counted.
function clipOfWall(wall, eye) {
  const at = Array.from(eye.inRoom);
  const across = V.less(wall.lowerRight_m, wall.lowerLeft_m), upwards = V.less(wall.upperLeft_m, wall.lowerLeft_m);
  const right = V.unit(across), normal = V.unit(V.cross(across, upwards)), up = V.cross(normal, right);
  const corner = V.less(wall.lowerLeft_m, at), distance = -V.dot(normal, corner);
  if (!(distance >= kNearestToWall_m)) return null;
  const scale = kNear_m / distance;
  const clip = frustum(V.dot(right, corner) * scale, V.dot(right, V.less(wall.lowerRight_m, at)) * scale,
    V.dot(up, corner) * scale, V.dot(up, V.less(wall.upperLeft_m, at)) * scale);
  return moved(product(clip, toAxes(right, up, normal)), V.less(Array.from(eye.seenFrom), at));
}

// The projection of a picture without a wall: a way to look (radians, from straight ahead), and the half of its height as a
// tangent.
function clipOfLook(axes, look, aspect) {
  const { right, up, forward } = axes;
  const level = V.add(V.times(forward, Math.cos(look.turn)), V.times(right, Math.sin(look.turn)));
  const ahead = V.add(V.times(level, Math.cos(look.raise)), V.times(up, Math.sin(look.raise)));
  const side = V.unit(V.cross(level, up)), over = V.cross(side, ahead);
  const high = kNear_m * look.half, wide = high * aspect;
  return product(frustum(-wide, wide, -high, high), toAxes(side, over, V.times(ahead, -1)));
}

// The columns of a wall from one to another as a wall of its own.
function columnsOf(wall, from, to) {
  const along = V.times(V.less(wall.lowerRight_m, wall.lowerLeft_m), 1 / wall.pixels[0]);
  const shifted = (corner, by) => V.add(corner, V.times(along, by));
  return { ...wall, lowerLeft_m: shifted(wall.lowerLeft_m, from), upperLeft_m: shifted(wall.upperLeft_m, from),
    lowerRight_m: shifted(wall.lowerLeft_m, to), pixels: [to - from, wall.pixels[1]] };
}
