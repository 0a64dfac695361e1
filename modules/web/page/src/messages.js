// What the page tells, over the picture: why something failed, and notes.

const $ = (id) => document.getElementById(id);

export function say({problem = '', notes = []}) {
  $('alert').textContent = problem;
  $('notes').replaceChildren(...notes.map((note) => {
    const item = document.createElement('p');
    item.textContent = note;
    return item;
  }));
  $('messages').hidden = problem === '' && notes.length === 0;
}
