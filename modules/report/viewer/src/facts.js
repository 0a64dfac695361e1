// What is known of a mesh, in words.
import {short} from './colours.js';

export const lengthUnit = 'model units';

export const counted = (n, one, many) => `${n.toLocaleString('en')} ${n === 1 ? one : many}`;

export const percent = (share) => `${short(100 * share)} %`;

/** "1,024 faces, 2 % of the original's, 50,176 fewer", as a line of `fillLabel` */
export function facesText(nFaces, nOriginal) {
  const text = counted(nFaces, 'face', 'faces');
  if (nOriginal === null || nFaces === nOriginal || nOriginal === 0) return [text];
  const [difference, word] = nFaces < nOriginal ? [nOriginal - nFaces, 'fewer'] : [nFaces - nOriginal, 'more'];
  return [`${text}, ${percent(nFaces / nOriginal)} of the original's`, `, ${difference.toLocaleString('en')} ${word}`];
}

/** "error: mean 0.012, largest 0.1 model units (0.01 %, 0.09 % of the diagonal)", as a line of `fillLabel`
    \param error {mean, max}, and whether it `isAbout` that \param diagonal of the original */
export function errorText({mean, max, isAbout = false}, diagonal) {
  const shares = diagonal > 0 ? ` (${percent(mean / diagonal)}, ${percent(max / diagonal)} of the diagonal)` : '';
  return [`error: ${isAbout ? 'about ' : ''}mean ${short(mean)}, largest ${short(max)} ${lengthUnit}`, shares];
}

/** Fills a label: the first line is a name. \param lines texts, or [text, what a narrow window leaves out] */
export function fillLabel(label, lines) {
  label.replaceChildren(...lines.filter((line) => line).flatMap((line, i) => {
    const element = document.createElement(i === 0 ? 'b' : 'span');
    const [text, more = ''] = [line].flat();
    const extra = document.createElement('span');
    extra.className = 'wide';
    extra.textContent = more;
    element.append(text, extra);
    return i === 0 ? [element] : [' ', element]; // so that the text can be read in one
  }));
}

/** Puts labels into the upper corners of their panes; the button in the picture's stays free. */
export function placeLabels(labels, boxes, {width, height}) {
  boxes.forEach(({left, bottom, height: own, begin, end}, i) => {
    const isAside = begin > left; // the right side of a split picture
    const room = isAside || boxes[1]?.left === 0 && boxes[1].begin > 0 ? width / 2 : end - begin;
    const isBesideButton = end === width && bottom + own === height;
    Object.assign(labels[i].style, {left: isAside ? 'auto' : `${begin}px`, right: isAside ? '2.6rem' : 'auto', top: `${height - bottom - own}px`,
      maxWidth: `${room - (isBesideButton ? 60 : 16)}px`});
  });
}
