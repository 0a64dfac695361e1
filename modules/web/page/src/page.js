// The page that simplifies: what happens when somebody opens a mesh, asks for something, and saves it.
import {doInSlices} from '../../../report/viewer/src/slices.js';
import {Curve} from './curve.js';
import {Cancelled} from './calls.js';
import {writeExample} from './example.js';
import {droppedFiles, filesOfMesh, meshesOf, named, setUpDrops} from './files.js';
import {say} from './messages.js';
import {Outcome} from './outcome.js';
import {Show} from './show.js';
import {Target} from './target.js';
import {Work} from './work.js';
import {problemText} from './words.js';

const mostRuns = 3; // for a size of the file
const $ = (id) => document.getElementById(id);

export class Page {
  constructor(calls) {
    this.calls = calls;
    this.mesh = null; // that is shown
    this.show = new Show();
    this.work = new Work((isBusy) => this.allow(!isBusy));
    this.outcome = new Outcome();
    this.target = new Target(() => this.onTarget());
    this.curve = new Curve($('curve'), (nFaces) => this.target.setFaces(nFaces));
    this.setUpEvents();
  }

  setUpEvents() {
    for (const id of ['choose', 'open']) $(id).addEventListener('click', () => $('files').click());
    $('files').addEventListener('change', () => {
      this.take([...$('files').files].map(named));
      $('files').value = ''; // the same file may be chosen again
    });
    setUpDrops(async (transfer) => this.take(await droppedFiles(transfer)));
    $('example').addEventListener('click', () => this.openExample());
    $('mesh').addEventListener('change', () => this.open(this.files, $('mesh').value));
    $('simplify').addEventListener('click', () => this.simplify());
    $('save-result').addEventListener('click', () => this.save());
    $('effort').addEventListener('change', () => this.outcome.show(this.key()));
    $('format').addEventListener('change', () => this.onFormat());
    $('dismiss').addEventListener('click', () => say({}));
  }

  allow(isAllowed) {
    for (const id of ['save-result', 'format']) $(id).disabled = !isAllowed;
  }

  // Opening ----------------------------------------------------------------------------------------------------------

  take(files) {
    const meshes = meshesOf(files);
    if (meshes.length > 0) this.open(files, meshes[0].name);
    else if (files.length > 0) say({problem: 'None of these files is a mesh. The page reads OBJ, PLY, STL, OFF and glTF, also as .gz.'});
  }

  async openExample() {
    const lines = [];
    await doInSlices(writeExample(lines));
    this.take([named(new File([lines.join('\n')], 'knot.obj'))]);
  }

  async open(files, name) {
    this.measuring = null;
    const source = {files: filesOfMesh(files, name), name};
    await this.work.does(this.mesh ? $('ask') : $('ways'), async (listeners) => {
      const {facts, page} = await this.calls.open(source, listeners);
      if (await this.show.show(page, false, () => this.reveal({files, name}, facts))) this.begin({...facts, source, isMeasured: false});
    });
    if (!this.mesh) return;
    $('mesh').value = this.mesh.source.name; // if it failed, the one that is still shown
    this.measure();
  }

  /** All that takes room is there before the picture is drawn: one of another size would have to be drawn anew. */
  reveal({files, name}, {warnings}) {
    this.files = files;
    say({notes: warnings});
    $('title').textContent = document.title = name;
    $('mesh').replaceChildren(...meshesOf(files).map((file) => new Option(file.name)));
    $('mesh').value = name;
    $('meshes').hidden = $('mesh').options.length < 2;
    $('welcome').hidden = true;
    for (const id of ['viewer', 'target', 'course', 'outcome', 'open', 'privacy']) $(id).hidden = false;
  }

  /** \param mesh that is shown from now on, as the worker has told of it */
  begin(mesh) {
    this.mesh = mesh;
    mesh.fewest = Math.max(1, this.show.app.recording.facesAfter.at(-1));
    this.outcome.reset(mesh);
    this.takeRecording([]);
    this.target.reset(mesh);
    this.show.draw();
  }

  /** The viewer has a new recording. \param levels of it that were measured */
  takeRecording(levels) {
    const {recording} = this.show.app;
    this.mesh.recording = recording;
    this.mesh.bytesPerFace = this.outcome.bytesPerFace();
    if (levels.length > recording.levels.length) this.show.takeLevels(levels);
    this.curve.setMesh(recording, this.mesh.fewest, this.mesh.faces);
  }

