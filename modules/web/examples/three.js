// A knot, and a slider for the share of its faces. The worker makes each level while the page goes on.
import {
  DirectionalLight,
  HemisphereLight,
  Mesh,
  MeshStandardMaterial,
  PerspectiveCamera,
  Scene,
  TorusKnotGeometry,
  WebGLRenderer,
} from 'three';
import {simplifyGeometryInWorker} from 'whittle-mesh/three';

const canvas = document.querySelector('canvas');
const slider = document.querySelector('input');
const output = document.querySelector('output');
const renderer = new WebGLRenderer({canvas, antialias: true, preserveDrawingBuffer: true});
const camera = new PerspectiveCamera(45, canvas.width / canvas.height, 0.1, 100);
camera.position.z = 5;
const scene = new Scene();
scene.add(new HemisphereLight(0xffffff, 0x444444, 2), new DirectionalLight(0xffffff, 2));

const original = new TorusKnotGeometry(1, 0.35, 400, 64);
const mesh = new Mesh(original, new MeshStandardMaterial({color: 0x3377cc, flatShading: true}));
scene.add(mesh);

let running = null;

async function show() {
  running?.abort();
  const own = (running = new AbortController());
  try {
    const share = Math.min(0.999, slider.value / 100);
    const small = await simplifyGeometryInWorker(original, {faceRatio: share}, {signal: own.signal});
    if (mesh.geometry !== original) mesh.geometry.dispose();
    mesh.geometry = small;
    renderer.render(scene, camera);
    output.textContent = `${small.index.count / 3} faces`;
  } catch (error) {
    if (error.name !== 'AbortError') output.textContent = error.message;
  }
}

slider.addEventListener('input', show);
show();
