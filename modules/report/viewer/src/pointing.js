// What clicks and fingers on the canvas do, beside what turns, moves and zooms.

const near = 4; // pixels that a click may move
const nearTap = 25; // pixels between the two of a double click
const soon = 350; // milliseconds between them
const begin = 8; // pixels after which it is plain what two fingers do

/** \param onClick, onDoubleClick are called with the event */
export function setUpClicks(canvas, {onClick, onDoubleClick}) {
  let down = null;
  let last = null;
  const isNear = (a, b, distance) => a && Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY) < distance;
  canvas.addEventListener('pointerdown', (event) => { down = event.isPrimary && event.button === 0 ? event : null; });
  canvas.addEventListener('pointerup', (event) => {
    if (!isNear(down, event, near)) return;
    const isSecond = isNear(last, event, nearTap) && event.timeStamp - last.timeStamp < soon;
    last = isSecond ? null : event;
    if (isSecond) onDoubleClick(event); else onClick(event);
  });
}

const middleOf = ([a, b]) => ({y: (a.clientY + b.clientY) / 2, apart: Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY)});

/** Two fingers zoom if they go apart, and scroll the page if they go up or down together. Otherwise a page whose picture
    fills the window of a phone could not be scrolled. \param view its controls would move the meshes */
export function setUpFingers(canvas, view) {
  let start = null;
  let last = null;
  let doing = null; // what two fingers do, once it is plain
  canvas.addEventListener('pointerdown', (event) => { view.controls.enablePan = event.pointerType !== 'touch'; }, {capture: true});
  const begins = ({touches}) => {
    [start, doing] = [touches.length === 2 ? middleOf(touches) : null, null];
    last = start;
    view.controls.enableZoom = !start;
  };
  for (const type of ['touchstart', 'touchend', 'touchcancel']) canvas.addEventListener(type, begins, {passive: true});
  canvas.addEventListener('touchmove', ({touches}) => {
    if (!start || touches.length !== 2) return;
    const now = middleOf(touches);
    const [along, apart] = [Math.abs(now.y - start.y), Math.abs(now.apart - start.apart)];
    if (!doing && Math.max(along, apart) > begin) doing = along > apart ? 'scrolls' : 'zooms';
    if (doing === 'scrolls') window.scrollBy({top: last.y - now.y, behavior: 'instant'});
    view.controls.enableZoom = doing === 'zooms';
    last = now;
  }, {passive: true});
}
