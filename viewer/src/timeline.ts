// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// All frames at a glance: how well each fits, which are not to be trusted, which is the worst.
import { button, cleared, colour, element, onDrag, onResize } from './element';
import { onLook } from './look';
import type { Player } from './player';
import { leastOverlap, type Frame, type Report } from './report';

const HEIGHT = 44;

function barColour(frame: Frame): string {
  if (!frame.pose) return colour('--missing');
  return colour(frame.doubts.length > 0 ? '--doubtful' : '--trusted');
}

function drawBars(canvas: HTMLCanvasElement, report: Report, width: number): void {
  const context = cleared(canvas, width, HEIGHT);
  const count = report.frames.length;
  const step = width / count;
  const gap = step > 4 ? 1 : 0;
  const stripes = colour('--paper');
  report.frames.forEach((frame, i) => {
    const share = frame.pose ? (leastOverlap(frame) ?? 1) : 1;
    const height = Math.max(3, share * (HEIGHT - 2));
    const [left, top, wide] = [i * step, HEIGHT - height, Math.max(0.5, step - gap)];
    context.fillStyle = barColour(frame);
    context.fillRect(left, top, wide, height);
    if (frame.pose) return;
    context.fillStyle = stripes;
    for (let y = top + 3; y < HEIGHT; y += 6) context.fillRect(left, y, wide, 3);
  });
}

/** What is said of the frame that is shown. */
function frameText(report: Report, i: number): string {
  const frame = report.frames[i];
  const time = frame.time - report.frames[0].time;
  const verdict = frame.doubts.length > 0 ? frame.doubts.join('; ') : 'to be trusted';
  return `Frame ${frame.name}, ${i + 1} of ${report.frames.length}, ${time.toFixed(2)} s: ${verdict}`;
}

export function timeline(report: Report, player: Player): HTMLElement {
  const count = report.frames.length;
  const canvas = element('canvas', { 'aria-hidden': 'true' });
  const position = element('div', { class: 'position' });
  const { worst } = report.verdict;
  const flag = element('div', { class: 'worst', title: `The worst frame: ${report.frames[worst].name}` },
    player.doubtful.length > 0 ? '▼ worst' : '▼ first');
  const strip = element('div', {
    class: 'strip', role: 'slider', tabindex: 0, 'aria-label': 'Frame',
    'aria-valuemin': 1, 'aria-valuemax': count,
  }, canvas, position);
  const text = element('p', { class: 'now', 'aria-live': 'off' });

  const play = button('▶ Play', () => player.togglePlaying(), { id: 'play', title: 'Space' });
  player.onPlaying((isPlaying) => play.replaceChildren(isPlaying ? '❚❚ Pause' : '▶ Play'));
  const buttons = [
    play,
    button('◀', () => player.step(-1), { 'aria-label': 'Frame before', title: 'Left arrow' }),
    button('▶', () => player.step(1), { 'aria-label': 'Next frame', title: 'Right arrow' }),
  ];
  if (player.doubtful.length > 0) {
    buttons.push(button('Next doubtful', () => player.stepToDoubt(true), { id: 'next-doubt', title: 'N' }));
  }

  const centre = (i: number) => `${((i + 0.5) / count) * 100}%`;
  flag.style.left = `clamp(1.8rem, ${centre(worst)}, calc(100% - 1.8rem))`;
  let width = 0;
  const draw = () => {
    if (width > 0) drawBars(canvas, report, width);
  };
  onResize(strip, (wide) => {
    width = wide;
    draw();
  });
  onLook(draw);
  onDrag(strip, (x) => {
    player.stop();
    player.show(Math.floor((x / strip.clientWidth) * count));
  });
  player.onFrame((i) => {
    position.style.left = centre(i);
    strip.setAttribute('aria-valuenow', String(i + 1));
    strip.setAttribute('aria-valuetext', report.frames[i].name);
    text.textContent = frameText(report, i);
    text.classList.toggle('doubtful', report.frames[i].doubts.length > 0);
  });
  return element(
    'nav',
    { class: 'timeline', 'aria-label': 'Frames' },
    element('div', { class: 'flags' }, flag),
    strip,
    element('div', { class: 'controls' }, ...buttons, text),
  );
}
