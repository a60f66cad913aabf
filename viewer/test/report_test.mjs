// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
//
// The report page in Chromium without a window. tests/viewer_test.cpp makes the page and runs this.
// TEGATA_REPORT is the page, TEGATA_SCREENSHOTS a folder for pictures of it.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const file = process.env.TEGATA_REPORT;
const screenshots = process.env.TEGATA_SCREENSHOTS;
assert.ok(file && screenshots, 'TEGATA_REPORT and TEGATA_SCREENSHOTS must be set');

const html = readFileSync(file, 'utf8');
const opening = '<script type="application/json" id="tegata-report">';
const dataBegin = html.indexOf(opening) + opening.length;
const dataEnd = html.indexOf('</script>', dataBegin);
const data = JSON.parse(html.slice(dataBegin, dataEnd));
const frameCount = data.frames.length;
const { worst } = data.verdict;
const DEGREES = 180 / Math.PI;

let browser;
let folder;
/** A page that most tests use one after the other. */
let shared;
before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'tegata-viewer-'));
  browser = await chromium.launch({
    executablePath: process.env.TEGATA_CHROMIUM ?? '/usr/bin/chromium',
    timeout: 120000,
    // What Chromium does by itself where there is no GPU: 3D is computed, the page is not drawn by it.
    args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader-webgl', '--enable-unsafe-swiftshader'],
  });
  shared = await openReport();
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** A page that was opened from the disk, and what went wrong in it; `first` runs in it before all else. */
async function open(path, options = {}, first = () => {}) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, ...options });
  context.setDefaultTimeout(120000); // a busy machine is no failure
  const page = await context.newPage();
  await page.addInitScript(first);
  const problems = [];
  page.on('console', (message) => {
    if (message.type() === 'error') problems.push(message.text());
  });
  page.on('pageerror', (error) => problems.push(error.message));
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) problems.push(`asked for ${request.url()}`);
  });
  await page.goto(pathToFileURL(path).href);
  await page.waitForFunction(() => document.documentElement.dataset.state !== undefined);
  return { page, problems };
}

/** Opened, and every part shows a frame. */
async function openReport(options) {
  const opened = await open(file, options);
  const state = await opened.page.evaluate(() => document.documentElement.dataset.state);
  assert.equal(state, 'ready', opened.problems.join('\n'));
  await sceneIsDrawn(opened.page);
  return opened;
}

/** When the 3D picture shows all that was asked of it so far, with all its pixels. */
async function sceneIsDrawn(page) {
  await page.waitForFunction(() => {
    const canvas = document.querySelector('.view canvas');
    return canvas?.dataset.frame && !canvas.hasAttribute('data-coarse');
  });
}

/** Lets the browser draw so many pictures of the page, however long that takes. */
function pictures(page, count) {
  return page.evaluate(async (count) => {
    for (let i = 0; i < count; ++i) await new Promise(requestAnimationFrame);
  }, count);
}

/** What each part of the page says that it shows. */
function shown(page) {
  return page.evaluate(() => ({
    scene: document.querySelector('.view canvas').dataset.frame,
    pictures: [...document.querySelectorAll('figure canvas')].map((canvas) => canvas.dataset.frame),
    strip: document.querySelector('.strip').getAttribute('aria-valuetext'),
    said: document.querySelector('.now').textContent,
    angles: Object.fromEntries(
      [...document.querySelectorAll('output[data-joint]')].map((o) => [o.dataset.joint, o.textContent]),
    ),
    support: [...document.querySelectorAll('.values output')].map((o) => o.textContent),
  }));
}

async function assertShows(page, index) {
  const { frame: name, angles, support } = data.frames[index];
  await page.waitForFunction(
    (wanted) =>
      [...document.querySelectorAll('.view canvas, figure canvas')].every(
        (canvas) => canvas.dataset.frame === wanted,
      ),
    name,
  );
  const now = await shown(page);
  assert.equal(now.strip, name);
  assert.match(now.said, new RegExp(`^Frame ${name}, ${index + 1} of ${frameCount}`));
  data.joint_names.forEach((joint, i) => {
    const expected = angles ? `${(angles[i] * DEGREES).toFixed(1)}°` : 'no pose';
    assert.ok(now.angles[joint].startsWith(expected), `${joint}: ${now.angles[joint]}, ${expected}`);
  });
  assert.deepEqual(now.support, data.bone_names.map((_, i) => (support ? support[i].toFixed(2) : '–')));
}

