// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// The page's data, "tegata-report" of docs/formats.md, and the reading of it. Whatever is wrong in
// it becomes a ReportError that says where.
import { bytesOf, floatsOf, longsOf, shortsOf } from './packed';

export class ReportError extends Error {}

export interface Verdict {
  word: string;
  sentence: string;
  trusted: number;
  meanOverlap: number;
  worst: number;
}

export interface Camera {
  name: string;
  size: number[];
  focal: number[];
  center: number[];
  rotation: number[];
  translation: number[];
  /** Left, top, width and height of what the page has of the pictures. */
  window: number[];
}

export interface HandSurface {
  vertices: Float32Array;
  triangles: Uint32Array;
  bones: Uint8Array;
  weights: Float32Array;
}

export interface Hull {
  low: number[];
  high: number[];
  vertices: Uint16Array;
  triangles: Uint16Array | Uint32Array;
}

export interface Pose {
  /** For each bone a rotation (w, x, y, z) and a translation from the rest surface to the world. */
  bones: Float32Array;
  angles: number[];
  keypoints: number[][];
  support: number[];
  overlap: Map<string, number>;
}

export interface Picture {
  camera: number;
  jpeg: string;
  hand: string;
  silhouette: string;
}

export interface Frame {
  name: string;
  time: number;
  status: string;
  severity: number;
  doubts: string[];
  pose: Pose | undefined;
  hull: Hull | undefined;
  pictures: Map<number, Picture>;
}

export interface Report {
  take: string;
  hand: string;
  model: { name: string; scale: number; deviation: number | undefined };
  verdict: Verdict;
  limits: string[];
  jointNames: string[];
  boneNames: string[];
  grasp: { angles: number[]; deviations: number[] };
  cameras: Camera[];
  surface: HandSurface;
  frames: Frame[];
  iterations: number;
  termination: string;
  seconds: Map<string, number>;
}

const VERSION = 1;
const ANGLES = 20;
const BONES = 16;
const KEYPOINTS = 21;

/** A value of the data and its place in it. */
class Value {
  constructor(
    private readonly value: unknown,
    private readonly place: string,
  ) {}

  fail(expected: string): never {
    const got = JSON.stringify(this.value) ?? 'nothing';
    const short = got.length > 60 ? `${got.slice(0, 60)}…` : got;
    throw new ReportError(`${this.place || 'the data'}: got ${short}, expected ${expected}`);
  }
  has(key: string): boolean {
    return this.object()[key] !== undefined;
  }
  at(key: string): Value {
    return new Value(this.object()[key], this.place ? `${this.place}.${key}` : key);
  }
  object(): Record<string, unknown> {
    if (typeof this.value !== 'object' || this.value === null || Array.isArray(this.value)) {
      this.fail('an object');
    }
    return this.value as Record<string, unknown>;
  }
  list(count?: number): Value[] {
    if (!Array.isArray(this.value)) this.fail('a list');
    if (count !== undefined && this.value.length !== count) this.fail(`a list of ${count}`);
    return this.value.map((item, i) => new Value(item, `${this.place}[${i}]`));
  }
  number(): number {
    if (typeof this.value !== 'number') this.fail('a number');
    return this.value;
  }
  string(): string {
    if (typeof this.value !== 'string') this.fail('text');
    return this.value;
  }
  numbers(count?: number): number[] {
    return this.list(count).map((item) => item.number());
  }
  strings(count?: number): string[] {
    return this.list(count).map((item) => item.string());
  }
  numbersByName(): Map<string, number> {
    return new Map(Object.keys(this.object()).map((key) => [key, this.at(key).number()]));
  }
  packed<T extends { length: number }>(unpack: (text: string) => T, count?: number): T {
    let numbers: T;
    try {
      numbers = unpack(this.string());
    } catch (error) {
      if (error instanceof ReportError) throw error;
      return this.fail('packed numbers');
    }
    if (count !== undefined && numbers.length !== count) this.fail(`${count} packed numbers`);
    return numbers;
  }
}

function readSurface(value: Value): HandSurface {
  const vertices = value.at('vertices').packed(floatsOf);
  const count = vertices.length / 3;
  const triangles = value.at('triangles').packed(longsOf);
  const bones = value.at('bones').packed(bytesOf, 4 * count);
  const weights = value.at('weights').packed(floatsOf, 4 * count);
  if (triangles.some((index) => index >= count)) value.at('triangles').fail(`indices below ${count}`);
  if (bones.some((bone) => bone >= BONES)) value.at('bones').fail(`bones below ${BONES}`);
  return { vertices, triangles, bones, weights };
}