  /** Has the error curve measured while nothing else is asked for; again if the worker has lost it meanwhile. */
  async measure() {
    const {mesh} = this;
    const measuring = {};
    this.measuring = measuring;
    $('measured').textContent = mesh.isMeasured ? '' : 'measuring';
    const isWanted = () => this.measuring === measuring;
    await this.show.app.drawn(); // which takes all cores of small machines
    while (!mesh.isMeasured && isWanted()) {
      try {
        await this.calls.measure(mesh.source, (point) => { if (isWanted()) this.takeLevel(point); });
        mesh.isMeasured = true;
      } catch (error) {
        if (error instanceof Cancelled) continue;
        if (isWanted()) say({problem: problemText(error)});
        break;
      }
    }
    if (isWanted()) $('measured').textContent = '';
  }

  takeLevel(point) {
    const others = this.mesh.recording.levels.filter(({faces}) => faces !== point.faces);
    this.show.takeLevels([...others, point].sort((a, b) => b.faces - a.faces));
    this.curve.update();
    this.target.show();
  }

  // What is asked for ------------------------------------------------------------------------------------------------

  /** Tells apart what is asked for. */
  key() {
    const effort = $('effort').value;
    return [this.target.key(), effort, this.target.kind === 'size' ? this.outcome.format() : ''].join();
  }

  onTarget() {
    const nFaces = this.target.faces();
    this.show.goToFaces(nFaces);
    this.curve.mark(nFaces);
    this.outcome.show(this.key());
  }

  /** Whether the worker can write the result. */
  isInMemory() {
    const {made} = this.outcome;
    return made !== null && made.memory === this.calls.memory;
  }

  /** The result is written anew, so that its size is told. */
  async onFormat() {
    if (this.isInMemory()) await this.work.does($('ask'), async (listeners) => say({notes: await this.write(listeners)}));
    this.mesh.bytesPerFace = this.outcome.bytesPerFace();
    this.target.show();
    this.outcome.show(this.key());
  }

  // Making it --------------------------------------------------------------------------------------------------------

  /** \return whether it was done */
  simplify() {
    return this.work.does($('ask'), async (listeners) => {
      const {result, notes} = await this.run(listeners);
      const {levels} = this.mesh.recording;
      if (!await this.show.show(result.page, true, () => say({notes}))) return;
      this.takeRecording(levels);
      this.curve.mark(this.target.faces());
      this.show.showResult();
      this.show.draw();
      this.target.show();
      this.outcome.show(this.key());
      await this.measureResult(result, listeners);
    });
  }

  /** Once it is seen. */
  async measureResult(result, listeners) {
    await this.show.app.drawn();
    const {error} = await this.calls.call(this.mesh.source, 'measure', {}, listeners);
    result.error = error;
    this.show.takeError(error);
    this.outcome.show(this.key());
  }

  /** Simplifies and writes, again where the file is larger than was asked for. */
  async run(listeners) {
    const {calls, mesh, target, outcome} = this;
    const [key, effort, kind, asked] = [this.key(), $('effort').value, target.kind, target.value];
    let goal = target.asked();
    for (let nRuns = 1; ; ++nRuns) {
      const result = await calls.call(mesh.source, 'simplify', {target: goal, effort}, listeners);
      outcome.take(result, key, calls.memory);
      const notes = [...result.texts, ...await this.write(listeners)];
      const size = outcome.size();
      const isLarger = kind === 'size' && size > asked;
      if (isLarger && nRuns < mostRuns && result.met) {
        goal = {faces: Math.max(1, Math.min(result.faces - 1, Math.floor(result.faces * asked / size)))};
        continue;
      }
      return {result, notes: isLarger ? [...notes, 'The file is larger than was asked for.'] : notes};
    }
  }

  /** \return warnings */
  async write(listeners) {
    const format = this.outcome.format();
    const {files, warnings} = await this.calls.call(this.mesh.source, 'write', {format}, listeners);
    this.outcome.takeFiles(format, files);
    return warnings;
  }

  async save() {
    const {outcome} = this;
    const isWritten = () => outcome.made?.key === this.key() && outcome.made.format === outcome.format();
    const isMade = () => outcome.made?.key === this.key() && this.isInMemory();
    if (!isWritten() && !isMade() && !await this.simplify()) return;
    if (!isWritten()) await this.onFormat();
    if (!isWritten()) return;
    outcome.save();
  }
}
