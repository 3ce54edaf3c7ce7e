// Chooses the positions to label on axes.

/** Returns the smallest number that is at least `least` and is 1, 2 or 5 times a power of ten. */
export function niceStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5].map((x) => x * power).find((x) => x >= least * (1 - 1e-9)) ?? 10 * power;
}

/** Returns the times to label on an axis that is `width` pixels long. They are at least `space`
 * pixels apart. */
export function timeTicks(from: number, to: number, width: number, space = 80): number[] {
  if (!(to > from) || !(width > 0)) return [];
  const step = niceStep(((to - from) * space) / width);
  const first = Math.ceil(from / step - 1e-9),
    last = Math.floor(to / step + 1e-9);
  // Multiplies instead of adding, because sums would accumulate rounding errors.
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) =>
    Number(((first + i) * step).toPrecision(12)),
  );
}
