// Pans and zooms the map with a mouse, fingers or keys. A short press is a click.
import type { View } from "./view";
import type { Point } from "./world";

/** Movement, in pixels, above which a press is not a click. */
const still = 5;
/** Pixels by which an arrow key moves the map, and the factor by which a key zooms it. */
const keyStep = 60;
export const zoomStep = 1.4;

const arrows: Readonly<Record<string, Point>> = {
  ArrowLeft: [keyStep, 0],
  ArrowRight: [-keyStep, 0],
  ArrowUp: [0, keyStep],
  ArrowDown: [0, -keyStep],
};

export interface Gestures {
  /** Called when the view has changed. */
  moved(): void;
  clicked(at: Point): void;
}

export function startGestures(canvas: HTMLCanvasElement, view: View, then: Gestures): void {
  const fingers = new Map<number, Point>();
  let travelled = 0;

  const pinch = (before: Point, after: Point, other: Point) => {
    const apart = (p: Point) => Math.max(1, Math.hypot(p[0] - other[0], p[1] - other[1]));
    view.zoom(apart(after) / apart(before), [(after[0] + other[0]) / 2, (after[1] + other[1]) / 2]);
  };

  canvas.onpointerdown = (event) => {
    if (event.button !== 0) return;
    canvas.setPointerCapture(event.pointerId);
    if (fingers.size === 0) travelled = 0;
    fingers.set(event.pointerId, [event.offsetX, event.offsetY]);
  };
  canvas.onpointermove = (event) => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    const after: Point = [event.offsetX, event.offsetY];
    const [dx, dy] = [after[0] - before[0], after[1] - before[1]];
    travelled += Math.hypot(dx, dy);
    if (travelled <= still) return;
    const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
    if (other) pinch(before, after, other);
    else view.pan(dx, dy);
    fingers.set(event.pointerId, after);
    then.moved();
  };
  const released = (event: PointerEvent) => {
    if (!fingers.delete(event.pointerId)) return;
    if (event.type === "pointerup" && fingers.size === 0 && travelled <= still)
      then.clicked([event.offsetX, event.offsetY]);
  };
  canvas.onpointerup = canvas.onpointercancel = released;
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      view.zoom(Math.exp(-event.deltaY / 400), [event.offsetX, event.offsetY]);
      then.moved();
    },
    { passive: false },
  );
  canvas.onkeydown = (event) => {
    const by = arrows[event.key];
    const zooms = event.key === "+" || event.key === "=" ? 1 : event.key === "-" ? -1 : 0;
    if (event.ctrlKey || event.altKey || event.metaKey || (!by && zooms === 0)) return;
    if (by) view.pan(...by);
    else view.zoom(zoomStep ** zooms, [view.width / 2, view.height / 2]);
    event.preventDefault();
    event.stopPropagation();
    then.moved();
  };
}
