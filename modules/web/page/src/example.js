// A mesh for those who have none at hand: a torus knot with bumps.

const [nAlong, nAround] = [500, 50]; // quads, each cut into two faces
const [p, q] = [2, 3]; // turns around the axis, and around the ring

const middleAt = (t) => {
  const r = 2 + Math.cos(q * t);
  return [r * Math.cos(p * t), r * Math.sin(p * t), -Math.sin(q * t)];
};

const minus = (a, b) => a.map((x, d) => x - b[d]);
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
const unit = (a) => a.map((x) => x / Math.hypot(...a));

function writeRing(i, lines) {
  const t = 2 * Math.PI * i / nAlong;
  const middle = middleAt(t);
  const along = unit(minus(middleAt(t + 0.01), middle));
  const aside = unit(cross(along, [0, 0, 1]));
  const up = cross(aside, along);
  for (let j = 0; j < nAround; ++j) {
    const s = 2 * Math.PI * j / nAround;
    const radius = 0.45 + 0.035 * Math.sin(48 * t) * Math.cos(5 * s);
    const point = middle.map((x, d) => x + radius * (Math.cos(s) * aside[d] + Math.sin(s) * up[d]));
    lines.push(`v ${point.map((x) => x.toFixed(5)).join(' ')}`);
  }
}

const vertex = (i, j) => 1 + i % nAlong * nAround + j % nAround;

/** Writes an OBJ file. \param lines that are added to; yields after each part of the work */
export function* writeExample(lines) {
  for (let i = 0; i < nAlong; ++i) {
    writeRing(i, lines);
    yield;
  }
  for (let i = 0; i < nAlong; ++i) {
    for (let j = 0; j < nAround; ++j) {
      const [a, b, c, d] = [vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1), vertex(i + 1, j)];
      lines.push(`f ${a} ${c} ${b}`, `f ${a} ${d} ${c}`);
    }
    yield;
  }
}
