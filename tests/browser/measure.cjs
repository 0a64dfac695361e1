// measure.cjs NODE_MODULES CHROMIUM PAGE...: prints how fast pages are, in software rendering: milliseconds until the
// first picture, frames a second while the view turns, and, of a recording, milliseconds a step through 1,000 levels.
'use strict';
const path = require('path');
const [nodeModules, chromium, ...pages] = process.argv.slice(2);
const {chromium: driver} = require(path.join(path.resolve(nodeModules), 'playwright-core'));

async function measure(browser, file) {
  const page = await browser.newPage({viewport: {width: 1366, height: 768}});
  await page.goto(`file://${path.resolve(file)}`);
  await page.waitForFunction(() => document.documentElement.dataset.ready);
  const first = await page.evaluate(() => document.documentElement.dataset.ready);
  await page.evaluate(() => window.whittle.drawn());
  const seconds = await page.evaluate(() => new Promise((done) => {
    const nFrames = 60;
    let n = 0;
    const begin = performance.now();
    const turn = () => {
      if (n++ === nFrames) return done((performance.now() - begin) / 1000 / nFrames);
      window.whittle.view.rotate(0.05, 0);
      requestAnimationFrame(turn);
    };
    requestAnimationFrame(turn);
  }));
  const steps = await page.evaluate(async () => {
    const {player} = window.whittle;
    if (!player) return null;
    const times = [];
    for (let i = 1000; i >= 0; --i) {
      player.goTo(i / 1000);
      times.push(player.lastStepMs);
      if (i % 10 === 0) await new Promise(requestAnimationFrame);
    }
    times.sort((a, b) => a - b);
    return {median: times[500], most: times[1000]};
  });
  console.log(`${path.basename(file)}: first picture ${first} ms, ${(1 / seconds).toFixed(1)} frames a second` +
    (steps ? `, a step ${steps.median.toFixed(2)} ms, at most ${steps.most.toFixed(2)} ms` : ''));
  await page.close();
}

async function main() {
  const browser = await driver.launch({executablePath: chromium,
    args: ['--no-sandbox', '--disable-dev-shm-usage', '--use-angle=swiftshader', '--enable-unsafe-swiftshader']});
  for (const page of pages) await measure(browser, page);
  await browser.close();
}

main().catch((error) => {
  console.error(error);
  process.exit(1);
});
