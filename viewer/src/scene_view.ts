// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
import { button, element, onResize, toggle } from './element';
import { onLook } from './look';
import type { Player } from './player';
import type { Camera, Report } from './report';
import { HandScene } from './scene';

/** The scene with what turns it and what is shown in it. */
export function sceneView(report: Report, player: Player): HTMLElement {
  let scene: HandScene;
  try {
    scene = new HandScene(report);
  } catch {
    return element(
      'section',
      { class: 'scene' },
      element('p', { class: 'message', role: 'alert' },
        'This browser shows no 3D (WebGL is off or missing). Everything else of the report is here.'),
    );
  }
  scene.canvas.setAttribute('role', 'img');
  scene.canvas.setAttribute('aria-label', 'The fitted hand, its visual hull and the cameras');
  const note = element('p', { class: 'note' });
  const view = element('div', { class: 'view' }, scene.canvas, note);

  const views: HTMLButtonElement[] = [];
  const choose = (chosen: HTMLButtonElement, through: Camera | undefined) => {
    for (const other of views) other.setAttribute('aria-pressed', String(other === chosen));
    if (through) scene.look(through);
    else scene.reset();
  };
  const viewButton = (name: string, through: Camera | undefined) => {
    const made = button(name, () => choose(made, through), {
      'aria-pressed': String(through === undefined), class: 'toggle', 'data-view': through?.name ?? '',
    });
    views.push(made);
    return made;
  };
  const free = viewButton('Free view', undefined);
  const through = report.cameras.map((camera) => viewButton(`from ${camera.name}`, camera));
  scene.onTurn = () => {
    for (const other of views) other.setAttribute('aria-pressed', String(other === free));
  };

  const hasHulls = report.frames.some((frame) => frame.hull);
  const switches: HTMLElement[] = [];
  if (hasHulls) switches.push(toggle('Hull', true, (isWanted) => scene.showHull(isWanted)));
  if (report.cameras.length > 0) {
    switches.push(toggle('Cameras', true, (isWanted) => scene.showCameras(isWanted)));
  }
  onResize(view, (width, height) => scene.resize(width, height));
  onLook(() => scene.applyLook());
  player.onFrame((frame) => {
    scene.show(frame);
    note.textContent = report.frames[frame].pose ? '' : 'No pose was found in this frame.';
  });
  return element(
    'section',
    { class: 'scene card' },
    element('div', { class: 'tools' }, free, ...through, element('span', { class: 'space' }), ...switches),
    view,
    element('p', { class: 'legend' },
      element('span', { class: 'key skin' }, 'fitted hand'),
      element('span', { class: 'key unseen' }, 'no picture backs it up'),
      ...(hasHulls ? [element('span', { class: 'key hull' }, 'visual hull')] : []),
      element('span', { class: 'soft' }, 'Drag turns, wheel or pinch zooms, right button moves.')),
  );
}
