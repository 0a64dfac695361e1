// new_errors.cjs NODE_MODULES LIST: validates pairs of glTF files, an input and what was made of it, one pair a line with
// a tab between. Prints the errors, by kind, of which an output has more than its input. Fails if there is one.
'use strict';
const fs = require('fs');
const path = require('path');

const [nodeModules, list] = process.argv.slice(2);
const validator = require(path.join(path.resolve(nodeModules), 'gltf-validator'));

// The number of errors of each kind, and an example of each.
async function errorsOf(file) {
  const readBeside = (uri) => fs.promises.readFile(path.join(path.dirname(file), decodeURIComponent(uri)));
  const options = {
    uri: path.basename(file),
    maxIssues: 0,
    externalResourceFunction: async (uri) => new Uint8Array(await readBeside(uri)),
  };
  const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), options);
  const errors = new Map();
  for (const {code, message, pointer, severity} of report.issues.messages) {
    if (severity !== 0) continue;
    const known = errors.get(code) ?? {count: 0, example: `${pointer}: ${message}`};
    errors.set(code, {...known, count: known.count + 1});
  }
  return errors;
}

async function main() {
  const pairs = fs.readFileSync(list, 'utf8').split('\n').filter(Boolean).map((line) => line.split('\t'));
  if (pairs.length === 0) throw new Error('no file to validate');
  for (const [input, output] of pairs) {
    const before = await errorsOf(input);
    for (const [code, {count, example}] of await errorsOf(output)) {
      if (count <= (before.get(code)?.count ?? 0)) continue;
      console.log(`${input}: ${code}, ${count} times: ${example}`);
      process.exitCode = 1;
    }
  }
}

main().catch((error) => {
  console.error(error);
  process.exitCode = 1;
});
