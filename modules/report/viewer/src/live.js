// A page that `simplify --live` has written while its run goes on: it reads its file again, until that has no mark of
// such a page or says why the run has ended. Camera and controls stay as they are, up to the report in the end.

const interval = 1000; // milliseconds between two readings
const key = `whittle ${location.pathname}`; // in the storage of the tab

const controls = () => [...document.querySelectorAll('#viewer select, #viewer input[type=checkbox]')]
  .filter(({id}) => id !== 'result');
const valueOf = (control) => control.type === 'checkbox' ? control.checked : control.value;

/** Storage may be forbidden; then each reading begins with the usual view. */
function stored(use) {
  try {
    return use(sessionStorage);
  } catch {
    return null;
  }
}

/** The camera by the units of the model: those of the page are other ones in each page. */
function cameraOf({view, json}) {
  const inModel = (point) => point.toArray().map((x, i) => json.origin[i] + x * json.step * 65535);
  return {position: inModel(view.camera.position), target: inModel(view.controls.target)};
}

function setCamera({view, json}, {position, target}) {
  const inPage = (point) => point.map((x, i) => (x - json.origin[i]) / (json.step * 65535));
  view.camera.position.fromArray(inPage(position));
  view.controls.target.fromArray(inPage(target));
  view.controls.update();
}

/** Sets what was left of the page before, if there was one. */
function restore(app) {
  const text = stored((storage) => storage.getItem(key));
  if (!text) return;
  stored((storage) => storage.removeItem(key));
  const {changed, camera} = JSON.parse(text);
  for (const [id, value] of changed) {
    app.setControl(id, value === true ? 'on' : value === false ? 'off' : value);
    document.getElementById(id)?.dispatchEvent(new Event('change'));
  }
  if (camera) setCamera(app, camera);
}

function words({stage, fraction, faces, target, seconds, problem}) {
  const percent = fraction > 0 ? `, ${Math.floor(100 * fraction)} %` : '';
  const where = `${stage}${percent}: ${faces.toLocaleString('en')} ${faces === 1 ? 'face' : 'faces'} left`;
  const how = `${where}, target ${target}, ${seconds.toFixed(1)} s since the beginning`;
  return problem ? `The run has ended without a result: ${problem}. It was at: ${how}` : how;
}

/** \param app that shows the page */
export function followRun(app) {
  const before = new Map(controls().map((control) => [control.id, valueOf(control)])); // as the page opens
  const cameraBefore = JSON.stringify(cameraOf(app));
  restore(app);
  const {live} = app.json;
  if (!live) return;
  const note = document.createElement('p');
  note.id = 'live';
  note.setAttribute('role', 'status');
  note.textContent = words(live);
  document.getElementById('stage').append(note);
  if (live.problem) return;
  let isPressed = false; // nobody is interrupted while dragging
  addEventListener('pointerdown', () => { isPressed = true; });
  for (const type of ['pointerup', 'pointercancel']) addEventListener(type, () => { isPressed = false; });
  setInterval(() => {
    if (isPressed) return;
    const changed = controls().map((control) => [control.id, valueOf(control)])
      .filter(([id, value]) => value !== before.get(id));
    const camera = JSON.stringify(cameraOf(app)) === cameraBefore ? null : cameraOf(app);
    stored((storage) => storage.setItem(key, JSON.stringify({changed, camera})));
    location.reload();
  }, interval);
}
