// The view of a page, to be carried over to another one: the camera, and the controls that somebody has changed.

const controls = () => [...document.querySelectorAll('#viewer select, #viewer input[type=checkbox]')]
  .filter(({id}) => id !== 'result');
const valueOf = (control) => control.type === 'checkbox' ? control.checked : control.value;

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

export class ViewState {
  /** \param app as the page opens */
  constructor(app) {
    this.app = app;
    this.controls = new Map(controls().map((control) => [control.id, valueOf(control)]));
    this.camera = JSON.stringify(cameraOf(app));
  }

  /** What somebody has changed: controls by name, and the camera, or null. */
  changes() {
    const changed = controls().map((control) => [control.id, valueOf(control)])
      .filter(([id, value]) => value !== this.controls.get(id));
    const camera = JSON.stringify(cameraOf(this.app)) === this.camera ? null : cameraOf(this.app);
    return {changed, camera};
  }

  restore({changed, camera}) {
    for (const [id, value] of changed) {
      this.app.setControl(id, value === true ? 'on' : value === false ? 'off' : value);
      document.getElementById(id)?.dispatchEvent(new Event('change'));
    }
    if (camera) setCamera(this.app, camera);
  }
}
