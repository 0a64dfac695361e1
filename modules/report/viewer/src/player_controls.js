// The controls of the player.
import {counted} from './facts.js';
import {Player} from './player.js';
import {plyOf, saveAs} from './save.js';

const longestFrame = 0.25; // seconds that the player goes on by at once, also after the page was out of sight

const $ = (id) => document.getElementById(id);

export class PlayerControls {
  /** \param app shows the recording \param onMove is called with the positions of each moment */
  constructor(app, recording, onMove) {
    this.app = app;
    this.recording = recording;
    $('player').hidden = !app.isPlayed;
    this.player = new Player(recording, (positions) => {
      onMove(positions);
      this.show();
    });
    this.player.goTo(1);
    this.isPlaying = false;
    this.setUpEvents();
  }

  setUpEvents() {
    const on = (id, event, act) => $(id).addEventListener(event, act);
    const shown = (act) => () => {
      this.app.showRecording();
      act();
    };
    on('slider', 'input', () => this.stopAt(Number($('slider').value) / 1000));
    on('play', 'click', () => this.play(1));
    on('back', 'click', () => this.play(-1));
    on('next', 'click', shown(() => this.player.stepBy(1)));
    on('previous', 'click', shown(() => this.player.stepBy(-1)));
    on('faster', 'click', () => this.changeSpeed(2));
    on('slower', 'click', () => this.changeSpeed(0.5));
    for (const [id, go] of [['count', () => this.goToFaces()], ['limit', () => this.goToLimit()]]) {
      on(id, 'change', go);
      on(id, 'keydown', ({key}) => key === 'Enter' && go()); // also if it is the same number again
    }
    on('save', 'click', () => this.save());
    for (const id of ['movement', 'spacing']) on(id, 'change', shown(() => this.setUpMovement()));
  }

  /** As the controls say. */
  setUpMovement() {
    this.player.isContinuous = $('movement').value === 'continuous';
    this.player.isByFaces = $('spacing').value === 'faces';
    this.player.goTo(this.player.place);
  }

  changeSpeed(factor) {
    this.player.setSpeed(this.player.speed * factor);
    this.show();
  }

  /** Stands still at a place in the recording, and shows it. \param place 0 … 1 */
  stopAt(place) {
    this.app.showRecording();
    this.player.stopAt(place);
  }

  goToFaces() {
    const n = Number($('count').value);
    this.app.showRecording();
    if ($('count').value !== '' && n >= 0) this.player.goToFaces(n); else this.show();
  }

  /** To the fewest faces within the error that is asked for. */
  goToLimit() {
    const {value} = $('limit');
    if (value === '') return;
    const nContractions = this.recording.contractionsWithin(Number(value));
    if (nContractions === null) return this.app.say(`No measured level keeps within ${value}.`);
    this.stopAt(this.player.placeOf(nContractions));
    this.app.say(`${counted(this.recording.nFaces, 'face', 'faces')} keep within ${value}, as far as samples tell; --max-error proves it.`);
  }

  save() {
    const {recording, app} = this;
    app.showRecording();
    const name = `${app.json.title.replace(/\.\w+(,.*)?$/, '').replace(/[^\w.-]+/g, '_') || 'level'}_${recording.nFaces}.ply`;
    saveAs(name, plyOf(recording, (coordinates) => app.toModel(coordinates)));
    app.say(`Saved ${name}. Positions are rounded to a 65,535th of the longest side: whittle replay writes the exact ones.`);
  }

  play(direction) {
    this.app.showRecording();
    this.player.play(direction);
    this.show();
    if (this.isPlaying || this.player.direction === 0) return;
    this.isPlaying = true;
    this.lastMoment = null;
    requestAnimationFrame((moment) => this.advance(moment));
  }

  advance(moment) {
    if (this.app.isClosed()) return;
    const seconds = this.lastMoment === null ? 0 : Math.min(longestFrame, (moment - this.lastMoment) / 1000);
    this.lastMoment = moment;
    this.isPlaying = this.player.advance(seconds);
    if (this.isPlaying) return requestAnimationFrame((next) => this.advance(next));
    this.show();
    this.app.draw(); // what takes longer is drawn now that it stands still
  }

  /** The error of the level; null if none was measured. */
  error() {
    const error = this.recording.errorAt(this.recording.nFaces);
    return error && {...error, isAbout: error.faces !== this.recording.nFaces};
  }

  /** What the player's controls say of this moment. */
  show() {
    const {recording, player, app} = this;
    $('level').textContent = `${counted(recording.nFaces, 'face', 'faces')}, ${counted(recording.nContractions, 'contraction', 'contractions')}`;
    $('slider').value = 1000 * player.place;
    $('slider').setAttribute('aria-valuetext', $('level').textContent);
    if (document.activeElement !== $('count')) $('count').value = recording.nFaces;
    $('speed').textContent = `speed ${player.speed >= 1 ? player.speed : `1/${1 / player.speed}`}`;
    const button = (id, isPlaying, sign, text, name) => {
      $(id).textContent = isPlaying ? '❚❚' + text.replace('Play', 'Pause') : sign + text;
      $(id).setAttribute('aria-label', isPlaying ? 'Pause' : name);
    };
    button('play', player.direction > 0, '▶', ' Play', 'Play');
    button('back', player.direction < 0, '◀', '', 'Play backwards');
    $('previous').disabled = player.isAtEnd(-1);
    $('next').disabled = player.isAtEnd(1);
    $('slower').disabled = player.isSlowest();
    $('faster').disabled = player.isFastest();
    app.onLevel();
  }
}
