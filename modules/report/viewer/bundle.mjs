// What puts pages together: scripts and styles within them, and a content security policy that runs only these.
import {createHash} from 'node:crypto';
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';
import {deflateSync} from 'node:zlib';

const viewer = dirname(fileURLToPath(import.meta.url));

/** \param folder has node_modules with what package.json names
    \return a function that makes one text of a script or style and of all that it imports */
export function bundler(folder) {
  const modules = resolve(folder, 'node_modules');
  const esbuild = createRequire(join(modules, 'x.js'))('esbuild');
  return async (file) => {
    const result = await esbuild.build({
      entryPoints: [file],
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
  };
}

/** What a content security policy allows to run. */
export const hash = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

/** Compressed, as the scripts of pages unpack it. */
export const packed = (contents) => deflateSync(contents, {level: 9}).toString('base64');

/** Replaces {{words}} of a page; others stay. */
export const filled = (page, contents) => page.replace(/\{\{(\w+)\}\}/g, (word, name) => contents[name] ?? word);

/** The picture and its controls, which pages share. */
export const controls = () => readFileSync(join(viewer, 'viewer.html'), 'utf8');
