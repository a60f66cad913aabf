// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
import './style.css';
import { element } from './element';
import { buildPage } from './page';
import { readReport, ReportError } from './report';
import { chooseLook } from './look';

const main = document.getElementById('page') as HTMLElement;

/** In place of the page, so that it is never blank. */
function showMessage(what: string, why: string): void {
  main.replaceChildren(
    element(
      'div',
      { class: 'message', role: 'alert' },
      element('h1', {}, what),
      element('p', {}, why),
      element('p', { class: 'soft' }, 'tegata report RESULT --take TAKE makes this page anew.'),
    ),
  );
  document.documentElement.dataset['state'] = 'failed';
}

chooseLook();
const data = document.getElementById('tegata-report');
try {
  if (!data) throw new ReportError('there is no result in this page');
  const report = readReport(data.textContent ?? '');
  data.remove();
  document.title = `${report.take}: tegata report`;
  buildPage(main, report);
  document.documentElement.dataset['state'] = 'ready';
} catch (error) {
  const why = error instanceof Error ? error.message : String(error);
  showMessage('This report cannot be shown', why);
  if (!(error instanceof ReportError)) throw error;
}
