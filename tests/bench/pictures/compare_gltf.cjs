// compare_gltf.cjs [OPTION]... ASSET... [-- WHITTLE_OPTION...]: results of Whittle and of gltfpack with as many triangles,
// by pictures that three.js draws of them. tests/bench/README.md has the options.
'use strict';
const crypto = require('crypto');
const fs = require('fs');
const path = require('path');
const {parseArgs} = require('util');
const {openPage, urlOf} = require('./browser.cjs');
const {countTriangles} = require('./gltf_counts.cjs');
const {convert, gltfpack, modes, simplify} = require('./programs.cjs');
const {header, psnr, summaries, summaryLine, tableLine} = require('./table.cjs');

const version = 3; // of what the cache holds: another one where pictures or gltfpack's options change
const tolerance = 0.02; // of a target

const options = {
  whittle: {type: 'string', default: 'build/release/bin/whittle'},
  'node-modules': {type: 'string', default: 'build/npm/node_modules'},
  gltfpack: {type: 'string'},
  chromium: {type: 'string', default: '/usr/bin/chromium'},
  shares: {type: 'string', default: '.5,.1,.02'},
  modes: {type: 'string', default: 'sa,svsp'},
  cache: {type: 'string', default: 'build/pictures'},
  results: {type: 'string', default: 'build/pictures/results'},
  json: {type: 'string'},
  sheet: {type: 'string'},
  check: {type: 'boolean', default: false},
};

function settingsOf(values) {
  const end = values.includes('--') ? values.indexOf('--') : values.length;
  const {values: given, positionals} = parseArgs({args: values.slice(0, end), options, allowPositionals: true});
  const nodeModules = path.resolve(given['node-modules']);
  return {...given, nodeModules, assets: positionals, whittleOptions: values.slice(end + 1),
    gltfpack: given.gltfpack ?? path.join(nodeModules, 'gltfpack/cli.js'),
    shares: given.shares.split(',').map(Number), modes: given.modes.split(',')};
}

const stemOf = (asset) => path.basename(asset).replace(/\.\w+$/, '');
/** The name of the file, with that of its folder. */
const nameOf = (asset) => `${path.basename(path.dirname(path.resolve(asset)))}-${stemOf(asset)}`;

const hashOf = (file) => crypto.createHash('sha256').update(fs.readFileSync(file)).digest('hex').slice(0, 8);

/** `input` is what both programs read: what gltfpack refuses, such as Draco's compression, is converted first. */
function prepare(asset, settings) {
  const name = nameOf(asset);
  const key = `${name}-${hashOf(asset)}-${version}`;
  const folder = path.join(settings.cache, key);
  fs.mkdirSync(folder, {recursive: true});
  const converted = path.join(folder, 'converted.glb');
  if (fs.existsSync(converted)) return {name, stem: stemOf(asset), key, folder, input: converted};
  try {
    gltfpack(settings.gltfpack, asset, path.join(folder, 'whole.glb'), 1, 'sa');
    return {name, stem: stemOf(asset), key, folder, input: asset};
  } catch (error) {
    console.error(`${name}: converted first: ${error.message.trim()}`);
    convert(settings.whittle, asset, converted);
    return {name, stem: stemOf(asset), key, folder, input: converted};
  }
}

async function scores(page, file, canPose) {
  const rest = await page.ask('score', urlOf(file), 'rest');
  return canPose ? {rest, posed: await page.ask('score', urlOf(file), 'posed')} : {rest};
}

/** Of gltfpack's result, from the cache if it is there. */
async function scoreGltfpack(page, asset, share, mode, settings) {
  const file = path.join(asset.folder, `gltfpack-${mode}-${share}.glb`);
  const saved = `${file}.json`;
  if (fs.existsSync(saved)) return JSON.parse(fs.readFileSync(saved, 'utf8'));
  gltfpack(settings.gltfpack, asset.input, file, share, mode);
  const triangles = countTriangles(file);
  const result = {file, triangles, ...triangles.drawn ? await scores(page, file, asset.canPose) : {}};
  fs.writeFileSync(saved, JSON.stringify(result));
  return result;
}

async function scoreWhittle(page, asset, nFaces, settings) {
  const file = path.join(settings.results, `${asset.name}-${nFaces}.glb`);
  const run = simplify(settings.whittle, asset.input, file, nFaces, settings.whittleOptions);
  return {file, target: nFaces, ...run, triangles: countTriangles(file), ...await scores(page, file, asset.canPose)};
}

/** As many faces as gltfpack's, each mesh once. It may unite meshes and drop some, so drawn triangles tell, if they can. */
function targetFor(asset, theirs) {
  const isInstanced = asset.triangles.stored !== asset.triangles.drawn;
  return isInstanced ? theirs.triangles.stored : theirs.triangles.drawn;
}

