// The colours of errors while the view rests: the distance to the other surface, for each pixel.
import {
  BufferAttribute, BufferGeometry, DataTexture, DepthTexture, DoubleSide, FloatType, GLSL3, Mesh, NearestFilter, NoBlending,
  RedFormat, Scene, ShaderMaterial, Vector3, WebGLRenderTarget,
} from 'three';
import {textureOf} from './colours.js';
import {FaceTree} from './face_tree.js';
import {paneShader, pixelShader, placeShader, vertexShader} from './shaders.js';
import {doInSlices} from './slices.js';
import {unit} from './surface.js';

const mostAtOnce = 32768; // faces that are drawn before the page answers again

export class ExactColours {
  /** \param onDone is called when they can be shown */
  constructor(view, onDone) {
    this.view = view;
    this.onDone = onDone;
    this.trees = new Map(); // of surfaces
    this.target = null;
    this.key = null; // of what is in work or done
    this.isDone = false;
    this.nRuns = 0; // the last one is wanted, unless it was stopped
    this.work = null; // a promise: settles when all runs have ended, those that were stopped, too
    this.placeMaterial = new ShaderMaterial({
      glslVersion: GLSL3, vertexShader, fragmentShader: placeShader, side: DoubleSide, blending: NoBlending,
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1, uniforms: {isSmooth: {value: false}},
    });
    this.pixelMaterial = new ShaderMaterial({
      glslVersion: GLSL3, vertexShader: paneShader, fragmentShader: pixelShader,
      uniforms: {top: {value: 1}, scale: {value: null}, values: {value: null}, lights: {value: null}, depths: {value: null}},
    });
    const corners = new BufferGeometry();
    corners.setAttribute('position', new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
    this.pixels = new Mesh(corners, this.pixelMaterial);
    this.pixels.frustumCulled = false;
    this.pixels.renderOrder = -1;
    view.scene.add(this.pixels);
  }

  /** \param top end of the scale, in the unit of the grid */
  setScale(scale, top) {
    this.pixelMaterial.uniforms.scale.value = textureOf(scale);
    this.pixelMaterial.uniforms.top.value = top || 1;
  }

  isDoneFor(key) {
    return this.isDone && this.key === key;
  }

  stop() {
    if (this.isDone) return;
    this.key = null;
    ++this.nRuns;
  }

  /** \param key tells views apart
      \param panes of each: `surface`, the `moment` of it, its `geometry`, whether it `isSmooth`, and the `other` surface; or null */
  start(key, panes) {
    if (this.key === key) return;
    this.key = key;
    this.isDone = false;
    this.work = Promise.all([this.work, this.run(panes, ++this.nRuns)]);
  }

  async run(panes, number) {
    if (!await doInSlices(this.find(panes), () => this.nRuns === number)) return;
    this.isDone = true;
    this.onDone();
  }

  /** \param moment of a surface that changes: another tree is made for another one */
  treeOf(surface, moment = 0) {
    const known = this.trees.get(surface);
    if (known?.moment === moment) return known.tree;
    const tree = new FaceTree(surface.onGrid?.() ?? surface);
    this.trees.set(surface, {moment, tree});
    return tree;
  }

  *find(panes) {
    const boxes = this.view.sharpBoxes();
    this.makeTarget();
    for (let i = 0; i < panes.length; ++i) if (panes[i]) yield* this.drawPlaces(panes[i], boxes[i]);
    const depths = new Float32Array(this.target.width * this.target.height);
    yield this.read(new Uint8Array(depths.buffer), this.target.width, this.target.height);
    const values = new Float32Array(depths.length).fill(-1);
    for (let i = 0; i < panes.length; ++i) if (panes[i]) yield* this.measure(panes[i], boxes[i], depths, values);
    this.keep(values);
  }

  /** Of the size of the canvas when it rests. */
  makeTarget() {
    const {renderer} = this.view;
    const {width, height} = this.view.sharpSize();
    if (this.target?.width !== width || this.target?.height !== height) {
      this.target?.dispose();
      this.target = new WebGLRenderTarget(width, height, {count: 2, minFilter: NearestFilter, magFilter: NearestFilter,
        depthTexture: new DepthTexture(width, height)});
    }
    this.target.viewport.set(0, 0, width, height);
    this.target.scissorTest = false;
    renderer.setRenderTarget(this.target);
    renderer.setClearColor(0, 0);
    renderer.clear();
    renderer.setRenderTarget(null);
  }

  /** Finds out how far away the surface is at each pixel of a pane. */
  *drawPlaces({geometry, isSmooth, surface}, {left, bottom, width, height, begin, end}) {
    const {renderer, camera} = this.view;
    const mesh = new Mesh(geometry, this.placeMaterial);
    mesh.frustumCulled = false;
    this.placeMaterial.uniforms.isSmooth.value = isSmooth;
    const scene = new Scene().add(mesh);
    this.target.viewport.set(left, bottom, width, height);
    this.target.scissor.set(begin, bottom, end - begin, height);
    this.target.scissorTest = true;
    for (let first = 0; first < 3 * surface.nFaces; first += 3 * mostAtOnce) {
      geometry.setDrawRange(first, Math.min(3 * mostAtOnce, 3 * surface.nFaces - first));
      renderer.setRenderTarget(this.target);
      renderer.render(scene, camera);
      renderer.setRenderTarget(null);
      yield this.read(new Uint8Array(4), 1, 1); // waits until they are drawn
    }
  }

  read(bytes, width, height) {
    return this.view.renderer.readRenderTargetPixelsAsync(this.target, 0, 0, width, height, bytes);
  }

  /** The distance to the other surface at each pixel of a pane. Graphics processors round where corners are to a share
      of a pixel, so the points that they see are put back onto the surface. */
  *measure({surface, moment, other}, box, depths, values) {
    const [own, others] = [this.treeOf(surface, moment), this.treeOf(other)];
    yield* own.finish();
    yield* others.finish();
    const begin = new Vector3();
    const point = new Vector3();
    for (let row = 0; row < box.height; ++row) {
      for (let column = box.begin - box.left; column < box.end - box.left; ++column) {
        const i = (row + box.bottom) * this.target.width + box.left + column;
        if (depths[i] === 0) continue;
        this.placeOf(column, row, box, depths[i], point);
        this.placeOf(column, row, box, this.view.camera.near, begin);
        own.putOnSurface(point, begin);
        values[i] = others.distance(point);
      }
      yield;
    }
  }

  /** Where something is, so far away, that is seen at the middle of a pixel. In the unit of the grid. */
  placeOf(column, row, {width, height}, depth, point) {
    const {projectionMatrix: {elements: projection}, matrixWorld} = this.view.camera;
    const x = (2 * (column + 0.5) / width - 1) / projection[0];
    const y = (2 * (row + 0.5) / height - 1) / projection[5];
    point.set(x * depth, y * depth, -depth).applyMatrix4(matrixWorld).multiplyScalar(unit);
  }

  keep(values) {
    const {uniforms} = this.pixelMaterial;
    uniforms.values.value?.dispose();
    uniforms.values.value = new DataTexture(values, this.target.width, this.target.height, RedFormat, FloatType);
    uniforms.values.value.needsUpdate = true;
    [uniforms.lights.value, uniforms.depths.value] = [this.target.textures[1], this.target.depthTexture];
  }
}
