// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts of the page in their order. Each is handed the player and follows it.
import { angleCharts } from './angles';
import { details } from './details';
import { element } from './element';
import { pictureWall } from './pictures';
import { listenToKeys, Player } from './player';
import type { Report } from './report';
import { sceneView } from './scene_view';
import { summary } from './summary';
import { supportMap } from './support';
import { timeline } from './timeline';

export function buildPage(main: HTMLElement, report: Report): void {
  const player = new Player(report);
  const hasPictures = report.frames.some((frame) => frame.pictures.size > 0);
  main.replaceChildren(
    summary(report, player),
    timeline(report, player),
    element(
      'div',
      { class: hasPictures ? 'stage' : 'stage alone' },
      sceneView(report, player),
      ...(hasPictures ? [pictureWall(report, player)] : []),
    ),
    angleCharts(report, player),
    supportMap(report, player),
    details(report, player),
  );
  listenToKeys(player);
  // Opened at what needs to be looked at, where there is such.
  if (player.doubtful.length > 0) player.show(report.verdict.worst);
  player.tell();
}
