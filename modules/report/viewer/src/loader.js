// Unpacks the viewer, which the page has compressed, and runs it. The page's policy knows its hash.

async function load() {
  const binary = atob(document.getElementById('whittle-viewer').textContent);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  const script = document.createElement('script');
  script.textContent = await new Response(stream).text();
  document.body.append(script);
}

load();
