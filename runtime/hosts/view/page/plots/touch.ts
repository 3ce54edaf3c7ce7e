// Touch gestures on a plot: two fingers zoom the time axis, and one finger moves it sideways. A tap
// goes to an instant, like a click. The browser handles scrolling up and down.
import type { Store } from "../store";

/** Movement, in pixels, above which a touch is not a tap. */
const still = 8;

export function startTouch(over: HTMLElement, store: Store): void {
  const fingers = new Map<number, number>();
  let travelled = 0;
  over.style.touchAction = "pan-y";

  const timeAt = (x: number) => {
    const [from, to] = store.range;
    return from + (x / Math.max(1, over.clientWidth)) * (to - from);
  };
  const pinch = (before: number, after: number, other: number) => {
    const by = Math.abs(before - other) / Math.max(10, Math.abs(after - other));
    const [from, to] = store.range;
    const middle = timeAt((after + other) / 2);
    store.setRange(middle - (middle - from) * by, middle + (to - middle) * by);
  };
  const pan = (by: number) => {
    const [from, to] = store.range;
    const { start, end } = store.program;
    const seconds = Math.max(start - from, Math.min(end - to, timeAt(0) - timeAt(by)));
    if (seconds !== 0) store.setRange(from + seconds, to + seconds);
  };

  over.addEventListener("pointerdown", (event) => {
    if (event.pointerType !== "touch") return;
    if (fingers.size === 0) travelled = 0;
    fingers.set(event.pointerId, event.offsetX);
  });
  over.addEventListener("pointermove", (event) => {
    const before = fingers.get(event.pointerId);
    if (before === undefined) return;
    const after = event.offsetX;
    travelled += Math.abs(after - before);
    if (travelled < still) return;
    const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
    fingers.set(event.pointerId, after);
    if (other === undefined) pan(after - before);
    else pinch(before, after, other);
  });
  const released = (event: PointerEvent) => fingers.delete(event.pointerId);
  over.addEventListener("pointerup", released);
  over.addEventListener("pointercancel", released);
  // With a mouse, turning the wheel while holding Ctrl zooms around the pointer.
  over.addEventListener(
    "wheel",
    (event) => {
      if (!event.ctrlKey) return;
      event.preventDefault();
      const by = Math.exp(event.deltaY / 400);
      const [from, to] = store.range;
      const middle = timeAt(event.offsetX);
      store.setRange(middle - (middle - from) * by, middle + (to - middle) * by);
    },
    { passive: false },
  );
}
