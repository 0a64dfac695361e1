// textured_files.cjs FOLDER: writes squares (0 … 1)² in the plane z = 0 with the texture of `quarters`: as glTF, OBJ and
// PLY. Required by another script, it has what these show.
'use strict';
const fs = require('fs');
const path = require('path');
const zlib = require('zlib');

/** sRGB; left and right above, left and right below. */
const quarters = [[255, 0, 0], [0, 128, 0], [0, 0, 255], [200, 180, 40]];
/** Linear. */
const factor = [1, 0.5, 0.25];
/** By which the texture coordinates of shifted.gltf are off. */
const shift = 0.125;
const vertexColour = [30, 140, 220];
const imageSize = 64;
const few = 8; // faces along a side, times 2
const many = 130; // for a page to draw fewer of them while it moves

function png(width, height, colourAt) {
  const chunk = (type, data) => {
    const body = Buffer.concat([Buffer.from(type), data]);
    const [length, check] = [Buffer.alloc(4), Buffer.alloc(4)];
    length.writeUInt32BE(data.length);
    check.writeUInt32BE(crc(body));
    return Buffer.concat([length, body, check]);
  };
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 2], 8); // bits, and three colours
  const rows = Buffer.alloc(height * (1 + 3 * width));
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) rows.set(colourAt(x, y), y * (1 + 3 * width) + 1 + 3 * x);
  }
  const signature = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
  return Buffer.concat([signature, chunk('IHDR', header), chunk('IDAT', zlib.deflateSync(rows)), chunk('IEND', Buffer.alloc(0))]);
}

function crc(bytes) {
  let value = 0xffffffff;
  for (const byte of bytes) {
    value ^= byte;
    for (let k = 0; k < 8; ++k) value = value & 1 ? value >>> 1 ^ 0xedb88320 : value >>> 1;
  }
  return (value ^ 0xffffffff) >>> 0;
}

const image = () => png(imageSize, imageSize, (x, y) => quarters[(x < imageSize / 2 ? 0 : 1) + (y < imageSize / 2 ? 0 : 2)]);

function square(n) {
  const vertices = [];
  const faces = [];
  for (let j = 0; j <= n; ++j) for (let i = 0; i <= n; ++i) vertices.push([i / n, j / n]);
  for (let j = 0; j < n; ++j) {
    for (let i = 0; i < n; ++i) {
      const v = j * (n + 1) + i;
      faces.push([v, v + 1, v + n + 2], [v, v + n + 2, v + n + 1]);
    }
  }
  return {vertices, faces};
}

/** The node doubles its size and moves it: the page has it where the scene has it. */
function gltf(off) {
  const {vertices, faces} = square(few);
  const floats = (numbers) => Buffer.from(new Float32Array(numbers).buffer);
  const parts = [floats(vertices.flatMap(([x, y]) => [x, y, 0])), floats(vertices.flatMap(() => [0, 0, 1])),
    floats(vertices.flatMap(([x, y]) => [x + off, 1 - y])), Buffer.from(new Uint16Array(faces.flat()).buffer)];
  let offset = 0;
  const views = parts.map(({length}) => ({buffer: 0, byteOffset: (offset += length) - length, byteLength: length}));
  const uri = (type, bytes) => `data:${type};base64,${bytes.toString('base64')}`;
  const ofVertices = (bufferView, type) => ({bufferView, type, componentType: 5126, count: vertices.length});
  return JSON.stringify({
    asset: {version: '2.0'}, scene: 0, scenes: [{nodes: [0]}], nodes: [{mesh: 0, scale: [2, 2, 2], translation: [5, 6, 7]}],
    meshes: [{primitives: [{attributes: {POSITION: 0, NORMAL: 1, TEXCOORD_0: 2}, indices: 3, material: 0}]}],
    materials: [{pbrMetallicRoughness: {baseColorFactor: [...factor, 1], baseColorTexture: {index: 0}}}],
    textures: [{source: 0}], images: [{uri: uri('image/png', image())}],
    accessors: [{...ofVertices(0, 'VEC3'), min: [0, 0, 0], max: [1, 1, 0]}, ofVertices(1, 'VEC3'), ofVertices(2, 'VEC2'),
      {bufferView: 3, type: 'SCALAR', componentType: 5123, count: 3 * faces.length}],
    bufferViews: views, buffers: [{byteLength: offset, uri: uri('application/octet-stream', Buffer.concat(parts))}],
  });
}

/** Texture coordinates count from below. */
function obj(library, n = few) {
  const {vertices, faces} = square(n);
  return [`mtllib ${library}`, ...vertices.map(([x, y]) => `v ${x} ${y} 0`), ...vertices.map(([x, y]) => `vt ${x} ${y}`), 'usemtl quarters',
    ...faces.map((face) => `f ${face.map((v) => `${v + 1}/${v + 1}`).join(' ')}`), ''].join('\n');
}

function ply() {
  const {vertices, faces} = square(few);
  return ['ply', 'format ascii 1.0', `element vertex ${vertices.length}`, ...['x', 'y', 'z'].map((c) => `property float ${c}`),
    ...['red', 'green', 'blue'].map((c) => `property uchar ${c}`), `element face ${faces.length}`,
    'property list uchar int vertex_indices', 'end_header', ...vertices.map(([x, y]) => `${x} ${y} 0 ${vertexColour.join(' ')}`),
    ...faces.map((face) => `3 ${face.join(' ')}`), ''].join('\n');
}

module.exports = {quarters, factor, shift, vertexColour};

if (require.main === module) {
  const write = (name, content) => fs.writeFileSync(path.join(process.argv[2], name), content);
  write('square.gltf', gltf(0));
  write('shifted.gltf', gltf(shift));
  write('quarters.png', image());
  write('square.mtl', 'newmtl quarters\nmap_Kd quarters.png\n');
  write('square.obj', obj('square.mtl'));
  write('fine.obj', obj('square.mtl', many));
  write('broken.png', 'no image');
  write('broken.mtl', 'newmtl quarters\nmap_Kd broken.png\n');
  write('broken.obj', obj('broken.mtl'));
  write('coloured.ply', ply());
}
