// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
import { button, element } from './element';

type Look = 'light' | 'dark';
const listeners: (() => void)[] = [];
const system = window.matchMedia('(prefers-color-scheme: dark)');
let chosen: Look | undefined;

const present = (): Look => chosen ?? (system.matches ? 'dark' : 'light');

function apply(): void {
  document.documentElement.dataset['look'] = present();
  for (const listener of listeners) listener();
}

/** The system's look, until the user chooses the other one. */
export function chooseLook(): void {
  system.addEventListener('change', apply);
  apply();
}

/** Calls back whenever colours change. */
export function onLook(listener: () => void): void {
  listeners.push(listener);
}

export function lookSwitch(): HTMLElement {
  const label = () => (present() === 'dark' ? 'Light look' : 'Dark look');
  const made = button(label(), () => {
    chosen = present() === 'dark' ? 'light' : 'dark';
    apply();
  }, { class: 'quiet', id: 'look' });
  onLook(() => made.replaceChildren(label()));
  return element('div', { class: 'look' }, made);
}
