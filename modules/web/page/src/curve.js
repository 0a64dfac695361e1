// The error curve: the mean and the largest error over the number of faces, both on logarithmic scales. A mark on it
// chooses a number of faces.
import {short} from '../../../report/viewer/src/colours.js';
import {counted, lengthUnit} from '../../../report/viewer/src/facts.js';

const margin = {left: 58, right: 14, top: 18, bottom: 34}; // pixels
const room = 70; // pixels between numbers along the axis of faces, at least
const step = 2 ** (1 / 8); // a press of an arrow key
const leap = 2;
const lines = [{key: 'max', name: 'largest'}, {key: 'mean', name: 'mean'}];

/** Round numbers in a range: powers of ten, and where these are few, twice and five times them. */
function ticksOf(low, high, most) {
  const all = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); ++power) {
    for (const digit of [1, 2, 5]) all.push({digit, value: Number(`${digit}e${power}`)});
  }
  const inside = all.filter(({value}) => value >= low && value <= high);
  const decades = inside.filter(({digit}) => digit === 1);
  const chosen = decades.length < 3 && inside.length <= most ? inside : decades;
  const every = Math.ceil(chosen.length / most);
  return chosen.filter((_, i) => i % every === 0).map(({value}) => value);
}

export class Curve {
  /** \param svg element that it is drawn in \param onChoose is called with a number of faces */
  constructor(svg, onChoose) {
    this.svg = svg;
    this.onChoose = onChoose;
    this.levels = [];
    this.title = svg.querySelector('title');
    svg.addEventListener('pointerdown', (event) => {
      svg.setPointerCapture(event.pointerId);
      this.chooseAt(event);
    });
    svg.addEventListener('pointermove', (event) => { if (svg.hasPointerCapture(event.pointerId)) this.chooseAt(event); });
    svg.addEventListener('keydown', (event) => this.onKey(event));
    new ResizeObserver(() => this.draw()).observe(svg);
  }

  /** \param recording its measured levels are drawn \param fewest, most faces that can be chosen */
  setMesh(recording, fewest, most) {
    Object.assign(this, {recording, fewest, most, nFaces: most});
    this.update();
  }

  /** Levels were measured. */
  update() {
    this.levels = this.recording.levels;
    this.draw();
  }

  mark(nFaces) {
    this.nFaces = nFaces;
    this.draw();
  }

  chooseAt({clientX}) {
    const share = (clientX - this.svg.getBoundingClientRect().left - margin.left) / this.width;
    this.choose(this.fewest * (this.most / this.fewest) ** share);
  }

  choose(nFaces) {
    this.onChoose(Math.min(this.most, Math.max(this.fewest, Math.round(nFaces))));
  }

  onKey(event) {
    const n = this.nFaces;
    const goal = {
      ArrowRight: Math.max(n + 1, n * step), ArrowUp: Math.max(n + 1, n * step), ArrowLeft: Math.min(n - 1, n / step),
      ArrowDown: Math.min(n - 1, n / step), PageUp: n * leap, PageDown: n / leap, Home: this.fewest, End: this.most,
    }[event.key];
    if (goal === undefined) return;
    event.preventDefault();
    event.stopPropagation(); // arrows turn the meshes elsewhere
    this.choose(goal);
  }

  draw() {
    const {svg, recording} = this;
    const {clientWidth, clientHeight} = svg;
    if (!recording || clientWidth === 0) return;
    this.width = Math.max(10, clientWidth - margin.left - margin.right);
    this.height = Math.max(10, clientHeight - margin.top - margin.bottom);
    svg.setAttribute('viewBox', `0 0 ${clientWidth} ${clientHeight}`);
    svg.replaceChildren(this.title);
    const errors = this.levels.flatMap(({mean, max}) => [mean, max]).filter((error) => error > 0);
    [this.least, this.greatest] = errors.length > 1 ? [Math.min(...errors), Math.max(...errors)] : [0, 0];
    this.drawAxes();
    if (this.greatest > this.least) for (const line of lines) this.drawLine(line);
    this.drawMark();
    this.say();
  }

  x(nFaces) {
    const {fewest, most} = this;
    return margin.left + (most > fewest ? Math.log(Math.max(fewest, nFaces) / fewest) / Math.log(most / fewest) : 1) * this.width;
  }

  y(error) {
    const share = Math.log(error / this.least) / Math.log(this.greatest / this.least);
    return margin.top + (1 - Math.min(1, Math.max(0, share))) * this.height;
  }

  add(name, attributes, text = '') {
    const element = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    element.textContent = text;
    this.svg.append(element);
  }

  drawAxes() {
    const {width, height} = this;
    const [bottom, right] = [margin.top + height, margin.left + width];
    for (const value of ticksOf(this.fewest, this.most, Math.max(2, Math.floor(width / room)))) {
      const x = this.x(value);
      this.add('line', {class: 'grid', x1: x, x2: x, y1: margin.top, y2: bottom});
      const isLast = x > right - 25;
      this.add('text', {x: isLast ? right : x, y: bottom + 14, 'text-anchor': isLast ? 'end' : 'middle'}, value.toLocaleString('en'));
    }
    if (this.greatest > this.least) {
      for (const value of ticksOf(this.least, this.greatest, Math.max(2, Math.floor(height / 22)))) {
        const y = this.y(value);
        this.add('line', {class: 'grid', x1: margin.left, x2: right, y1: y, y2: y});
        this.add('text', {x: margin.left - 5, y: y + 4, 'text-anchor': 'end'}, short(value));
      }
    }
    this.add('path', {class: 'axis', fill: 'none', d: `M${margin.left} ${margin.top}V${bottom}H${right}`});
    this.add('text', {x: margin.left + width / 2, y: bottom + 29, 'text-anchor': 'middle'}, 'faces');
    this.add('text', {x: right - 4, y: margin.top + 12, 'text-anchor': 'end'}, `error, ${lengthUnit}`);
  }

  drawLine({key, name}) {
    const points = this.levels.filter((level) => level[key] > 0).map((level) => [this.x(level.faces), this.y(level[key])]);
    this.add('polyline', {class: key, points: points.map((point) => point.map((x) => x.toFixed(1)).join()).join(' ')});
    const [x, y] = points[Math.floor(points.length / 2)] ?? [0, 0];
    const isAbove = key === 'max';
    this.add('text', {class: key, x: isAbove ? x + 6 : x - 6, y: isAbove ? y - 6 : y + 14, 'text-anchor': isAbove ? 'start' : 'end'}, name);
  }

  drawMark() {
    const x = this.x(this.nFaces);
    this.add('line', {class: 'mark', x1: x, x2: x, y1: margin.top, y2: margin.top + this.height});
    const error = this.recording.errorAt(this.nFaces);
    if (!error || !(this.greatest > this.least)) return;
    for (const {key} of lines) if (error[key] > 0) this.add('circle', {class: key, cx: x, cy: this.y(error[key]), r: 5});
  }

  say() {
    const {svg, nFaces} = this;
    const error = this.recording.errorAt(nFaces);
    svg.setAttribute('aria-valuemin', this.fewest);
    svg.setAttribute('aria-valuemax', this.most);
    svg.setAttribute('aria-valuenow', nFaces);
    svg.setAttribute('aria-valuetext', counted(nFaces, 'face', 'faces') + (error ? `, largest error about ${short(error.max)} ${lengthUnit}` : ''));
  }
}