/** Presses the pointer on an element, at a share of its width. */
async function pressAt(page, selector, share) {
  const area = page.locator(selector).first();
  await area.scrollIntoViewIfNeeded();
  const box = await area.boundingBox();
  await page.mouse.click(box.x + share * box.width, box.y + box.height / 2);
}

/** Which pixels of the 3D picture are drawn on, and how they differ from another copy of them. */
function scenePixels(page) {
  return page.evaluate(() => {
    const source = document.querySelector('.view canvas');
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [source.width, source.height];
    const context = copy.getContext('2d');
    context.drawImage(source, 0, 0);
    const { data: values } = context.getImageData(0, 0, copy.width, copy.height);
    const before = window.lastScene;
    window.lastScene = values;
    let [drawn, changed] = [0, 0];
    for (let i = 0; i < values.length; i += 4) {
      if (values[i + 3] > 127) ++drawn;
      if (before && Math.abs(values[i] - before[i]) + Math.abs(values[i + 3] - before[i + 3]) > 24) ++changed;
    }
    return { share: (4 * drawn) / values.length, changed };
  });
}

test('opens without an error, without the network, at the worst frame', async () => {
  const { page, problems } = shared;
  await assertShows(page, worst);
  assert.ok((await scenePixels(page)).share > 0.02, 'the 3D picture is blank');
  assert.deepEqual(problems, []);
});

