// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// What the cameras saw, with the outlines of the silhouette and of the fitted hand over it.
import { cleared, element, onResize, pixelRatio, toggle } from './element';
import { bytesOf, shortsOf } from './packed';
import type { Player } from './player';
import type { Camera, Picture, Report } from './report';

const PICTURES_KEPT = 240;
const FRAMES_AHEAD = 2;
/** Over infrared and colour pictures alike, in the light look and in the dark one. */
const HAND = '#ff8c00';
const SILHOUETTE = '#46c8ff';

/** Lines in a picture that is 1 wide and high; see packed_outlines() of report_json.cpp. */
function outlinePath(packed: string, width: number, height: number): Path2D {
  const numbers = shortsOf(packed);
  const place = (i: number) => (numbers[i] / 65535) * 17 - 8;
  const path = new Path2D();
  for (let at = 0; at < numbers.length; ) {
    const end = at + 1 + 2 * numbers[at];
    for (let i = at + 1; i + 1 < end; i += 2) path.lineTo(place(i) * width, place(i + 1) * height);
    path.closePath();
    at = end;
    if (at + 1 < numbers.length) path.moveTo(place(at + 1) * width, place(at + 2) * height);
  }
  return path;
}

interface Decoded {
  width: number;
  bitmap: Promise<ImageBitmap>;
}

/** Decodes pictures in the size that they are shown in, and keeps those that were asked for last. */
class Decoder {
  private readonly kept = new Map<Picture, Decoded>();

  /** Sizes in pixels of the screen. */
  get(picture: Picture, width: number, height: number): Promise<ImageBitmap> {
    let decoded = this.kept.get(picture);
    this.kept.delete(picture);
    if (decoded?.width !== width) {
      decoded?.bitmap.then((image) => image.close(), () => {});
      const bytes = new Blob([bytesOf(picture.jpeg)], { type: 'image/jpeg' });
      // Not on the page's own thread, as drawing in another size is.
      const size: ImageBitmapOptions = { resizeWidth: width, resizeHeight: height, resizeQuality: 'high' };
      decoded = { width, bitmap: createImageBitmap(bytes, size) };
    }
    this.kept.set(picture, decoded);
    if (this.kept.size > PICTURES_KEPT) {
      const [oldest, dropped] = this.kept.entries().next().value as [Picture, Decoded];
      this.kept.delete(oldest);
      dropped.bitmap.then((image) => image.close(), () => {});
    }
    return decoded.bitmap;
  }
}

interface Wanted {
  hand: boolean;
  silhouette: boolean;
}

/** One camera's picture. */
class CameraPicture {
  readonly figure: HTMLElement;
  private readonly canvas: HTMLCanvasElement;
  private readonly caption = element('figcaption');
  private shown = -1;
  private width = 0;

  constructor(
    private readonly report: Report,
    private readonly camera: Camera,
    private readonly index: number,
    private readonly decoder: Decoder,
    private readonly wanted: Wanted,
  ) {
    this.canvas = element('canvas', { role: 'img', 'aria-label': `Picture of ${camera.name} with outlines` });
    const [, , width, height] = camera.window;
    this.canvas.style.aspectRatio = `${width} / ${height}`;
    this.figure = element('figure', {}, this.canvas, this.caption);
    onResize(this.canvas, (wide) => {
      this.width = wide;
      this.drawShown();
    });
  }

  show(frame: number): void {
    this.shown = frame;
    const { pose } = this.report.frames[frame];
    const overlap = pose?.overlap.get(this.camera.name);
    this.caption.replaceChildren(
      element('span', {}, this.camera.name),
      element('span', { class: overlap !== undefined && overlap < 0.5 ? 'doubtful' : 'soft' },
        overlap === undefined ? 'not used in this frame' : `overlap ${overlap.toFixed(2)}`),
    );
    this.drawShown();
  }

  /** Decodes the picture of a frame that may be shown soon; what is wrong with it is said then. */
  prepare(frame: number): void {
    const picture = this.report.frames[frame]?.pictures.get(this.index);
    if (picture && this.width > 0) this.decoded(picture).catch(() => {});
  }

  private decoded(picture: Picture): Promise<ImageBitmap> {
    const [, , width, height] = this.camera.window;
    const wide = Math.max(1, Math.min(width, Math.round(this.width * pixelRatio())));
    return this.decoder.get(picture, wide, Math.max(1, Math.round((wide * height) / width)));
  }

  /** As soon as it is decoded, unless another frame is shown by then. */
  private drawShown(): void {
    const frame = this.shown;
    if (this.width === 0 || frame < 0) return;
    const picture = this.report.frames[frame].pictures.get(this.index);
    if (!picture) {
      this.say('no picture of this frame in the page');
      return;
    }
    this.decoded(picture).then(
      (bitmap) => {
        if (this.shown === frame) this.draw(picture, bitmap);
      },
      () => {
        if (this.shown === frame) this.say('this picture cannot be decoded');
      },
    );
  }

  /** The canvas, as large as it is shown, and empty. */
  private paper() {
    const [, , width, height] = this.camera.window;
    const high = (this.width * height) / width;
    this.canvas.dataset['frame'] = this.report.frames[this.shown].name;
    return { context: cleared(this.canvas, this.width, high), width: this.width, height: high };
  }

  private draw(picture: Picture, bitmap: ImageBitmap): void {
    const { context, width, height } = this.paper();
    context.imageSmoothingQuality = 'high';
    context.drawImage(bitmap, 0, 0, width, height);
    context.lineJoin = 'round';
    context.lineWidth = Math.max(1.3, width / 220);
    const stroke = (packed: string, colour: string) => {
      context.strokeStyle = colour;
      context.stroke(outlinePath(packed, width, height));
    };
    if (this.wanted.silhouette) stroke(picture.silhouette, SILHOUETTE);
    if (this.wanted.hand) stroke(picture.hand, HAND);
  }

  private say(text: string): void {
    const { context, width, height } = this.paper();
    context.fillStyle = '#222';
    context.fillRect(0, 0, width, height);
    context.fillStyle = '#ccc';
    context.font = `${Math.round(Math.max(11, width / 24))}px system-ui, sans-serif`;
    context.textAlign = 'center';
    context.fillText(text, width / 2, height / 2);
  }
}

export function pictureWall(report: Report, player: Player): HTMLElement {
  const decoder = new Decoder();
  const wanted: Wanted = { hand: true, silhouette: true };
  const pictures = report.cameras.map(
    (camera, index) => new CameraPicture(report, camera, index, decoder, wanted),
  );
  const show = (frame: number) => {
    for (const picture of pictures) picture.show(frame);
  };
  player.onFrame((frame) => {
    show(frame);
    for (let ahead = frame - FRAMES_AHEAD; ahead <= frame + FRAMES_AHEAD; ++ahead) {
      for (const picture of pictures) picture.prepare(ahead);
    }
  });
  const outlineToggle = (name: string, key: keyof Wanted) => {
    const made = toggle(name, true, (isWanted) => {
      wanted[key] = isWanted;
      show(player.frame);
    });
    made.classList.add('key', key);
    return made;
  };
  return element(
    'section',
    { class: 'pictures card' },
    element('div', { class: 'tools' },
      outlineToggle('Fitted hand', 'hand'), outlineToggle('Silhouette', 'silhouette')),
    element('div', { class: pictures.length > 4 ? 'wall many' : 'wall' },
      ...pictures.map((picture) => picture.figure)),
  );
}
