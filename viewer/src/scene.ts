// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// The fitted hand, its visual hull and the cameras in three dimensions, drawn when something
// changes. World coordinates are the result's.
import * as THREE from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { colour, pixelRatio } from './element';
import type { Camera, Frame, Hull, Report } from './report';
import { poseVertices, spreadOverVertices } from './skinned_hand';

const HULLS_KEPT = 64;
const CAMERA_SIZE = 0.07; // of the drawn pyramids [m]
/** Without a GPU a moving picture has so many of the screen's pixels in width, a still one all. */
const COARSE = 0.4;
const STILL_AFTER = 160; // [ms]
const GLASS = { transparent: true, opacity: 0.28, depthWrite: false };

/** From a camera's axes as three.js has them (y up, looking along -z) to the world. */
function worldFromCamera(camera: Camera): THREE.Matrix4 {
  const [w, x, y, z] = camera.rotation;
  const cameraFromWorld = new THREE.Matrix4().compose(
    new THREE.Vector3(...(camera.translation as [number, number, number])),
    new THREE.Quaternion(x, y, z, w),
    new THREE.Vector3(1, 1, 1),
  );
  return cameraFromWorld.invert().multiply(new THREE.Matrix4().makeScale(1, -1, -1));
}

/** The pyramid that a camera sees, and a tick on its upper side. */
function cameraLines(camera: Camera): THREE.Vector3[] {
  const matrix = worldFromCamera(camera);
  const at = (u: number, v: number) =>
    new THREE.Vector3(
      ((u - camera.center[0]) / camera.focal[0]) * CAMERA_SIZE,
      (-(v - camera.center[1]) / camera.focal[1]) * CAMERA_SIZE,
      -CAMERA_SIZE,
    ).applyMatrix4(matrix);
  const [w, h] = camera.size;
  const eye = new THREE.Vector3().setFromMatrixPosition(matrix);
  const corners = [at(0, 0), at(w, 0), at(w, h), at(0, h)];
  const tip = at(w / 2, -h / 4);
  const lines = corners.flatMap((corner, i) => [eye, corner, corner, corners[(i + 1) % 4]]);
  return [...lines, corners[0], tip, tip, corners[1]];
}

function label(text: string, ink: string): THREE.Sprite {
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('2d') as CanvasRenderingContext2D;
  const font = '600 40px system-ui, sans-serif';
  context.font = font;
  canvas.width = Math.ceil(context.measureText(text).width) + 16;
  canvas.height = 56;
  context.font = font;
  context.fillStyle = ink;
  context.textBaseline = 'middle';
  context.fillText(text, 8, 28);
  const texture = new THREE.CanvasTexture(canvas);
  texture.colorSpace = THREE.SRGBColorSpace;
  const sprite = new THREE.Sprite(
    new THREE.SpriteMaterial({ map: texture, depthTest: false, sizeAttenuation: false }),
  );
  const height = 0.028;
  sprite.scale.set((height * canvas.width) / canvas.height, height, 1);
  return sprite;
}

/** Whether the browser's 3D pictures are computed without a GPU. */
function hasNoGpu(): boolean {
  const context = document.createElement('canvas').getContext('webgl2');
  const names = context?.getExtension('WEBGL_debug_renderer_info');
  const name = context?.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : context.RENDERER);
  context?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(String(name));
}

export class HandScene {
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: THREE.WebGLRenderer;
  private readonly scene = new THREE.Scene();
  private readonly free = new THREE.PerspectiveCamera(30, 1, 0.01, 20);
  private readonly fixed = new THREE.Camera();
  private readonly controls: OrbitControls;
  private readonly hand: THREE.Mesh<THREE.BufferGeometry, THREE.MeshLambertMaterial>;
  private readonly hull: THREE.Mesh;
  private readonly hullShaded = new THREE.MeshLambertMaterial({ ...GLASS, flatShading: true });
  /** Much cheaper without a GPU, and through glass hardly another picture while it moves. */
  private readonly hullPlain = new THREE.MeshBasicMaterial(GLASS);
  private readonly cameras = new THREE.Group();
  private readonly hulls = new Map<number, THREE.BufferGeometry | undefined>();
  private readonly support: Float32Array;
  private lookingThrough: Camera | undefined;
  private readonly isSlow = hasNoGpu();
  private readonly seen = new THREE.Color();
  private readonly unseen = new THREE.Color();
  private isStale = false;
  private drawnAt = -Infinity;
  private still: number | undefined;
  private width = 0;
  private height = 0;
  private shown: Frame;
  /** Called when the user turns the view. */
  onTurn: () => void = () => {};

