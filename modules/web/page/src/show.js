// Shows one page of meshes after another in the viewer.
import {App, prepare} from '../../../report/viewer/src/app.js';
import {contextOf} from '../../../report/viewer/src/view.js';
import {ViewState} from '../../../report/viewer/src/view_state.js';

const ids = ['viewer', 'advice', 'keys']; // of the viewer's markup
const $ = (id) => document.getElementById(id);

/** A page that the worker has made: its arrays are as they are in memory. */
function reader({json, bytes}) {
  const array = ({at, count, size}, Type) => new Type(bytes.slice(at, at + count * size));
  return {json, array};
}

/** What comes after is a task of its own, so that the page answers before. */
const ownTask = () => new Promise((next) => setTimeout(next));

export class Show {
  constructor() {
    this.markup = ids.map((id) => $(id).cloneNode(true));
    this.app = null;
    this.nShown = 0;
  }

  /** \param page {json, bytes} \param isSameMesh whether the camera stays \param onReady is called before it is drawn
      \return whether it can be drawn: another one may have been asked for meanwhile */
  async show(page, isSameMesh, onReady) {
    const number = ++this.nShown;
    const prepared = await prepare(reader(page));
    const markup = this.markup.map((element) => element.cloneNode(true));
    await ownTask();
    contextOf(markup[0].querySelector('#canvas'));
    await ownTask();
    if (number !== this.nShown) return false;
    const changes = this.state?.changes() ?? {changed: [], camera: null};
    if (!isSameMesh) changes.camera = null;
    this.app?.close();
    ids.forEach((id, i) => $(id).replaceWith(markup[i])); // nothing listens to it any more
    onReady();
    this.app = new App(prepared, {isPlayed: false, isHeld: true});
    await ownTask();
    if (number !== this.nShown) return false;
    window.whittle = this.app;
    this.state = new ViewState(this.app);
    this.state.restore(changes);
    this.app.motion.stop();
    return true;
  }

  draw() {
    this.app.show();
  }

  /** Shows the level of the recording with at most so many faces. */
  goToFaces(nFaces) {
    this.app.showRecording();
    this.app.player.goToFaces(nFaces);
  }

  /** Shows the mesh that was made. */
  showResult() {
    $('result').value = this.app.results.length - 1;
    $('result').dispatchEvent(new Event('change'));
  }

  /** The mesh that was made was measured. \param error {mean, max} or null */
  takeError(error) {
    this.app.results.at(-1).surface.error = error;
    this.app.showLabels();
  }

  /** Levels were measured. */
  takeLevels(levels) {
    this.app.recording.levels = levels;
    this.app.offerErrors();
    this.app.showLevel();
  }
}