function readHull(value: Value): Hull {
  const vertices = value.at('vertices').packed(shortsOf);
  const unpack: (text: string) => Uint16Array | Uint32Array =
    vertices.length / 3 > 65536 ? longsOf : shortsOf;
  const triangles = value.at('triangles').packed(unpack);
  if (triangles.some((index) => index >= vertices.length / 3)) {
    value.at('triangles').fail(`indices below ${vertices.length / 3}`);
  }
  return { low: value.at('low').numbers(3), high: value.at('high').numbers(3), vertices, triangles };
}

function readPose(value: Value): Pose {
  return {
    bones: value.at('bones').packed(floatsOf, 7 * BONES),
    angles: value.at('angles').numbers(ANGLES),
    keypoints: value.at('keypoints').list(KEYPOINTS).map((point) => point.numbers(3)),
    support: value.at('support').numbers(BONES),
    overlap: value.at('overlap').numbersByName(),
  };
}

function readFrame(value: Value, cameraCount: number): Frame {
  const pictures = new Map<number, Picture>();
  for (const item of value.has('pictures') ? value.at('pictures').list() : []) {
    const camera = item.at('camera').number();
    if (!(Number.isInteger(camera) && camera >= 0 && camera < cameraCount)) {
      item.at('camera').fail('a camera of the list');
    }
    pictures.set(camera, {
      camera,
      jpeg: item.at('jpeg').string(),
      hand: item.at('hand').string(),
      silhouette: item.at('silhouette').string(),
    });
  }
  return {
    name: value.at('frame').string(),
    time: value.at('time').number(),
    status: value.at('status').string(),
    severity: value.at('severity').number(),
    doubts: value.at('doubts').strings(),
    pose: value.has('bones') ? readPose(value) : undefined,
    hull: value.has('hull') ? readHull(value.at('hull')) : undefined,
    pictures,
  };
}

function readCamera(value: Value): Camera {
  return {
    name: value.at('name').string(),
    size: value.at('size').numbers(2),
    focal: value.at('focal').numbers(2),
    center: value.at('center').numbers(2),
    rotation: value.at('rotation').numbers(4),
    translation: value.at('translation').numbers(3),
    window: value.at('window').numbers(4),
  };
}

function readVerdict(value: Value, frameCount: number): Verdict {
  const worst = value.at('worst').number();
  if (!(Number.isInteger(worst) && worst >= 0 && worst < frameCount)) {
    value.at('worst').fail(`the position of one of ${frameCount} frames`);
  }
  return {
    word: value.at('word').string(),
    sentence: value.at('sentence').string(),
    trusted: value.at('trusted').number(),
    meanOverlap: value.at('mean_overlap').number(),
    worst,
  };
}

/** Reads the data of a page. Throws ReportError. */
export function readReport(text: string): Report {
  let parsed: unknown;
  try {
    parsed = JSON.parse(text);
  } catch (error) {
    throw new ReportError(`the data is no JSON: ${(error as Error).message}`);
  }
  const root = new Value(parsed, '');
  if (root.at('format').string() !== 'tegata-report') root.at('format').fail('"tegata-report"');
  if (root.at('version').number() !== VERSION) root.at('version').fail(String(VERSION));
  const cameras = root.at('cameras').list().map(readCamera);
  const frames = root.at('frames').list().map((frame) => readFrame(frame, cameras.length));
  if (frames.length === 0) root.at('frames').fail('one frame or more');
  const model = root.at('model');
  const report = root.at('report');
  return {
    take: root.at('take').string(),
    hand: root.at('hand').string(),
    model: {
      name: model.at('name').string(),
      scale: model.at('scale').number(),
      deviation: model.has('scale_standard_deviation')
        ? model.at('scale_standard_deviation').number()
        : undefined,
    },
    verdict: readVerdict(root.at('verdict'), frames.length),
    limits: root.at('limits').strings(),
    jointNames: root.at('joint_names').strings(ANGLES),
    boneNames: root.at('bone_names').strings(BONES),
    grasp: {
      angles: root.at('grasp').at('angles').numbers(ANGLES),
      deviations: root.at('grasp').at('standard_deviations').numbers(ANGLES),
    },
    cameras,
    surface: readSurface(root.at('hand_surface')),
    frames,
    iterations: report.at('iterations').number(),
    termination: report.at('termination').string(),
    seconds: report.at('seconds').numbersByName(),
  };
}

/** "thumb_cmc_abduction" as people read it: "thumb CMC abduction". */
export function spoken(name: string): string {
  const joints = ['cmc', 'mcp', 'pip', 'dip', 'ip'];
  return name
    .split('_')
    .map((word) => (joints.includes(word) ? word.toUpperCase() : word))
    .join(' ');
}

/** The least overlap of the fitted hand with a silhouette, or nothing. */
export function leastOverlap(frame: Frame): number | undefined {
  const overlaps = frame.pose ? [...frame.pose.overlap.values()] : [];
  return overlaps.length > 0 ? Math.min(...overlaps) : undefined;
}
