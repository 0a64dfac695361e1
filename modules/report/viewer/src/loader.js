// Unpacks the viewer, which the page has compressed, and runs it. The page's policy knows its hash.

async function load() {
  const binary = atob(document.getElementById('whittle-viewer').textContent);
  const bytes = Uint8Array.from(binary, (character) => character.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  const script = document.createElement('script');
  script.textContent = await new Response(stream).text();
  document.body.append(script);
}

load();