async function rowsOf(page, asset, settings) {
  const ours = new Map(); // by faces
  const rows = [];
  for (const share of settings.shares) {
    for (const mode of settings.modes) {
      const theirs = await scoreGltfpack(page, asset, share, mode, settings);
      if (!theirs.rest) continue; // nothing is left of it
      const target = targetFor(asset, theirs);
      if (!ours.has(target)) ours.set(target, await scoreWhittle(page, asset, target, settings));
      const whittle = ours.get(target);
      const row = {asset: asset.name, stem: asset.stem, share, mode, original: asset.input, triangles: asset.triangles, whittle, gltfpack: theirs,
        met: Math.abs(whittle.triangles.stored / target - 1) <= tolerance};
      rows.push(row);
      console.log(tableLine(row));
    }
  }
  return rows;
}

/** \return what `prepare` does, its triangles, and whether it can be posed */
async function openAsset(page, file, settings) {
  const asset = prepare(file, settings);
  const canPose = await page.ask('setOriginal', urlOf(asset.input), `/cache/${asset.key}/`);
  return {...asset, canPose, triangles: countTriangles(asset.input)};
}

async function compareAsset(page, file, settings) {
  return rowsOf(page, await openAsset(page, file, settings), settings);
}

/** Of the comparison itself: how far the original is from itself, from a copy, and from 99 % of its faces. */
async function checkAsset(page, file, settings) {
  const asset = await openAsset(page, file, settings);
  const copy = path.join(settings.results, `${asset.name}-copy.glb`);
  convert(settings.whittle, asset.input, copy);
  const nearly = path.join(settings.results, `${asset.name}-nearly.glb`);
  simplify(settings.whittle, asset.input, nearly, Math.floor(0.99 * asset.triangles.stored), settings.whittleOptions);
  for (const [name, result] of Object.entries({itself: asset.input, 'a copy': copy, '99 %': nearly})) {
    const {rest, posed} = await scores(page, result, asset.canPose);
    const told = ({squaredError, normalsDeg}) => `${psnr({squaredError}).toFixed(2)} dB, normals ${normalsDeg.toFixed(3)}°`;
    console.log(`${asset.name}, ${name}: ${told(rest)}${posed ? `; posed ${told(posed)}` : ''}`);
  }
  return [];
}

/** The view in which Whittle's picture is worst. */
function columnOf({stem, original, whittle, gltfpack: theirs}) {
  const errors = whittle.rest.squaredErrorOfViews;
  const cell = (name, {file, triangles, rest}) =>
    ({url: urlOf(file), label: `${name}: ${triangles.stored} faces, ${psnr(rest).toFixed(1)} dB`});
  return {view: errors.indexOf(Math.max(...errors)),
    cells: [{url: urlOf(original), label: stem}, cell('Whittle', whittle), cell('gltfpack', theirs)]};
}

/** Up to twelve assets, at 10 % if that is a share, beside gltfpack's first mode. */
async function writeSheet(page, rows, settings) {
  const share = settings.shares.includes(0.1) ? 0.1 : settings.shares[0];
  const chosen = rows.filter((row) => row.share === share && row.mode === settings.modes[0]).slice(0, 12);
  if (chosen.length === 0) return;
  const url = await page.ask('sheet', chosen.map(columnOf));
  fs.writeFileSync(settings.sheet, Buffer.from(url.split(',')[1], 'base64'));
}

async function main() {
  const settings = settingsOf(process.argv.slice(2));
  const unknown = settings.modes.find((mode) => !(mode in modes));
  if (unknown !== undefined || settings.assets.length === 0) throw new Error(unknown ? `no mode: ${unknown}` : 'no assets');
  fs.mkdirSync(settings.results, {recursive: true});
  if (!settings.check) console.log(header());
  const rows = [];
  const failed = [];
  for (const file of settings.assets) {
    const page = await openPage(settings); // anew, as memory of an asset stays
    try {
      rows.push(...await (settings.check ? checkAsset : compareAsset)(page, file, settings));
    } catch (error) {
      console.error(`${nameOf(file)}: ${error.message.trim()}`);
      failed.push(file);
    }
    await page.close();
    if (settings.json) fs.writeFileSync(settings.json, JSON.stringify({rows, summaries: summaries(rows), failed}, null, 1));
  }
  for (const summary of summaries(rows)) console.log(summaryLine(summary));
  if (settings.sheet && rows.length) {
    const page = await openPage(settings);
    await writeSheet(page, rows, settings);
    await page.close();
  }
  process.exitCode = failed.length ? 1 : 0;
}

main().catch((error) => {
  console.error(error.message);
  process.exit(1);
});
