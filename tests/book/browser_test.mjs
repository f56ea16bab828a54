// The book in a browser, opened as files: no errors, nothing fetched, formulas set, an embedded ray that moves.
// node browser_test.mjs PROGRAM SOURCE_FOLDER NODE_MODULES; ends with 77 where browser, library or pandoc are missing.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import assert from 'node:assert/strict';
import { found, launched, missing, program, runAll, source, watched } from '../support/browser.mjs';

if (!found('/usr/bin/pandoc', '/usr/local/bin/pandoc')) missing('pandoc');
const browser = await launched();
const folder = mkdtempSync(join(tmpdir(), 'rayscope-book-')), site = join(folder, 'site');
execFileSync('python3', ['-B', join(source, 'chapters/book/build.py'), '-o', site, '--program', program], { stdio: 'inherit' });
const pages = readdirSync(site, { recursive: true, encoding: 'utf8' }).filter(name => name.endsWith('.html') && !/^(rays|source)\//.test(name)).sort();

const opened = async (name, width = 1280) => {
  const context = await browser.newContext({ viewport: { width, height: 800 } });
  const page = await watched(context);
  await page.goto(pathToFileURL(join(site, name)).href);
  return page;
};

const tests = {
  async 'every page opens, and fits a desktop and a phone'() {
    assert.ok(pages.length >= 12, pages.join());
    for (const name of pages) {
      const page = await opened(name);
      for (const width of [1280, 360]) {
        await page.setViewportSize({ width, height: 800 });
        const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
        assert.ok(wide <= 0, `${name} is ${wide} pixels too wide at ${width}`);
        const broken = await page.evaluate(async () => {
          const images = [...document.images];
          for (const image of images) image.loading = 'eager';
          await Promise.all(images.map(image => image.decode().catch(() => {})));
          return images.filter(image => image.naturalWidth === 0).map(image => image.src);
        });
        assert.deepEqual(broken, [], name);
      }
      await page.context().close();
    }
  },
  async 'texts stand out from their ground'() {
    for (const name of ['index.html', 'reference/debugger.html', 'reference/extending.html'].filter(name => pages.includes(name))) {
      const page = await opened(name);
      const faint = await page.evaluate(() => {
        const channels = text => text.match(/[\d.]+/g).map(Number);
        const light = c => { const [r, g, b] = c.map(v => v / 255).map(v => v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4); return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
        const ground = e => { for (; e; e = e.parentElement) { const c = channels(getComputedStyle(e).backgroundColor); if (c.length < 4 || c[3] > 0.5) return c; } return [255, 255, 255]; };
        return [...document.querySelectorAll('h1, h2, h3, p, li, th, td, a, code, code span, figcaption')].filter(e => e.textContent.trim() && e.offsetParent).map(e => {
          const [a, b] = [light(channels(getComputedStyle(e).color)), light(ground(e))].sort((x, y) => y - x);
          return [(a + 0.05) / (b + 0.05), e.outerHTML.slice(0, 90)];
        }).filter(([contrast]) => contrast < 4.5);
      });
      assert.deepEqual(faint, [], name);
    }
  },
  async 'an embedded ray can be walked'() {
    for (const name of pages) {
      const page = await opened(name), frames = page.locator('figure.ray iframe');
      if (await frames.count() === 0) { await page.context().close(); continue; }
      await frames.first().scrollIntoViewIfNeeded();
      const frame = await (await frames.first().elementHandle()).contentFrame();
      await frame.waitForFunction(() => window.rayscope !== undefined);
      assert.equal((await frame.evaluate(() => window.rayscope.state())).ray, 0);
      await frame.locator('#row-1').click();
      assert.equal((await frame.evaluate(() => window.rayscope.state())).ray, 1);
      await page.locator('figure.ray figcaption a').first().click();
      await page.waitForFunction(() => window.rayscope !== undefined);
      return;
    }
    assert.fail('no page has a ray');
  },
  async 'it can be walked without script'() {
    const context = await browser.newContext({ javaScriptEnabled: false });
    const page = await context.newPage();
    await page.goto(pathToFileURL(join(site, 'index.html')).href);
    await page.locator('a[rel=next]').click();
    const second = page.url();
    await page.locator('a[rel=prev]').click();
    const address = second.slice(page.url().lastIndexOf('/') + 1); // seen from the first page
    await page.locator(`nav#contents a[href="${address}"]`).click();
    assert.equal(page.url(), second);
  },
  async 'formulas are set as formulas'() {
    for (const name of pages) {
      const page = await opened(name);
      const flat = await page.evaluate(() => [...document.querySelectorAll('math mfrac')].filter(e => {
        const [top, bottom] = [...e.children].map(part => part.getBoundingClientRect());
        return top.bottom > bottom.top + 2;
      }).length);
      assert.equal(flat, 0, name);
      await page.context().close();
    }
  },
};

const code = await runAll(tests, [pathToFileURL(site).href, 'data:', 'blob:']);
await browser.close();
rmSync(folder, { recursive: true });
process.exit(code);
