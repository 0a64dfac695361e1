// Runs the programs that are compared.
'use strict';
const fs = require('fs');
const path = require('path');
const {spawnSync} = require('child_process');

/** gltfpack's modes: as near to the share as it goes, and as well as it can. */
const modes = {sa: ['-sa'], svsp: ['-sv', '-sp']};

/** \return seconds and what it said \throw Error with what it said, if it fails */
function runProgram(command, values) {
  const begin = process.hrtime.bigint();
  const {status, error, stderr, stdout} = spawnSync(command, values, {encoding: 'utf8', maxBuffer: 1 << 26});
  if (status !== 0) throw new Error(`${path.basename(command)} ${values.join(' ')}: ${error ?? stderr + stdout}`);
  return {seconds: Number(process.hrtime.bigint() - begin) / 1e9, said: stderr};
}

/** Without quantization, named nodes, materials and animations as they were: what differs is simplified. */
function gltfpack(program, input, output, share, mode) {
  if (fs.existsSync(output)) return;
  const kept = ['-noq', '-kn', '-km', '-af', '0'];
  runProgram('node', [program, '-i', input, '-o', output, ...kept, '-si', String(share), ...modes[mode]]);
}

/** \return seconds and warnings */
function simplify(program, input, output, nFaces, options) {
  const {seconds, said} = runProgram(program, ['simplify', input, '-o', output, '--faces', String(nFaces), ...options]);
  return {seconds, warnings: said.split('\n').filter((text) => text.includes('warning:'))};
}

const convert = (program, input, output) => runProgram(program, ['convert', input, output, '--quiet']);

module.exports = {convert, gltfpack, modes, simplify};
