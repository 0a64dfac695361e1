// What the browser does for compare_gltf.cjs: it draws glTF files by three.js and compares the pictures.
import * as THREE from 'three';
import {RoomEnvironment} from 'three/addons/environments/RoomEnvironment.js';
import {MeshoptDecoder} from 'three/addons/libs/meshopt_decoder.module.js';
import {DRACOLoader} from 'three/addons/loaders/DRACOLoader.js';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';

const size = 512; // pixels of a side
const nPixels = size * size;
/** Azimuth and elevation in degrees: all round, and no symmetry of usual models in line with the view. */
const directions = [[20, 25], [110, 25], [200, 25], [290, 25], [65, -20], [155, -20], [245, -20], [335, -20]];
const fieldOfView = 30; // degrees
const intensity = 0.42; // of the light: a white sphere is 1 where it is brightest, so nothing dull is cut off

const renderer = new THREE.WebGLRenderer({antialias: false, alpha: true});
renderer.setPixelRatio(1);
renderer.setSize(size, size, false);
renderer.setClearColor(0, 0);
renderer.toneMapping = THREE.NoToneMapping;
const environment = new THREE.PMREMGenerator(renderer).fromScene(new RoomEnvironment(), 0.04).texture;
const normalsTarget = new THREE.WebGLRenderTarget(size, size, {type: THREE.FloatType});

const loader = new GLTFLoader();
loader.setMeshoptDecoder(MeshoptDecoder);
loader.setDRACOLoader(new DRACOLoader().setDecoderPath('/three/examples/jsm/libs/draco/gltf/'));

const meshesIn = (object) => {
  const meshes = [];
  object.traverse((part) => part.isMesh && meshes.push(part));
  return meshes;
};

/**
 * The file as it is when nothing moves or, `posed`, with all morph weights .5 and after `time` seconds of its first
 * animation; by default half of it.
 */
async function load(url, {posed = false, time} = {}) {
  const {scene: model, animations} = await loader.loadAsync(url);
  const scene = new THREE.Scene();
  scene.environment = environment;
  scene.environmentIntensity = intensity;
  scene.add(model);
  const posedAt = posed ? pose(model, animations, time) : undefined;
  scene.updateMatrixWorld(true);
  const isMorphed = meshesIn(model).some((mesh) => mesh.morphTargetInfluences?.length);
  return {scene, time: posedAt, canPose: animations.length > 0 || isMorphed};
}

/** The animation is the first by name, as programs may write them in another order. \return its time in seconds */
function pose(model, animations, time) {
  const [clip] = [...animations].sort((a, b) => a.name < b.name ? -1 : Number(a.name > b.name));
  time ??= (clip?.duration ?? 0) / 2;
  if (clip) {
    const mixer = new THREE.AnimationMixer(model);
    mixer.clipAction(clip).play();
    mixer.setTime(time);
  }
  for (const {morphTargetInfluences} of meshesIn(model)) morphTargetInfluences?.fill(0.5);
  return time;
}

function release(scene) {
  for (const mesh of meshesIn(scene)) {
    mesh.geometry.dispose();
    for (const material of [mesh.material].flat()) {
      for (const value of Object.values(material)) if (value?.isTexture) value.dispose();
      material.dispose();
    }
    mesh.skeleton?.dispose();
  }
}

/** \return [x, y, z, radius] */
function sphereAround(scene) {
  const {center, radius} = new THREE.Box3().setFromObject(scene, true).getBoundingSphere(new THREE.Sphere());
  return [...center, radius];
}

function cameraAt([azimuth, elevation], [x, y, z, radius]) {
  const distance = radius / Math.sin(THREE.MathUtils.degToRad(fieldOfView / 2));
  const camera = new THREE.PerspectiveCamera(fieldOfView, 1, distance - 1.5 * radius, distance + 1.5 * radius);
  const [polar, turn] = [90 - elevation, azimuth].map(THREE.MathUtils.degToRad);
  camera.position.setFromSphericalCoords(distance, polar, turn).add(new THREE.Vector3(x, y, z));
  camera.lookAt(x, y, z);
  camera.updateMatrixWorld();
  return camera;
}

