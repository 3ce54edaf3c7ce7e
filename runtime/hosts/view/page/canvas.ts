// Drawing in pixels of the page, on a canvas that may have more.

/** Makes a canvas so large, and empty. It gets other memory only with another size: what is drawn
 *  many times a second would leave much of it behind. */
export function clear(context: CanvasRenderingContext2D, width: number, height: number): void {
  const { canvas } = context;
  const ratio = devicePixelRatio;
  const [across, down] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== across) canvas.width = across;
  if (canvas.height !== down) canvas.height = down;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
}