test('load time', async () => {
  const { page } = await open(file, {}, () => {
    window.times = {};
    const look = () => {
      const canvases = [...document.querySelectorAll('.view canvas, figure canvas')];
      if (document.documentElement.dataset.state) window.times.ready ??= performance.now();
      if (canvases.length > 0 && canvases.every((c) => c.dataset.frame)) window.times.drawn ??= performance.now();
      else requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  });
  await page.waitForFunction(() => window.times.drawn);
  const { ready, drawn } = await page.evaluate(() => window.times);
  console.log(`from opening: ${ready.toFixed(0)} ms until it answers, ${drawn.toFixed(0)} ms until all is drawn`);
  await page.context().close();
});

test('the hand is where the cameras saw it', async () => {
  const { page } = shared;
  await page.click('button:has-text("Hull")');
  await page.click('.scene button:has-text("Cameras")');
  for (const frame of [0, worst]) {
    await pressAt(page, '.strip', (frame + 0.5) / frameCount);
    await assertShows(page, frame);
    for (const [index, camera] of data.cameras.entries()) {
      await page.click(`button[data-view="${camera.name}"]`);
      await sceneIsDrawn(page);
      const overlap = await page.evaluate(({ camera, packed }) => {
        const source = document.querySelector('.view canvas');
        const { width, height } = source;
        const canvases = [0, 1].map(() => Object.assign(document.createElement('canvas'), { width, height }));
        const [expected, seen] = canvases.map((canvas) => canvas.getContext('2d'));
        // The fitted hand's outline as the program drew it, from the window to the view.
        const bytes = Uint8Array.from(atob(packed), (c) => c.charCodeAt(0));
        const numbers = new Uint16Array(bytes.buffer);
        const [left, top, wide, high] = camera.window;
        const [w, h] = camera.size;
        const scale = Math.min(width / w, height / h);
        const x = (v) => (left + ((v / 65535) * 17 - 8) * wide - w / 2) * scale + width / 2;
        const y = (v) => (top + ((v / 65535) * 17 - 8) * high - h / 2) * scale + height / 2;
        for (let at = 0; at < numbers.length; at += 1 + 2 * numbers[at]) {
          for (let i = 0; i < numbers[at]; ++i) {
            const point = [x(numbers[at + 1 + 2 * i]), y(numbers[at + 2 + 2 * i])];
            if (i === 0) expected.moveTo(...point);
            else expected.lineTo(...point);
          }
          expected.closePath();
        }
        expected.fill('evenodd');
        seen.drawImage(source, 0, 0);
        const [a, b] = [expected, seen].map((c) => c.getImageData(0, 0, width, height).data);
        let [both, either] = [0, 0];
        for (let i = 3; i < a.length; i += 4) {
          if (a[i] > 127 && b[i] > 127) ++both;
          if (a[i] > 127 || b[i] > 127) ++either;
        }
        return both / either;
      }, { camera, packed: data.frames[frame].pictures.find((p) => p.camera === index).hand });
      console.log(`frame ${frame} through ${camera.name}: overlap ${overlap.toFixed(3)} with the outline`);
      // What is left is the lens, which the view does without, and the pixels' size.
      assert.ok(overlap > 0.93, `${camera.name}: ${overlap}`);
    }
  }
  await page.click('button:has-text("Hull")');
  await page.click('.scene button:has-text("Cameras")');
});

test('pointing at a frame in any part moves all others', async () => {
  const { page, problems } = shared;
  await page.click('button[data-view=""]');
  const places = [
    ['.strip', 5, (i) => (i + 0.5) / frameCount],
    ['.chart .u-over', 44, (i) => (i + 0.5) / frameCount],
    ['.cells', 21, (i) => (i + 0.5) / frameCount],
    ['.strip', 52, (i) => (i + 0.5) / frameCount],
    ['.strip', 50, (i) => (i + 0.5) / frameCount],
  ];
  await sceneIsDrawn(page);
  await scenePixels(page);
  for (const [selector, frame, share] of places) {
    await pressAt(page, selector, share(frame));
    await assertShows(page, frame);
    await sceneIsDrawn(page);
    assert.ok((await scenePixels(page)).changed > 200, `the 3D picture did not change to frame ${frame}`);
  }
  await page.click('.doubts button');
  await assertShows(page, worst);
  await page.click('summary');
  await page.click('details button:has-text("' + data.frames[9].frame + '")');
  await assertShows(page, 9);
  const strip = await page.locator('.strip').boundingBox();
  await page.mouse.move(strip.x + 1, strip.y + 9);
  await page.mouse.down();
  await page.mouse.move(strip.x + (strip.width * (frameCount / 2 + 0.5)) / frameCount, strip.y + 9, { steps: 12 });
  await page.mouse.up();
  await assertShows(page, frameCount / 2);
  assert.deepEqual(problems, []);
});

test('keys', async () => {
  const { page } = shared;
  await page.evaluate(() => {
    document.activeElement.blur();
    window.scrollTo(0, 0);
  });
  for (const [key, frame] of [['Home', 0], ['ArrowRight', 1], ['Shift+ArrowRight', 11], ['ArrowLeft', 10],
    ['End', frameCount - 1], ['ArrowRight', frameCount - 1], ['Home', 0]]) {
    await page.keyboard.press(key);
    await assertShows(page, frame);
  }
  const doubtful = data.frames.flatMap((frame, i) => (frame.doubts.length > 0 ? [i] : []));
  await page.keyboard.press('n');
  await assertShows(page, doubtful[0]);
  await page.keyboard.press('p');
  await assertShows(page, doubtful[doubtful.length - 1]);

  await page.keyboard.press('Home');
  await page.keyboard.press('Space');
  await page.waitForFunction(() => Number(document.querySelector('.strip').getAttribute('aria-valuenow')) > 5);
  await page.keyboard.press('Space');
  await pictures(page, 2);
  const stopped = await shown(page);
  await pictures(page, 20);
  assert.equal((await shown(page)).strip, stopped.strip, 'it plays on after a second press of the space bar');
  assert.equal(await page.evaluate(() => window.scrollY), 0, 'keys scroll the page');
});

test('scrubbing rate', async () => {
  const { page } = shared;
  const rate = await page.evaluate(async (names) => {
    const press = (key) => document.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true }));
    const canvases = [...document.querySelectorAll('.view canvas, figure canvas')];
    const isShown = async (name) => {
      while (!canvases.every((canvas) => canvas.dataset.frame === name)) await new Promise(requestAnimationFrame);
    };
    press('Home');
    await isShown(names[0]);
    const began = performance.now();
    const order = [...names.keys()].slice(1, 46);
    for (const frame of order) {
      press('ArrowRight');
      await isShown(names[frame]);
    }
    for (const frame of order.reverse()) {
      press('ArrowLeft');
      await isShown(names[frame - 1]);
    }
    return (2000 * order.length) / (performance.now() - began);
  }, data.frames.map(({ frame }) => frame));
  console.log(`scrubbing: ${rate.toFixed(0)} frames/s with the 3D picture, ${data.cameras.length} ` +
    'pictures, charts and numbers all drawn');
});

