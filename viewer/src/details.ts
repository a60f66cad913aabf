// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
import { button, card, element } from './element';
import type { Player } from './player';
import type { Report } from './report';

function timings(report: Report): HTMLElement {
  const all = [...report.seconds.values()].reduce((sum, spent) => sum + spent, 0);
  const table = element('table', { class: 'timings' });
  const words: Record<string, string> = {
    segment: 'pictures to silhouettes', hull: 'silhouettes to hulls', frames: 'fit of each frame',
    all_frames: 'fit of all frames', scale: "the hand's size",
  };
  for (const [stage, spent] of report.seconds) {
    const bar = element('i', { style: `width: ${(100 * spent) / Math.max(all, 1e-9)}%` });
    table.append(
      element('tr', {}, element('th', { scope: 'row' }, words[stage] ?? stage),
        element('td', {}, `${spent.toFixed(2)} s`), element('td', { class: 'bar' }, bar)),
    );
  }
  return table;
}

function frameTable(report: Report, player: Player): HTMLElement {
  const table = element('table', {});
  const head = element('tr', {}, element('th', {}, 'frame'), element('th', {}, 'time'));
  for (const camera of report.cameras) head.append(element('th', {}, camera.name));
  head.append(element('th', { class: 'text' }, 'what speaks against it'));
  table.append(head);
  report.frames.forEach((frame, i) => {
    const row = element(
      'tr',
      { class: frame.doubts.length > 0 ? 'doubtful' : undefined },
      element('th', { scope: 'row' }, button(frame.name, () => {
        player.stop();
        player.show(i);
      }, { class: 'quiet' })),
      element('td', {}, `${(frame.time - report.frames[0].time).toFixed(3)} s`),
    );
    for (const camera of report.cameras) {
      row.append(element('td', {}, frame.pose?.overlap.get(camera.name)?.toFixed(2) ?? ''));
    }
    row.append(element('td', { class: 'text' }, frame.doubts.join('; ')));
    table.append(row);
  });
  return element('div', { class: 'wide' }, table);
}

export function details(report: Report, player: Player): HTMLElement {
  const notes = element('ul', {});
  for (const limit of report.limits) notes.append(element('li', {}, limit));
  const frames = element('details', {}, element('summary', {}, 'All frames as a table'));
  frames.addEventListener('toggle', () => {
    if (frames.childElementCount === 1) frames.append(frameTable(report, player));
  });
  return card(
    'How it was made',
    `The fit ended with “${report.termination}” after ${report.iterations} iterations.`,
    timings(report),
    ...(report.limits.length > 0 ? [element('h3', {}, 'What this page leaves out'), notes] : []),
    frames,
    element('p', { class: 'soft' },
      'Keys: ← → one frame, with Shift ten; Home and End; Space plays; N and P go to the next and the previous doubtful frame.'),
  );
}
