// SPDX-License-Identifier: MIT
//
// Where the eye is: a target in the scene, a turn, a distance. Plain values; nothing is drawn here.

export type Vector = readonly [number, number, number];
/** x, y, z, w of unit length. */
export type Quaternion = readonly [number, number, number, number];

export interface Camera {
  /** Scene units; in the middle of the view. */
  target: Vector;
  /** From scene to eye. */
  turn: Quaternion;
  /** Of the eye from the target. */
  distance: number;
}

const kHalfView = (Math.PI / 180) * 14; // half of the vertical angle of view
/** At which a ball of radius 1 fills the view. */
export const kFittingDistance = 1.02 / Math.sin(kHalfView);

export function product(a: Quaternion, b: Quaternion): Quaternion {
  const [ax, ay, az, aw] = a;
  const [bx, by, bz, bw] = b;
  const q = [
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by - ax * bz + ay * bw + az * bx,
    aw * bz + ax * by - ay * bx + az * bw,
    aw * bw - ax * bx - ay * by - az * bz,
  ];
  const length = Math.hypot(...q);
  return [q[0] / length, q[1] / length, q[2] / length, q[3] / length];
}

export function turnAround(axis: Vector, angle: number): Quaternion {
  const s = Math.sin(angle / 2) / Math.hypot(...axis);
  return [axis[0] * s, axis[1] * s, axis[2] * s, Math.cos(angle / 2)];
}

/** Rows of the rotation matrix. */
export function rowsOf([x, y, z, w]: Quaternion): [Vector, Vector, Vector] {
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
    [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
    [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
  ];
}

/** The turn whose rotation matrix has these rows, an orthonormal right-handed basis. */
export function turnOfRows([a, b, c]: [Vector, Vector, Vector]): Quaternion {
  const q = [
    Math.sqrt(Math.max(0, 1 + a[0] - b[1] - c[2])) / 2,
    Math.sqrt(Math.max(0, 1 - a[0] + b[1] - c[2])) / 2,
    Math.sqrt(Math.max(0, 1 - a[0] - b[1] + c[2])) / 2,
    Math.sqrt(Math.max(0, 1 + a[0] + b[1] + c[2])) / 2,
  ];
  return product(
    [
      Math.abs(q[0]) * Math.sign(c[1] - b[2] || 1),
      Math.abs(q[1]) * Math.sign(a[2] - c[0] || 1),
      Math.abs(q[2]) * Math.sign(b[0] - a[1] || 1),
      q[3],
    ],
    [0, 0, 0, 1],
  );
}

export function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** Turned by a drag of so many radians to the right and down. */
export function orbited(camera: Camera, right: number, down: number): Camera {
  const angle = Math.hypot(right, down);
  if (angle === 0) return camera;
  return { ...camera, turn: product(turnAround([down, right, 0], angle), camera.turn) };
}

/** Turned around the line of sight, counterclockwise. */
export function rolled(camera: Camera, angle: number): Camera {
  return { ...camera, turn: product(turnAround([0, 0, 1], angle), camera.turn) };
}

/** Moved so that things go right and up by shares of the view's height. */
export function panned(camera: Camera, right: number, up: number): Camera {
  const rows = rowsOf(camera.turn);
  const height = 2 * camera.distance * Math.tan(kHalfView);
  const [x, y, z] = camera.target.map(
    (t, axis) => t - height * (right * rows[0][axis] + up * rows[1][axis]),
  );
  return { ...camera, target: [x, y, z] };
}

/** Nearer by a factor, held to what can be seen. */
export function zoomed(camera: Camera, factor: number): Camera {
  return { ...camera, distance: Math.min(60, Math.max(1e-4, camera.distance / factor)) };
}

/** [4 * column + row] */
export type Matrix = number[];

export function viewMatrix(camera: Camera): Matrix {
  const rows = rowsOf(camera.turn);
  const moved = rows.map((row) => -dot(row, camera.target));
  const matrix = new Array<number>(16).fill(0);
  for (let r = 0; r < 3; ++r) {
    for (let c = 0; c < 3; ++c) matrix[4 * c + r] = rows[r][c];
    matrix[12 + r] = moved[r] - (r === 2 ? camera.distance : 0);
  }
  matrix[15] = 1;
  return matrix;
}

/** How much of the scene the depth buffer holds, around the target. */
export function depthRange(camera: Camera, reach: number): [number, number] {
  const away = camera.distance;
  const far = away + reach;
  return [Math.max(away - reach, far / 2000), far];
}

/** @param shift  of the middle to the right, in half widths of the view. */
export function projectionMatrix(
  camera: Camera,
  aspect: number,
  isOrthographic: boolean,
  [near, far]: [number, number],
  shift: number,
): Matrix {
  const matrix = new Array<number>(16).fill(0);
  const height = Math.tan(kHalfView);
  if (isOrthographic) {
    const half = camera.distance * height;
    matrix[0] = 1 / (half * aspect);
    matrix[5] = 1 / half;
    matrix[10] = -2 / (far - near);
    matrix[12] = shift;
    matrix[14] = -(far + near) / (far - near);
    matrix[15] = 1;
  } else {
    matrix[0] = 1 / (height * aspect);
    matrix[5] = 1 / height;
    matrix[8] = -shift;
    matrix[10] = -(far + near) / (far - near);
    matrix[11] = -1;
    matrix[14] = (-2 * far * near) / (far - near);
  }
  return matrix;
}

const kFarBefore = 100; // everything in the scene: without perspective all of it is seen

/** What lies under a place of the view: x to the right and y up, -1..1. In the scene. */
export function rayAt(
  camera: Camera,
  aspect: number,
  isOrthographic: boolean,
  x: number,
  y: number,
): { origin: Vector; direction: Vector } {
  const half = camera.distance * Math.tan(kHalfView);
  const rows = rowsOf(camera.turn);
  const toScene = (e: readonly number[]): Vector =>
    [0, 1, 2].map(
      (axis) => e[0] * rows[0][axis] + e[1] * rows[1][axis] + e[2] * rows[2][axis],
    ) as unknown as Vector;
  const onTarget = [x * aspect * half, y * half, 0];
  const eye = isOrthographic ? [onTarget[0], onTarget[1], kFarBefore] : [0, 0, camera.distance];
  const direction = [onTarget[0] - eye[0], onTarget[1] - eye[1], -eye[2]];
  const length = Math.hypot(...direction);
  const origin = toScene(eye).map((e, axis) => e + camera.target[axis]) as unknown as Vector;
  return { origin, direction: toScene(direction.map((d) => d / length)) };
}

/** The eigenvectors of a symmetric 3 x 3 matrix, largest eigenvalue first (Jacobi rotations). */
function axesOf(matrix: number[][]): Vector[] {
  const a = matrix.map((row) => [...row]);
  const v = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  for (let sweep = 0; sweep < 30; ++sweep) {
    for (const [p, q] of [
      [0, 1],
      [0, 2],
      [1, 2],
    ]) {
      if (Math.abs(a[p][q]) < 1e-14) continue;
      const angle = Math.atan2(2 * a[p][q], a[q][q] - a[p][p]) / 2;
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      for (let k = 0; k < 3; ++k)
        [a[k][p], a[k][q]] = [c * a[k][p] - s * a[k][q], s * a[k][p] + c * a[k][q]];
      for (let k = 0; k < 3; ++k)
        [a[p][k], a[q][k]] = [c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]];
      for (let k = 0; k < 3; ++k)
        [v[k][p], v[k][q]] = [c * v[k][p] - s * v[k][q], s * v[k][p] + c * v[k][q]];
    }
  }
  return [0, 1, 2]
    .sort((i, j) => a[j][j] - a[i][i])
    .map((i) => [v[0][i], v[1][i], v[2][i]] as Vector);
}

