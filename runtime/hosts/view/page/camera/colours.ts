// Converts colours to the numbers that programs use in the library's ColourRange.

/** Computes the hue in degrees, on the HSV hexagon (0 for grey, which has no hue), and the
 * saturation and value, from 0 to 1. */
export function hueSaturationValue(
  red: number,
  green: number,
  blue: number,
): { hue: number; saturation: number; value: number } {
  const most = Math.max(red, green, blue),
    range = most - Math.min(red, green, blue);
  const sixth =
    range === 0
      ? 0
      : most === red
        ? ((green - blue) / range + 6) % 6
        : most === green
          ? (blue - red) / range + 2
          : (red - green) / range + 4;
  return { hue: 60 * sixth, saturation: most === 0 ? 0 : range / most, value: most / 255 };
}