/** As they lie in the frame: multiplied by alpha, sRGB. */
function drawColours(scene, camera, pixels) {
  renderer.setRenderTarget(null);
  renderer.render(scene, camera);
  const gl = renderer.getContext();
  gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
}

const normalMaterialOf = ({side, flatShading}) => new THREE.MeshNormalMaterial({side, flatShading});

function packNormals(pixels, normals) {
  for (let i = 0; i < nPixels; ++i) {
    if (pixels[4 * i + 3] === 0) continue;
    const [x, y, z] = [2 * pixels[4 * i] - 1, 2 * pixels[4 * i + 1] - 1, 2 * pixels[4 * i + 2] - 1];
    const scale = 32767 / (Math.sqrt(x * x + y * y + z * z) || 1);
    normals[3 * i] = Math.round(scale * x);
    normals[3 * i + 1] = Math.round(scale * y);
    normals[3 * i + 2] = Math.round(scale * z);
  }
}

/** The interpolated normals of the vertices, without normal maps, times 32767, and 0 where nothing is drawn. */
function drawNormals(scene, cameras, normals) {
  for (const mesh of meshesIn(scene)) {
    mesh.material = Array.isArray(mesh.material) ? mesh.material.map(normalMaterialOf) : normalMaterialOf(mesh.material);
  }
  const pixels = new Float32Array(4 * nPixels);
  renderer.setRenderTarget(normalsTarget);
  cameras.forEach((camera, view) => {
    renderer.clear();
    renderer.render(scene, camera);
    renderer.readRenderTargetPixels(normalsTarget, 0, 0, size, size, pixels);
    packNormals(pixels, normals.subarray(3 * nPixels * view, 3 * nPixels * (view + 1)));
  });
  renderer.setRenderTarget(null);
}

function draw(scene, sphere) {
  const cameras = directions.map((direction) => cameraAt(direction, sphere));
  const colours = new Uint8Array(4 * nPixels * cameras.length);
  cameras.forEach((camera, view) => drawColours(scene, camera, colours.subarray(4 * nPixels * view, 4 * nPixels * (view + 1))));
  const normals = new Int16Array(3 * nPixels * cameras.length);
  drawNormals(scene, cameras, normals);
  return {colours, normals};
}

/** Over the pixels that one of the two covers: the mean squared error of their four numbers. */
function differenceOfColours(one, other, first, last) {
  let [sum, n] = [0, 0];
  for (let i = 4 * first; i < 4 * last; i += 4) {
    if (one[i + 3] === 0 && other[i + 3] === 0) continue;
    ++n;
    for (let k = i; k < i + 4; ++k) sum += (one[k] - other[k]) ** 2;
  }
  return {sum: sum / 4, n};
}

