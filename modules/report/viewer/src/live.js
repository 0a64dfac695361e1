// A page that `simplify --live` has written while its run goes on: it reads its file again, until that has no mark of
// such a page or says why the run has ended. Camera and controls stay as they are, up to the report in the end.
import {ViewState} from './view_state.js';

const interval = 1000; // milliseconds between two readings
const key = `whittle ${location.pathname}`; // in the storage of the tab

/** Storage may be forbidden; then each reading begins with the usual view. */
function stored(use) {
  try {
    return use(sessionStorage);
  } catch {
    return null;
  }
}

/** Sets what was left of the page before, if there was one. */
function restore(state) {
  const text = stored((storage) => storage.getItem(key));
  if (!text) return;
  stored((storage) => storage.removeItem(key));
  state.restore(JSON.parse(text));
}

function words({stage, fraction, faces, target, seconds, problem}) {
  const percent = fraction > 0 ? `, ${Math.floor(100 * fraction)} %` : '';
  const where = `${stage}${percent}: ${faces.toLocaleString('en')} ${faces === 1 ? 'face' : 'faces'} left`;
  const how = `${where}, target ${target}, ${seconds.toFixed(1)} s since the beginning`;
  return problem ? `The run has ended without a result: ${problem}. It was at: ${how}` : how;
}

/** \param app that shows the page */
export function followRun(app) {
  const state = new ViewState(app);
  restore(state);
  const {live} = app.json;
  if (!live) return;
  const note = document.createElement('p');
  note.id = 'live';
  note.setAttribute('role', 'status');
  note.textContent = words(live);
  document.getElementById('meanings').prepend(note);
  if (live.problem) return;
  let isPressed = false; // nobody is interrupted while dragging
  addEventListener('pointerdown', () => { isPressed = true; });
  for (const type of ['pointerup', 'pointercancel']) addEventListener(type, () => { isPressed = false; });
  setInterval(() => {
    if (isPressed) return;
    stored((storage) => storage.setItem(key, JSON.stringify(state.changes())));
    location.reload();
  }, interval);
}
