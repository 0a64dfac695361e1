// The distance of a point to a mesh, and where a ray meets it, by a look at every face, or at the box around it or the side
// of the ray that it is on. Sources: Ericson: Real-Time Collision Detection (2005), section 5.1.5; Möller and Trumbore: Fast,
// Minimum Storage Ray/Triangle Intersection (1997).
'use strict';

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const along = (a, direction, t) => [a[0] + t * direction[0], a[1] + t * direction[1], a[2] + t * direction[2]];

function closestOnSegment(p, a, b) {
  const ab = minus(b, a);
  const length = dot(ab, ab);
  return length > 0 ? along(a, ab, Math.min(1, Math.max(0, dot(minus(p, a), ab) / length))) : a;
}

const nearer = (p, a, b) => dot(minus(a, p), minus(a, p)) < dot(minus(b, p), minus(b, p)) ? a : b;

const closestOnSides = (p, a, b, c) =>
  nearer(p, closestOnSegment(p, a, b), nearer(p, closestOnSegment(p, b, c), closestOnSegment(p, c, a)));

function closestOnFace(p, a, b, c) {
  const ab = minus(b, a);
  const ac = minus(c, a);
  const normal = cross(ab, ac);
  if (dot(normal, normal) === 0) return closestOnSides(p, a, b, c);
  const ap = minus(p, a);
  const [d1, d2] = [dot(ab, ap), dot(ac, ap)];
  if (d1 <= 0 && d2 <= 0) return a;
  const bp = minus(p, b);
  const [d3, d4] = [dot(ab, bp), dot(ac, bp)];
  if (d3 >= 0 && d4 <= d3) return b;
  const vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return along(a, ab, d1 / (d1 - d3));
  const cp = minus(p, c);
  const [d5, d6] = [dot(ab, cp), dot(ac, cp)];
  if (d6 >= 0 && d5 <= d6) return c;
  const vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return along(a, ac, d2 / (d2 - d6));
  const va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return along(b, minus(c, b), (d4 - d3) / (d4 - d3 + d5 - d6));
  const sum = va + vb + vc;
  return along(along(a, ab, vb / sum), ac, vc / sum);
}

/** Not above the square of the distance to a face: that to the box around it. */
function squareToBox(p, a, b, c) {
  let sum = 0;
  for (let d = 0; d < 3; ++d) {
    const off = Math.max(0, Math.min(a[d], b[d], c[d]) - p[d], p[d] - Math.max(a[d], b[d], c[d]));
    sum += off * off;
  }
  return sum;
}

/** \param mesh {positions: [x, y, z] each, corners: three numbers a face} */
function exactDistance(p, {positions, corners}) {
  let least = Infinity;
  for (let i = 0; i < corners.length; i += 3) {
    const [a, b, c] = [positions[corners[i]], positions[corners[i + 1]], positions[corners[i + 2]]];
    if (squareToBox(p, a, b, c) > least) continue;
    const difference = minus(p, closestOnFace(p, a, b, c));
    least = Math.min(least, dot(difference, difference));
  }
  return Math.sqrt(least);
}

/** How many times its direction a ray goes until it meets a face; Infinity if it misses. */
function meetsFace(origin, direction, a, b, c) {
  const ab = minus(b, a);
  const ac = minus(c, a);
  const p = cross(direction, ac);
  const determinant = dot(ab, p);
  if (determinant === 0) return Infinity;
  const ao = minus(origin, a);
  const u = dot(ao, p) / determinant;
  const q = cross(ao, ab);
  const v = dot(direction, q) / determinant;
  const t = dot(ac, q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : Infinity;
}

const unit = (a) => along([0, 0, 0], a, 1 / Math.sqrt(dot(a, a)));

/** How far each point is on one side of two planes that meet in a ray. */
function sidesOf(positions, origin, direction) {
  const sizes = direction.map(Math.abs);
  const axis = [0, 0, 0];
  axis[sizes.indexOf(Math.min(...sizes))] = 1;
  const first = unit(cross(direction, axis));
  return [first, unit(cross(direction, first))].map((normal) => Float64Array.from(positions, (p) => dot(p, normal) - dot(origin, normal)));
}

/** The first point of a mesh on a ray, or null. */
function firstPoint(origin, direction, {positions, corners}) {
  const planes = sidesOf(positions, origin, direction);
  const rounding = 1e-6; // of sides, in the unit of the grid
  let least = Infinity;
  for (let i = 0; i < corners.length; i += 3) {
    const [a, b, c] = [corners[i], corners[i + 1], corners[i + 2]];
    const isAside = (sides) => Math.min(sides[a], sides[b], sides[c]) > rounding || Math.max(sides[a], sides[b], sides[c]) < -rounding;
    if (isAside(planes[0]) || isAside(planes[1])) continue;
    least = Math.min(least, meetsFace(origin, direction, positions[a], positions[b], positions[c]));
  }
  return least < Infinity ? along(origin, direction, least) : null;
}

module.exports = {exactDistance, firstPoint};
