// What tests in Debian's Chromium share: node browser_test.mjs PROGRAM SOURCE_FOLDER NODE_MODULES.
import { existsSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import assert from 'node:assert/strict';

export const [program, source, modules] = process.argv.slice(2);
export const found = (...files) => files.find(existsSync);
export const missing = what => {
  console.log('not run: ' + what + ' is missing');
  process.exit(process.env.RAYSCOPE_NEED_BROWSER ? 1 : 77);
};

/// Ends with 77 where browser or library are missing.
export const launched = async () => {
  const executablePath = found('/usr/bin/chromium', '/usr/bin/chromium-browser');
  if (!executablePath) missing('chromium');
  let playwright;
  try { playwright = createRequire(join(modules, 'x.js'))('playwright-core'); } catch { missing('playwright-core in ' + modules); }
  return playwright.chromium.launch({ executablePath,
    args: ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync',
      '--use-angle=swiftshader', '--enable-unsafe-swiftshader'] });
};

const troubles = [], requests = [];
/// A new page whose console and requests are listened to.
export const watched = async context => {
  const page = await context.newPage();
  page.on('console', message => { if (['error', 'warning'].includes(message.type()) && !/GPU stall|swiftshader/i.test(message.text())) troubles.push(message.text()); });
  page.on('pageerror', error => troubles.push(String(error)));
  page.on('request', request => requests.push(request.url()));
  return page;
};

/// Runs all tests; gives the exit code.
/// @param allowed beginnings of addresses that may be asked for
export const runAll = async (tests, allowed) => {
  let failed = 0;
  for (const [name, test] of Object.entries(tests)) {
    try {
      await test();
      assert.deepEqual(troubles.splice(0), [], 'the console is silent');
      const outside = requests.splice(0).filter(url => !allowed.some(beginning => url.startsWith(beginning)));
      assert.deepEqual(outside, [], 'nothing is fetched but from ' + allowed.join(', '));
      console.log('ok   ' + name);
    } catch (error) {
      ++failed;
      console.log('FAIL ' + name + '\n' + (error.stack ?? error));
    }
  }
  return failed > 0 ? 1 : 0;
};
