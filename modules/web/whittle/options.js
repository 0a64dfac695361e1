// Options by the names of JavaScript, as the module takes them.
import {WhittleError, textAt} from './errors.js';

const ofProgram = {facesLeft: 'faces', verticesLeft: 'vertices'};

const kebab = (name) => ofProgram[name] ?? name.replace(/[A-Z]/g, (letter) => '-' + letter.toLowerCase());

/** The names of all options, as keys. */
function knownNames(engine) {
  const names = textAt(engine.memory, engine.option_names()).split('\n');
  return new Set(names.map((name) => name.split(' ')[0]));
}

export function writeText(engine, reserve, text) {
  const bytes = new TextEncoder().encode(text);
  const at = reserve(bytes.length);
  new Uint8Array(engine.memory.buffer, at, bytes.length).set(bytes);
}

function setOne(engine, given, name, value) {
  const text = String(value);
  const isPercent = typeof value === 'string' && text.endsWith('%');
  const digits = isPercent ? text.slice(0, -1) : text;
  const isNumber = typeof value === 'number' || (typeof value === 'string' && /^[-+0-9.]/.test(digits));
  writeText(engine, engine.name_of, name);
  writeText(engine, engine.word_of, text);
  try {
    engine.option(isNumber ? Number(digits) : NaN, isPercent ? 1 : 0);
  } catch (error) {
    if (!(error instanceof WhittleError) || error.kind !== 'invalid') throw error;
    throw new WhittleError(`${given}: '${text}' isn't valid: ${error.message}`);
  }
}

/** Sets each option that is neither undefined nor null. \throws WhittleError that names the option and what is valid */
export function setOptions(engine, options) {
  const known = knownNames(engine);
  for (const [given, value] of Object.entries(options)) {
    if (value === undefined || value === null) continue;
    const name = kebab(given);
    if (!known.has(name) || given.includes('-') || given === 'faces' || given === 'vertices') {
      throw new WhittleError(`there is no option ${given}`);
    }
    if (name === 'attribute-weight') {
      for (const [kind, weight] of Object.entries(value))
        setOne(engine, `attributeWeight.${kind}`, `${name} ${kind}`, weight);
    } else {
      setOne(engine, given, name, value);
    }
  }
}
