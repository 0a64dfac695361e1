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
    element.classList.toggle('left', place.x > view.width / 2);
    Object.assign(element.style, {left: `${place.x}px`, top: `${Math.min(view.height - 30, Math.max(30, place.y))}px`});
  }
}
