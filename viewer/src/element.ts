// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0

type Attributes = Record<string, string | number | boolean | undefined>;

/** An HTML element with attributes and children; strings become text, never markup. */
export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === false) continue;
    made.setAttribute(name, value === true ? '' : String(value));
  }
  made.append(...children);
  return made;
}

export function button(label: string, onClick: () => void, attributes: Attributes = {}) {
  const made = element('button', { type: 'button', ...attributes }, label);
  made.addEventListener('click', onClick);
  return made;
}

/** A button that stays down. */
export function toggle(label: string, isDown: boolean, onChange: (isDown: boolean) => void) {
  const made = button(label, () => {
    isDown = !isDown;
    made.setAttribute('aria-pressed', String(isDown));
    onChange(isDown);
  }, { 'aria-pressed': String(isDown), class: 'toggle' });
  return made;
}

/** A part of the page with a heading and, under it, what one should know to read it. */
export function card(title: string, note: string, ...children: Node[]): HTMLElement {
  return element(
    'section',
    { class: 'card' },
    element('h2', {}, title),
    ...(note ? [element('p', { class: 'soft' }, note)] : []),
    ...children,
  );
}

/** What a colour of the style sheet is in the present look. */
export function colour(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

/** Calls back with the offset of the pointer from the left, as it is pressed and dragged. */
export function onDrag(area: HTMLElement, move: (x: number) => void): void {
  const say = (event: PointerEvent) => move(event.clientX - area.getBoundingClientRect().left);
  area.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    if (event.pointerType === 'mouse') area.setPointerCapture(event.pointerId);
    say(event);
  });
  area.addEventListener('pointermove', (event) => {
    if (event.buttons & 1) say(event);
  });
}

/** Calls back once the element has a size, and whenever that changes. */
export function onResize(area: HTMLElement, resize: (width: number, height: number) => void): void {
  new ResizeObserver(() => {
    const { clientWidth, clientHeight } = area;
    if (clientWidth > 0 && clientHeight > 0) resize(clientWidth, clientHeight);
  }).observe(area);
}

/** Pixels of a canvas that one CSS pixel is worth. */
export const pixelRatio = (): number => Math.min(window.devicePixelRatio, 2);

/** A canvas's context whose unit is one CSS pixel, cleared and of the given size. */
export function cleared(canvas: HTMLCanvasElement, width: number, height: number) {
  const ratio = pixelRatio();
  const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h];
  const context = canvas.getContext('2d');
  if (!context) throw new Error('this browser has no 2D canvas');
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  return context;
}
