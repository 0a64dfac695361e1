// Somebody who looks at a page and uses it, by mouse, keyboard or touch.
'use strict';

const assert = require('assert/strict');

const patience = 20000; // milliseconds, on a busy machine

/** What is wrong with what lies over the picture: in the page. */
function faultsOfOverlays() {
  const boxes = ['reasons', 'legend', 'spot'].map((id) => document.getElementById(id)).filter(({hidden}) => !hidden)
    .map((element) => ({name: element.id, box: element.getBoundingClientRect()}));
  const {left, right} = document.getElementById('stage').getBoundingClientRect();
  const faults = boxes.filter(({box}) => box.left < left || box.right > right).map(({name}) => `${name} leaves the picture`);
  const [reasons, legend] = ['reasons', 'legend'].map((id) => boxes.find(({name}) => name === id)?.box);
  if (reasons && legend && reasons.right > legend.left) faults.push('the legend covers the reasons');
  return faults;
}

class Visitor {
  constructor(page) {
    this.page = page;
  }

  /** What is seen. `picture` tells pictures apart. */
  async look() {
    assert.deepEqual(await this.page.evaluate(faultsOfOverlays), []);
    return this.page.evaluate(async () => {
      await new Promise(requestAnimationFrame); // moves of a mouse and of fingers come with it
      await window.whittle.drawn();
      const $ = (id) => document.getElementById(id);
      const gl = $('canvas').getContext('webgl2'); // of the page: what is in it is what is shown
      const pixels = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
      gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      const text = (id) => $(id).closest('[hidden]') ? '' : $(id).textContent;
      const name = (id) => $(id).closest('[hidden]') ? '' : $(id).getAttribute('aria-label');
      const labels = `${text('left-label')} | ${text('right-label')}`;
      const seen = {
        labels, legend: text('legend'), reasons: text('reasons'), status: text('status'), level: text('level'), speed: text('speed'),
        play: name('play'), back: name('back'), place: $('slider').value / 1000, focus: document.activeElement.id,
        direction: Number(name('play') === 'Pause') - Number(name('back') === 'Pause'), isOpen: $('json').open, isHelpOpen: $('keys').open,
        spot: $('spot').hidden ? '' : text('spot'), scrolled: window.scrollY, split: $('split').hidden ? null : $('split').value,
        isRecordingShown: labels.includes('level of the run'), nLevels: window.whittle.recording?.nSteps,
      };
      const digest = await crypto.subtle.digest('SHA-256', pixels); // of what was seen with these texts
      return {...seen, picture: `${pixels.length} ${new Uint32Array(digest).join()}`};
    });
  }

  async wait(condition, about, what) {
    await this.page.waitForFunction(condition, about, {timeout: patience}).catch((error) => {
      throw new Error(`not seen: ${what} (${error.message.split('\n')[0]})`);
    });
  }

  /** Lets a few frames pass. */
  frames() {
    return this.page.evaluate(async () => {
      for (let i = 0; i < 5; ++i) await new Promise(requestAnimationFrame);
    });
  }

  /** Puts the player to a place, and lets it go on as it does. */
  jumpTo(place) {
    return this.page.evaluate((at) => window.whittle.player.goTo(at), place);
  }

  /** Brings the player into a state. If it plays, it has left the end where it began. \param direction −1, 0 or 1 */
  async reach(place, direction, speed = 1) {
    const begin = await this.page.evaluate(([at, way, fast]) => {
      const {player} = window.whittle;
      player.setSpeed(fast);
      window.whittle.playing.stopAt(at);
      if (way !== 0) window.whittle.playing.play(way);
      return player.place;
    }, [place, direction, speed]);
    if (direction !== 0) await this.wait(([at]) => window.whittle.player.place !== at, [begin], 'it plays');
  }

  /** Brings lists to values, and shows all from the front, in one picture, if something of it is not so yet.
      \param values by the list's name */
  prepare(values) {
    return this.page.evaluate((wanted) => {
      for (const [name, value] of Object.entries(wanted)) {
        const list = document.getElementById(name);
        if (list.value === value) continue;
        list.value = value;
        if (list.value !== value) throw new Error(`${name} has no ${value}`);
        list.dispatchEvent(new Event('change'));
      }
      const {view} = window.whittle;
      if (view.key() === window.keyWhenFitted) return;
      view.fit();
      window.keyWhenFitted = view.key();
    }, values);
  }

