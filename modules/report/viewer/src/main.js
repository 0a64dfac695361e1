// The page of `whittle report`.
import {App, prepare} from './app.js';
import {readPage} from './data.js';
import {followRun} from './live.js';

async function start() {
  try {
    window.whittle = new App(await prepare(await readPage(document)));
    followRun(window.whittle);
  } catch (error) {
    const problem = document.getElementById('problem');
    problem.hidden = false;
    problem.textContent = `The meshes can't be shown: ${error.message}`;
    document.documentElement.dataset.ready = 'failed';
    throw error;
  }
}

start();
