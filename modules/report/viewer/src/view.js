// The camera, and how the meshes lie beside, below or over each other.
import {
  Color, FramebufferTexture, LinearSRGBColorSpace, PerspectiveCamera, Quaternion, Raycaster, Scene, Spherical, Vector2, Vector3, WebGLRenderer,
} from 'three';
import {OrbitControls} from 'three/addons/controls/OrbitControls.js';
import {forgetTextures} from './colours.js';

/** The layer of what is drawn over everything else, by the colours that are there. */
export const lineLayer = 1;

const sharpRatio = () => Math.max(2, window.devicePixelRatio || 1);

/** The context of a canvas, which takes long to make. */
export const contextOf = (canvas) => canvas.getContext('webgl2', {antialias: false, preserveDrawingBuffer: true});

/** Whether the processor draws, not a graphics card. Some browsers tell the renderer's name by an extension alone. */
export function drawsBySoftware(context) {
  const name = context.getParameter(context.RENDERER);
  const extension = name === 'WebKit WebGL' && context.getExtension('WEBGL_debug_renderer_info');
  return /swiftshader|llvmpipe|software|basic render/i.test(extension ? context.getParameter(extension.UNMASKED_RENDERER_WEBGL) : name);
}

export class View {
  /** \param box {low, high}: what is to be seen \param behind a uniform: what is drawn below the lines
      \param onChange is called when another drawing is needed */
  constructor(canvas, box, behind, onChange) {
    this.canvas = canvas;
    this.measureCanvas();
    Object.assign(canvas, this.sharpSize()); // before it has a picture, which would have to be made anew
    this.renderer = new WebGLRenderer({canvas, context: contextOf(canvas)});
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.autoClear = false;
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(35, 1, 0.001, 100);
    this.center = new Vector3().addVectors(box.low, box.high).multiplyScalar(0.5);
    this.radius = Math.max(1e-6, box.high.distanceTo(box.low) / 2);
    this.onChange = onChange;
    this.behind = behind;
    this.setUp('y');
    this.panes = 1;
    this.split = null; // a share of the width, where one pane ends and the other begins; null: they don't overlap
    this.useSize(sharpRatio());
    this.fit();
  }

  /** \param axis 'x', 'y' or 'z', which is to point upwards */
  setUp(axis) {
    this.camera.up.set(Number(axis === 'x'), Number(axis === 'y'), Number(axis === 'z'));
    this.fromUp = new Quaternion().setFromUnitVectors(this.camera.up, new Vector3(0, 1, 0)); // to where y is upwards
    this.toUp = this.fromUp.clone().invert();
    this.controls?.dispose();
    this.controls = new OrbitControls(this.camera, this.canvas); // looks at the camera's axis once
    this.controls.enableDamping = false;
    this.controls.addEventListener('change', this.onChange);
  }

