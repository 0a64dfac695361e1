// Each line of JavaScript on the pages runs, in order.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync, rmSync, writeFileSync} from 'node:fs';
import path from 'node:path';
import {test} from 'node:test';
import {folder, without} from './package.mjs';

const skip = without('three') || without('meshoptimizer');

for (const page of ['docs/user/web.md', 'docs/user/from-meshoptimizer-js.md']) {
  test(page, {skip}, () => {
    const text = readFileSync(path.join(process.env.WHITTLE_SOURCE, page), 'utf8');
    const blocks = [...text.matchAll(/^```js\n(.*?)^```$/gms)].map((match) => match[1]);
    assert.ok(blocks.length > 3);
    // Beside node_modules, where imports are looked for.
    const script = path.join(folder, '..', path.basename(page, '.md') + '.mjs');
    writeFileSync(script, "import assert from 'node:assert/strict';\n" + blocks.join('\n') + "console.log('done');\n");
    assert.match(execFileSync(process.execPath, [script], {encoding: 'utf8'}), /done\n$/);
    rmSync(script);
  });
}
