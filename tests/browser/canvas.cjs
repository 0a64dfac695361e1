// What is drawn in a page.
'use strict';

/** The pixels of the canvas, as something to give to `page.evaluate`: {data, width, height}, four bytes a pixel. */
const pixelsOfCanvas = (page) => page.evaluateHandle(() => {
  const canvas = document.getElementById('canvas');
  const copy = document.createElement('canvas');
  [copy.width, copy.height] = [canvas.width, canvas.height];
  const context = copy.getContext('2d', {willReadFrequently: true});
  context.drawImage(canvas, 0, 0);
  const {data, width, height} = context.getImageData(0, 0, copy.width, copy.height);
  return {data, width, height};
});

module.exports = {pixelsOfCanvas};
