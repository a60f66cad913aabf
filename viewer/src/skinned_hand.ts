// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
import type { HandSurface } from './report';

const BONES = 16;
const LINKS = 4;

/** For each bone the 3 x 4 matrix of a rotation (w, x, y, z) and a translation, row by row. */
function matricesOf(bones: Float32Array): Float64Array {
  const matrices = new Float64Array(12 * BONES);
  for (let bone = 0; bone < BONES; ++bone) {
    const [w, x, y, z, tx, ty, tz] = bones.subarray(7 * bone, 7 * bone + 7);
    matrices.set(
      [
        1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), tx,
        2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x), ty,
        2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y), tz,
      ],
      12 * bone,
    );
  }
  return matrices;
}

/** Linear blend skinning: the rest surface's vertices where a pose's bones take them. */
export function poseVertices(surface: HandSurface, bones: Float32Array, to: Float32Array): void {
  const matrices = matricesOf(bones);
  const { vertices } = surface;
  for (let v = 0; v < vertices.length / 3; ++v) {
    const [x, y, z] = [vertices[3 * v], vertices[3 * v + 1], vertices[3 * v + 2]];
    let [px, py, pz] = [0, 0, 0];
    for (let link = LINKS * v; link < LINKS * (v + 1); ++link) {
      const weight = surface.weights[link];
      if (weight === 0) continue;
      const m = 12 * surface.bones[link];
      px += weight * (matrices[m] * x + matrices[m + 1] * y + matrices[m + 2] * z + matrices[m + 3]);
      py += weight * (matrices[m + 4] * x + matrices[m + 5] * y + matrices[m + 6] * z + matrices[m + 7]);
      pz += weight * (matrices[m + 8] * x + matrices[m + 9] * y + matrices[m + 10] * z + matrices[m + 11]);
    }
    to[3 * v] = px;
    to[3 * v + 1] = py;
    to[3 * v + 2] = pz;
  }
}

/** A number a bone, as each vertex has it of the bones that it is linked to. */
export function spreadOverVertices(surface: HandSurface, byBone: number[], to: Float32Array): void {
  for (let v = 0; v < to.length; ++v) {
    let sum = 0;
    for (let link = LINKS * v; link < LINKS * (v + 1); ++link) {
      sum += surface.weights[link] * byBone[surface.bones[link]];
    }
    to[v] = sum;
  }
}
