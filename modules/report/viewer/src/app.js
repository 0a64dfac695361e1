// What shows a page of meshes: puts them, the controls and the player together.
import {Vector3} from 'three';
import {scales, short, showLegend, showNote, showRefusals} from './colours.js';
import {ExactColours} from './exact.js';
import {errorText, facesText, fillLabel, lengthUnit, placeLabels} from './facts.js';
import {rowsOfKeys, setUpKeys} from './keys.js';
import {LevelErrors} from './level_errors.js';
import {loadImages} from './look.js';
import {Model} from './model.js';
import {Motion} from './motion.js';
import {PlayerControls} from './player_controls.js';
import {setUpClicks, setUpFingers} from './pointing.js';
import {Recording} from './recording.js';
import {doInSlices} from './slices.js';
import {Spot} from './spot.js';
import {Surface, unit} from './surface.js';
import {View, drawsBySoftware} from './view.js';
import {worstOfLevel, worstOfSurface} from './worst.js';

const $ = (id) => document.getElementById(id);

/** The box around a surface. */
function boxOf(surface) {
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = low.clone().negate();
  const {positions, corners, nFaces} = surface;
  const [least, most] = [[unit, unit, unit], [0, 0, 0]];
  for (let i = 0; i < 3 * nFaces; ++i) {
    for (let d = 0; d < 3; ++d) {
      const x = positions[4 * corners[i] + d];
      if (x < least[d]) least[d] = x;
      if (x > most[d]) most[d] = x;
    }
  }
  if (nFaces === 0) return {low, high};
  return {low: low.fromArray(least).divideScalar(unit), high: high.fromArray(most).divideScalar(unit)};
}

const colours = {original: '#9db4c8', result: '#d9b382'};

/** What an App shows. Yields after each part of the work. */
function* makeModels({json, array}, images, made) {
  const behind = {value: null}; // a uniform of lines: what they are drawn over
  const surface = new Surface(json.original, array, images);
  const recording = json.recording && new Recording(json.recording, array, surface);
  yield;
  if (recording) yield* recording.prepare();
  const original = new Model(surface, colours.original, behind);
  yield;
  const results = recording ? [new Model(recording, colours.result, behind)] : [];
  if (recording) yield* recording.goToEnd(); // where the player begins
  for (const result of json.results) {
    results.push(new Model(new Surface(result, array, images), colours.result, behind));
    yield;
  }
  Object.assign(made, {json, behind, original, results, recording});
}

/** Makes in slices what an App shows. \param page {json, array}, as of readPage */
export async function prepare(page) {
  const made = {};
  await doInSlices(makeModels(page, await loadImages(page.json.images, page.array), made));
  return made;
}

export class App {
  /** \param prepared by `prepare` \param isPlayed whether a recording has the player's controls
      \param isHeld whether nothing is drawn before `show` */
  constructor({json, behind, original, results, recording}, {isPlayed = true, isHeld = false} = {}) {
    Object.assign(this, {json, original, results, recording, isPlayed, isHeld});
    this.ending = new AbortController();
    const box = boxOf(original.surface);
    this.diagonal = box.high.distanceTo(box.low) * unit * json.step; // model units
    this.isDrawn = true; // what was asked for
    this.isWhole = false; // what is drawn: sharp, with all faces, and in exact colours
    this.nDescribed = 0;
    this.motion = new Motion((wasQuick) => this.onRest(wasQuick));
    this.view = new View($('canvas'), box, behind, () => this.onView());
    if (this.isSlow(json)) this.motion.expectSlow();
    this.spot = new Spot($('spot'), this.view);
    this.exact = new ExactColours(this.view, () => this.draw());
    for (const model of [this.original, ...this.results]) this.view.scene.add(model.group);
    this.setUpChoices();
    if (this.recording) this.setUpPlayer();
    this.setUpEvents();
    this.followAddress();
    this.applyTheme();
    this.apply();
    this.motion.stop(); // setting up the view was no movement
  }

  /** Whether a moving view can't have all faces: known before it moves. */
  isSlow({original, results}) {
    const most = 30000; // faces that software draws in time
    return drawsBySoftware(this.view.renderer.getContext()) && [original, ...results].reduce((sum, {faces}) => sum + faces, 0) > most;
  }

