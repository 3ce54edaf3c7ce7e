// Shows the program's image with its marks, or the camera's last image if the program shows none.
import { clear } from "../canvas";
import { drawShape, readMarks } from "../map/marks";
import type { Point } from "../map/world";
import type { Picture } from "../protocol";
import type { Store } from "../store";
import { colour, onTheme } from "../theme";
import { formatNumber } from "../values";
import { hueSaturationValue } from "./colours";

/** Height of the note below the image, in pixels. */
const noteHeight = 20;
/** Minimum number of page pixels per image pixel at which image pixels are drawn with sharp
 * edges. */
const largePixels = 3;

/** Describes a frame that the recording mentions but does not contain. */
function loss({ number, k, changed }: NonNullable<Picture["lost"]>): string {
  return (
    `frame ${number} at instant ${k} ` +
    (changed
      ? "is not the recorded frame: its file was changed"
      : "is missing from the folder next to the recording")
  );
}

export function startCamera(store: Store, host: HTMLElement): void {
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("2d");
  const pixels = document.createElement("canvas");
  const image = pixels.getContext("2d", { willReadFrequently: true });
  if (!store.program.sees || !context || !image) {
    host.hidden = true;
    return;
  }
  document.body.classList.add("sees");
  const note = document.createElement("p");
  host.append(canvas, note);
  let picture: Picture | null = null;
  /** Page pixels per image pixel, and the position of the centre of the first pixel. */
  let scale = 1,
    left = 0,
    top = 0;
  let pointer: Point | null = null;

  const ask = () => {
    if (host.clientWidth > 0)
      store.askPicture(Math.round(host.clientWidth * devicePixelRatio), received);
  };
  const received = (answer: Picture) => {
    picture = answer;
    const { data, columns, rows } = answer;
    if (data && columns && rows) {
      pixels.width = columns;
      pixels.height = rows;
      image.putImageData(new ImageData(data, columns, rows), 0, 0);
    }
    draw();
  };

  const describe = (shown: Picture) => {
    if (shown.lost || shown.number === undefined) return "";
    const age = `frame ${shown.number}, ${formatNumber(Math.round((shown.age ?? 0) * 1000))} ms old`;
    const at = pointer && under(shown, pointer);
    if (at) return at;
    return shown.chosen ? age : `${age}, as the camera saw it`;
  };
  /** Describes the pixel at a position, with its colour in the form that programs use. */
  const under = ({ width = 0, height = 0, by = 1 }: Picture, [px, py]: Point): string | null => {
    const x = Math.round((px - left) / scale),
      y = Math.round((py - top) / scale);
    if (x < 0 || y < 0 || x >= width || y >= height) return null;
    const [red = 0, green = 0, blue = 0] = image.getImageData(
      Math.floor(x / by),
      Math.floor(y / by),
      1,
      1,
    ).data;
    const { hue, saturation, value } = hueSaturationValue(red, green, blue);
    return (
      `x ${x}, y ${y} px: hue ${hue.toFixed(0)}°, saturation ${saturation.toFixed(2)}, ` +
      `value ${value.toFixed(2)}`
    );
  };

  const say = (text: string, width: number, height: number) => {
    context.font = "13px system-ui, sans-serif";
    context.fillStyle = colour("dim");
    context.textAlign = "center";
    const words = text.split(" ");
    const lines = [""];
    for (const word of words) {
      const longer = `${lines.at(-1)} ${word}`.trim();
      if (context.measureText(longer).width < width - 30) lines[lines.length - 1] = longer;
      else lines.push(word);
    }
    lines.forEach((line, i) =>
      context.fillText(line, width / 2, height / 2 + 18 * (i - (lines.length - 1) / 2)),
    );
    context.textAlign = "start";
  };

  const draw = () => {
    const { clientWidth: width, clientHeight } = host;
    if (width === 0 || clientHeight === 0) return;
    const height = clientHeight - noteHeight;
    clear(context, width, clientHeight);
    note.textContent = picture ? describe(picture) : "";
    if (!picture || picture.lost || !picture.width || !picture.height) {
      if (picture) say(picture.lost ? loss(picture.lost) : "no frame yet", width, clientHeight);
      return;
    }
    scale = Math.min(width / picture.width, height / picture.height);
    const across = picture.width * scale,
      down = picture.height * scale;
    left = (width - across) / 2 + scale / 2;
    top = (height - down) / 2 + scale / 2;
    context.imageSmoothingEnabled = scale < largePixels;
    context.drawImage(pixels, left - scale / 2, top - scale / 2, across, down);
    context.save();
    context.beginPath();
    context.rect(left - scale / 2, top - scale / 2, across, down);
    context.clip();
    context.lineJoin = context.lineCap = "round";
    const toPixel = ([x, y]: Point): Point => [left + x * scale, top + y * scale];
    for (const { colour: name, shape } of readMarks(picture.marks ?? []).marks)
      drawShape(context, shape, name, toPixel, scale, "image");
    context.restore();
  };

  canvas.onpointermove = (event) => {
    pointer = [event.offsetX, event.offsetY];
    if (picture) note.textContent = describe(picture);
  };
  canvas.onpointerleave = () => {
    pointer = null;
    if (picture) note.textContent = describe(picture);
  };
  store.on("instant", ask);
  onTheme(draw);
  new ResizeObserver(() => {
    draw();
    ask();
  }).observe(host);
}
