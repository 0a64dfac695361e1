// Long work, done in slices between which the page answers.

const slice = 20; // milliseconds

/** \param work a generator that yields after each small part, or yields a promise to wait for
    \param isWanted is asked between slices \return whether all is done */
export async function doInSlices(work, isWanted = () => true) {
  while (true) {
    const end = performance.now() + slice;
    let part = work.next();
    while (!part.done && !part.value && performance.now() < end) part = work.next();
    if (part.done) return true;
    await part.value;
    await new Promise((next) => setTimeout(next));
    if (!isWanted()) return false;
  }
}
