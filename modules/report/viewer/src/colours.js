// What colours mean. All scales can be told apart by colour-blind people.
import {DataTexture, LinearSRGBColorSpace, NearestFilter, RGBAFormat} from 'three';
import {interpolateCividis, interpolatePuOr, interpolateViridis} from 'd3-scale-chromatic';

const nSteps = 8; // of a scale

const valenceClasses = ['3 or less', '4', '5', '6', '7', '8', '9 or more'];

/** \return 0 … 6 */
export const valenceClass = (valence) => Math.min(6, Math.max(0, valence - 3));

const parse = (text) => {
  const hex = /^#(..)(..)(..)$/.exec(text);
  return hex ? hex.slice(1).map((part) => parseInt(part, 16)) : text.match(/\d+/g).map(Number);
};

const even = (interpolate, n) => Array.from({length: n}, (_, i) => parse(interpolate(n > 1 ? (i + 0.5) / n : 0.5)));

export const scales = {
  error: {colours: even(interpolateViridis, nSteps)},
  shape: {colours: even(interpolateCividis, nSteps)},
  valence: {colours: valenceClasses.map((_, i) => i === 3 ? [150, 150, 150] : parse(interpolatePuOr(i / 6))), names: valenceClasses},
};

/** A scale as a row of texels. */
export function textureOf(scale) {
  return scale.texture ??= makeTexture(scale);
}

/** Scales stay; what a graphics processor has of them goes. */
export function forgetTextures() {
  for (const {texture} of Object.values(scales)) texture?.dispose();
}

function makeTexture(scale) {
  const data = new Uint8Array(4 * scale.colours.length);
  scale.colours.forEach((colour, i) => data.set([...colour, 255], 4 * i));
  const texture = new DataTexture(data, scale.colours.length, 1, RGBAFormat);
  texture.colorSpace = LinearSRGBColorSpace; // shown as it is
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

/** Of the reasons for which pairs are refused: those of Okabe and Ito that are seen on a surface. */
export const refusalColours = ['#d55e00', '#0072b2', '#cc79a7', '#009e73', '#000000', '#56b4e9', '#e69f00'];

/** Shows what the colours of refused pairs mean. */
export function showRefusals(element, refusals) {
  element.replaceChildren();
  const heading = document.createElement('div');
  heading.textContent = 'pairs that may not be contracted';
  element.append(heading);
  refusals.forEach(({reason, pairs}, i) => {
    const row = document.createElement('div');
    const mark = document.createElement('span');
    mark.className = 'mark';
    mark.style.backgroundColor = refusalColours[i % refusalColours.length];
    row.append(mark, `${(pairs.length / 2).toLocaleString('en')} ${reason}`);
    element.append(row);
  });
}

/** Three digits that count. */
export const short = (value) => value === 0 ? '0' : Number(value.toPrecision(3)).toString();

/** Adds a line to an element. */
export function showNote(element, text) {
  const line = document.createElement('div');
  line.textContent = text;
  element.append(line);
}

/** Adds a scale to an element. \param top the value at its end, of scales without names */
export function showLegend(element, title, scale, top) {
  const heading = document.createElement('div');
  heading.textContent = title;
  const steps = document.createElement('div');
  steps.className = 'steps';
  const ticks = document.createElement('div');
  ticks.className = 'ticks';
  for (const [r, g, b] of scale.colours) {
    const step = document.createElement('span');
    step.style.backgroundColor = `rgb(${r} ${g} ${b})`;
    steps.append(step);
  }
  const labels = scale.names ?? (top > 0 ? [0, top / 4, top / 2, 3 * top / 4, top] : [0]).map(short);
  for (const label of labels) {
    const tick = document.createElement('span');
    tick.textContent = label;
    ticks.append(tick);
  }
  element.append(heading, steps, ticks);
}
