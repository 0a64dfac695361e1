// What a surface carries besides its shape: texture coordinates, normals, colours and materials, and how far they are off.
import {
  BufferAttribute, BufferGeometry, ClampToEdgeWrapping, Color, DoubleSide, GLSL3, InterleavedBuffer, InterleavedBufferAttribute,
  LinearMipmapLinearFilter, Matrix3, MirroredRepeatWrapping, RepeatWrapping, SRGBColorSpace, ShaderMaterial, Texture,
} from 'three';
import {shareOfMax} from './distances.js';
import {lookShader, lookVertexShader} from './shaders.js';

/** Kinds of attributes of which deviations are shown: their name, what the legend says, and what a click says. */
const kinds = {
  texcoord: {label: 'texture coordinates', title: 'texture coordinates off by, 1 is the whole texture', value: 'texture coordinates off by'},
  colour: {label: 'vertex colours', title: 'length of the difference of red, green, blue and opacity', value: 'colour off by'},
  normal: {label: 'normals', title: 'angle between normals, degrees', value: 'degrees between normals'},
};

/** Deviations of an attribute. The colouring is named after the kind; of several, further ones have a number. */
function deviationsOf(map, i, all, array) {
  const n = all.slice(0, i).filter(({kind}) => kind === map.kind).length;
  const {label, title, value} = kinds[map.kind];
  return {...map, title, value, colour: map.kind + (n > 0 ? n + 1 : ''), label: `error of ${label}${n > 0 ? ` (${map.name})` : ''}`,
    values: array(map.values, Uint8Array)};
}

/** The decoded images of the page. */
export function loadImages(images, array) {
  return Promise.all(images.map(({type, bytes}) => createImageBitmap(new Blob([array(bytes, Uint8Array)], {type}),
    {colorSpaceConversion: 'none', premultiplyAlpha: 'none'}).catch(() => null))); // null: it isn't what it says
}

/** A vertex for each wedge; the first ones are the vertices of the surface. */
export class Look {
  /** \param wedges the wedge of each corner */
  constructor(json, array, wedges, images) {
    this.nWedges = json.count;
    this.wedges = wedges;
    this.further = array(json.wedges, Uint32Array); // the vertices of the wedges above these
    this.nVertices = this.nWedges - this.further.length;
    this.texcoords = json.texcoords.map(({values}) => Float32Array.from(array(values, Int32Array), (n) => n / 65536));
    this.normals = json.normals && directions(array(json.normals, Int16Array));
    this.colours = json.colours && array(json.colours, Uint8Array);
    this.isLinear = json.linear; // whether colours are to be interpolated as light
    this.materials = json.materials;
    this.groups = json.groups && array(json.groups, Uint16Array); // the number of each face's material
    this.coarseGroups = json.coarse_groups && array(json.coarse_groups, Uint16Array);
    this.images = images;
    this.maps = json.maps.map((map, i, all) => deviationsOf(map, i, all, array));
  }

  vertexOf(wedge) {
    return wedge < this.nVertices ? wedge : this.further[wedge - this.nVertices];
  }

  verticesOf(wedges) {
    return this.further.length === 0 ? wedges : wedges.map((wedge) => this.vertexOf(wedge));
  }

  /** Whether there is something to see in a colouring. */
  has(colour) {
    if (colour === 'material') return this.materials.length > 0;
    if (colour === 'colours') return this.colours !== null;
    if (colour === 'normals') return this.normals !== null;
    return this.mapOf(colour) !== undefined;
  }

  mapOf(colour) {
    return this.maps.find((map) => map.colour === colour);
  }

  /** The deviation of each wedge, as a share of the map's greatest one. */
  shares(map) {
    map.shares ??= Float32Array.from(map.values.subarray(0, this.nWedges), (byte) => shareOfMax(byte, map));
    return map.shares;
  }

  /** All faces, those of a material one after the other. \param positions packed, four numbers a vertex */
  geometry(positions) {
    const gathered = new Uint16Array(4 * this.nWedges);
    gathered.set(positions);
    for (let w = this.nVertices; w < this.nWedges; ++w) {
      const v = 4 * this.vertexOf(w);
      gathered.set(positions.subarray(v, v + 4), 4 * w);
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new InterleavedBufferAttribute(new InterleavedBuffer(gathered, 4), 3, 0, true));
    this.texcoords.forEach((values, i) => geometry.setAttribute(`texcoord${i}`, new BufferAttribute(values, 2)));
    if (this.colours) geometry.setAttribute('tint', new BufferAttribute(this.colours, 4, true));
    useFaces(geometry, facesByMaterial(this.wedges, this.groups));
    return geometry;
  }

