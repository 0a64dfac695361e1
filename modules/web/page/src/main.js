// The page that simplifies.
import {Calls} from './calls.js';
import {Page} from './page.js';
import {warmUp} from './warm.js';

const textOf = (id) => document.getElementById(id).textContent;

const calls = new Calls(textOf('whittle-worker'), textOf('whittle-wasm'));
new Page(calls);
warmUp();
calls.start(); // it compiles its module while nobody waits for it
