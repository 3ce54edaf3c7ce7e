// Draws in CSS pixels on a canvas that may have a higher resolution.

/** Clears a canvas and sets its size. Resizes it only if the size changes, because each resize
 * allocates memory, and at many frames a second this memory would accumulate. */
export function clear(context: CanvasRenderingContext2D, width: number, height: number): void {
  const { canvas } = context;
  const ratio = devicePixelRatio;
  const [across, down] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== across) canvas.width = across;
  if (canvas.height !== down) canvas.height = down;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
}
