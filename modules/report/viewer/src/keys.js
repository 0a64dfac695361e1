// What keys do. The page lists them.

const $ = (id) => document.getElementById(id);

function change(id, property, value) {
  const control = $(id);
  if (control.disabled || control.closest('[hidden]')) return;
  control[property] = value;
  control.dispatchEvent(new Event('change'));
}

/** What a key does, and the control that it stands for. */
const of = (id, act) => Object.assign(act, {id});

const choose = (id, value) => of(id, () => change(id, 'value', value));
const toggle = (id) => of(id, () => change(id, 'checked', !$(id).checked));
const focus = (id) => of(id, () => $(id).focus());
const press = (id) => of(id, () => {
  if (!$(id).closest('[hidden]')) $(id).click();
});

const slide = (id, by) => of(id, () => {
  if ($(id).hidden) return;
  $(id).value = Number($(id).value) + by;
  $(id).dispatchEvent(new Event('input'));
});

const next = (id) => of(id, () => {
  const options = [...$(id).options].filter(({disabled}) => !disabled);
  const i = options.findIndex(({value}) => value === $(id).value);
  change(id, 'value', options[(i + 1) % options.length].value);
});

/** What the arrow keys do in a direction. \param right, up the steps */
const arrow = (view, right, up) => (isShifted) => {
  const angle = Math.PI / 24;
  if (isShifted) view.move(-0.05 * right, -0.05 * up); else view.rotate(angle * right, -angle * up);
};

/** Rows of the list: the keys as they are shown, what they do in words, and, by the name of each key, what is called
    then with whether Shift is held. */
export function rowsOfKeys({view, player, result, describeMiddles}) {
  const rows = [
    {shown: 'Arrows', says: 'rotate; with Shift, move', acts: {ArrowLeft: arrow(view, -1, 0), ArrowRight: arrow(view, 1, 0),
      ArrowUp: arrow(view, 0, 1), ArrowDown: arrow(view, 0, -1)}},
    {shown: '+ − 0', says: 'nearer, farther, fit', acts: {'+': () => view.zoom(0.85), '=': () => view.zoom(0.85),
      '-': () => view.zoom(1 / 0.85), '0': press('fit')}},
    {shown: 'c t s u', says: 'next colour, end of its scale, shading, axis upwards', acts: {c: next('colour'), t: next('top'), s: next('shading'), u: next('up')}},
    {shown: 'f e o n p', says: 'faces, edges, open borders, non-manifold edges, refused pairs', acts: {f: toggle('faces'), e: toggle('edges'),
      o: toggle('borders'), n: toggle('nonmanifold'), p: toggle('refused')}},
    {shown: 'Enter', says: 'say what is in the middle, as a click there does', acts: {Enter: describeMiddles}},
    $('numbers') ? {shown: 'w x ?', says: 'the place with the largest error, tables and plots, this list',
      acts: {w: press('worst'), x: press('numbers'), '?': press('help')}}
      : {shown: 'w ?', says: 'the place with the largest error, this list', acts: {w: press('worst'), '?': press('help')}},
    {shown: 'Esc', says: 'go from a list or button to the picture, so that all keys act', acts: {Escape: () => $('canvas').focus({preventScroll: true})}},
  ];
  if (result) {
    rows.push({shown: '1 2 3 4 5', says: 'side by side, laid over each other, original, result, before and after', acts: {1: choose('layout', 'beside'),
      2: choose('layout', 'over'), 3: choose('layout', 'original'), 4: choose('layout', 'result'), 5: choose('layout', 'split')}});
    rows.push({shown: '[ ]', says: 'the line between before and after to the left, to the right', acts: {'[': slide('split', -50), ']': slide('split', 50)}});
    rows.push({shown: 'r g', says: 'next result, how the original lies over it', acts: {r: next('result'), g: next('ghost')}});
  }
  if (player) {
    rows.push({shown: 'Space b', says: 'play or pause, play backwards', acts: {' ': press('play'), b: press('back')}});
    rows.push({shown: ', .', says: 'one step back, one on', acts: {',': press('previous'), '.': press('next')}});
    rows.push({shown: '< >', says: 'slower, faster', acts: {'<': press('slower'), '>': press('faster')}});
    rows.push({shown: 'j i d', says: 'a number of faces, a largest error, save the level', acts: {j: focus('count'), i: focus('limit'), d: press('save')}});
    rows.push({shown: 'm l', says: 'in steps or continuous, what the slider counts', acts: {m: next('movement'), l: next('spacing')}});
  }
  return rows;
}

/** Whether a control that has the focus does something of its own with a key. */
function isKeyOf(control, key) {
  if (control.matches('select')) return key !== 'Escape'; // letters choose, too
  if (control.matches('[type=number]')) return key !== 'Escape';
  if (control.matches('[type=range]')) return /^(Arrow|Page|Home|End)/.test(key);
  return key === ' ' || key === 'Enter' && !control.matches('[type=checkbox]');
}

/** Adds the keys of each control to what is shown when the mouse rests on it. */
function addToTitles(acts) {
  const keysOf = new Map();
  for (const [key, {id}] of acts) if (id) keysOf.set(id, [...keysOf.get(id) ?? [], key === ' ' ? 'Space' : key]);
  for (const [id, keys] of keysOf) {
    const titled = $(id).closest('[title]');
    titled.title += ` (${keys.length > 1 ? 'keys' : 'key'} ${keys.join(' ')})`;
  }
}

/** Lists the keys in an element, and lets them act, up to a signal. */
export function setUpKeys(list, rows, {signal}) {
  for (const {shown, says} of rows) {
    const term = document.createElement('dt');
    const meaning = document.createElement('dd');
    term.textContent = shown;
    meaning.textContent = says;
    list.append(term, meaning);
  }
  const acts = new Map(rows.flatMap((row) => Object.entries(row.acts)));
  addToTitles(acts);
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || document.querySelector('dialog[open]')) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const act = acts.get(key);
    const control = event.target instanceof Element && event.target.closest('select, input, button, summary');
    if (!act || control && isKeyOf(control, key)) return;
    event.preventDefault();
    act(event.shiftKey);
  }, {signal});
}
