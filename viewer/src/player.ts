// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
import type { Report } from './report';

/** Which frame is shown, for all parts of the page. */
export class Player {
  private shown = 0;
  private timer: number | undefined;
  private isDue = false;
  private readonly listeners: ((frame: number) => void)[] = [];
  private readonly playListeners: ((isPlaying: boolean) => void)[] = [];
  /** Positions of the frames that are not to be trusted. */
  readonly doubtful: number[];

  constructor(private readonly report: Report) {
    this.doubtful = report.frames.flatMap((frame, i) => (frame.doubts.length > 0 ? [i] : []));
  }

  get frame(): number {
    return this.shown;
  }
  get count(): number {
    return this.report.frames.length;
  }
  get isPlaying(): boolean {
    return this.timer !== undefined;
  }

  onFrame(listener: (frame: number) => void): void {
    this.listeners.push(listener);
  }
  onPlaying(listener: (isPlaying: boolean) => void): void {
    this.playListeners.push(listener);
  }

  /** With the next picture of the screen; of several frames until then only the last is shown. */
  show(frame: number): void {
    if (!this.goTo(frame) || this.isDue) return;
    this.isDue = true;
    requestAnimationFrame(() => {
      if (this.isDue) this.tell();
    });
  }
  /** Says the present frame to everybody, now. */
  tell(): void {
    this.isDue = false;
    for (const listener of this.listeners) listener(this.shown);
  }
  /** Whether that is another frame. */
  private goTo(frame: number): boolean {
    const next = Math.max(0, Math.min(this.count - 1, Math.round(frame)));
    const isOther = next !== this.shown;
    this.shown = next;
    return isOther;
  }
  /** By so many frames; the user's own steps stop the playing. */
  step(by: number): void {
    this.stop();
    this.show(this.shown + by);
  }
  /** To the next frame (or the one before) that is not to be trusted, around the ends. */
  stepToDoubt(forwards: boolean): void {
    this.stop();
    const order = forwards ? this.doubtful : [...this.doubtful].reverse();
    const next = order.find((i) => (forwards ? i > this.shown : i < this.shown)) ?? order[0];
    if (next !== undefined) this.show(next);
  }

  togglePlaying(): void {
    if (this.isPlaying) {
      this.stop();
    } else if (this.count > 1) {
      if (this.shown === this.count - 1) this.show(0);
      this.play();
    }
  }
  stop(): void {
    if (this.timer === undefined) return;
    cancelAnimationFrame(this.timer);
    this.timer = undefined;
    for (const listener of this.playListeners) listener(false);
  }

  /** As fast as it was recorded, round and round. */
  private play(): void {
    const { frames } = this.report;
    const start = frames[0].time;
    const last = frames[this.count - 1].time;
    const usual = (last - start) / (this.count - 1);
    const length = last - start + usual;
    const began = performance.now() / 1000 - (frames[this.shown].time - start);
    const isTimed = Number.isFinite(length) && length > 0;
    const advance = () => {
      const seconds = performance.now() / 1000 - began;
      let next = Math.floor(seconds * 10) % this.count;
      if (isTimed) {
        const time = start + (seconds % length);
        next = 0;
        while (next + 1 < this.count && frames[next + 1].time <= time) ++next;
      }
      if (this.goTo(next)) this.tell();
      this.timer = requestAnimationFrame(advance);
    };
    this.timer = requestAnimationFrame(advance);
    for (const listener of this.playListeners) listener(true);
  }
}

/** Arrows (with shift ten frames), home and end, space, n and p. */
export function listenToKeys(player: Player): void {
  const actions: Record<string, (isFast: boolean) => void> = {
    ArrowLeft: (isFast) => player.step(isFast ? -10 : -1),
    ArrowRight: (isFast) => player.step(isFast ? 10 : 1),
    Home: () => player.step(-player.count),
    End: () => player.step(player.count),
    n: () => player.stepToDoubt(true),
    p: () => player.stepToDoubt(false),
    ' ': () => player.togglePlaying(),
  };
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const target = event.target instanceof HTMLElement ? event.target : undefined;
    if (target?.closest('input, select, textarea')) return;
    // A focused button takes the space for itself.
    if (event.key === ' ' && target?.closest('button, summary, a')) return;
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action(event.shiftKey);
  });
}
