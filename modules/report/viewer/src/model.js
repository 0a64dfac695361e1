// What is drawn of a mesh: its faces, in one of several colourings, its edges, its vertices, and lines along its borders.
import {
  BufferAttribute, BufferGeometry, Color, ColorManagement, DoubleSide, GLSL3, Group, InterleavedBuffer, InterleavedBufferAttribute, LineBasicMaterial,
  LessDepth, LineSegments, Mesh, Points, PointsMaterial, ShaderMaterial, Vector3,
} from 'three';
import {refusalColours, scales, textureOf, valenceClass} from './colours.js';
import {useFaces} from './look.js';
import {faceShader, lineShader, lineVertexShader, vertexShader} from './shaders.js';
import {edgesOf, radiusRatio, valences} from './surface.js';
import {lineLayer} from './view.js';

ColorManagement.enabled = false; // colours are shown as they are written

function faceMaterial(front, opacity) {
  return new ShaderMaterial({
    glslVersion: GLSL3, vertexShader, fragmentShader: faceShader, side: DoubleSide, transparent: opacity < 1, depthWrite: opacity === 1,
    polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
    uniforms: {
      isSmooth: {value: false}, isScaled: {value: false}, isSigned: {value: false}, top: {value: 1}, opacity: {value: opacity},
      front: {value: new Color(front)}, back: {value: new Color('#8a5a44')}, scale: {value: textureOf(scales.shape)},
      areNormals: {value: false},
    },
  });
}

/** Dark or bright, as is better seen on what is behind. Lines along borders, which have a colour, stay as they are. */
function lineMaterial(behind) {
  return new ShaderMaterial({
    glslVersion: GLSL3, vertexShader: lineVertexShader, fragmentShader: lineShader, transparent: true, depthWrite: false, depthFunc: LessDepth,
    uniforms: {behind},
  });
}

/** Geometry with positions as 16-bit numbers, four a vertex; the fourth one is a signed distance, if anything. */
function packedGeometry(positions, corners) {
  const buffer = new InterleavedBuffer(positions, 4);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new InterleavedBufferAttribute(buffer, 3, 0, true));
  geometry.setAttribute('value', new InterleavedBufferAttribute(buffer, 1, 3, true));
  geometry.setIndex(new BufferAttribute(corners, 1));
  return geometry;
}

export class Model {
  /** \param surface a Surface or a Recording \param behind a uniform: what edges are drawn over */
  constructor(surface, colour, behind) {
    this.surface = surface;
    this.errors = null; // of the vertices of a recording's level, once they are wanted
    this.isMoving = surface.positions instanceof Float32Array;
    this.group = new Group();
    this.position = this.isMoving ? new BufferAttribute(surface.positions.slice(), 3)
      : new InterleavedBufferAttribute(new InterleavedBuffer(surface.positions, 4), 3, 0, true);
    this.material = faceMaterial(colour, 1);
    this.ghostMaterial = faceMaterial(colour, 0.35);
    this.plain = this.plainGeometry();
    this.faces = new Mesh(this.plain, this.material);
    this.pointMaterial = new PointsMaterial({color: colour, size: 2, sizeAttenuation: false});
    this.edges = this.lines(new Uint32Array(0), lineMaterial(behind));
    this.edges.layers.set(lineLayer);
    this.borders = this.lines(surface.borders, new LineBasicMaterial({color: '#d55e00'}));
    this.nonmanifold = this.lines(surface.nonmanifold, new LineBasicMaterial({color: '#cc0066', depthTest: false}));
    this.refusals = surface.refusals.map(({pairs}, i) =>
      this.lines(pairs, new LineBasicMaterial({color: refusalColours[i % refusalColours.length], depthTest: false})));
    this.points = new Points(this.pointGeometry(), this.pointMaterial);
    this.valencePoints = null;
    this.moment = 0; // of the positions: vertices move between two versions of a recording, too
    this.cached = {};
    this.shading = 'flat';
    this.setColour('none');
    this.group.add(this.faces, this.edges, this.borders, this.nonmanifold, this.points, ...this.refusals);
    this.group.traverse((object) => { object.frustumCulled = false; });
  }

