// The page of `whittle report`: puts the meshes, the controls and the player together.
import {Vector3} from 'three';
import {scales, short, showLegend, showNote, showRefusals} from './colours.js';
import {readPage} from './data.js';
import {ExactColours} from './exact.js';
import {rowsOfKeys, setUpKeys} from './keys.js';
import {loadImages} from './look.js';
import {Model} from './model.js';
import {Motion} from './motion.js';
import {Player} from './player.js';
import {Recording} from './recording.js';
import {doInSlices} from './slices.js';
import {Surface, unit} from './surface.js';
import {View} from './view.js';

const longestFrame = 0.25; // seconds that the player goes on by at once, also after the page was out of sight

const $ = (id) => document.getElementById(id);
const inWords = (n, one, many) => `${n.toLocaleString('en')} ${n === 1 ? one : many}`;

/** The box around a surface. */
function boxOf(surface) {
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = low.clone().negate();
  const {positions, corners, nFaces} = surface;
  const p = new Vector3();
  for (let i = 0; i < 3 * nFaces; ++i) {
    p.fromArray(positions, 4 * corners[i]).divideScalar(65535);
    low.min(p);
    high.max(p);
  }
  return {low, high};
}

class App {
  /** \param images of the page */
  constructor({json, array}, images) {
    this.json = json;
    const original = new Surface(json.original, array, images);
    this.original = new Model(original, '#9db4c8');
    this.results = json.results.map((result) => new Model(new Surface(result, array, images), '#d9b382'));
    this.recording = json.recording && new Recording(json.recording, array, original);
    if (this.recording) this.results.unshift(new Model(this.recording, '#d9b382'));
    // What stands in the way of fewer faces is to be seen at once.
    this.result = this.results.find((model) => model.surface.refusals.length > 0) ??
      this.results.find((model) => model.surface.look) ?? this.results[0] ?? null;
    this.isDrawn = true; // what was asked for
    this.isWhole = false; // what is drawn: sharp, with all faces, and in exact colours
    this.nDescribed = 0;
    this.motion = new Motion((wasQuick) => this.onRest(wasQuick));
    this.view = new View($('canvas'), boxOf(original), () => this.onView());
    this.exact = new ExactColours(this.view, () => this.draw());
    for (const model of [this.original, ...this.results]) this.view.scene.add(model.group);
    this.setUpChoices();
    if (this.recording) this.setUpPlayer();
    this.setUpEvents();
    this.followAddress();
    this.applyTheme();
    this.apply();
  }

  setUpChoices() {
    this.results.forEach((model, i) => $('result').add(new Option(model.surface.name, i)));
    if (this.result) $('result').value = this.results.indexOf(this.result);
    if (!this.result) {
      for (const id of ['layout', 'ghost']) $(id).closest('label').hidden = true;
      $('layout').value = 'original';
    }
    const surfaces = [this.original, ...this.results].map(({surface}) => surface);
    const hasErrors = surfaces.some(({distances}) => distances);
    $('colour').querySelector('[value=error]').disabled = !hasErrors;
    this.addColours();
  }

  /** Those that a mesh has beside its shape. The page opens with what it looks like. */
  addColours() {
    const looks = [this.original, ...this.results].map(({surface}) => surface.look).filter((look) => look);
    const hasAny = (colour) => looks.some((look) => look.has(colour));
    const names = [['material', 'material'], ['colours', 'vertex colours'], ['normals', 'normals']].filter(([colour]) => hasAny(colour));
    const errors = new Map(looks.flatMap(({maps}) => maps.map(({colour, label}) => [colour, label])));
    const error = $('colour').querySelector('[value=error]');
    for (const [colour, name] of names) error.before(new Option(name, colour));
    error.after(...[...errors].map(([colour, name]) => new Option(name, colour)));
    if (hasAny('normals')) $('shading').add(new Option('normals of the file', 'file'));
    $('colour').value = ['material', 'colours'].find(hasAny) ?? 'none';
  }

  setUpPlayer() {
    $('player').hidden = false;
    const model = this.results[0];
    this.player = new Player(this.recording, (positions) => {
      model.update(positions);
      this.showLevel();
      this.draw();
    });
    this.player.goTo(1);
    this.isPlaying = false;
  }

