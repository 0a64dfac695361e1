// What the tests share: the package as it was built, meshes, and random numbers that are the same everywhere.
import {existsSync} from 'node:fs';
import path from 'node:path';
import {pathToFileURL} from 'node:url';

export const folder = process.env.WHITTLE_WEB_PACKAGE;
export const npm = process.env.WHITTLE_NPM_MODULES;
export const whittle = await import(pathToFileURL(path.join(folder, 'index.js')));
await whittle.ready;

/** False, or why a test of something from npm is skipped. */
export const without = (name) => !existsSync(path.join(npm, name)) && `npm's ${name} is not in ${npm}`;
export const fromNpm = (file) => import(pathToFileURL(path.join(npm, file)));

/** Numbers in [0, 1). */
export function random(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** A height field of n × n squares, with texture coordinates. */
export function terrain(n, height = (x, y) => 0.2 * Math.sin(7 * x) * Math.cos(5 * y)) {
  const positions = new Float32Array(3 * (n + 1) ** 2);
  const texcoords = new Float32Array(2 * (n + 1) ** 2);
  for (let j = 0, v = 0; j <= n; ++j) {
    for (let i = 0; i <= n; ++i, ++v) {
      positions.set([i / n, j / n, height(i / n, j / n)], 3 * v);
      texcoords.set([i / n, j / n], 2 * v);
    }
  }
  const indices = [];
  for (let j = 0; j < n; ++j) {
    for (let i = 0; i < n; ++i) {
      const a = j * (n + 1) + i;
      indices.push(a, a + 1, a + n + 2, a, a + n + 2, a + n + 1);
    }
  }
  return {positions, texcoords, indices: Uint32Array.from(indices)};
}

/** A mesh of random size and kind: rough terrain, terrain with holes, or faces anyhow. */
export function randomMesh(seed) {
  const next = random(seed);
  const mesh = terrain(2 + Math.floor(10 * next()), () => 0.1 * next());
  const kind = Math.floor(3 * next());
  if (kind === 1) mesh.indices = mesh.indices.filter((_, i) => Math.floor(i / 3) % 7 !== 3);
  if (kind === 2)
    mesh.indices = mesh.indices.map((v) => (next() < 0.05 ? Math.floor((next() * mesh.positions.length) / 3) : v));
  return mesh;
}
