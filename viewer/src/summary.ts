// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
import { button, element } from './element';
import { lookSwitch } from './look';
import type { Player } from './player';
import { leastOverlap, type Frame, type Report } from './report';

const MOST_LISTED = 4;
const DEGREES = 180 / Math.PI;

function fact(name: string, value: string): HTMLElement {
  return element('div', {}, element('dt', {}, name), element('dd', {}, value));
}

function facts(report: Report): HTMLElement {
  const deviations = [...report.grasp.deviations].sort((a, b) => a - b);
  const typical = deviations[deviations.length >> 1] * DEGREES;
  const seconds = [...report.seconds.values()].reduce((sum, spent) => sum + spent, 0);
  const { model } = report;
  const size = model.deviation === undefined
    ? ''
    : `, ${model.scale.toFixed(3)} ± ${model.deviation.toFixed(3)} of its size`;
  return element(
    'dl',
    {},
    fact('mean overlap with the silhouettes', report.verdict.meanOverlap.toFixed(2)),
    fact('joint angles, typically', `± ${typical.toFixed(1)}°`),
    fact('hand', `${report.hand}, ${model.name}${size}`),
    fact('work', `${seconds.toFixed(1)} s`),
  );
}

/** The frames that are not to be trusted, runs of neighbours for the same reasons as one. */
interface Run {
  frames: number[];
  worst: number;
}

function runsOfDoubt(report: Report, player: Player): Run[] {
  const runs: Run[] = [];
  for (const i of player.doubtful) {
    const run = runs[runs.length - 1];
    if (run && run.frames[run.frames.length - 1] === i - 1) {
      run.frames.push(i);
      if (report.frames[i].severity > report.frames[run.worst].severity) run.worst = i;
    } else {
      runs.push({ frames: [i], worst: i });
    }
  }
  const { worst } = report.verdict;
  for (const run of runs) if (run.frames.includes(worst)) run.worst = worst;
  const severity = (run: Run) => report.frames[run.worst].severity + (run.worst === worst ? 1 : 0);
  return runs.sort((a, b) => severity(b) - severity(a));
}

function runName(report: Report, run: Run): string {
  const first = report.frames[run.frames[0]].name;
  const last = report.frames[run.frames[run.frames.length - 1]].name;
  return run.frames.length === 1 ? first : `${first} – ${last}`;
}

function doubtItem(report: Report, player: Player, run: Run): HTMLElement {
  const frame: Frame = report.frames[run.worst];
  const isWorst = run.worst === report.verdict.worst;
  const go = button(runName(report, run), () => {
    player.stop();
    player.show(run.worst);
  });
  return element(
    'li',
    { class: frame.pose ? 'doubtful' : 'missing' },
    go,
    ...(isWorst ? [element('strong', {}, run.frames.length === 1 ? 'worst' : `worst ${frame.name}`)] : []),
    element('span', {}, frame.doubts.join('; ')),
  );
}

function doubtList(report: Report, player: Player): HTMLElement {
  const runs = runsOfDoubt(report, player);
  if (runs.length === 0) {
    const frame = report.frames[report.verdict.worst];
    const least = leastOverlap(frame);
    return element(
      'p',
      { class: 'soft' },
      `No frame is in doubt. Look first at frame ${frame.name}`,
      least === undefined ? '.' : `: its lowest overlap is ${least.toFixed(2)}.`,
    );
  }
  const list = element('ul', { class: 'doubts', 'aria-label': 'Frames not to be trusted' });
  for (const run of runs.slice(0, MOST_LISTED)) list.append(doubtItem(report, player, run));
  if (runs.length > MOST_LISTED) {
    const rest = runs.slice(MOST_LISTED);
    const more = element('li', {}, button(`${rest.length} more`, () => {
      more.replaceWith(...rest.map((run) => doubtItem(report, player, run)));
    }, { class: 'quiet' }));
    list.append(more);
  }
  return list;
}

export function summary(report: Report, player: Player): HTMLElement {
  const words: Record<string, string> = { good: '✓ Good fit', fair: '! Usable with care', poor: '✕ Poor fit' };
  return element(
    'header',
    { class: 'summary' },
    element(
      'div',
      { class: 'title' },
      element('h1', {}, report.take),
      lookSwitch(),
    ),
    element(
      'div',
      { class: 'verdict' },
      element('span', { class: `word ${report.verdict.word}` }, words[report.verdict.word] ?? report.verdict.word),
      element('span', { class: 'sentence' }, report.verdict.sentence),
    ),
    doubtList(report, player),
    facts(report),
  );
}