  /** Sets the controls as the address says: "#colour=error&edges=on". "plain" leaves out names, "level" is the place in
      the recording, "turn" and "tilt" are degrees, "zoom" is how many times as near. */
  followAddress() {
    const settings = new Map(location.hash.slice(1).split('&').map((part) => part.split('=')));
    const number = (key, otherwise) => Number.isFinite(Number(settings.get(key))) ? Number(settings.get(key)) : otherwise;
    if (settings.has('plain')) document.body.classList.add('plain');
    for (const [key, value] of settings) this.setControl(key, value);
    if (this.player) this.setUpMovement();
    this.result = this.results[Number($('result').value)] ?? this.result;
    if (settings.has('level') && this.player) {
      if (!settings.has('result')) this.showRecording();
      this.player.stopAt(number('level', 1));
    }
    this.view.setPanes(this.layout() === 'beside' ? 2 : 1);
    this.view.setUp($('up').value);
    this.view.fit();
    this.view.rotate(-number('turn', 0) * Math.PI / 180, -number('tilt', 0) * Math.PI / 180);
    if (number('zoom', 0) > 0) this.view.zoom(1 / number('zoom', 1));
  }

  setControl(key, value) {
    const control = /^[a-z]+$/.test(key) && $(key);
    if (control instanceof HTMLSelectElement && [...control.options].some((option) => option.value === value && !option.disabled)) {
      control.value = value;
    }
    if (control instanceof HTMLInputElement && control.type === 'checkbox') control.checked = value === 'on';
  }

  // What is chosen ---------------------------------------------------------------------------------------------------

  layout() {
    const layout = $('layout').value;
    return this.result ? layout : 'original';
  }

  /** Where the scale of errors ends, in their unit. */
  greatestShown() {
    const greatest = (key) => Math.max(...[this.original, this.result].map((model) => model?.range()?.[key] ?? 0));
    const chosen = $('top').value;
    return chosen === 'usual' ? greatest('usual') : greatest('max') * Number(chosen);
  }

  apply() {
    const models = [this.original, this.result].filter((model) => model);
    for (const model of models) model.setColour($('colour').value, $('shading').value);
    const top = this.greatestShown();
    for (const model of models) model.setScale(scales.error, top);
    this.exact.setScale(scales.error, top / this.json.step);
    $('ghost').closest('label').hidden = this.layout() !== 'over';
    $('result').closest('label').hidden = this.results.length < 2 || this.layout() === 'original';
    for (const lines of ['borders', 'nonmanifold']) $(lines).disabled = this.shownModels().every(({surface}) => surface[lines].length === 0);
    this.forgetWhatWasDescribed();
    this.showLegend($('colour').value, top);
    this.showReasons();
    this.showLabels();
    this.view.setPanes(this.layout() === 'beside' ? 2 : 1);
    if (!this.hasExactColours()) this.exact.stop();
    this.draw();
  }

  /** The models that are in the picture. */
  shownModels() {
    return this.layout() === 'over' ? [this.original, this.result] : this.modelsOfPanes();
  }

  showLegend(colour, top) {
    const shown = this.shownModels();
    const legend = $('legend');
    const map = shown.map(({surface}) => surface.look?.mapOf(colour)).find((one) => one);
    $('top').closest('label').hidden = !shown.some((model) => model.range()?.max > 0);
    legend.replaceChildren();
    if (map) showLegend(legend, map.title, scales.error, top);
    else if (shown.some((model) => model.range())) showLegend(legend, 'distance, model units', scales.error, top);
    if (colour === 'normals') showNote(legend, 'normals: x, y, z from −1 to 1 as red, green, blue');
    if (colour === 'shape') showLegend(legend, 'radius ratio 2r/R, 1 is equilateral', scales.shape, 1);
    if (colour === 'valence') showLegend(legend, 'edges at a vertex', scales.valence);
    for (const model of shown) if (!model.hasColour()) showNote(legend, `${model.surface.name} has no such colours`);
    legend.hidden = legend.childElementCount === 0;
    legend.setAttribute('aria-label', [...legend.querySelectorAll('div:not(:has(*)), .ticks span')].map((part) => part.textContent).join(' '));
  }

