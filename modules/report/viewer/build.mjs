// build.mjs FOLDER OUT.cc: puts the viewer together, script and style within the page, and writes it as a C++ string. The
// viewer is compressed; a small script unpacks it.
// FOLDER has node_modules with what package.json names.
import {createHash} from 'node:crypto';
import {readFileSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';
import {deflateSync} from 'node:zlib';

const [folder, output] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const modules = resolve(folder, 'node_modules');
const esbuild = createRequire(join(modules, 'x.js'))('esbuild');

async function bundle(file) {
  const result = await esbuild.build({
    entryPoints: [join(here, file)],
    bundle: true,
    minify: true,
    format: 'iife',
    target: 'es2022',
    charset: 'ascii',
    legalComments: 'inline',
    nodePaths: [modules],
    write: false,
  });
  return result.outputFiles[0].text.trim().replaceAll('</script', '<\\/script');
}

/// What a content security policy allows to run.
const hash = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

const viewer = await bundle('src/main.js');
const script = await bundle('src/loader.js');
const style = (await bundle('style.css')).trim();
const policy = [
  "default-src 'none'",
  `script-src ${hash(script)} ${hash(viewer)} 'wasm-unsafe-eval'`,
  `style-src ${hash(style)}`,
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

const contents = {policy, viewer: deflateSync(viewer, {level: 9}).toString('base64'), script, style};
const page = readFileSync(join(here, 'page.html'), 'utf8').replace(/\{\{(policy|viewer|script|style)\}\}/g, (_, word) => contents[word]);

const delimiter = 'whittle_page';
const length = 15000; // some compilers take no longer string literals
const parts = [];
const bytes = Buffer.from(page, 'utf8').toString('latin1');
for (let i = 0; i < bytes.length; i += length) parts.push(bytes.slice(i, i + length));
const literals = parts.map((part) => `R"${delimiter}(${part})${delimiter}"`).join(',\n');
writeFileSync(output, Buffer.from(`#include "page_template.hh"

namespace whittle::report {

std::string page_template() {
  static const char* const parts[] = {
${literals}};
  std::string page;
  for (const char* const part : parts) page += part;
  return page;
}

}  // namespace whittle::report
`, 'latin1'));