test('what to distrust is seen without scrolling, in each look', async () => {
  assert.ok(data.frames[worst].doubts.length > 0);
  const seen = new Map();
  for (const [name, options] of [
    ['light', { colorScheme: 'light', viewport: { width: 1440, height: 900 } }],
    ['dark', { colorScheme: 'dark', viewport: { width: 1280, height: 720 } }],
    ['phone', { colorScheme: 'light', viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, isMobile: true, hasTouch: true }],
  ]) {
    const { page } = await openReport(options);
    const { viewport } = options;
    for (const selector of ['.word', '.sentence', '.doubts li', '.worst', '.strip', '.now']) {
      const box = await page.locator(selector).first().boundingBox();
      assert.ok(box && box.y >= 0 && box.y + box.height <= viewport.height && box.x >= 0 &&
        box.x + box.width <= viewport.width, `${selector} is out of sight at ${viewport.width} pixels`);
    }
    const first = await page.locator('.doubts li').first().textContent();
    assert.ok(first.includes(data.frames[worst].doubts[0]), first);
    const flag = await page.locator('.worst').boundingBox();
    const strip = await page.locator('.strip').boundingBox();
    const marked = (flag.x + flag.width / 2 - strip.x) / strip.width;
    assert.ok(Math.abs(marked - (worst + 0.5) / frameCount) < 0.02, `marked at ${marked}`);
    const isTooWide = await page.evaluate(() => document.documentElement.scrollWidth > window.innerWidth);
    assert.ok(!isTooWide, `the page scrolls sideways at ${viewport.width} pixels`);

    await assertShows(page, worst);
    await page.screenshot({ path: join(screenshots, `${name}.png`) });
    await page.screenshot({ path: join(screenshots, `${name}_whole.png`), fullPage: true });
    const background = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    seen.set(name, await background());
    await page.click('#look');
    seen.set(`${name} switched`, await background());
    await page.context().close();
  }
  assert.notEqual(seen.get('light'), seen.get('dark'));
  assert.equal(seen.get('light switched'), seen.get('dark'));
  assert.equal(seen.get('dark switched'), seen.get('light'));
});

test('a malformed result shows a message', async () => {
  const page = (text) => html.slice(0, dataBegin) + text + html.slice(dataEnd);
  const short = { ...data, frames: data.frames.slice(0, 4), verdict: { ...data.verdict, worst: 0 } };
  const changed = (change) => {
    const copy = structuredClone(short);
    change(copy);
    return page(JSON.stringify(copy).replaceAll('<', '\\u003c'));
  };
  const cases = {
    'no result': html.slice(0, dataBegin - opening.length) + html.slice(dataEnd),
    'no JSON': page('{"format": "tegata-'),
    'nothing': page(''),
    'null': page('null'),
    'another format': changed((d) => { d.format = 'tegata-result'; }),
    'a later version': changed((d) => { d.version = 2; }),
    'no frames': changed((d) => { d.frames = []; }),
    'a missing key': changed((d) => { delete d.grasp; }),
    'too few angles': changed((d) => { d.frames[3].angles.pop(); }),
    'no number': changed((d) => { d.frames[0].time = null; }),
    'no base64': changed((d) => { d.frames[2].bones = '%%%'; }),
    'cut bytes': changed((d) => { d.hand_surface.vertices = d.hand_surface.vertices.slice(0, 400); }),
    'triangles of other vertices': changed((d) => { d.hand_surface.triangles = '/////w=='; }),
    'a camera that is not there': changed((d) => { d.frames[0].pictures[0].camera = 9; }),
    'a worst frame that is not there': changed((d) => { d.verdict.worst = 1000; }),
  };
  const path = join(folder, 'malformed.html');
  writeFileSync(path, changed(() => {}));
  const { page: opened } = await open(path);
  const state = () => opened.evaluate(() => document.documentElement.dataset.state);
  assert.equal(await state(), 'ready', 'the page that is to be spoilt must be a good one');
  for (const [name, content] of Object.entries(cases)) {
    writeFileSync(path, content);
    await opened.reload();
    await opened.waitForFunction(() => document.documentElement.dataset.state !== undefined);
    const alert = opened.locator('[role=alert]');
    assert.equal(await alert.count(), 1, `${name}: no message`);
    assert.match(await alert.textContent(), /cannot be shown.{10,}/s, name);
  }
  await opened.context().close();
});

test('a picture that cannot be decoded is said and the rest works', async () => {
  const copy = structuredClone(data);
  copy.frames[0].pictures[0].jpeg = 'AAAA';
  const path = join(folder, 'picture.html');
  writeFileSync(path, html.slice(0, dataBegin) + JSON.stringify(copy).replaceAll('<', '\\u003c') + html.slice(dataEnd));
  const { page, problems } = await open(path);
  await page.keyboard.press('Home');
  await assertShows(page, 0);
  assert.deepEqual(problems, []);
  await page.context().close();
});