  /** Why there are not fewer faces. */
  showReasons() {
    const refusals = this.result?.surface.refusals ?? [];
    const isThere = refusals.length > 0 && this.layout() !== 'original';
    $('refused').closest('label').hidden = !isThere;
    $('reasons').hidden = !isThere || !$('refused').checked;
    if (isThere) showRefusals($('reasons'), refusals);
    $('advice').hidden = !this.json.advice;
    $('advice').textContent = this.json.advice;
  }

  showLabels() {
    const text = ({surface}) => `${surface.name}: ${inWords(surface.nFaces, 'face', 'faces')}${surface.note ? `. ${surface.note}` : ''}`;
    const layout = this.layout();
    const left = layout === 'result' ? this.result : this.original;
    const compared = left === this.original && left.range() && layout !== 'original' ? this.comparedWithOriginal() : this.result;
    $('left-label').textContent = text(left) + (compared !== this.result ? `, compared with ${compared.surface.name}` : '') +
      (layout === 'over' ? `, over ${text(this.result)}` : '');
    $('right-label').textContent = layout === 'beside' ? text(this.result) : '';
  }

  showLevel() {
    const {recording, player} = this;
    const error = recording.errorAt(recording.nFaces);
    const about = error && error.faces !== recording.nFaces ? 'about ' : '';
    $('level').textContent = inWords(recording.nFaces, 'face', 'faces') + `, ${inWords(recording.nContractions, 'contraction', 'contractions')}` +
      (error ? `; error ${about}${short(error.mean)} on average, ${short(error.max)} at most (model units)` : '');
    $('slider').value = 1000 * player.place;
    $('speed').textContent = `speed ${player.speed >= 1 ? player.speed : `1/${1 / player.speed}`}`;
    $('play').textContent = player.direction > 0 ? 'Pause' : 'Play';
    $('back').textContent = player.direction < 0 ? 'Pause' : 'Backwards';
    $('previous').disabled = player.isAtEnd(-1);
    $('next').disabled = player.isAtEnd(1);
    $('slower').disabled = player.isSlowest();
    $('faster').disabled = player.isFastest();
    if (this.result?.surface === recording) this.showLabels();
  }

  applyTheme() {
    const style = getComputedStyle(document.documentElement);
    this.background = style.getPropertyValue('--ground').trim();
    const isDark = window.matchMedia('(prefers-color-scheme: dark)').matches && !window.matchMedia('print').matches;
    for (const model of [this.original, ...this.results]) model.setLineColour(isDark ? '#0c0c0c' : '#202020');
    this.draw();
  }

  // Drawing ----------------------------------------------------------------------------------------------------------

  onView() {
    this.exact?.stop();
    this.motion.goOn();
    this.draw();
  }

  /** What was drawn quickly stays until exact colours are found. */
  onRest(wasQuick) {
    if (this.hasExactColours()) this.startExactColours(); else if (wasQuick) this.draw();
  }

  /** The models of the panes, left to right, without what is laid over them. */
  modelsOfPanes() {
    return {beside: [this.original, this.result], original: [this.original]}[this.layout()] ?? [this.result];
  }

  /** The model that errors of the original are differences to. */
  comparedWithOriginal() {
    return this.results.find(({surface}) => surface.distances) ?? this.result;
  }

  /** The surface that distances of a model go to; null if it is not all in the page. */
  otherOf(model) {
    const other = model === this.original ? this.comparedWithOriginal() : this.original;
    return model.surface.distances && other?.surface.note === '' ? other.surface : null;
  }

  hasExactColours() {
    return $('colour').value === 'error' && this.modelsOfPanes().some((model) => this.otherOf(model));
  }

  keyOfExactColours() {
    return [this.view.key(), this.layout(), this.results.indexOf(this.result), $('shading').value].join();
  }

  startExactColours() {
    const isSmooth = $('shading').value !== 'flat';
    this.exact.start(this.keyOfExactColours(), this.modelsOfPanes().map((model) => {
      const other = this.otherOf(model);
      return other && {surface: model.surface, geometry: model.wholeGeometry(), isSmooth, other};
    }));
  }