  plainGeometry() {
    const {surface} = this;
    if (!this.isMoving) return packedGeometry(surface.positions, surface.corners);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', this.position);
    geometry.setAttribute('value', new BufferAttribute(new Float32Array(surface.nVertices), 1));
    geometry.setIndex(new BufferAttribute(surface.corners, 1));
    geometry.setDrawRange(0, 3 * surface.nFaces);
    return geometry;
  }

  lines(ends, material) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', this.position);
    geometry.setIndex(new BufferAttribute(ends, 1));
    return new LineSegments(geometry, material);
  }

  pointGeometry() {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', this.position);
    const isUsed = new Uint8Array(this.surface.nVertices);
    const {corners, nFaces} = this.surface;
    for (let i = 0; i < 3 * nFaces; ++i) isUsed[corners[i]] = 1;
    const used = new Uint32Array(isUsed.length);
    let n = 0;
    for (let v = 0; v < isUsed.length; ++v) if (isUsed[v]) used[n++] = v;
    geometry.setIndex(new BufferAttribute(used.slice(0, n), 1));
    return geometry;
  }

  /** Whether a colouring shows what wedges have. */
  showsLook(colour) {
    const {look} = this.surface;
    return look !== null && (look.has(colour) || colour === 'none' && this.shading === 'file' && look.normals !== null);
  }

  /** The vertices of the wedges. */
  lookGeometry() {
    this.wedged ??= this.surface.look.geometry(this.surface.positions);
    return this.wedged;
  }

  /** Of the colouring: something with `max` and `usual`, and where its values come from; or null. */
  range() {
    return this.colour === 'error' ? this.surface.distances ?? this.errors : this.surface.look?.mapOf(this.colour) ?? null;
  }

  /** Whether there is something to see in the colouring. */
  hasColour() {
    return ['none', 'valence', 'shape'].includes(this.colour) || this.range() !== null || this.showsLook(this.colour);
  }

  /** The geometry of a colouring, made when it is first asked for. */
  geometryOf(colour) {
    if (this.showsLook(colour)) return this.lookGeometry();
    const isPlain = colour !== 'shape' && !(colour === 'error' && this.surface.distances);
    if (isPlain) return this.plain;
    const key = this.moment;
    const cached = this.cached[colour];
    if (cached && cached.key === key) return cached.geometry;
    cached?.geometry.dispose();
    let geometry;
    if (colour === 'error') {
      this.surface.distances.cut();
      geometry = packedGeometry(this.surface.distances.positions, this.surface.distances.corners);
    } else {
      geometry = this.shapeGeometry();
    }
    this.cached[colour] = {key, geometry};
    return geometry;
  }

  /** Each face has corners of its own. */
  shapeGeometry() {
    const {corners, nFaces} = this.surface;
    const from = this.isMoving ? this.position.array : this.surface.unitPositions();
    const positions = new Float32Array(9 * nFaces);
    const values = new Float32Array(3 * nFaces);
    for (let i = 0; i < 3 * nFaces; ++i) {
      for (let d = 0; d < 3; ++d) positions[3 * i + d] = from[3 * corners[i] + d];
      if (i % 3 === 2) values.fill(radiusRatio(from, corners[i - 2], corners[i - 1], corners[i]), i - 2, i + 1);
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('value', new BufferAttribute(values, 1));
    return geometry;
  }

  /** Coloured points at the vertices, because a valence is a vertex's alone. */
  makeValencePoints() {
    const {corners, nFaces, nVertices} = this.surface;
    const counts = valences(corners, 3 * nFaces, nVertices);
    const colours = new Float32Array(3 * nVertices);
    const used = [];
    for (let v = 0; v < nVertices; ++v) {
      if (counts[v] === 0) continue;
      used.push(v);
      scales.valence.colours[valenceClass(counts[v])].forEach((part, d) => { colours[3 * v + d] = part / 255; });
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', this.position);
    geometry.setAttribute('color', new BufferAttribute(colours, 3));
    geometry.setIndex(used);
    const points = new Points(geometry, new PointsMaterial({vertexColors: true, size: 5, sizeAttenuation: false}));
    points.frustumCulled = false;
    return points;
  }

  /** \param shading 'flat', 'smooth', or 'file': by the normals that the file has */
  setColour(colour, shading = this.shading) {
    this.colour = colour;
    this.shading = shading;
    const {look} = this.surface;
    const map = look?.mapOf(colour);
    this.faces.geometry = this.geometryOf(colour);
    if (map) this.faces.geometry.setAttribute('value', new BufferAttribute(look.shares(map), 1));
    for (const {uniforms} of [this.material, this.ghostMaterial]) {
      uniforms.isScaled.value = colour === 'shape' || this.range() !== null;
      uniforms.isSigned.value = colour === 'error' && !this.isMoving;
      uniforms.areNormals.value = colour === 'normals' && this.showsLook(colour);
      if (colour === 'shape') uniforms.scale.value = textureOf(scales.shape);
    }
    this.shown = this.shownMaterial();
    if (colour === 'valence' && this.valenceVersion !== this.surface.version) {
      if (this.valencePoints) this.group.remove(this.valencePoints);
      this.valencePoints = this.makeValencePoints();
      this.valenceVersion = this.surface.version;
      this.group.add(this.valencePoints);
    }
    if (this.valencePoints) this.valencePoints.visible = colour === 'valence';
    this.useShading();
  }

  /** What the whole surface is drawn with. */
  shownMaterial() {
    const isLook = this.showsLook(this.colour);
    if (isLook && this.colour === 'material') return this.surface.look.surfaceMaterials();
    return isLook && this.colour === 'colours' ? this.surface.look.colourMaterial() : this.material;
  }

  useShading() {
    for (const {uniforms} of [this.shown, this.material, this.ghostMaterial].flat()) uniforms.isSmooth.value = this.shading !== 'flat';
    this.useNormals(this.faces.geometry);
  }

  useNormals(geometry) {
    if (this.shading === 'flat') return;
    const isLook = geometry === this.wedged;
    const {look, corners, nFaces} = this.surface;
    const key = isLook && this.shading === 'file' && look.normals ? 'file' : this.moment;
    if (geometry.normalKey === key) return;
    geometry.normalKey = key;
    geometry.deleteAttribute('normal');
    if (key === 'file') geometry.setAttribute('normal', new BufferAttribute(look.normals, 3));
    else if (isLook) geometry.setAttribute('normal', this.normalsOf(look.nWedges, (w) => look.vertexOf(w)));
    else if (geometry === this.cached.shape?.geometry) geometry.setAttribute('normal', this.normalsOf(3 * nFaces, (c) => corners[c]));
    else geometry.computeVertexNormals();
  }

  /** The normals of vertices. \param vertexOf of each number below n */
  normalsOf(n, vertexOf) {
    this.useNormals(this.plain);
    const ofVertices = this.plain.getAttribute('normal').array;
    const normals = new Float32Array(3 * n);
    for (let i = 0; i < n; ++i) {
      const v = 3 * vertexOf(i);
      normals.set(ofVertices.subarray(v, v + 3), 3 * i);
    }
    return new BufferAttribute(normals, 3);
  }

  /** \param scale of deviations \param top where it ends, in the unit of `range()` */
  setScale(scale, top) {
    const range = this.range();
    for (const {uniforms} of [this.material, this.ghostMaterial]) {
      if (range) uniforms.scale.value = textureOf(scale);
      uniforms.top.value = range ? top / (range.max || 1) || 1 : 1;
    }
  }

  /** What the colour means at a point of a face, between its corners; or null. */
  interpolatedAt({face, point}) {
    const geometry = this.faces.geometry;
    const value = geometry.getAttribute('value');
    if (!value) return null;
    const position = geometry.getAttribute('position');
    const [a, b, c] = [face.a, face.b, face.c].map((v) => new Vector3().fromBufferAttribute(position, v));
    const area = (p, q, r) => q.clone().sub(p).cross(r.clone().sub(p)).length();
    const weights = [area(point, b, c), area(a, point, c), area(a, b, point)];
    const sum = weights[0] + weights[1] + weights[2];
    if (sum === 0) return null;
    const interpolated = [face.a, face.b, face.c].reduce((so_far, v, i) => so_far + weights[i] / sum * value.getX(v), 0);
    if (this.colour === 'shape') return interpolated;
    const share = this.colour === 'error' && !this.isMoving ? Math.abs(interpolated * 65535 - 32768) / 32767 : interpolated;
    return this.range() && share * this.range().max;
  }

  /** All faces as they are in the file. */
  wholeGeometry() {
    this.useNormals(this.plain);
    this.whole ??= new BufferGeometry();
    for (const [name, attribute] of Object.entries(this.plain.attributes)) this.whole.setAttribute(name, attribute);
    return this.whole.setIndex(this.plain.allFaces?.index ?? this.plain.getIndex());
  }

  /** Draws fewer faces over the same vertices, if there are some, or all of them again. */
  useCoarse(isCoarse) {
    const {coarse, coarseWedges, look} = this.surface;
    const {geometry} = this.faces;
    if (coarse.length === 0 || this.colour === 'shape') return;
    geometry.allFaces ??= {index: geometry.getIndex(), groups: geometry.groups};
    geometry.coarseFaces ??= geometry === this.wedged ? look.coarseFaces(coarseWedges) : {index: new BufferAttribute(coarse, 1), groups: []};
    useFaces(geometry, isCoarse ? geometry.coarseFaces : geometry.allFaces);
  }

  /** What is drawn. \param ghost '' for the whole surface, or how it is drawn in front of another one
      \param areFacesDrawn whether something else has drawn the whole surface already */
  show({faces, edges, borders, nonmanifold, refused, ghost = '', areFacesDrawn = false}) {
    this.faces.visible = ghost === '' && faces && !areFacesDrawn || ghost === 'transparent';
    this.faces.material = ghost === '' ? this.shown : this.ghostMaterial;
    this.faces.renderOrder = ghost === '' ? 0 : 1;
    this.points.visible = ghost === 'points';
    this.edges.visible = ghost === 'edges' || ghost === '' && edges;
    this.borders.visible = borders && this.surface.borders.length > 0;
    for (const lines of this.refusals) lines.visible = refused && ghost === '';
    this.nonmanifold.visible = nonmanifold && this.surface.nonmanifold.length > 0;
    if (this.valencePoints) this.valencePoints.visible = this.colour === 'valence' && ghost === '';
    if (this.edges.visible) this.updateEdges();
  }

  updateEdges() {
    if (this.edgeVersion === this.surface.version) return;
    this.edgeVersion = this.surface.version;
    const ends = edgesOf(this.surface.corners, 3 * this.surface.nFaces);
    const {geometry} = this.edges;
    const index = geometry.getIndex();
    if (index.array.length < ends.length) {
      geometry.dispose();
      geometry.setIndex(new BufferAttribute(ends.slice(), 1));
    } else {
      index.array.set(ends);
      index.needsUpdate = true;
    }
    geometry.setDrawRange(0, ends.length);
  }

  /** Takes over what the recording has now. \param positions of this moment, of its vertices */
  update(positions) {
    ++this.moment;
    this.surface.shownPositions = positions;
    this.position.array.set(positions);
    this.position.needsUpdate = true;
    const {plain} = this;
    const index = plain.getIndex();
    if (this.shownVersion !== this.surface.version) {
      this.shownVersion = this.surface.version;
      index.clearUpdateRanges();
      index.addUpdateRange(0, 3 * this.surface.nFaces);
      index.needsUpdate = true;
      plain.setDrawRange(0, 3 * this.surface.nFaces);
    }
    this.setColour(this.colour);
    if (this.colour === 'error') this.updateErrors();
    if (this.edges.visible) this.updateEdges();
  }

  /** Colours a recording's levels by the errors of their vertices from now on. */
  setErrors(errors) {
    this.errors = errors;
    this.plain.setAttribute('value', new BufferAttribute(errors.values, 1));
  }

  updateErrors() {
    if (this.errors?.update(this.position.array)) this.plain.getAttribute('value').needsUpdate = true;
  }
}