  /** Throws where the browser has no WebGL. */
  constructor(private readonly report: Report) {
    this.renderer = new THREE.WebGLRenderer({
      antialias: !this.isSlow, alpha: true, preserveDrawingBuffer: true,
    });
    this.canvas = this.renderer.domElement;
    this.shown = report.frames[0];

    const geometry = new THREE.BufferGeometry();
    const vertexCount = report.surface.vertices.length / 3;
    this.support = new Float32Array(vertexCount);
    geometry.setIndex(new THREE.BufferAttribute(report.surface.triangles, 1));
    geometry.setAttribute('position', new THREE.BufferAttribute(report.surface.vertices.slice(), 3));
    geometry.setAttribute('color', new THREE.BufferAttribute(new Float32Array(3 * vertexCount), 3));
    this.hand = new THREE.Mesh(
      geometry,
      new THREE.MeshLambertMaterial({ vertexColors: true }),
    );
    this.hull = new THREE.Mesh(new THREE.BufferGeometry(), this.hullShaded);
    this.hull.renderOrder = 1;
    // Their vertices are replaced with each frame, and they are always in view.
    this.hand.frustumCulled = this.hull.frustumCulled = false;
    this.scene.add(this.hand, this.hull, this.cameras, new THREE.HemisphereLight(0xffffff, 0x555566, 1.6));
    const lamp = new THREE.DirectionalLight(0xffffff, 2.2);
    lamp.position.set(-0.4, 0.7, 1);
    this.free.add(lamp, lamp.target);
    lamp.target.position.set(0, 0, -1);
    this.scene.add(this.free);
    this.fixed.matrixAutoUpdate = false;

    this.free.up.copy(this.upwards());
    this.controls = new OrbitControls(this.free, this.canvas);
    this.controls.enableDamping = false;
    this.controls.addEventListener('change', () => this.draw());
    this.controls.addEventListener('start', () => {
      this.look(undefined);
      this.onTurn();
    });
    this.applyLook();
    this.reset();
  }

  show(index: number): void {
    this.shown = this.report.frames[index];
    const { pose } = this.shown;
    this.hand.visible = pose !== undefined;
    if (pose) {
      const position = this.hand.geometry.getAttribute('position') as THREE.BufferAttribute;
      poseVertices(this.report.surface, pose.bones, position.array as Float32Array);
      position.needsUpdate = true;
      this.hand.geometry.computeVertexNormals();
      this.paintSupport();
    }
    const hull = this.hullGeometry(index);
    if (hull) this.hull.geometry = hull;
    this.hull.userData['isThere'] = hull !== undefined;
    this.hull.visible = hull !== undefined && this.hull.userData['isWanted'] !== false;
    this.render();
  }

  showHull(isWanted: boolean): void {
    this.hull.userData['isWanted'] = isWanted;
    this.hull.visible = isWanted && this.hull.userData['isThere'] === true;
    this.draw();
  }
  showCameras(isWanted: boolean): void {
    this.cameras.visible = isWanted;
    this.draw();
  }

  /** Through a camera of the recording, without its lens distortion; or freely again. */
  look(through: Camera | undefined): void {
    this.lookingThrough = through;
    this.canvas.dataset['through'] = through?.name ?? '';
    this.project();
    this.draw();
  }

  /** Back to where the hand is seen well, from between the cameras. */
  reset(): void {
    const points = this.report.frames.flatMap((frame) => frame.pose?.keypoints ?? []);
    const box = new THREE.Box3();
    for (const [x, y, z] of points) box.expandByPoint(new THREE.Vector3(x, y, z));
    const center = box.isEmpty() ? new THREE.Vector3() : box.getCenter(new THREE.Vector3());
    const radius = box.isEmpty() ? 0.1 : Math.max(0.08, box.getSize(new THREE.Vector3()).length() / 2);
    const towards = new THREE.Vector3();
    for (const camera of this.report.cameras) {
      const eye = new THREE.Vector3().setFromMatrixPosition(worldFromCamera(camera));
      towards.add(eye.sub(center).normalize());
    }
    // Cameras all around cancel out, and without cameras any direction is as good.
    if (towards.length() < 0.1) towards.set(0.3, -0.3, -1);
    this.free.position.copy(center).addScaledVector(towards.normalize(), 3.5 * radius);
    this.controls.target.copy(center);
    this.controls.update();
    this.look(undefined);
  }

  resize(width: number, height: number): void {
    [this.width, this.height] = [width, height];
    this.project();
    this.render();
  }

  applyLook(): void {
    for (const material of [this.hullShaded, this.hullPlain]) material.color.set(colour('--hull'));
    this.seen.set(colour('--skin'));
    this.unseen.set(colour('--unseen'));
    this.cameras.clear();
    const ink = colour('--soft');
    const lines = new THREE.BufferGeometry().setFromPoints(this.report.cameras.flatMap(cameraLines));
    this.cameras.add(new THREE.LineSegments(lines, new THREE.LineBasicMaterial({ color: ink })));
    for (const camera of this.report.cameras) {
      const name = label(camera.name, ink);
      name.position.setFromMatrixPosition(worldFromCamera(camera));
      name.position.addScaledVector(this.free.up, 0.05);
      this.cameras.add(name);
    }
    this.paintSupport();
    this.draw();
  }