/** In radians; NaN if one of the two isn't there. It is exact for small angles, too. */
function angleAt(one, other, i) {
  const [ax, ay, az, bx, by, bz] = [one[i], one[i + 1], one[i + 2], other[i], other[i + 1], other[i + 2]];
  if (!(ax || ay || az) || !(bx || by || bz)) return NaN;
  const [x, y, z] = [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
  return Math.atan2(Math.sqrt(x * x + y * y + z * z), ax * bx + ay * by + az * bz);
}

/** Over the pixels that both cover: the mean angle in degrees. */
function differenceOfNormals(one, other) {
  let [sum, n] = [0, 0];
  for (let i = 0; i < one.length; i += 3) {
    const angle = angleAt(one, other, i);
    if (Number.isNaN(angle)) continue;
    sum += angle;
    ++n;
  }
  return n ? THREE.MathUtils.radToDeg(sum / n) : 180;
}

function compare(one, other) {
  const views = directions.map((_, v) => differenceOfColours(one.colours, other.colours, v * nPixels, (v + 1) * nPixels));
  const [sum, n] = ['sum', 'n'].map((key) => views.reduce((total, view) => total + view[key], 0));
  return {squaredError: n ? sum / n : 0, normalsDeg: differenceOfNormals(one.normals, other.normals),
    squaredErrorOfViews: views.map((view) => view.n ? view.sum / view.n : 0)};
}

const streamThrough = (data, transform) => new Response(new Blob([data]).stream().pipeThrough(transform));

/** 1024 bytes of JSON, then colours and normals. */
async function keep(place, {colours, normals, ...rest}) {
  const head = new TextEncoder().encode(JSON.stringify(rest).padEnd(1024));
  const packed = streamThrough(new Blob([head, colours, normals]), new CompressionStream('gzip'));
  await fetch(place, {method: 'PUT', body: await packed.blob()});
}

async function kept(place) {
  const response = await fetch(place);
  if (!response.ok) return null;
  const bytes = await streamThrough(await response.blob(), new DecompressionStream('gzip')).arrayBuffer();
  const nColours = 4 * nPixels * directions.length;
  return {...JSON.parse(new TextDecoder().decode(bytes.slice(0, 1024))), colours: new Uint8Array(bytes, 1024, nColours),
    normals: new Int16Array(bytes.slice(1024 + nColours))};
}

let originals = {}; // at rest and posed

async function drawOriginal(url, place, posed) {
  const {scene, ...told} = await load(url, {posed});
  const sphere = sphereAround(scene);
  const original = {sphere, ...told, ...draw(scene, sphere)};
  release(scene);
  await keep(place, original);
  return original;
}

/** \param place where its pictures are kept \return whether it can be posed */
async function setOriginal(url, place) {
  const pictures = async (name, posed) => await kept(place + name) ?? drawOriginal(url, place + name, posed);
  originals = {rest: await pictures('rest', false)};
  if (originals.rest.canPose) originals.posed = await pictures('posed', true);
  return originals.rest.canPose;
}

/** How a result differs from the original. */
async function score(url, which) {
  const original = originals[which];
  const {scene} = await load(url, {posed: which === 'posed', time: original.time});
  const result = compare(original, draw(scene, original.sphere));
  release(scene);
  return result;
}

const cell = 256; // pixels of a side, of a picture on a sheet
const line = 18;

async function drawCell(context, url, sphere, view, x, y) {
  const {scene} = await load(url);
  sphere ??= sphereAround(scene);
  renderer.setRenderTarget(null);
  renderer.render(scene, cameraAt(directions[view], sphere));
  context.drawImage(renderer.domElement, x, y, cell, cell);
  release(scene);
  return sphere;
}

/** \param columns each with its `view`, and `cells` from above, each with `url` and `label`; six fit beside one another */
async function sheet(columns) {
  const nBeside = Math.min(columns.length, 6);
  const nRows = columns[0].cells.length;
  const canvas = document.createElement('canvas');
  canvas.width = nBeside * cell;
  canvas.height = Math.ceil(columns.length / nBeside) * nRows * (cell + line);
  const context = canvas.getContext('2d');
  context.fillStyle = '#9fb0c0'; // that white and black models stand out
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.font = '12px sans-serif';
  context.fillStyle = '#000';
  for (const [i, {view, cells}] of columns.entries()) {
    let sphere;
    for (const [row, {url, label}] of cells.entries()) {
      const [x, y] = [i % nBeside * cell, (Math.floor(i / nBeside) * nRows + row) * (cell + line)];
      context.fillText(label, x + 4, y + 13, cell - 8);
      sphere = await drawCell(context, url, sphere, view, x, y + line);
    }
  }
  return canvas.toDataURL('image/png');
}

window.pictures = {setOriginal, score, sheet};
document.documentElement.dataset.ready = 'yes';
