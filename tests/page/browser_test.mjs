// The page in a browser: keys, clicks, drags, touch, print; the same numbers as the terminal; nothing fetched.
// node browser_test.mjs PROGRAM SOURCE_FOLDER NODE_MODULES; ends with 77 where browser or library are missing.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import assert from 'node:assert/strict';
import { launched, program, runAll, source, watched } from '../support/browser.mjs';

const browser = await launched();
const folder = mkdtempSync(join(tmpdir(), 'rayscope-page-'));
const run = (...words) => execFileSync(program, words, { encoding: 'utf8', cwd: folder, stdio: ['ignore', 'pipe', 'pipe'] });
const pageOf = (scene, name, ...more) => { run('trace', scene, '-o', name, ...more); return join(folder, name); };
const commands = lines => {
  writeFileSync(join(folder, 'script'), lines.join('\n') + '\n');
  return run('step', 'prism', '--json', '--script', 'script').trim().split('\n').map(line => JSON.parse(line));
};

const opened = async (file, { hash = '', before, ...options } = {}) => {
  const context = await browser.newContext({ viewport: { width: 1280, height: 760 }, ...options });
  const page = await watched(context);
  if (before) await page.addInitScript(before);
  await page.goto(pathToFileURL(file).href + hash);
  await page.waitForFunction(() => window.rayscope !== undefined);
  return page;
};
const state = page => page.evaluate(() => window.rayscope.state());
const picture = async page => { await page.waitForTimeout(150); return (await page.locator('#canvas').screenshot()).toString('base64'); };

