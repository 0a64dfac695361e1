// What the colours of errors in a page mean, against the exact distances of the meshes in it.
'use strict';
const {pixelsOfCanvas} = require('./canvas.cjs');
const {exactDistance, firstPoint} = require('./exact_distance.cjs');

/** Random pixels of a pane that are not background, with their colours and the rays through their middles. */
const seenPixels = async (page, pane, n) => page.evaluate(([canvas, paneOf, nPixels]) => {
  const {view} = window.whittle;
  const colourAt = (i) => Array.from(canvas.data.subarray(4 * i, 4 * i + 3));
  const background = window.whittle.background.match(/\w\w/g).map((part) => parseInt(part, 16)).join();
  const {left, width, height} = view.sharpBoxes()[paneOf];
  let seed = 1;
  const random = (below) => Math.floor((seed = seed * 48271 % 2147483647) / 2147483647 * below);
  const grid = (vector) => vector.toArray().map((coordinate) => 65535 * coordinate);
  const pixels = [];
  while (pixels.length < nPixels) {
    const [x, y] = [random(width), random(height)];
    const colour = colourAt(left + x + y * canvas.width);
    if (colour.join() === background) continue;
    const {position} = view.camera;
    const beyond = position.clone().set(2 * (x + 0.5) / width - 1, 1 - 2 * (y + 0.5) / height, 0.5).unproject(view.camera);
    pixels.push({colour, origin: grid(position), direction: grid(beyond.sub(position))});
  }
  return pixels;
}, [await pixelsOfCanvas(page), pane, n]);

/** The meshes as the page has them, the legend's colours, and where the scale ends. Lengths are those of its grid. */
const shownMeshes = (page) => page.evaluate(() => {
  const app = window.whittle;
  return {
    meshes: [app.original, app.result].map(({surface}) => {
      const {positions, corners, nFaces} = surface.onGrid?.() ?? surface;
      return {
        positions: Array.from({length: surface.nVertices}, (_, v) => [0, 1, 2].map((d) => positions[4 * v + d])),
        corners: Array.from(corners.subarray(0, 3 * nFaces)),
      };
    }),
    colours: [...document.querySelectorAll('#legend .steps span')].map(
      ({style}) => style.backgroundColor.match(/\d+/g).map(Number)),
    top: app.greatestShown() / app.json.step,
  };
});

/** Which colour it is, in whatever light. */
function stepOf(colour, colours) {
  const along = ([r, g, b]) => [r, g, b].map((part) => part / Math.hypot(r, g, b));
  const cosines = colours.map((other) => along(other).reduce((sum, part, d) => sum + part * along(colour)[d], 0));
  return cosines.indexOf(Math.max(...cosines));
}

/** How far colours are off at n random pixels of a pane, each in steps of the scale. Infinity where something else is seen.
    \param page has both meshes side by side */
async function stepsOff(page, pane, n) {
  const {meshes, colours, top} = await shownMeshes(page);
  const pixels = await seenPixels(page, pane, n);
  return pixels.map(({colour, origin, direction}) => {
    const point = firstPoint(origin, direction, meshes[pane]);
    if (!point) return Infinity;
    const exact = Math.min(exactDistance(point, meshes[1 - pane]) / top, 1) * colours.length;
    const step = stepOf(colour, colours);
    return Math.max(0, step - exact, exact - (step + 1));
  });
}

module.exports = {stepsOff};
