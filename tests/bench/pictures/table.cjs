// The table of compare_gltf.cjs, and what it comes to.
'use strict';

/** In dB; the greatest square is 255². */
const psnr = ({squaredError}) => squaredError === 0 ? Infinity : 10 * Math.log10(255 ** 2 / squaredError);

/** Of equal infinities, too. */
const gain = (ours, theirs) => ours === theirs ? 0 : ours - theirs;

const gainOf = ({whittle, gltfpack}, which = 'rest') => gain(psnr(whittle[which]), psnr(gltfpack[which]));

function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted.length ? (sorted[Math.floor((sorted.length - 1) / 2)] + sorted[Math.floor(sorted.length / 2)]) / 2 : NaN;
}

const decibels = (value) => Number.isFinite(value) ? value.toFixed(2) : '∞';

const columns = ['asset', 'share', 'mode', 'faces', 'Whittle', 'gltfpack', 'gain', 'normals', 'normals gp', 'posed', 'posed gp'];

function cellsOf(row) {
  const {whittle, gltfpack} = row;
  const pair = (which) => whittle[which] ? [whittle, gltfpack].map((side) => decibels(psnr(side[which]))) : ['', ''];
  return [row.asset, `${100 * row.share} %`, row.mode, whittle.triangles.stored, ...pair('rest'), decibels(gainOf(row)),
    ...[whittle, gltfpack].map(({rest}) => rest.normalsDeg.toFixed(2)), ...pair('posed')];
}

const lineOf = (cells) => cells.map((text, i) => i ? String(text).padStart(10) : String(text).padEnd(34)).join(' ');

const header = () => lineOf(columns);

const tableLine = (row) => lineOf(cellsOf(row));

function summaryOf(rows) {
  const gains = rows.map((row) => gainOf(row));
  const posed = rows.filter(({whittle}) => whittle.posed);
  const normals = (side) => median(rows.map((row) => row[side].rest.normalsDeg));
  return {n: rows.length, medianGain: median(gains), nBetter: gains.filter((value) => value > 0).length,
    worst: Math.min(...gains), worstAsset: rows[gains.indexOf(Math.min(...gains))].asset,
    medianNormalsDeg: normals('whittle'), medianNormalsDegGltfpack: normals('gltfpack'),
    nBetterNormals: rows.filter(({whittle, gltfpack}) => whittle.rest.normalsDeg < gltfpack.rest.normalsDeg).length,
    nMet: rows.filter(({met}) => met).length,
    nPosed: posed.length, medianGainPosed: posed.length ? median(posed.map((row) => gainOf(row, 'posed'))) : null};
}

/** One for each share and mode. */
function summaries(rows) {
  const groups = groupsOf(rows);
  return [...groups.values()].map((group) => ({share: group[0].share, mode: group[0].mode, ...summaryOf(group)}));
}

function groupsOf(rows) {
  const groups = new Map();
  for (const row of rows) {
    const key = `${row.share} ${row.mode}`;
    groups.set(key, [...groups.get(key) ?? [], row]);
  }
  return groups;
}

function summaryLine(s) {
  const posed = s.nPosed ? `, posed ${s.medianGainPosed.toFixed(2)} dB (${s.nPosed})` : '';
  return `${100 * s.share} % against ${s.mode}: median ${s.medianGain.toFixed(2)} dB, better in ${s.nBetter} of ${s.n}, ` +
    `worst ${s.worst.toFixed(2)} dB (${s.worstAsset}); normals ${s.medianNormalsDeg.toFixed(2)}° and ` +
    `${s.medianNormalsDegGltfpack.toFixed(2)}°, better in ${s.nBetterNormals}; targets met within 2 %: ${s.nMet}${posed}`;
}

module.exports = {header, psnr, summaries, summaryLine, tableLine};
