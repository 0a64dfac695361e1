// validate.cjs NODE_MODULES FILE...: prints what Khronos' validator finds wrong with glTF files. Fails if there is an
// error or a warning, or if a file named geomorph_* has no morph target.
'use strict';
const fs = require('fs');
const path = require('path');

const [nodeModules, ...files] = process.argv.slice(2);
const validator = require(path.join(path.resolve(nodeModules), 'gltf-validator'));

async function isValid(file) {
  const readBeside = async (uri) => new Uint8Array(fs.readFileSync(path.join(path.dirname(file), decodeURIComponent(uri))));
  const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {uri: path.basename(file), externalResourceFunction: readBeside});
  const problems = report.issues.messages.filter((message) => message.severity <= 1);
  for (const {code, message, pointer} of problems) console.log(`${file}: ${code} at ${pointer}: ${message}`);
  console.log(`${file}: ${problems.length} errors and warnings, ${report.info.totalTriangleCount} faces, ` +
              `${report.info.hasMorphTargets ? 'morph targets' : 'no morph target'}`);
  return problems.length === 0 && (report.info.hasMorphTargets || !path.basename(file).startsWith('geomorph_'));
}

async function main() {
  if (files.length === 0) throw new Error('no file to validate');
  const results = [];
  for (const file of files) results.push(await isValid(file));
  process.exitCode = results.every(Boolean) ? 0 : 1;
}

main().catch((error) => {
  console.error(error);
  process.exitCode = 1;
});