  /** Soon, and once for all changes until then; the canvas names its frame when all are drawn. */
  private draw(): void {
    delete this.canvas.dataset['frame'];
    if (this.isStale) return;
    this.isStale = true;
    requestAnimationFrame(() => {
      if (this.isStale) this.render();
    });
  }

  /** Now. A canvas that will soon be drawn with more pixels says that it is coarse. */
  private render(isStill = false): void {
    this.isStale = false;
    clearTimeout(this.still);
    if (this.width === 0) return;
    const isCoarse = this.isSlow && !isStill && performance.now() - this.drawnAt < STILL_AFTER;
    this.drawnAt = performance.now();
    if (isCoarse) this.still = window.setTimeout(() => this.render(true), STILL_AFTER);
    this.hull.material = isCoarse ? this.hullPlain : this.hullShaded;
    this.setPixelRatio(isCoarse ? COARSE : pixelRatio());
    this.renderer.render(this.scene, this.lookingThrough ? this.fixed : this.free);
    this.canvas.toggleAttribute('data-coarse', isCoarse);
    this.canvas.dataset['frame'] = this.shown.name;
  }

  /** Of the canvas; to set its size clears it, even to what it is. */
  private setPixelRatio(ratio: number): void {
    const { canvas, width, height } = this;
    if (canvas.width === Math.floor(width * ratio) && canvas.height === Math.floor(height * ratio)) return;
    this.renderer.setDrawingBufferSize(width, height, ratio);
  }

  /** Against where the cameras think is down, on the average; y points down without any. */
  private upwards(): THREE.Vector3 {
    const up = new THREE.Vector3();
    for (const camera of this.report.cameras) {
      up.add(new THREE.Vector3().setFromMatrixColumn(worldFromCamera(camera), 1));
    }
    return up.length() < 0.1 ? new THREE.Vector3(0, -1, 0) : up.normalize();
  }

  private project(): void {
    this.free.aspect = this.width / this.height;
    // The hand must fit into a narrow view as well.
    this.free.zoom = Math.min(1, this.free.aspect);
    this.free.updateProjectionMatrix();
    const camera = this.lookingThrough;
    if (!camera) return;
    // The whole picture in the middle of the view, as large as it fits.
    const [w, h] = camera.size;
    const scale = Math.min(this.width / w, this.height / h);
    const [near, far] = [0.01, 20];
    const x = (pixel: number) => ((pixel - camera.center[0]) / camera.focal[0]) * near;
    const y = (pixel: number) => (-(pixel - camera.center[1]) / camera.focal[1]) * near;
    const [middleX, middleY] = [(w - 1) / 2, (h - 1) / 2];
    const [halfX, halfY] = [this.width / scale / 2, this.height / scale / 2];
    this.fixed.projectionMatrix.makePerspective(
      x(middleX - halfX), x(middleX + halfX), y(middleY - halfY), y(middleY + halfY), near, far,
    );
    this.fixed.projectionMatrixInverse.copy(this.fixed.projectionMatrix).invert();
    this.fixed.matrix.copy(worldFromCamera(camera));
    this.fixed.matrixWorldNeedsUpdate = true;
    this.fixed.updateMatrixWorld();
  }

  /** Skin where the pictures back the hand up, grey where they do not. */
  private paintSupport(): void {
    const { pose } = this.shown;
    if (!pose) return;
    spreadOverVertices(this.report.surface, pose.support, this.support);
    const { seen, unseen } = this;
    const attribute = this.hand.geometry.getAttribute('color') as THREE.BufferAttribute;
    const colours = attribute.array as Float32Array;
    this.support.forEach((share, v) => {
      colours[3 * v] = unseen.r + share * (seen.r - unseen.r);
      colours[3 * v + 1] = unseen.g + share * (seen.g - unseen.g);
      colours[3 * v + 2] = unseen.b + share * (seen.b - unseen.b);
    });
    attribute.needsUpdate = true;
  }

  private hullGeometry(index: number): THREE.BufferGeometry | undefined {
    if (this.hulls.has(index)) return this.hulls.get(index);
    if (this.hulls.size >= HULLS_KEPT) {
      const oldest = this.hulls.keys().next().value as number;
      this.hulls.get(oldest)?.dispose();
      this.hulls.delete(oldest);
    }
    const { hull } = this.report.frames[index];
    const geometry = hull && geometryOfHull(hull);
    this.hulls.set(index, geometry);
    return geometry;
  }
}

function geometryOfHull(hull: Hull): THREE.BufferGeometry {
  const positions = new Float32Array(hull.vertices.length);
  for (let i = 0; i < positions.length; ++i) {
    const axis = i % 3;
    positions[i] = hull.low[axis] + (hull.vertices[i] / 65535) * (hull.high[axis] - hull.low[axis]);
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
  geometry.setIndex(new THREE.BufferAttribute(hull.triangles, 1));
  return geometry;
}
