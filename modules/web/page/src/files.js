// The files that somebody drops or chooses: {name, file}, a name has the folders that were dropped.

const mesh = /\.(obj|ply|stl|off|gltf|glb)(\.gz)?$/i;

/** Files that can be opened; the others may belong to them. */
export const meshesOf = (files) => files.filter(({name}) => mesh.test(name));

/** A mesh, and what may belong to it: not the other meshes. */
export const filesOfMesh = (files, name) => files.filter((file) => file.name === name || !mesh.test(file.name));

/** \param file a File that is no folder's */
export const named = (file) => ({name: file.name, file});

const fileOf = (entry) => new Promise((resolve, reject) => entry.file(resolve, reject));

/** A reader gives the entries of a folder a hundred at a time. */
async function entriesOf(folder) {
  const reader = folder.createReader();
  const all = [];
  for (;;) {
    const some = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
    if (some.length === 0) return all;
    all.push(...some);
  }
}

async function filesOf(entry) {
  if (entry.isFile) return [{name: entry.fullPath.replace(/^\//, ''), file: await fileOf(entry)}];
  return (await Promise.all((await entriesOf(entry)).map(filesOf))).flat();
}

/** \param transfer of a drop, which forgets its items when the event is over \return a promise of files, those in folders, too */
export function droppedFiles({items}) {
  const dropped = [...items].filter(({kind}) => kind === 'file').map((item) => ({entry: item.webkitGetAsEntry(), file: item.getAsFile()}));
  return Promise.all(dropped.map(({entry, file}) => entry?.isDirectory ? filesOf(entry) : [named(file)])).then((all) => all.flat());
}

/** Calls back with a transfer that is dropped anywhere on the page. */
export function setUpDrops(onDrop) {
  const mark = (isOver) => document.body.classList.toggle('dropping', isOver);
  addEventListener('dragover', (event) => {
    event.preventDefault();
    mark(true);
  });
  addEventListener('dragleave', ({relatedTarget}) => { if (!relatedTarget) mark(false); });
  addEventListener('drop', (event) => {
    event.preventDefault();
    mark(false);
    onDrop(event.dataTransfer);
  });
}