  /** The names of the controls that can be used now: their id, or their tag.
      \param isOfPlayer whether only those of the player are meant, or only the others; otherwise all are */
  controls(isOfPlayer = null) {
    return this.page.evaluate((ofPlayer) => {
      const all = document.querySelectorAll('a[href], button, input, select, textarea, summary, [tabindex]:not([tabindex="-1"]), [contenteditable]');
      const isMeant = (e) => ofPlayer === null || Boolean(e.closest('#player')) === ofPlayer;
      return [...all].filter((e) => e.offsetParent !== null && !e.disabled && isMeant(e)).map((e) => e.id || e.tagName.toLowerCase());
    }, isOfPlayer);
  }

  async isUsable(name) {
    return (await this.controls()).includes(name);
  }

  /** Presses a button or a box. */
  async press(name, by) {
    if (by === 'mouse') return this.click(await this.point(name, 0.5, 0.5), by);
    if (by === 'touch') return this.tap(name);
    await this.focus(name);
    return this.page.keyboard.press(name === 'summary' ? 'Enter' : 'Space');
  }

  /** Taps again where the browser takes a tap for the end of a movement: soon after the page has scrolled. */
  async tap(name) {
    await this.page.evaluate((control) => {
      window.isTapped = false;
      const element = document.getElementById(control) ?? document.querySelector(control);
      element.addEventListener('click', () => { window.isTapped = true; }, {capture: true, once: true});
    }, name);
    for (let i = 0; i < 5; ++i) {
      await this.click(await this.point(name, 0.5, 0.5), 'touch');
      if (await this.page.waitForFunction(() => window.isTapped, null, {timeout: 1000}).then(() => true, () => false)) return;
    }
    throw new Error(`${name} is not tapped`);
  }

  /** \param name id or tag of a control */
  focus(name) {
    return this.page.evaluate((control) => (document.getElementById(control) ?? document.querySelector(control)).focus(), name);
  }

  /** The values that a list offers. */
  options(name) {
    return this.page.evaluate((id) => [...document.getElementById(id).options].filter(({disabled}) => !disabled).map(({value}) => value), name);
  }

  value(name) {
    return this.page.evaluate((id) => document.getElementById(id).value, name);
  }

  /** Chooses in a list. A browser without a window has no list to click into. */
  async choose(name, value, by) {
    if (by !== 'keys') return this.page.selectOption(`#${name}`, value);
    await this.focus(name);
    const options = await this.options(name);
    const steps = options.indexOf(value) - options.indexOf(await this.value(name));
    for (let i = 0; i < Math.abs(steps); ++i) await this.page.keyboard.press(steps > 0 ? 'ArrowDown' : 'ArrowUp');
    if (await this.value(name) !== value) throw new Error(`the arrow keys don't choose ${value}`);
  }

  /** A point of the window. Nothing covers the control there, but the legend, which lies over the canvas.
      \param x, y shares of the control's width and height */
  point(name, x, y) {
    return this.page.evaluate(([control, right, down]) => {
      const element = document.getElementById(control) ?? document.querySelector(control);
      element.scrollIntoView({block: 'nearest', behavior: 'instant'});
      const {left, top, width, height} = element.getBoundingClientRect();
      const point = [left + right * width, top + down * height];
      const there = document.elementFromPoint(...point);
      if (!element.contains(there) && there?.id !== 'legend') throw new Error(`${control} is covered by ${there?.outerHTML.slice(0, 80)}`);
      return point;
    }, [name, x, y]);
  }

  async click(point, by) {
    await (by === 'touch' ? this.page.touchscreen : this.page.mouse)[by === 'touch' ? 'tap' : 'click'](...point);
  }

  async drag(from, to, button = 'left') {
    await this.page.mouse.move(...from);
    await this.page.mouse.down({button});
    await this.page.mouse.move(...to, {steps: 3});
    await this.page.mouse.up({button});
  }

  /** Moves fingers. \param fingers of each, from where to where */
  async touch(fingers) {
    this.session ??= await this.page.context().newCDPSession(this.page);
    const send = (type, share) => this.session.send('Input.dispatchTouchEvent', {type, touchPoints: share === null ? []
      : fingers.map(([from, to], id) => ({id, x: from[0] + share * (to[0] - from[0]), y: from[1] + share * (to[1] - from[1])}))});
    await send('touchStart', 0);
    for (const share of [0.3, 0.6, 1]) await send('touchMove', share);
    await send('touchEnd', null);
  }
}

module.exports = {Visitor};
