// What is asked for: a number of faces, a largest error, or a size of the file. The slider, the number and the curve agree.
import {short} from '../../../report/viewer/src/colours.js';
import {counted, lengthUnit, percent} from '../../../report/viewer/src/facts.js';
import {sizeText} from './words.js';

const $ = (id) => document.getElementById(id);
const kilobyte = 1000;
const share = 0.1; // of the faces, which is asked for at first

export class Target {
  /** \param onChange is called when something else is asked for */
  constructor(onChange) {
    this.onChange = onChange;
    this.mesh = null;
    $('kind').addEventListener('change', () => this.setFaces(this.faces()));
    $('prove').addEventListener('change', () => this.take(this.value));
    $('range').addEventListener('input', () => this.take(this.valueAt(Number($('range').value) / 1000)));
    $('amount').addEventListener('change', () => this.takeAmount());
    $('amount').addEventListener('keydown', ({key}) => key === 'Enter' && this.takeAmount());
  }

  /** \param mesh {faces, fewest, diagonal, recording} that is asked about from now on */
  reset(mesh) {
    this.mesh = mesh;
    this.kind = 'faces';
    $('kind').value = this.kind;
    this.take(Math.max(this.fewest(), Math.round(share * mesh.faces)));
  }

  fewest() {
    return this.mesh.fewest;
  }

  /** Largest errors of measured levels, from the least one on. */
  errors() {
    return this.mesh.recording.levels.map(({max}) => max).filter((max) => max > 0).sort((a, b) => a - b);
  }

  /** The least and the greatest value of the slider. */
  bounds() {
    const [few, all] = [this.fewest(), this.mesh.faces];
    if (this.kind === 'error') return [this.errors()[0], this.errors().at(-1)];
    return this.kind === 'size' ? [few, all].map((n) => n * this.mesh.bytesPerFace) : [few, all];
  }

  valueAt(place) {
    const [least, most] = this.bounds();
    const value = least * (most / least) ** place;
    return this.kind === 'faces' ? Math.round(value) : Number(value.toPrecision(3));
  }

  placeOf(value) {
    const [least, most] = this.bounds();
    return most > least ? Math.min(1, Math.max(0, Math.log(value / least) / Math.log(most / least))) : 1;
  }

  /** How many faces the value stands for: of errors and sizes, as far as it is known before the run. */
  faces() {
    const {mesh, value} = this;
    const {recording} = mesh;
    let n = value;
    if (this.kind === 'size') n = Math.round(value / mesh.bytesPerFace);
    if (this.kind === 'error') {
      const nContractions = recording.contractionsWithin(value);
      n = nContractions === null ? mesh.faces : recording.facesAfter[nContractions];
    }
    return Math.min(mesh.faces, Math.max(0, Math.round(n)));
  }

  /** Asks, in the kind that is chosen, for what so many faces have. */
  setFaces(nFaces) {
    this.kind = $('kind').value;
    if (this.kind === 'faces') this.take(nFaces);
    if (this.kind === 'size') this.take(Number((nFaces * this.mesh.bytesPerFace).toPrecision(3)));
    if (this.kind === 'error') this.take(Number((this.mesh.recording.errorAt(nFaces).max || this.errors()[0]).toPrecision(3)));
  }

  takeAmount() {
    const number = Number($('amount').value);
    if ($('amount').value === '' || !(number >= 0)) return this.show();
    if (this.kind === 'faces') return this.take(Math.min(this.mesh.faces, Math.round(number)));
    return this.take(this.kind === 'size' ? number * kilobyte : number);
  }

  take(value) {
    this.value = value;
    this.show();
    this.onChange();
  }

  /** What `simplify` is called with. */
  asked() {
    return this.isProven() ? {maxError: this.value} : {faces: this.faces()};
  }

  isProven() {
    return this.kind === 'error' && $('prove').checked;
  }

  /** Tells two targets apart. */
  key() {
    return JSON.stringify([this.kind, this.value, this.isProven()]);
  }

  /** By what is known: levels may be measured, or a file written, later. */
  show() {
    const {kind, value, mesh} = this;
    const amount = String(kind === 'size' ? Number((value / kilobyte).toPrecision(6)) : value);
    if ($('amount').value !== amount) $('amount').value = amount;
    $('range').value = 1000 * this.placeOf(value);
    $('range').setAttribute('aria-valuetext', kind === 'size' ? sizeText(value) : `${value} ${kind === 'faces' ? kind : lengthUnit}`);
    $('proof').hidden = kind !== 'error';
    $('kind').querySelector('[value=error]').disabled = this.errors().length < 2;
    $('unit').textContent = {faces: 'faces', error: lengthUnit, size: 'kB'}[kind];
    $('meaning').textContent = this.meaning();
  }

  /** "10 % of 51,200 faces" */
  share() {
    const {mesh, kind, value} = this;
    const [whole, of] = {faces: [mesh.faces, counted(mesh.faces, 'face', 'faces')], error: [mesh.diagonal, 'the diagonal'],
      size: [mesh.bytes, sizeText(mesh.bytes)]}[kind];
    return whole > 0 ? `${percent(value / whole)} of ${of}` : '';
  }

  /** What else the target means. */
  meaning() {
    const {mesh, kind, value} = this;
    const nFaces = this.faces();
    const {recording} = mesh;
    const error = recording.errorAt(nFaces);
    const isBeyond = nFaces > recording.facesAfter[0]; // of a large mesh, the picture has fewer faces
    const about = kind === 'faces' ? [] : [`about ${counted(nFaces, 'face', 'faces')}`];
    if (error && kind !== 'error') about.push(`largest error ${isBeyond ? 'below' : 'about'} ${short(error.max)} ${lengthUnit}`);
    if (kind !== 'size') about.push(`about ${sizeText(nFaces * mesh.bytesPerFace)}`);
    if (this.isProven()) about.splice(0, about.length, `the picture has ${counted(nFaces, 'face', 'faces')}, the result may have others`);
    const words = [this.share(), about.join(', ')].filter((part) => part).join(': ');
    const sentence = `${words[0].toUpperCase()}${words.slice(1)}.`;
    if (kind === 'error' && recording.contractionsWithin(value) === null) return `No measured level keeps within ${value}. ${sentence}`;
    return isBeyond ? `${sentence} The picture has at most ${counted(recording.facesAfter[0], 'face', 'faces')}.` : sentence;
  }
}
