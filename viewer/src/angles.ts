// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// The joint angles over the frames, a chart a digit, with a band of two standard deviations.
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { card, colour, element, onDrag, onResize } from './element';
import { onLook } from './look';
import type { Player } from './player';
import { spoken, type Report } from './report';

const DEGREES = 180 / Math.PI;
const ANGLES_A_DIGIT = 4;
const HEIGHT = 190;
const MOST_MARKED = 40;

type Column = (number | null)[];

/** The data of a digit's chart: positions, the four angles, then their upper and lower bounds. */
function columnsOf(report: Report, digit: number): uPlot.AlignedData {
  const column = (joint: number, sigmas: number): Column => {
    const off = sigmas * report.grasp.deviations[joint];
    return report.frames.map(({ pose }) => (pose ? (pose.angles[joint] + off) * DEGREES : null));
  };
  const joints = Array.from({ length: ANGLES_A_DIGIT }, (_, i) => ANGLES_A_DIGIT * digit + i);
  return [
    report.frames.map((_, i) => i),
    ...joints.map((joint) => column(joint, 0)),
    ...joints.flatMap((joint) => [column(joint, 2), column(joint, -2)]),
  ] as uPlot.AlignedData;
}

/** Frames that are not to be trusted, behind the lines. */
function shadeDoubts(plot: uPlot, player: Player): void {
  const { ctx, bbox } = plot;
  ctx.save();
  ctx.fillStyle = colour('--doubt-shade');
  for (const i of player.doubtful) {
    const left = Math.max(bbox.left, plot.valToPos(i - 0.5, 'x', true));
    const right = Math.min(bbox.left + bbox.width, plot.valToPos(i + 0.5, 'x', true));
    ctx.fillRect(left, bbox.top, Math.max(1, right - left), bbox.height);
  }
  ctx.restore();
}

function optionsOf(report: Report, player: Player, onDrawn: () => void): Omit<uPlot.Options, 'width'> {
  const line = (i: number) => () => colour(`--line${i}`);
  const band = (i: number) => () => colour(`--band${i}`);
  const four = [0, 1, 2, 3];
  const axis: uPlot.Axis = {
    stroke: () => colour('--soft'),
    grid: { stroke: () => colour('--rule'), width: 1 },
    ticks: { show: false },
    font: '12px system-ui, sans-serif',
  };
  return {
    height: HEIGHT,
    padding: [8, 8, 0, 0],
    legend: { show: false },
    cursor: { drag: { x: false, y: false }, points: { show: false }, y: false },
    scales: {
      x: { time: false, range: [-0.5, report.frames.length - 0.5] },
      y: { range: (_plot, low, high) => [Math.min(0, low) - 2, Math.max(60, high) + 2] },
    },
    axes: [
      {
        ...axis, size: 24, gap: 2, incrs: [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000],
        values: (_plot, positions) => positions.map((i) => report.frames[i]?.name ?? ''),
        space: 70,
      },
      { ...axis, size: 44, gap: 4, values: (_plot, values) => values.map((v) => `${v}°`) },
    ],
    series: [
      {},
      ...four.map((i) => ({
        stroke: line(i), width: 2, points: { show: report.frames.length <= MOST_MARKED, size: 5 },
      })),
      ...four.flatMap(() => [{ width: 0, points: { show: false } }, { width: 0, points: { show: false } }]),
    ],
    bands: four.map((i) => ({ series: [5 + 2 * i, 6 + 2 * i] as [number, number], fill: band(i) })),
    hooks: { drawClear: [(plot) => shadeDoubts(plot, player)], draw: [onDrawn] },
  };
}

function chart(report: Report, player: Player, digit: number): HTMLElement {
  const first = ANGLES_A_DIGIT * digit;
  const name = spoken(report.jointNames[first]).split(' ')[0];
  const area = element('div', { class: 'chart' });
  const values = [0, 1, 2, 3].map((i) => element('output', { 'data-joint': report.jointNames[first + i] }));
  const legend = element('p', { class: 'legend' });
  values.forEach((value, i) => {
    const joint = spoken(report.jointNames[first + i]).split(' ').slice(1).join(' ');
    legend.append(element('span', { class: `key line${i}` }, joint, ' ', value));
  });

  const position = element('div', { class: 'position' });
  let plot: uPlot | undefined;
  const mark = (frame: number) => {
    if (plot) position.style.left = `${plot.valToPos(frame, 'x')}px`;
  };
  onResize(area, (width) => {
    if (plot) {
      plot.setSize({ width, height: HEIGHT });
    } else {
      // Where a frame is, the plot knows once it is drawn.
      const options = optionsOf(report, player, () => mark(player.frame));
      plot = new uPlot({ ...options, width }, columnsOf(report, digit), area);
      plot.over.append(position);
      onDrag(plot.over, (x) => {
        player.stop();
        if (plot) player.show(plot.posToVal(x, 'x'));
      });
    }
  });
  onLook(() => plot?.redraw(false, true));
  player.onFrame((frame) => {
    mark(frame);
    const { pose } = report.frames[frame];
    values.forEach((value, i) => {
      const deviation = report.grasp.deviations[first + i] * DEGREES;
      value.textContent = pose
        ? `${(pose.angles[first + i] * DEGREES).toFixed(1)}° ± ${deviation.toFixed(1)}°`
        : 'no pose';
    });
  });
  return element('section', { class: 'digit' }, element('h3', {}, name), area, legend);
}

export function angleCharts(report: Report, player: Player): HTMLElement {
  const poses = report.frames.flatMap((frame) => frame.pose ?? []);
  const isFixed = poses.length > 1 && poses.every((pose) => pose.angles.every((a, i) => a === poses[0].angles[i]));
  const digits = Array.from({ length: report.jointNames.length / ANGLES_A_DIGIT }, (_, digit) =>
    chart(report, player, digit),
  );
  return card(
    'Joint angles',
    'Zero is the flat hand with straight fingers; flexion is positive towards the palm. Bands are two standard deviations wide to each side.' +
      (isFixed ? ' One set of angles was fitted to all frames, so that the lines are flat.' : ''),
    element('div', { class: 'charts' }, ...digits),
  );
}
