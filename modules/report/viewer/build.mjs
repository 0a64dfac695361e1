// build.mjs FOLDER OUT.cc: puts the viewer together, script and style within the page, and writes it as a C++ string. The
// viewer is compressed; a small script unpacks it.
// FOLDER has node_modules with what package.json names.
import {readFileSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {bundler, controls, filled, hash, packed} from './bundle.mjs';

const [folder, output] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const bundle = bundler(folder);

const viewer = await bundle(join(here, 'src/main.js'));
const script = await bundle(join(here, 'src/loader.js'));
const style = await bundle(join(here, 'style.css'));
const policy = [
  "default-src 'none'",
  `script-src ${hash(script)} ${hash(viewer)} 'wasm-unsafe-eval'`,
  `style-src ${hash(style)}`,
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

const page = filled(readFileSync(join(here, 'page.html'), 'utf8'),
  {policy, viewer: packed(viewer), script, style, controls: controls()});

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
