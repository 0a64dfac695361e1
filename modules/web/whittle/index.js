export {WhittleError, ready} from './engine.js';
export {MeshoptSimplifier} from './meshoptimizer.js';
export {lod, simplify} from './simplify.js';
export {simplifyInWorker} from './in_worker.js';
