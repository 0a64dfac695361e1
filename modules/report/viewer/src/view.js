// The camera, and how the meshes lie beside or over each other.
import {Color, PerspectiveCamera, Quaternion, Raycaster, Scene, Spherical, Vector2, Vector3, WebGLRenderer, LinearSRGBColorSpace} from 'three';
import {OrbitControls} from 'three/addons/controls/OrbitControls.js';

export class View {
  /** \param box {low, high}: what is to be seen \param onChange is called when another drawing is needed */
  constructor(canvas, box, onChange) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({canvas, antialias: false, preserveDrawingBuffer: true});
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.autoClear = false;
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(35, 1, 0.001, 100);
    this.center = new Vector3().addVectors(box.low, box.high).multiplyScalar(0.5);
    this.radius = Math.max(1e-6, box.high.distanceTo(box.low) / 2);
    this.onChange = onChange;
    this.setUp('y');
    this.panes = 1;
    this.setSharp(true);
    this.resize();
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

  /** Fits the canvas to its element. */
  resize() {
    const {clientWidth, clientHeight} = this.canvas;
    this.width = Math.max(1, clientWidth);
    this.height = Math.max(1, clientHeight);
    this.renderer.setSize(this.width, this.height, false);
    this.fitPanes();
  }

  /** Several pixels for each of the screen, which smooths what is drawn. */
  setSharp(isSharp) {
    const wanted = isSharp ? this.sharpRatio() : Math.min(1, window.devicePixelRatio || 1);
    if (this.renderer.getPixelRatio() !== wanted) this.renderer.setPixelRatio(wanted);
  }

  sharpRatio() {
    return Math.max(2, window.devicePixelRatio || 1);
  }

  /** The pixels of the canvas when it is sharp. */
  sharpSize() {
    return {width: Math.floor(this.width * this.sharpRatio()), height: Math.floor(this.height * this.sharpRatio())};
  }

  /** The panes among them. */
  boxesOfPanes() {
    const ratio = this.sharpRatio();
    return this.spansOfPanes().map(({left, width}) => (
      {left: Math.round(left * ratio), width: Math.round(width * ratio), height: Math.round(this.height * ratio)}));
  }

  spansOfPanes() {
    const edge = (i) => Math.round(this.width * i / this.panes);
    return Array.from({length: this.panes}, (_, i) => ({left: edge(i), width: edge(i + 1) - edge(i)}));
  }

  /** Of two views that look the same. */
  key() {
    this.camera.updateMatrixWorld();
    const {matrixWorld, projectionMatrix} = this.camera;
    return [this.panes, ...Object.values(this.sharpSize()), ...matrixWorld.elements, ...projectionMatrix.elements].join();
  }

  setPanes(n) {
    if (n === this.panes) return;
    this.panes = n;
    this.fitPanes();
  }

  /** Lets the camera see what has the shape of a pane. */
  fitPanes() {
    this.camera.aspect = this.width / this.panes / this.height;
    this.camera.updateProjectionMatrix();
    this.onChange();
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

  /** \param panes functions that show what is to be seen in each, left to right */
  draw(panes, background) {
    const {renderer, width, height} = this;
    renderer.setClearColor(new Color(background));
    renderer.setScissorTest(false);
    renderer.setViewport(0, 0, width, height);
    renderer.clear();
    renderer.setScissorTest(true);
    this.spansOfPanes().forEach((span, i) => {
      renderer.setViewport(span.left, 0, span.width, height);
      renderer.setScissor(span.left, 0, span.width, height);
      panes[i]();
      renderer.render(this.scene, this.camera);
    });
  }

  /** What is seen at a point of the window. \return {pane, hit}, without `hit` where there is nothing */
  pick(event, meshes) {
    const box = this.canvas.getBoundingClientRect();
    const x = event.clientX - box.left - this.canvas.clientLeft;
    const y = event.clientY - box.top - this.canvas.clientTop;
    const spans = this.spansOfPanes();
    const pane = Math.max(0, spans.findLastIndex(({left}) => left <= x));
    const {left, width} = spans[pane];
    const at = new Vector2(2 * (x - left) / width - 1, 1 - 2 * y / this.height);
    this.camera.updateMatrixWorld(); // it may have moved since the last picture
    const raycaster = new Raycaster();
    raycaster.setFromCamera(at, this.camera);
    return {pane, hit: raycaster.intersectObject(meshes[pane], false)[0]};
  }
}
