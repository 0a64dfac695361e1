// What goes on: its progress, and a button that ends it.
import {Cancelled} from './calls.js';
import {say} from './messages.js';
import {problemText, progressText} from './words.js';

const $ = (id) => document.getElementById(id);

export class Work {
  /** \param onChange is called with whether something goes on */
  constructor(onChange) {
    this.onChange = onChange;
    this.ending = null; // of what goes on
    $('cancel').addEventListener('click', () => this.ending?.abort());
  }

  /** Does something that can be cancelled, and says why it failed. What went on before ends.
      \param element that the progress takes the place of \param act is called with {signal, onProgress}
      \return whether it was done */
  async does(element, act) {
    this.ending?.abort();
    this.end();
    const ending = new AbortController();
    this.begin(element, ending);
    try {
      await act({signal: ending.signal, onProgress: (progress) => this.show(progress)});
      return !ending.signal.aborted;
    } catch (error) {
      if (!(error instanceof Cancelled)) say({problem: problemText(error)});
      return false;
    } finally {
      if (this.ending === ending) this.end();
    }
  }

  begin(element, ending) {
    say({});
    Object.assign(this, {element, ending});
    const hadFocus = element.contains(document.activeElement);
    element.after($('work'));
    element.hidden = true;
    $('work').hidden = false;
    $('progress').removeAttribute('value');
    $('stage-of-work').textContent = '';
    if (hadFocus) $('cancel').focus();
    this.onChange(true);
  }

  end() {
    if (!this.ending) return;
    this.ending = null;
    const hadFocus = $('work').contains(document.activeElement);
    $('work').hidden = true;
    this.element.hidden = false;
    if (hadFocus) this.element.querySelector('button').focus();
    this.onChange(false);
  }

  /** \param progress {stage, fraction, faces}, as of the worker */
  show(progress) {
    if (progress.fraction > 0) $('progress').value = progress.fraction; else $('progress').removeAttribute('value');
    $('stage-of-work').textContent = progressText(progress);
  }
}