  setUpChoices() {
    // What stands in the way of fewer faces is to be seen at once.
    this.result = this.results.find((model) => model.surface.refusals.length > 0) ??
      this.results.find((model) => model.surface.look) ?? this.results[0] ?? null;
    this.results.forEach((model, i) => $('result').add(new Option(model.surface.name, i)));
    if (this.result) $('result').value = this.results.indexOf(this.result);
    if (!this.result) {
      for (const id of ['layout', 'ghost']) $(id).closest('label').hidden = true;
      $('layout').value = 'original';
    }
    this.offerErrors();
    this.addColours();
  }

  /** Of meshes that have distances, and of levels once some are measured. */
  offerErrors() {
    const surfaces = [this.original, ...this.results].map(({surface}) => surface);
    const hasErrors = surfaces.some(({distances}) => distances) || this.recording?.levels.length > 0;
    $('colour').querySelector('[value=error]').disabled = !hasErrors;
    $('worst').hidden = !hasErrors;
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
    if (hasAny('normals')) {
      $('shading').add(new Option('normals of the file', 'file'));
      $('shading').value = 'file';
    }
    $('colour').value = ['material', 'colours'].find(hasAny) ?? 'none';
  }

  setUpPlayer() {
    const model = this.results[0];
    this.playing = new PlayerControls(this, this.recording, (positions) => model.update(positions));
    this.player = this.playing.player;
  }

  /** Sets the controls as the address says: "#colour=error&edges=on". "plain" leaves out names, "level" is the place in
      the recording, "turn" and "tilt" are degrees, "zoom" is how many times as near. */
  followAddress() {
    const settings = new Map(location.hash.slice(1).split('&').map((part) => part.split('=')));
    const number = (key, otherwise) => Number.isFinite(Number(settings.get(key))) ? Number(settings.get(key)) : otherwise;
    if (settings.has('plain')) document.body.classList.add('plain');
    for (const [key, value] of settings) this.setControl(key, value);
    if (this.player) this.playing.setUpMovement();
    this.result = this.results[Number($('result').value)] ?? this.result;
    if (settings.has('level') && this.player) {
      if (!settings.has('result')) this.showRecording();
      this.player.stopAt(number('level', 1));
    }
    this.setPanes();
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
    if (key === 'split' && value >= 0 && value <= 1) control.value = 1000 * value;
  }

  // What is chosen ---------------------------------------------------------------------------------------------------

  layout() {
    const layout = $('layout').value;
    return this.result ? layout : 'original';
  }

  setPanes() {
    const layout = this.layout();
    this.view.setPanes(['beside', 'split'].includes(layout) ? 2 : 1, layout === 'split' ? Number($('split').value) / 1000 : null);
  }

  /** Whether a model has the errors of its level, on a scale of its own: there is no player, whose levels are compared. */
  isOnScaleOfLevel(model) {
    return !this.isPlayed && Boolean(model?.errors) && model.range() === model.errors;
  }

  /** Where the scale of errors ends, in their unit. */
  greatestShown() {
    const ofLevel = ({max}) => ({max, usual: max});
    const ranges = [this.original, this.result].map((model) => this.isOnScaleOfLevel(model) ? ofLevel(this.playing.error()) : model?.range());
    const greatest = (key) => Math.max(...ranges.map((range) => range?.[key] ?? 0));
    const chosen = $('top').value;
    return chosen === 'usual' ? greatest('usual') : greatest('max') * Number(chosen);
  }

  apply() {
    const models = [this.original, this.result].filter((model) => model);
    if ($('colour').value === 'error' && this.result?.isMoving) this.useLevelErrors();
    for (const model of models) model.setColour($('colour').value, $('shading').value);
    const top = this.greatestShown();
    for (const model of models) model.setScale(scales.error, top);
    this.exact.setScale(scales.error, top / this.json.step);
    $('ghost').closest('label').hidden = this.layout() !== 'over';
    $('result').closest('label').hidden = this.results.length < 2 || this.layout() === 'original';
    for (const lines of ['borders', 'nonmanifold']) $(lines).disabled = this.shownModels().every(({surface}) => surface[lines].length === 0);
    this.forgetWhatWasDescribed();
    this.setPanes();
    this.showLegend($('colour').value, top);
    this.showReasons();
    this.showLabels();
    if (!this.hasExactColours()) this.exact.stop();
    this.draw();
  }