  /** Fewer faces. \param wedges of their corners */
  coarseFaces(wedges) {
    return facesByMaterial(wedges, this.coarseGroups);
  }

  /** For the groups of the geometry; made when they are first asked for. */
  surfaceMaterials() {
    this.drawn ??= this.materials.map((material) => this.surfaceMaterial(material));
    return this.drawn;
  }

  surfaceMaterial({colour, image, texcoords, transform: [a, b, c, d, e, f], wrap, alpha, cutoff}) {
    const bitmap = image === null ? null : this.images[image];
    return lookMaterial({
      image: bitmap && textureOf(bitmap, wrap), texcoord: `texcoord${texcoords ?? 0}`, alpha, cutoff,
      factor: colour, transform: new Matrix3().set(a, b, c, d, e, f, 0, 0, 1), isTinted: this.colours !== null,
      isLinear: this.isLinear,
    });
  }

  /** Vertex colours alone. */
  colourMaterial() {
    this.tinted ??= lookMaterial({isTinted: true, isLinear: this.isLinear});
    return this.tinted;
  }
}

/** Faces, those of a material one after the other. \param groups the number of each face's material, or null */
function facesByMaterial(corners, groups) {
  if (!groups) return {index: new BufferAttribute(corners, 1), groups: []};
  const nFaces = corners.length / 3;
  const order = Uint32Array.from({length: nFaces}, (_, f) => f).sort((a, b) => groups[a] - groups[b] || a - b);
  const index = new Uint32Array(corners.length);
  order.forEach((f, i) => index.set(corners.subarray(3 * f, 3 * f + 3), 3 * i));
  const runs = [];
  for (let first = 0; first < nFaces;) {
    const materialIndex = groups[order[first]];
    let end = first;
    while (end < nFaces && groups[order[end]] === materialIndex) ++end;
    runs.push({start: 3 * first, count: 3 * (end - first), materialIndex});
    first = end;
  }
  return {index: new BufferAttribute(index, 1), groups: runs};
}

/** \param faces {index, groups} */
export function useFaces(geometry, {index, groups}) {
  geometry.setIndex(index);
  geometry.groups = groups;
}

/** Unit vectors of an octahedral map. */
function directions(packed) {
  const unpacked = new Float32Array(packed.length / 2 * 3);
  for (let i = 0, j = 0; i < packed.length; i += 2, j += 3) {
    let x = packed[i] / 32767;
    let y = packed[i + 1] / 32767;
    const z = 1 - Math.abs(x) - Math.abs(y);
    if (z < 0) [x, y] = [(1 - Math.abs(y)) * (x < 0 ? -1 : 1), (1 - Math.abs(x)) * (y < 0 ? -1 : 1)];
    const length = Math.hypot(x, y, z);
    unpacked.set([x / length, y / length, z / length], j);
  }
  return unpacked;
}

const wraps = {repeat: RepeatWrapping, mirror: MirroredRepeatWrapping, clamp: ClampToEdgeWrapping};
const textures = new WeakMap(); // by image, then how it is wrapped

function textureOf(bitmap, wrap) {
  if (!textures.has(bitmap)) textures.set(bitmap, new Map());
  const ofImage = textures.get(bitmap);
  if (!ofImage.has(wrap.join())) {
    const texture = new Texture(bitmap);
    texture.colorSpace = SRGBColorSpace; // blended in linear light
    [texture.wrapS, texture.wrapT] = wrap.map((word) => wraps[word]);
    texture.minFilter = LinearMipmapLinearFilter;
    texture.flipY = false;
    texture.needsUpdate = true;
    ofImage.set(wrap.join(), texture);
  }
  return ofImage.get(wrap.join());
}

function lookMaterial({image = null, texcoord = 'texcoord0', factor = [1, 1, 1, 1], transform = new Matrix3(), isTinted, isLinear, alpha = 'opaque', cutoff = 0}) {
  return new ShaderMaterial({
    glslVersion: GLSL3, vertexShader: lookVertexShader, fragmentShader: lookShader, side: DoubleSide, defines: {TEXCOORD: texcoord},
    transparent: alpha === 'blend', depthWrite: alpha !== 'blend', polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
    uniforms: {
      isSmooth: {value: false}, hasImage: {value: image !== null}, image: {value: image}, isTinted: {value: isTinted}, isLinear: {value: isLinear},
      factor: {value: new Color(...factor)}, opacity: {value: factor[3]}, transform: {value: transform},
      cutoff: {value: alpha === 'mask' ? cutoff : 0}, isOpaque: {value: alpha !== 'blend'},
    },
  });
}