const tests = {
  async 'keys report the same numbers as the terminal'() {
    const page = await opened(prism);
    const moves = [['ArrowRight', 'next'], ['n', 'next'], ['s', 'step'], ['.', 'step'], ['S', 'reverse-step'], ['ArrowRight', 'next'], ['ArrowRight', 'next'],
      ['ArrowDown', 'in'], ['s', 'step'], ['o', 'over'], ['ArrowUp', 'out'], ['ArrowLeft', 'back'], ['o', 'over'], ['End', 'goto 9'], ['ArrowLeft', 'back'], ['u', 'out'], ['Home', 'goto 0']];
    const replies = commands(moves.map(([, command]) => command));
    assert.deepEqual(await state(page), replies[0].state);
    for (const [i, [key]] of moves.entries()) {
      await page.keyboard.press(key);
      assert.deepEqual(await state(page), replies[i + 1].state, `${key}: ${replies[i + 1].command}`);
    }
  },
  async 'every step has the numbers of the terminal'() {
    const page = await opened(prism);
    const replies = commands(Array(138).fill('step'));
    for (const reply of replies) {
      assert.deepEqual(await state(page), reply.state);
      await page.keyboard.press('s');
    }
  },
  async 'clicks in tree, events and links select everywhere'() {
    const page = await opened(prism);
    await page.locator('#row-4').click();
    assert.equal((await state(page)).ray, 4);
    assert.equal(await page.locator('#row-4').getAttribute('aria-selected'), 'true');
    assert.match(await page.locator('#card-title').textContent(), /Total internal reflection/);
    assert.match(await page.locator('#lanes-title').textContent(), /along ray 4/);
    assert.equal(await page.locator('#slider').inputValue(), '4');
    await page.locator('#events li', { hasText: 'total reflection' }).click();
    assert.equal((await state(page)).what, 'totally_reflected');
    await page.locator('#details-numbers button', { hasText: 'ray 5' }).first().click();
    assert.equal((await state(page)).ray, 5);
  },
  async 'the address names the step'() {
    const page = await opened(prism, { hash: '#ray=4.13' });
    assert.deepEqual([(await state(page)).ray, (await state(page)).event], [4, 13]);
    await page.keyboard.press('ArrowRight');
    assert.equal(new URL(page.url()).hash, '#ray=5');
    await page.evaluate(() => { location.hash = '#ray=2'; });
    await page.waitForFunction(() => window.rayscope.state().ray === 2);
    const odd = await opened(prism, { hash: '#ray=99999.<img>' });
    assert.equal((await state(odd)).ray, 0);
  },
  async 'slider and play move on'() {
    const page = await opened(prism);
    await page.locator('#slider').fill('6');
    assert.equal((await state(page)).ray, 6);
    await page.locator('#speed').selectOption('5');
    await page.locator('#play').click();
    await page.waitForFunction(() => window.rayscope.state().ray === 9);
    await page.waitForFunction(() => document.getElementById('play').getAttribute('aria-pressed') === 'false');
  },
  async 'dragging turns, the wheel comes closer, fingers pinch'() {
    const page = await opened(prism, { hasTouch: true });
    const camera = () => page.evaluate(() => ({ ...window.rayscope.camera }));
    const before = await camera(), first = await picture(page);
    await page.mouse.move(400, 300);
    await page.mouse.down();
    await page.mouse.move(500, 340, { steps: 4 });
    await page.mouse.up();
    const turned = await camera();
    assert.notEqual(turned.azimuth, before.azimuth);
    assert.notEqual(await picture(page), first);
    await page.mouse.wheel(0, -300);
    await page.waitForFunction(distance => window.rayscope.camera.distance < distance, turned.distance);
    const touch = await page.context().newCDPSession(page), near = await camera();
    const fingers = (type, gap) => touch.send('Input.dispatchTouchEvent', { type, touchPoints: type === 'touchEnd' ? [] : [{ x: 400 - gap, y: 300, id: 0 }, { x: 400 + gap, y: 300, id: 1 }] });
    await fingers('touchStart', 40);
    await fingers('touchMove', 90);
    await fingers('touchEnd', 0);
    assert.ok((await camera()).distance < near.distance);
    await page.locator('[data-camera=fit]').click();
    assert.ok(Math.abs((await camera()).distance - before.distance) < 1e-9);
    await page.locator('[data-camera=eye]').click();
    assert.notEqual((await camera()).distance, before.distance);
  },
  async 'the sweep line tells what contains a t'() {
    const page = await opened(prism, { hash: '#ray=4' });
    const area = await page.locator('#lanes-drawing svg').boundingBox();
    await page.mouse.move(area.x + 300, area.y + 40);
    const t = Number(await page.locator('[data-sweep]').getAttribute('data-sweep'));
    const inside = await page.locator('[data-inside]').first().getAttribute('data-inside');
    const spans = await page.evaluate(() => trace.rays[4].events.filter(e => e.event === 'span_found').at(-1));
    assert.equal(inside, String(0 < t && t < 1.4528));
    assert.ok(spans !== undefined);
  },
  async 'without WebGL it can be read'() {
    const page = await opened(prism, { before: () => { HTMLCanvasElement.prototype.getContext = () => null; } });
    assert.match(await page.locator('#unseen').textContent(), /shows no WebGL 2/);
    await page.keyboard.press('ArrowRight');
    assert.equal((await state(page)).ray, 1);
    assert.ok(await page.locator('#tree .row').count() === 10);
  },
  async 'it prints as a whole'() {
    const page = await opened(prism);
    await page.emulateMedia({ media: 'print' });
    assert.equal(await page.locator('#tree .row').count(), 10);
    assert.equal(await page.locator('#steps').isVisible(), false);
    assert.ok((await page.pdf()).length > 20_000);
  },
  async 'it can be used without seeing it'() {
    const page = await opened(prism, { reducedMotion: 'reduce' });
    const nameless = await page.evaluate(() => [...document.querySelectorAll('button, select, input, canvas, [role=tree]')]
      .filter(e => !(e.getAttribute('aria-label') || e.getAttribute('aria-labelledby') || e.textContent.trim() || e.closest('label'))).map(e => e.outerHTML));
    assert.deepEqual(nameless, []);
    await page.locator('#tree').focus();
    await page.keyboard.press('ArrowDown');
    assert.equal(await page.locator('#tree').getAttribute('aria-activedescendant'), 'row-1');
    // Texts against what they stand on: contrast AA.
    const faint = await page.evaluate(() => {
      const channels = text => text.match(/[\d.]+/g).map(Number);
      const light = c => { const [r, g, b] = c.map(v => v / 255).map(v => v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4); return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
      const ground = e => { for (; e; e = e.parentElement) { const c = channels(getComputedStyle(e).backgroundColor); if (c.length < 4 || c[3] > 0.5) return c; } return [255, 255, 255]; };
      return [...document.querySelectorAll('h1, h2, h3, th, td, li, .row, .share, label, output, button')].filter(e => e.textContent.trim() && e.offsetParent).map(e => {
        const [a, b] = [light(channels(getComputedStyle(e).color)), light(ground(e))].sort((x, y) => y - x);
        return [(a + 0.05) / (b + 0.05), e.outerHTML.slice(0, 90)];
      }).filter(([contrast]) => contrast < 4.5);
    });
    assert.deepEqual(faint, []);
    await page.keyboard.press('?');
    assert.ok(await page.locator('#help').evaluate(dialog => dialog.open));
  },
  async 'hostile names are shown as text'() {
    mkdirSync(join(folder, 'a<'));
    const hostile = 'a</script><img src=x onerror=window.hit=1>.toml';
    writeFileSync(join(folder, hostile), readFileSync(join(source, 'chapters/04_refraction/prism.toml')));
    const page = await opened(pageOf(hostile, 'hostile.html'));
    assert.equal(await page.evaluate(() => window.hit), undefined);
    assert.equal(await page.locator('img').count(), 0);
    assert.match(await page.locator('#title').textContent(), /<img src=x onerror=window.hit=1>/);
  },
  async 'thousands of rays stay quick'() {
    writeFileSync(join(folder, 'deep.toml'), '[camera]\neye = [0, 0, 4]\nlook_at = [0, 0, 0]\n[limits]\nmax_depth = 14\nmin_weight = 0.0\nmax_rays = 5000\n' +
      '[lights.lamp]\nposition = [1, 2, 3]\n[materials.glass]\nreflection = 0.45\ntransmission = 0.55\nindex = 1.5\n[materials.mirror]\nreflection = 0.9\n' +
      '[generics.ball]\nshape = "sphere"\nmaterial = "glass"\n[generics.room]\nshape = "sphere"\nmaterial = "mirror"\ntransform = [{scale = 6}]\n');
    const file = pageOf('deep.toml', 'deep.html', '--ray', '0.2,0.1,4,0.02,0.01,-1');
    const page = await opened(file);
    const rays = await page.evaluate(() => trace.rays.length);
    assert.ok(rays > 3000, String(rays));
    const times = await page.evaluate(() => [10, 500, 1500, 2500, 3000].map(ray => { const t = performance.now(); window.rayscope.go(ray); document.body.offsetHeight; return performance.now() - t; }));
    console.log(`   ${rays} rays: steps of ${times.map(t => t.toFixed(0)).join(', ')} ms`);
    assert.ok(times.sort((a, b) => a - b)[2] < 100, times.join());
    assert.ok(await page.locator('#tree .row').count() < 100);
    await page.locator('#least').fill('50');
    assert.match(await page.locator('#recursion-title').textContent(), /shown/);
  },
};

const prism = pageOf('prism', 'prism.html');
const code = await runAll(tests, ['file://', 'data:']);
await browser.close();
rmSync(folder, { recursive: true });
process.exit(code);
