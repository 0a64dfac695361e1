// The page that simplifies.
import {Calls} from './calls.js';
import {Page} from './page.js';
import {warmUp} from './warm.js';

const textOf = (id) => document.getElementById(id).textContent;

new Page(new Calls(textOf('whittle-worker'), textOf('whittle-wasm')));
warmUp();
