import type {SimplifyOptions} from './options.js';

export type {SimplifyOptions} from './options.js';

export type Numbers = Float32Array | Float64Array | number[];
export type Indices = Uint32Array | Uint16Array | Uint8Array | number[];

/** What an attribute's numbers mean; it decides how values are blended. */
export type AttributeKind =
  | 'texcoord'
  | 'normal'
  | 'tangent'
  | 'color'
  | 'joints'
  | 'morph'
  | 'direction'
  | 'scalar'
  | 'category';

export interface Attribute {
  /** `itemSize` for each vertex, in turn. */
  values: Numbers;
  /** Default: as many as there are for each vertex. */
  itemSize?: number;
  /** Default: 'scalar'. 'joints': numbers of k joints, then their k weights. */
  kind?: AttributeKind;
}

/**
 * A triangle mesh of V vertices and F faces. Vertices with one position are one, with a seam where attributes differ.
 */
export interface Mesh {
  /** 3 V, x, y, z in turn; finite. */
  positions: Numbers;
  /** 3 F, below V, counter-clockwise seen from outside. Default: 0, 1, 2, …: three vertices for each face. */
  indices?: Indices;
  /** 3 V, of unit length. */
  normals?: Numbers;
  /** 2 V. */
  texcoords?: Numbers;
  /** 3 V or 4 V, in [0, 1]. */
  colors?: Numbers;
  attributes?: Record<string, Attribute | Numbers>;
  /** F: whole numbers from 0, whose borders are seams. */
  faceGroups?: Indices;
  /** V: vertices with a number other than 0 stay. */
  locked?: Uint8Array | number[];
}

/** A mesh that `simplify` has made. Floats are Float64Array where those given were, else Float32Array. */
export interface MeshLevel {
  positions: Float32Array | Float64Array;
  indices: Uint32Array;
  normals?: Float32Array;
  texcoords?: Float32Array | Float64Array;
  colors?: Float32Array | Float64Array;
  attributes?: Record<string, {values: Float32Array | Float64Array; itemSize: number; kind: AttributeKind}>;
  faceGroups?: Uint32Array;
  /** For each vertex the vertex given that it comes from, with the lowest number. */
  origins: Uint32Array;
}

export interface Report {
  /** Of the mesh given, without duplicates. */
  verticesBefore: number;
  facesBefore: number;
  /** Why the run ended: 'target' when a count was reached, 'exhausted' when nothing more could be contracted. */
  stop: 'target' | 'cost' | 'error' | 'exhausted' | 'cancelled';
  /** Of a contraction made; its unit is that of `maxCost`. */
  maxCost: number;
  /** With `maxError`: the distance both ways that is proven, model units; else null. */
  provenError: number | null;
  contractions: number;
  /** Faces whose orientation on a texture differs from that of the mesh given. */
  foldedTextureFaces: number;
}

export interface Result extends MeshLevel {
  /** For each vertex given its vertex here, or −1. */
  vertexMap: Int32Array;
  /** For each face the face given that it was, ascending. */
  faceOrigins: Uint32Array;
  report: Report;
  /** Whether the count asked for was reached. */
  met: boolean;
}

/** Gets the stage ('decimating', 'polishing'), its fraction in [0, 1], and the faces left. False ends the call. */
export type OnProgress = (stage: string, fraction: number, faces: number) => boolean | void;

/** What was wrong: 'invalid' for what was given, 'memory' where there was too little, 'internal' for all else. */
export class WhittleError extends Error {
  kind: 'invalid' | 'memory' | 'internal';
}

/** Settles when the module is loaded. All other calls but `simplifyInWorker` throw before. */
export const ready: Promise<void>;

/**
 * Simplifies a mesh on this thread. The result has the bytes that the C++ library gives.
 * @throws WhittleError for a mesh or options that aren't valid, or without memory; a DOMException named AbortError if
 * `onProgress` returns false. All is as before then.
 */