  /** Frees what the graphics processor has. */
  close() {
    this.controls.dispose();
    forgetTextures();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  /** Fits the picture to its element. One of another size is made anew, which waits for the graphics processor. */
  resize() {
    const {clientWidth, clientHeight} = this.canvas;
    if (Math.max(1, clientWidth) === this.width && Math.max(1, clientHeight) === this.height) return;
    this.measureCanvas();
    this.useSize(this.renderer.getPixelRatio());
  }

  measureCanvas() {
    this.width = Math.max(1, this.canvas.clientWidth);
    this.height = Math.max(1, this.canvas.clientHeight);
  }

  useSize(ratio) {
    this.renderer.setDrawingBufferSize(this.width, this.height, ratio);
    this.fitPanes();
  }

  /** \param roughness of a moving view; at 0 there are several pixels for each of the screen, which smooths what is drawn */
  setRoughness(roughness) {
    const wanted = [sharpRatio(), Math.min(1, window.devicePixelRatio || 1), 0.5][roughness];
    if (this.renderer.getPixelRatio() !== wanted) this.renderer.setPixelRatio(wanted);
  }

  /** The pixels of the canvas when it is sharp. */
  sharpSize() {
    return {width: Math.floor(this.width * sharpRatio()), height: Math.floor(this.height * sharpRatio())};
  }

  /** The first pane's box, then the second's, in pixels from the left and from the bottom. `begin` and `end` bound what
      is seen of it. Two are beside each other, in a high window below each other, or where one picture is split. */
  boxes() {
    const {width, height, panes, split} = this;
    const whole = {left: 0, bottom: 0, width, height};
    const at = split === null ? 0 : Math.round(split * width);
    if (split !== null) return [{...whole, begin: 0, end: at}, {...whole, begin: at, end: width}];
    if (panes === 1) return [{...whole, begin: 0, end: width}];
    if (height > width) {
      const lower = height >> 1;
      return [{...whole, bottom: lower, height: height - lower, begin: 0, end: width}, {...whole, height: lower, begin: 0, end: width}];
    }
    const half = Math.round(width / 2);
    return [{...whole, width: half, begin: 0, end: half}, {...whole, left: half, width: width - half, begin: half, end: width}];
  }

  /** The same, in the pixels of the canvas when it is sharp. */
  sharpBoxes() {
    const ratio = sharpRatio();
    return this.boxes().map((box) => Object.fromEntries(Object.entries(box).map(([key, value]) => [key, Math.round(value * ratio)])));
  }

  /** Of two views that look the same. */
  key() {
    this.camera.updateMatrixWorld();
    const {matrixWorld, projectionMatrix} = this.camera;
    return [this.panes, this.split, ...Object.values(this.sharpSize()), ...matrixWorld.elements, ...projectionMatrix.elements].join();
  }

  /** \param split a share of the width, of one picture in two panes */
  setPanes(n, split = null) {
    if (n === this.panes && split === this.split) return;
    [this.panes, this.split] = [n, split];
    this.fitPanes();
  }

  /** Lets the camera see what has the shape of a pane, and as much along its shorter side as before. */
  fitPanes() {
    const {width, height} = this.boxes()[0];
    const before = Math.min(1, this.camera.aspect);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.zoom(before / Math.min(1, this.camera.aspect));
  }

  /** Looks at all of it, from the front, a little from above and from the side. */
  fit() {
    const half = this.camera.fov / 2 * Math.PI / 180;
    const narrow = Math.atan(Math.tan(half) * Math.min(1, this.camera.aspect));
    const distance = 1.05 * this.radius / Math.sin(narrow);
    this.controls.target.copy(this.center);
    this.camera.position.copy(this.center).add(new Vector3(0.35, 0.25, 1).normalize().multiplyScalar(distance).applyQuaternion(this.toUp));
    this.camera.near = distance / 1000;
    this.camera.far = distance * 100;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.onChange();
  }

  /** Turns around a point from now on, half as far away from it. \param direction to look at it from; or as before */
  focus(point, direction = null) {
    const {camera, controls} = this;
    const distance = Math.max(this.radius / 50, camera.position.distanceTo(controls.target) / 2);
    const from = direction ?? camera.position.clone().sub(controls.target);
    controls.target.copy(point);
    camera.position.copy(point).addScaledVector(from.normalize(), distance);
    controls.update();
    this.onChange();
  }

  /** Around the middle of what is seen. Angles in radians. */
  rotate(aside, up) {
    const offset = this.camera.position.clone().sub(this.controls.target).applyQuaternion(this.fromUp);
    const spherical = new Spherical().setFromVector3(offset);
    spherical.theta -= aside;
    spherical.phi -= up;
    spherical.makeSafe();
    this.camera.position.copy(this.controls.target).add(offset.setFromSpherical(spherical).applyQuaternion(this.toUp));
    this.controls.update();
    this.onChange();
  }

  /** \param right, up shares of the distance */
  move(right, up) {
    const distance = this.camera.position.distanceTo(this.controls.target);
    const x = new Vector3().setFromMatrixColumn(this.camera.matrix, 0).multiplyScalar(right * distance);
    const y = new Vector3().setFromMatrixColumn(this.camera.matrix, 1).multiplyScalar(up * distance);
    this.camera.position.add(x).add(y);
    this.controls.target.add(x).add(y);
    this.controls.update();
    this.onChange();
  }

  zoom(factor) {
    this.camera.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
    this.controls.update();
    this.onChange();
  }

  /** \param panes functions that show what is to be seen in each \param hasLines whether they show lines of `lineLayer` */
  draw(panes, background, hasLines) {
    const {renderer, camera, width, height} = this;
    renderer.setClearColor(new Color(background));
    renderer.setScissorTest(false);
    renderer.setViewport(0, 0, width, height);
    renderer.clear();
    renderer.setScissorTest(true);
    camera.layers.set(0);
    this.drawPanes(panes);
    if (!hasLines) return;
    this.copyPicture();
    camera.layers.set(lineLayer);
    this.drawPanes(panes);
    camera.layers.set(0);
  }

  drawPanes(panes) {
    const {renderer} = this;
    this.boxes().forEach(({left, bottom, width, height, begin, end}, i) => {
      if (begin === end) return;
      renderer.setViewport(left, bottom, width, height);
      renderer.setScissor(begin, bottom, end - begin, height);
      panes[i]();
      renderer.render(this.scene, this.camera);
    });
  }

  /** Lets lines know what is drawn behind them. */
  copyPicture() {
    const {width, height} = this.renderer.getDrawingBufferSize(new Vector2());
    if (this.behind.value?.image.width !== width || this.behind.value?.image.height !== height) {
      this.behind.value?.dispose();
      this.behind.value = new FramebufferTexture(width, height);
    }
    this.renderer.copyFramebufferToTexture(this.behind.value);
  }

  /** The pane at a point of the window, and where in it. \return {pane, x, y}: −1 … 1 to the right and upwards */
  paneAt({clientX, clientY}) {
    const canvas = this.canvas.getBoundingClientRect();
    const x = clientX - canvas.left;
    const y = canvas.top + this.height - clientY;
    const boxes = this.boxes();
    const pane = Math.max(0, boxes.findIndex(({begin, end, bottom, height}) => x >= begin && x < end && y >= bottom && y < bottom + height));
    const {left, bottom, width, height} = boxes[pane];
    return {pane, x: 2 * (x - left) / width - 1, y: 2 * (y - bottom) / height - 1};
  }

  /** Where a point is seen in a pane, in pixels from the left and the top of the canvas; null if it isn't. */
  placeOf(point, pane) {
    this.camera.updateMatrixWorld();
    const seen = point.clone().project(this.camera);
    const {left, bottom, width, height, begin, end} = this.boxes()[pane];
    const x = left + (seen.x + 1) / 2 * width;
    const y = bottom + (seen.y + 1) / 2 * height;
    const isSeen = seen.z < 1 && x >= begin && x <= end && y >= bottom && y <= bottom + height;
    return isSeen ? {x, y: this.height - y} : null;
  }

  /** What is seen at a point of the window. \return {pane, hit}, without `hit` where there is nothing */
  pick(event, meshes) {
    const {pane, x, y} = this.paneAt(event);
    this.camera.updateMatrixWorld(); // it may have moved since the last picture
    const raycaster = new Raycaster();
    raycaster.setFromCamera(new Vector2(x, y), this.camera);
    return {pane, hit: raycaster.intersectObject(meshes[pane], false)[0]};
  }
}
