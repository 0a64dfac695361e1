// What was made: its facts, and its files.
import {short} from '../../../report/viewer/src/colours.js';
import {lengthUnit, percent} from '../../../report/viewer/src/facts.js';
import {saveAs} from '../../../report/viewer/src/save.js';
import {sizeText} from './words.js';

const $ = (id) => document.getElementById(id);

/** Bytes a face that files of a format take, as far as it is known before one is written. */
const usual = {ply: 23, stl: 50, obj: 35, off: 35, glb: 18, gltf: 18};

export class Outcome {
  /** \param mesh as `open` has told of it, with its `source` */
  reset(mesh) {
    this.mesh = mesh;
    this.made = null; // what was asked for, and what came
    this.perFace = {...usual};
    if (mesh.faces > 0 && !/\.gz$/i.test(mesh.source.name)) this.perFace[mesh.format] = mesh.bytes / mesh.faces;
    $('format').replaceChildren(...mesh.formats.map(({id, name}) => new Option(name, id)));
    if (mesh.formats.some(({id}) => id === mesh.format)) $('format').value = mesh.format;
    this.show('');
  }

  format() {
    return $('format').value;
  }

  bytesPerFace() {
    return this.perFace[this.format()] ?? usual.ply;
  }

  /** \param key of what was asked for \param memory of the worker that has it */
  take(result, key, memory) {
    this.made = {result, key, memory, format: null, files: []};
  }

  /** The files of what was made. */
  takeFiles(format, files) {
    Object.assign(this.made, {format, files});
    if (this.made.result.faces > 0) this.perFace[format] = this.size() / this.made.result.faces;
  }

  /** Bytes of the files. */
  size() {
    return this.made.files.reduce((sum, {bytes}) => sum + bytes.byteLength, 0);
  }

  save() {
    for (const {name, bytes} of this.made.files) saveAs(name, new Blob([bytes]));
  }

  /** \param key of what is asked for now */
  show(key) {
    const {made, mesh} = this;
    const rows = made ? this.rows(made, mesh) : [];
    $('made').replaceChildren(...rows.flatMap(([term, text, title]) => {
      const [dt, dd] = [document.createElement('dt'), document.createElement('dd')];
      [dt.textContent, dd.textContent, dd.title] = [term, text, title];
      return [dt, dd];
    }));
    const note = made ? made.key !== key && 'The target has changed since.' : 'Simplify makes the mesh, Save writes its file.';
    if (!note) return;
    const [dt, dd] = [document.createElement('dt'), document.createElement('dd')];
    dt.className = 'unseen';
    dt.textContent = 'Note';
    dd.className = 'stale';
    dd.textContent = note;
    $('made').append(dt, dd);
  }

  rows({result, format}, mesh) {
    const {faces, error, proven, seconds} = result;
    const length = (x) => `${short(x)} ${lengthUnit}`;
    const rows = [['Faces', `${faces.toLocaleString('en')}, ${percent(faces / mesh.faces)}`, 'Those of the result, and their share of all']];
    if (error) rows.push(['Mean', length(error.mean), 'Mean error, as it was sampled']);
    if (error) rows.push(['Largest', length(error.max), 'Largest error, as it was sampled']);
    if (proven !== null) rows.push(['Proven', length(proven), 'No place is farther off than this']);
    if (format) rows.push(['File', `${sizeText(this.size())}, in ${short(seconds)} s`, 'The size of what is saved, and the time of the run']);
    return rows;
  }
}
