export {ready} from './engine.js';
export {WhittleError} from './errors.js';
export {MeshoptSimplifier} from './meshoptimizer.js';
export {Recording, lod, record, simplify} from './simplify.js';
export {simplifyInWorker} from './in_worker.js';
