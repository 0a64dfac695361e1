// Saves a level of the recording as a file.

const utf8 = new TextEncoder();

/** A binary PLY file. \param toModel gives coordinates of a point in 0 … 1 */
export function plyOf({corners, nFaces, shownPositions}, toModel) {
  const number = new Map(); // of the vertices that faces use, in the file
  for (let i = 0; i < 3 * nFaces; ++i) if (!number.has(corners[i])) number.set(corners[i], number.size);
  const header = utf8.encode(`ply\nformat binary_little_endian 1.0\nelement vertex ${number.size}
property double x\nproperty double y\nproperty double z\nelement face ${nFaces}\nproperty list uchar uint vertex_indices\nend_header\n`);
  const bytes = new Uint8Array(header.length + 24 * number.size + 13 * nFaces);
  bytes.set(header);
  const view = new DataView(bytes.buffer);
  let at = header.length;
  for (const v of number.keys()) {
    for (const coordinate of toModel(shownPositions.subarray(3 * v, 3 * v + 3))) {
      view.setFloat64(at, coordinate, true);
      at += 8;
    }
  }
  for (let i = 0; i < 3 * nFaces; i += 3) {
    view.setUint8(at++, 3);
    for (let k = 0; k < 3; ++k, at += 4) view.setUint32(at, number.get(corners[i + k]), true);
  }
  return new Blob([bytes], {type: 'model/ply'});
}

/** Lets the browser save something. */
export function saveAs(name, blob) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}
