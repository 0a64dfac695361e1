// measure_simplify.cjs NODE_MODULES CHROMIUM PAGE.html MESH...: prints how fast the page that simplifies is, in software
// rendering: seconds from choosing a mesh until its level of a tenth is seen, from Simplify until the result is seen, until
// the error curve is complete, and the longest task of the page's own thread meanwhile.
'use strict';
const path = require('path');
const [nodeModules, chromium, file, ...meshes] = process.argv.slice(2);
const patience = 2000; // milliseconds after the page was opened
const {chromium: driver} = require(path.join(path.resolve(nodeModules), 'playwright-core'));

/** Seconds until something is so, looked at on each frame. */
const untilSeen = (page, condition) => page.evaluate(async (text) => {
  const isSo = new Function(`return ${text}`)();
  const begin = performance.now();
  while (!isSo()) await new Promise(requestAnimationFrame);
  await window.whittle.drawn();
  return (performance.now() - begin) / 1000;
}, condition.toString());

async function measure(browser, mesh) {
  const page = await browser.newPage({viewport: {width: 1366, height: 768}});
  await page.addInitScript(() => {
    window.longest = 0;
    new PerformanceObserver((list) => {
      for (const {duration} of list.getEntries()) window.longest = Math.max(window.longest, duration);
    }).observe({type: 'longtask', buffered: true});
  });
  await page.goto(`file://${path.resolve(file)}`);
  await page.waitForTimeout(patience);
  const opens = untilSeen(page, () => Boolean(window.whittle?.recording));
  await page.setInputFiles('#files', [mesh]);
  const opened = await opens;
  await page.click('#simplify');
  const made = await untilSeen(page, () => document.querySelectorAll('#made dt').length > 1);
  const curve = await untilSeen(page, () => document.getElementById('measured').textContent === '');
  const longest = await page.evaluate(() => window.longest);
  console.log(`${path.basename(mesh)}: opened in ${opened.toFixed(2)} s, simplified in ${made.toFixed(2)} s, ` +
    `the curve ${curve.toFixed(2)} s later; the longest task took ${longest} ms`);
  await page.close();
}

async function main() {
  const browser = await driver.launch({executablePath: chromium,
    args: ['--no-sandbox', '--disable-dev-shm-usage', '--use-angle=swiftshader', '--enable-unsafe-swiftshader']});
  for (const mesh of meshes) await measure(browser, mesh);
  await browser.close();
}

main().catch((error) => {
  console.error(error);
  process.exit(1);
});
