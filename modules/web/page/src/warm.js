// Starts what draws while nobody waits for it: the first context of a browser takes long, in a page longer than in a
// worker, and after that a page's first one takes half as long.

const script = "new OffscreenCanvas(1, 1).getContext('webgl2'); postMessage(0)";

export function warmUp() {
  const worker = new Worker(URL.createObjectURL(new Blob([script], {type: 'text/javascript'})));
  worker.onmessage = () => {
    worker.terminate();
    document.createElement('canvas').getContext('webgl2')?.getExtension('WEBGL_lose_context').loseContext();
  };
}