  /** Before the next picture. */
  draw() {
    if (!this.isDrawn) return;
    this.isDrawn = false;
    requestAnimationFrame(() => this.drawNow());
  }

  drawNow() {
    this.isDrawn = true;
    if (!this.view || !this.background) return;
    const hasExactColours = this.hasExactColours();
    const isExact = hasExactColours && this.exact.isDoneFor(this.keyOfExactColours());
    const isQuick = !isExact && (this.motion.beginFrame() || hasExactColours && this.motion.isSlow);
    this.view.setSharp(!isQuick);
    for (const model of [this.original, this.result]) model?.useCoarse(isQuick);
    this.view.draw(this.panes(isExact), this.background);
    this.isWhole = !isQuick && isExact === hasExactColours;
    if (hasExactColours && !this.motion.isMoving) this.startExactColours();
    if (!document.documentElement.dataset.ready) document.documentElement.dataset.ready = Math.round(performance.now());
  }

  /** Functions that show what is to be seen in each pane, left to right. */
  panes(isExact) {
    const chosen = {edges: $('edges').checked, borders: $('borders').checked, nonmanifold: $('nonmanifold').checked, refused: $('refused').checked};
    const only = (...shown) => {
      for (const model of [this.original, ...this.results]) model.group.visible = shown.includes(model);
    };
    const showWhole = (model) => {
      this.exact.pixels.visible = isExact && this.otherOf(model) !== null;
      model.show({...chosen, areFacesDrawn: this.exact.pixels.visible});
    };
    if (this.layout() !== 'over') {
      return this.modelsOfPanes().map((model) => () => {
        only(model);
        showWhole(model);
      });
    }
    return [() => {
      only(this.original, this.result);
      this.original.show({...chosen, ghost: $('ghost').value});
      showWhole(this.result);
    }];
  }

  /** Settles when what was asked for is drawn, in exact colours. */
  async drawn() {
    this.motion.end();
    for (let isInPicture = this.isDrawn; !isInPicture || !this.isWhole; isInPicture = true) { // a player goes on asking
      this.motion.end();
      this.draw();
      await new Promise(requestAnimationFrame); // what was asked for before is drawn in it
      await this.exact.work;
    }
    await this.exact.work; // one that was stopped may still be reading
    return 'drawn';
  }

  /** Stands still at a place in the recording, and shows it. \param place 0 … 1 */
  showPlace(place) {
    if (!this.player) return;
    this.showRecording();
    this.player.stopAt(place);
  }

  /** What the player does is to be in the picture. */
  showRecording() {
    if (this.result.surface === this.recording && this.layout() !== 'original') return;
    this.result = this.results.find(({surface}) => surface === this.recording);
    $('result').value = this.results.indexOf(this.result);
    if (this.layout() === 'original') $('layout').value = 'result';
    this.apply();
  }

  play(direction) {
    this.showRecording();
    this.player.play(direction);
    this.showLevel();
    if (this.isPlaying || this.player.direction === 0) return;
    this.isPlaying = true;
    this.lastMoment = null;
    requestAnimationFrame((moment) => this.advance(moment));
  }

  advance(moment) {
    const seconds = this.lastMoment === null ? 0 : Math.min(longestFrame, (moment - this.lastMoment) / 1000);
    this.lastMoment = moment;
    this.isPlaying = this.player.advance(seconds);
    if (this.isPlaying) requestAnimationFrame((next) => this.advance(next)); else this.showLevel();
  }

  // Events -----------------------------------------------------------------------------------------------------------

