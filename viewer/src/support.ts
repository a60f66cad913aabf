// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// Which bone was backed up by the pictures in which frame (figure 4 of the paper, for any take).
import { card, cleared, colour, element, onDrag, onResize } from './element';
import { onLook } from './look';
import type { Player } from './player';
import { spoken, type Report } from './report';

const ROW = 20;
const SHADES = 7;

function drawCells(canvas: HTMLCanvasElement, report: Report, width: number): void {
  const rows = report.boneNames.length;
  const context = cleared(canvas, width, rows * ROW);
  const step = width / report.frames.length;
  const gap = step > 6 ? 1 : 0;
  const shades = Array.from({ length: SHADES }, (_, i) => colour(`--heat${i}`));
  const none = colour('--rule');
  report.frames.forEach((frame, i) => {
    for (let row = 0; row < rows; ++row) {
      const [left, top, wide, high] = [i * step, row * ROW, Math.max(0.5, step - gap), ROW - 1];
      if (frame.pose) {
        const share = Math.max(0, Math.min(1, frame.pose.support[row]));
        context.fillStyle = shades[Math.round(share * (SHADES - 1))];
        context.fillRect(left, top, wide, high);
      } else {
        context.fillStyle = none;
        context.fillRect(left, top + high / 2 - 1, wide, 2);
      }
    }
  });
}

function scale(): HTMLElement {
  const swatches = Array.from({ length: SHADES }, (_, i) =>
    element('i', { style: `background: var(--heat${i})` }),
  );
  return element('p', { class: 'legend' }, element('span', { class: 'soft' }, '0 hidden or contradicted'),
    element('span', { class: 'swatches' }, ...swatches), element('span', { class: 'soft' }, '1 seen and explained'));
}

export function supportMap(report: Report, player: Player): HTMLElement {
  const canvas = element('canvas', { role: 'img', 'aria-label': 'Support of each bone by frame' });
  const position = element('div', { class: 'position' });
  const cells = element('div', { class: 'cells' }, canvas, position);
  const names = element('div', { class: 'rows', 'aria-hidden': 'true' });
  const values = report.boneNames.map(() => element('output'));
  const column = element('div', { class: 'rows values' }, ...values);
  for (const name of report.boneNames) names.append(element('span', {}, spoken(name)));

  const count = report.frames.length;
  let width = 0;
  const draw = () => {
    if (width > 0) drawCells(canvas, report, width);
  };
  onResize(cells, (wide) => {
    width = wide;
    draw();
  });
  onLook(draw);
  onDrag(cells, (x) => {
    player.stop();
    player.show(Math.floor((x / cells.clientWidth) * count));
  });
  player.onFrame((frame) => {
    position.style.left = `${((frame + 0.5) / count) * 100}%`;
    const { pose } = report.frames[frame];
    values.forEach((value, row) => {
      value.textContent = pose ? pose.support[row].toFixed(2) : '–';
    });
  });
  return card(
    'Support',
    'How much of each bone the pictures of a frame back up. What is not seen in one frame is known from the others only.',
    element('div', { class: 'support' }, names, cells, column),
    scale(),
  );
}