/** The turn that shows points from their broad side, longest side across. */
export function broadSide(points: Float32Array, count: number): Quaternion {
  const sum = [
    [0, 0, 0],
    [0, 0, 0],
    [0, 0, 0],
  ];
  for (let p = 0; p < count; ++p) {
    for (let i = 0; i < 3; ++i)
      for (let j = 0; j < 3; ++j) sum[i][j] += points[4 * p + i] * points[4 * p + j];
  }
  const scale = Math.max(1e-30, sum[0][0] + sum[1][1] + sum[2][2]);
  const [x, y] = axesOf(sum.map((row) => row.map((e) => e / scale)));
  const z: Vector = [
    x[1] * y[2] - x[2] * y[1],
    x[2] * y[0] - x[0] * y[2],
    x[0] * y[1] - x[1] * y[0],
  ];
  return turnOfRows([x, y, z]);
}

/** The first look at a scene. */
export function startCamera(
  points: Float32Array,
  count: number,
  dimension: number,
  isMolecule: boolean,
): Camera {
  const target: Vector = [0, 0, 0];
  if (dimension === 2) return { target, turn: [0, 0, 0, 1], distance: 0.86 * kFittingDistance };
  let reach = 0;
  for (let p = 0; p < count; ++p)
    reach = Math.max(reach, Math.hypot(points[4 * p], points[4 * p + 1], points[4 * p + 2]));
  const distance = kFittingDistance * (reach || 1) * (isMolecule ? 1 : 0.96);
  const front = isMolecule && count > 3 ? broadSide(points, count) : ([0, 0, 0, 1] as const);
  const turned = product(turnAround([1, 0, 0], 0.32), product(turnAround([0, 1, 0], -0.42), front));
  return { target, turn: turned, distance };
}