  setUpEvents() {
    for (const id of ['layout', 'ghost', 'shading', 'colour', 'top', 'edges', 'borders', 'nonmanifold', 'refused']) {
      $(id).addEventListener('change', () => this.apply());
    }
    $('result').addEventListener('change', () => {
      this.result = this.results[Number($('result').value)];
      this.apply();
    });
    $('fit').addEventListener('click', () => this.view.fit());
    $('up').addEventListener('change', () => {
      this.view.setUp($('up').value);
      this.view.fit();
    });
    new ResizeObserver(() => this.view.resize()).observe($('canvas'));
    for (const query of ['(prefers-color-scheme: dark)', 'print']) {
      window.matchMedia(query).addEventListener('change', () => this.applyTheme());
    }
    setUpKeys($('keys'), rowsOfKeys({...this, describeMiddles: () => this.describeMiddles()}));
    window.addEventListener('hashchange', () => {
      this.followAddress();
      this.apply();
    });
    this.setUpPicking();
    if (this.player) this.setUpPlayerEvents();
  }

  setUpPlayerEvents() {
    const on = (id, event, act) => $(id).addEventListener(event, act);
    const stepBy = (n) => {
      this.showRecording();
      this.player.stepBy(n);
    };
    on('slider', 'input', () => this.showPlace(Number($('slider').value) / 1000));
    on('play', 'click', () => this.play(1));
    on('back', 'click', () => this.play(-1));
    on('next', 'click', () => stepBy(1));
    on('previous', 'click', () => stepBy(-1));
    on('faster', 'click', () => this.changeSpeed(2));
    on('slower', 'click', () => this.changeSpeed(0.5));
    for (const id of ['movement', 'spacing']) {
      on(id, 'change', () => {
        this.showRecording();
        this.setUpMovement();
      });
    }
  }

  /** As the controls say. */
  setUpMovement() {
    this.player.isContinuous = $('movement').value === 'continuous';
    this.player.isByFaces = $('spacing').value === 'faces';
    this.player.goTo(this.player.place);
  }

  changeSpeed(factor) {
    this.player.setSpeed(this.player.speed * factor);
    this.showLevel();
  }

  /** A click without a drag says what is there. */
  setUpPicking() {
    let down = null;
    $('canvas').addEventListener('pointerdown', (event) => { down = [event.clientX, event.clientY]; });
    $('canvas').addEventListener('pointerup', (event) => {
      if (down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 4) this.describe([event]);
    });
  }

  /** Says what is in the middle of each pane. */
  describeMiddles() {
    const {left, top, height} = $('canvas').getBoundingClientRect();
    return this.describe(this.view.spansOfPanes().map((span) =>
      ({clientX: left + span.left + span.width / 2, clientY: top + height / 2})), 'There is nothing in the middle.');
  }

  /** Says what is at points of the window, unless it is asked for something else meanwhile. */
  async describe(points, otherwise = '') {
    const number = ++this.nDescribed;
    const texts = [];
    for (const point of points) texts.push(await this.textAt(point));
    if (number === this.nDescribed) $('status').textContent = texts.filter((text) => text).join('; ') || otherwise;
  }

  forgetWhatWasDescribed() {
    ++this.nDescribed;
    $('status').textContent = '';
  }

  async textAt(point) {
    const models = this.modelsOfPanes();
    const {pane, hit} = this.view.pick(point, models.map((model) => model.faces));
    if (!hit) return '';
    const model = models[pane];
    const place = this.toModel(hit.point).map(short).join(', ');
    const value = await this.valueAt(model, hit);
    const meaning = {error: 'distance', shape: 'radius ratio'}[model.colour] ?? model.range()?.value;
    return `${model.surface.name}: (${place})${meaning && value !== null ? `, ${meaning} ${short(value)}` : ''}`;
  }

  toModel(point) {
    return point.toArray().map((coordinate, d) => this.json.origin[d] + coordinate * unit * this.json.step);
  }

  /** What the colour means at a point of a face. */
  async valueAt(model, hit) {
    const other = model.colour === 'error' && this.otherOf(model);
    if (!other) return model.interpolatedAt(hit);
    const tree = this.exact.treeOf(other);
    await doInSlices(tree.finish());
    return tree.distance(hit.point.clone().multiplyScalar(unit)) * this.json.step;
  }
}

async function start() {
  try {
    const page = await readPage(document);
    window.whittle = new App(page, await loadImages(page.json.images, page.array));
  } catch (error) {
    $('problem').hidden = false;
    $('problem').textContent = `The meshes can't be shown: ${error.message}`;
    document.documentElement.dataset.ready = 'failed';
    throw error;
  }
}

start();
