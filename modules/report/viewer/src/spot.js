// What is said of a place on a surface, beside it.

export class Spot {
  constructor(element, view) {
    this.element = element;
    this.view = view;
    this.point = null;
  }

  /** \param point of the scene \param pane that it was asked for in */
  show(point, pane, text) {
    this.point = point.clone();
    this.pane = pane;
    this.element.textContent = text;
    this.follow();
  }

  hide() {
    this.point = null;
    this.element.hidden = true;
  }

  /** Stays beside the place when the view moves. */
  follow() {
    const {element, view, point, pane} = this;
    const place = point && pane < view.boxes().length ? view.placeOf(point, pane) : null;
    element.hidden = place === null;
    if (place === null) return;
    const isLeft = place.x > view.width / 2;
    element.classList.toggle('left', isLeft);
    const room = isLeft ? place.x : view.width - place.x;
    Object.assign(element.style, {left: `${place.x}px`, maxWidth: `min(20rem, 80%, ${room}px - 1rem)`});
    const half = element.offsetHeight / 2;
    element.style.top = `${Math.min(view.height - half, Math.max(half, place.y))}px`;
  }
}
