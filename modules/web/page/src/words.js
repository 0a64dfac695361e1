// What the page says, in words.
import {short} from '../../../report/viewer/src/colours.js';
import {counted} from '../../../report/viewer/src/facts.js';

const units = [['MB', 1e6], ['kB', 1e3]];

/** "93.1 kB" */
export function sizeText(nBytes) {
  const [name, factor] = units.find(([, bytes]) => nBytes >= bytes) ?? ['bytes', 1];
  return `${short(nBytes / factor)} ${name}`;
}

/** "simplifying, 40 %: 12,345 faces left" */
export function progressText({stage, fraction, faces}) {
  const percent = fraction > 0 ? `, ${Math.floor(100 * fraction)} %` : '';
  return faces > 0 ? `${stage}${percent}: ${counted(faces, 'face', 'faces')} left` : stage + percent;
}

/** What is said of an error of the worker. */
export function problemText({message, kind}) {
  if (kind === 'memory') return 'This mesh needs more memory than a page can have (4 GB). The program has no such limit.';
  return kind === 'invalid' ? message : `Something went wrong: ${message}`;
}