  /** Colours the recording by its errors from now on. With a player, the scale is that of its last level. */
  useLevelErrors() {
    const model = this.result;
    if (model.errors || !(this.recording.levels.length > 0)) return;
    const max = this.isPlayed ? this.recording.levels.at(-1).max : this.diagonal;
    const scale = this.results.find(({surface}) => surface.distances)?.surface.distances ?? {max, usual: max};
    const tree = this.exact.treeOf(this.original.surface);
    const errors = new LevelErrors(this.recording, scale, tree, this.json.step);
    model.setErrors(errors);
    doInSlices(tree.finish(), () => !this.isClosed()).then((isDone) => {
      if (!isDone) return;
      errors.isReady = true;
      model.updateErrors();
      this.draw();
    });
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
    else if (shown.some((model) => model.range())) showLegend(legend, `distance, ${lengthUnit}`, scales.error, top);
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

  /** What is known of a model, a line each. */
  linesOf({surface}) {
    const isOriginal = surface === this.original.surface;
    const error = surface === this.recording ? this.playing.error() : surface.error;
    const nFaces = surface.nFacesOfFile ?? surface.nFaces;
    return [surface.name, facesText(nFaces, isOriginal ? null : this.original.surface.nFacesOfFile), error && errorText(error, this.diagonal),
      surface.note];
  }

  showLabels() {
    const layout = this.layout();
    const left = layout === 'result' ? this.result : this.original;
    const lines = this.linesOf(left);
    const compared = left === this.original && left.range() && layout !== 'original' ? this.comparedWithOriginal() : this.result;
    if (compared !== this.result) lines.push(`compared with ${compared.surface.name}`);
    if (layout === 'over') {
      const [name, ...others] = this.linesOf(this.result);
      lines.push(`over: ${name}`, ...others);
    }
    fillLabel($('left-label'), lines);
    fillLabel($('right-label'), this.view.panes > 1 ? this.linesOf(this.result) : []);
    this.placeWhatLiesOver();
  }

  placeWhatLiesOver() {
    const {view} = this;
    placeLabels([$('left-label'), $('right-label')], view.boxes(), view);
    for (const id of ['split', 'divider']) $(id).hidden = view.split === null;
    if (view.split !== null) $('divider').style.left = `${Math.round(view.split * view.width)}px`;
    this.spot.follow();
  }

  /** The level of the recording is another one. */
  onLevel() {
    if (this.result?.surface === this.recording && this.playing) this.showLevel();
    this.spot.hide();
    this.draw();
  }

  showLevel() {
    if (this.isOnScaleOfLevel(this.result)) this.apply(); else this.showLabels();
  }

  applyTheme() {
    const style = getComputedStyle(document.documentElement);
    this.background = style.getPropertyValue('--ground').trim();
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

  /** The models of the panes, left to right or from above, without what is laid over them. */
  modelsOfPanes() {
    const both = [this.original, this.result];
    return {beside: both, split: both, original: [this.original]}[this.layout()] ?? [this.result];
  }

  /** The model that errors of the original are differences to. */
  comparedWithOriginal() {
    return this.results.find(({surface}) => surface.distances) ?? this.result;
  }

  /** The surface that distances of a model go to; null if it is not all in the page, or while the model plays. */
  otherOf(model) {
    if (model.isMoving) return model.errors && !this.playing.isPlaying ? this.original.surface : null;
    const other = model === this.original ? this.comparedWithOriginal() : this.original;
    return model.surface.distances && other?.surface.note === '' ? other.surface : null;
  }

  hasExactColours() {
    return $('colour').value === 'error' && $('faces').checked && this.modelsOfPanes().some((model) => this.otherOf(model));
  }

  keyOfExactColours() {
    const models = this.modelsOfPanes();
    return [this.view.key(), this.layout(), this.results.indexOf(this.result), $('shading').value, ...models.map((model) => this.otherOf(model) && model.moment)].join();
  }

  startExactColours() {
    const isSmooth = $('shading').value !== 'flat';
    this.exact.start(this.keyOfExactColours(), this.modelsOfPanes().map((model) => {
      const other = this.otherOf(model);
      return other && {surface: model.surface, moment: model.moment, geometry: model.wholeGeometry(), isSmooth, other};
    }));
  }

  /** Before the next picture. */
  draw() {
    if (this.isHeld || !this.isDrawn || this.isClosed()) return;
    this.isDrawn = false;
    this.frame = requestAnimationFrame(() => this.drawNow());
  }

  show() {
    this.isHeld = false;
    this.draw();
  }

  drawNow() {
    this.isDrawn = true;
    if (!this.view || !this.background) return;
    const hasExactColours = this.hasExactColours();
    const isExact = hasExactColours && this.exact.isDoneFor(this.keyOfExactColours());
    const moving = isExact ? 0 : this.motion.beginFrame();
    const roughness = moving || (hasExactColours && !isExact ? Math.min(1, this.motion.roughness) : 0);
    const isQuick = roughness > 0;
    this.view.setRoughness(roughness);
    for (const model of [this.original, this.result]) model?.useCoarse(isQuick);
    const hasLines = $('edges').checked || this.layout() === 'over' && $('ghost').value === 'edges';
    this.view.draw(this.panes(isExact), this.background, hasLines);
    this.spot.follow();
    this.isWhole = !isQuick && isExact === hasExactColours;
    if (hasExactColours && !this.motion.isMoving) this.startExactColours();
    if (!document.documentElement.dataset.ready) document.documentElement.dataset.ready = Math.round(performance.now());
  }

  /** Functions that show what is to be seen in each pane. */
  panes(isExact) {
    const boxes = ['faces', 'edges', 'borders', 'nonmanifold', 'refused'];
    const chosen = Object.fromEntries(boxes.map((id) => [id, $(id).checked]));
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

  /** What the player does is to be in the picture. */
  showRecording() {
    if (this.result.surface === this.recording && this.layout() !== 'original') return;
    this.result = this.results.find(({surface}) => surface === this.recording);
    $('result').value = this.results.indexOf(this.result);
    if (this.layout() === 'original') $('layout').value = 'result';
    this.apply();
  }

  // Events -----------------------------------------------------------------------------------------------------------

  setUpEvents() {
    const {signal} = this.ending;
    for (const id of ['layout', 'ghost', 'shading', 'colour', 'top', 'faces', 'edges', 'borders', 'nonmanifold', 'refused']) {
      $(id).addEventListener('change', () => this.apply());
    }
    $('result').addEventListener('change', () => {
      this.result = this.results[Number($('result').value)];
      this.apply();
    });
    $('split').addEventListener('input', () => {
      this.setPanes();
      this.placeWhatLiesOver();
    });
    $('fit').addEventListener('click', () => this.view.fit());
    $('worst').addEventListener('click', () => this.showWorst());
    $('up').addEventListener('change', () => {
      this.view.setUp($('up').value);
      this.view.fit();
    });
    $('numbers')?.addEventListener('click', () => {
      $('tables').scrollIntoView();
      $('tables').focus({preventScroll: true});
    }, {signal});
    $('help').addEventListener('click', () => $('keys').showModal());
    $('close').addEventListener('click', () => $('keys').close());
    this.setUpWindow();
    const player = this.isPlayed ? this.player : null;
    setUpKeys($('key-list'), rowsOfKeys({...this, player, describeMiddles: () => this.describeMiddles()}), {signal});
    this.setUpPicking();
  }

  setUpWindow() {
    const {signal} = this.ending;
    this.resizing = new ResizeObserver(() => {
      this.view.resize();
      this.showLabels();
    });
    this.resizing.observe($('canvas'));
    for (const query of ['(prefers-color-scheme: dark)', 'print']) {
      window.matchMedia(query).addEventListener('change', () => this.applyTheme(), {signal});
    }
    window.addEventListener('hashchange', () => {
      this.followAddress();
      this.apply();
    }, {signal});
  }

  isClosed() {
    return this.ending.signal.aborted;
  }

  /** Ends all that goes on and frees what the graphics processor has, so that another one can take its place, with the
      markup as it was. */
  async close() {
    this.ending.abort();
    this.resizing.disconnect();
    cancelAnimationFrame(this.frame);
    this.motion.stop();
    this.exact.stop();
    ++this.nDescribed;
    await this.exact.work; // it may still be reading a picture
    this.view.close();
  }

  // Places -----------------------------------------------------------------------------------------------------------

  /** A click without a drag says what is there; a second one goes there. */
  setUpPicking() {
    setUpFingers($('canvas'), this.view);
    setUpClicks($('canvas'), {
      onClick: (event) => this.describe([event]),
      onDoubleClick: (event) => {
        const {hit} = this.hitAt(event);
        if (hit) this.view.focus(hit.point); else this.view.fit();
      },
    });
  }

  hitAt(point) {
    return this.view.pick(point, this.modelsOfPanes().map((model) => model.faces));
  }

  /** Says what is in the middle of each pane. */
  describeMiddles() {
    const {left, top} = $('canvas').getBoundingClientRect();
    return this.describe(this.view.boxes().map((box) =>
      ({clientX: left + (box.begin + box.end) / 2, clientY: top + this.view.height - box.bottom - box.height / 2})), 'There is nothing in the middle.');
  }

  /** Says what is at points of the window, unless it is asked for something else meanwhile. */
  async describe(points, otherwise = '') {
    const number = ++this.nDescribed;
    const places = [];
    for (const point of points) places.push(await this.placeAt(point));
    if (number !== this.nDescribed) return;
    const found = places.filter((place) => place);
    this.say(found.map(({text}) => text).join('; ') || otherwise);
    if (found.length > 0) this.spot.show(found[0].point, found[0].pane, found[0].text); else this.spot.hide();
  }

  say(text) {
    $('status').textContent = text;
  }

  forgetWhatWasDescribed() {
    ++this.nDescribed;
    this.say('');
    this.spot.hide();
  }

  async placeAt(windowPoint) {
    const {pane, hit} = this.hitAt(windowPoint);
    if (!hit) return null;
    const model = this.modelsOfPanes()[pane];
    const value = await this.valueAt(model, hit);
    const meaning = {error: 'distance', shape: 'radius ratio'}[model.colour] ?? model.range()?.value;
    const unitOfValue = model.colour === 'error' ? ` ${lengthUnit}` : '';
    const text = meaning && value !== null ? `${meaning} ${short(value)}${unitOfValue}, ` : '';
    return {pane, point: hit.point, text: text + this.textOf(model, hit.point)};
  }

  textOf(model, point) {
    return `${model.surface.name} at (${this.toModel(point.toArray()).map(short).join(', ')})`;
  }

  /** \param coordinates in the scene */
  toModel(coordinates) {
    return Array.from(coordinates, (coordinate, d) => this.json.origin[d] + coordinate * unit * this.json.step);
  }

  /** What the colour means at a point of a face. */
  async valueAt(model, hit) {
    const other = model.colour === 'error' && this.otherOf(model);
    if (!other) return model.interpolatedAt(hit);
    const tree = this.exact.treeOf(other);
    await doInSlices(tree.finish());
    return tree.distance(hit.point.clone().multiplyScalar(unit)) * this.json.step;
  }

  /** Goes to the place with the largest error of what is shown, in its colours. Where the result has none, its level of
      the recording is shown. */
  async showWorst() {
    $('colour').value = 'error';
    this.apply();
    if (this.recording && !this.shownModels().some((model) => model.range())) {
      const {nFaces} = this.result.surface;
      this.showRecording();
      this.player.goToFaces(nFaces);
    }
    const number = ++this.nDescribed;
    const places = [];
    const models = this.shownModels();
    for (const model of models) {
      const worst = await this.worstOf(model);
      if (worst) places.push({model, ...worst});
    }
    if (number !== this.nDescribed || places.length === 0) return;
    const {model, value, point, normal} = places.reduce((a, b) => b.value > a.value ? b : a);
    this.view.focus(point, normal);
    this.keepInSplit(model);
    const text = `Largest distance ${short(value)} ${lengthUnit}, ${this.textOf(model, point)}`;
    this.say(text);
    this.spot.show(point, this.layout() === 'over' ? 0 : models.indexOf(model), text);
  }

  /** Moves the line between before and after aside, where it hides the middle of a model. */
  keepInSplit(model) {
    const aside = 100;
    const {value} = $('split');
    $('split').value = model === this.original ? Math.max(value, 500 + aside) : Math.min(value, 500 - aside);
    this.setPanes();
    this.placeWhatLiesOver();
  }

  async worstOf(model) {
    if (model.surface.distances) return worstOfSurface(model.surface);
    if (!model.errors) return null;
    await doInSlices(this.exact.treeOf(this.original.surface).finish());
    await doInSlices(model.errors.finish(model.position.array));
    return worstOfLevel(model.surface, model.errors);
  }
}