export function simplify(mesh: Mesh, options: SimplifyOptions & {onProgress?: OnProgress}): Result;

/** Numbers of faces, or shares of them, descending. */
export type LevelTargets =
  | {facesLeft: number[]; faceRatios?: undefined}
  | {faceRatios: number[]; facesLeft?: undefined};

/** Levels of detail out of one run, the finest first; fewer where nothing more could be contracted. */
export function lod(
  mesh: Mesh,
  targets: LevelTargets,
  options?: SimplifyOptions & {onProgress?: OnProgress},
): MeshLevel[];

/** A level of a recorded run. Its report's `stop`, `verticesBefore` and `facesBefore` are those of the run. */
export type RecordedLevel = Omit<Result, 'met'>;

/** A recorded run. It holds memory of its own, which is given back when nothing refers to it any more. */
export class Recording {
  private constructor();
  /** The last level: the result of the run, whose attributes are not fitted to those given in the end. */
  readonly last: RecordedLevel;
  /**
   * The first level with at most so many faces, or vertices, from 0 on: the last level where none has so few.
   * @throws WhittleError unless one count is given
   */
  level(count: {facesLeft: number; verticesLeft?: undefined} | {verticesLeft: number; facesLeft?: undefined}): RecordedLevel;
}

/**
 * Simplifies a mesh as `simplify` does, and keeps all levels on the way, from the mesh given to the result: any of them
 * can be had in a small part of the time of a run.
 * @throws as `simplify`
 */
export function record(mesh: Mesh, options: SimplifyOptions & {onProgress?: OnProgress}): Recording;

export interface WorkerControl {
  /** Ends the worker at once; the promise is rejected with an AbortError. */
  signal?: AbortSignal;
  onProgress?: (stage: string, fraction: number, faces: number) => void;
}

/** `simplify` in a worker of its own, in browsers and in Node.js. The mesh is copied. */
export function simplifyInWorker(mesh: Mesh, options: SimplifyOptions, control?: WorkerControl): Promise<Result>;
/** `lod` in a worker of its own. */
export function simplifyInWorker(
  mesh: Mesh,
  options: SimplifyOptions,
  control: WorkerControl & {targets: LevelTargets},
): Promise<MeshLevel[]>;

export type SimplifierFlags =
  | 'LockBorder'
  | 'Sparse'
  | 'ErrorAbsolute'
  | 'Prune'
  | 'Regularize'
  | 'Permissive'
  | 'RegularizeLight'
  | 'PreserveFolds'
  | 'ErrorClamped';

type IndexArray = Uint32Array | Int32Array | Uint16Array | Int16Array;

/** The calls of meshoptimizer's MeshoptSimplifier. docs/user/from-meshoptimizer-js.md has what differs. */
export const MeshoptSimplifier: {
  supported: boolean;
  ready: Promise<void>;
  compactMesh(indices: IndexArray): [Uint32Array, number];
  generatePositionRemap(positions: Float32Array, stride: number): Uint32Array;
  simplify<T extends IndexArray>(
    indices: T,
    positions: Float32Array,
    stride: number,
    targetIndexCount: number,
    targetError: number,
    flags?: SimplifierFlags[],
  ): [T, number];
  simplifyWithAttributes<T extends IndexArray>(
    indices: T,
    positions: Float32Array,
    stride: number,
    attributes: Float32Array,
    attributesStride: number,
    attributeWeights: number[],
    vertexLock: Uint8Array | null,
    targetIndexCount: number,
    targetError: number,
    flags?: SimplifierFlags[],
  ): [T, number];
  simplifyPrune<T extends IndexArray>(indices: T, positions: Float32Array, stride: number, targetError: number): T;
  getScale(positions: Float32Array, stride: number): number;
  /** @throws WhittleError always: Whittle has no equivalent */
  simplifyWithUpdate(...given: unknown[]): never;
  simplifySloppy(...given: unknown[]): never;
  simplifyPoints(...given: unknown[]): never;
  remesh(...given: unknown[]): never;
};
