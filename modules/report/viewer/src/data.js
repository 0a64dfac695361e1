// What the page holds: JSON, and arrays that meshoptimizer has compressed.
import {MeshoptDecoder} from 'meshoptimizer';

function bytesOfText(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

async function inflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Reads the page. `array(section, Type)` gives one of its arrays. */
export async function readPage(document) {
  const json = JSON.parse(document.getElementById('whittle-data').textContent);
  const bytes = await inflated(bytesOfText(document.getElementById('whittle-bytes').textContent));
  await MeshoptDecoder.ready;
  const array = (section, Type) => {
    const {at, bytes: length, count, size, codec} = section;
    const decoded = new Uint8Array(count * size);
    const source = bytes.subarray(at, at + length);
    if (count > 0 && codec === 'faces') MeshoptDecoder.decodeIndexBuffer(decoded, count, size, source);
    if (codec === 'none') decoded.set(source);
    if (count > 0 && codec === 'vertices') MeshoptDecoder.decodeVertexBuffer(decoded, count, size, source);
    return new Type(decoded.buffer);
  };
  return {json, array};
}
