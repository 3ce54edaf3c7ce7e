// The panel of plots. The plots are stacked, share a time axis, and fill the panel.
import type { Store } from "../store";
import { onTheme } from "../theme";
import { takesSignals } from "./drag";
import type { Plot } from "./model";
import { Strip } from "./strip";
import { drawTimeAxis, timeAxisHeight } from "./time_axis";

/** Minimum heights of a plot of numbers, and of a plot of truth values or names. */
const leastHigh = 60,
  leastLow = 44;
/** Maximum height of a plot of truth values or names. */
const mostLow = 90;
/** With more plots than this, the panel no longer shows the hint on how to add one. */
const hinted = 1;

export function startPlots(store: Store, host: HTMLElement): void {
  const strips = new Map<Plot, Strip>();
  const list = document.createElement("div");
  const empty = document.createElement("p");
  const axis = document.createElement("canvas");
  list.className = "strips";
  axis.className = "time-axis";
  axis.style.height = `${timeAxisHeight}px`;
  empty.className = "empty";
  empty.textContent =
    "Click a value in the source, or a signal in the list, to plot it; drag it onto a plot to add it.";
  host.append(list, axis, empty);
  takesSignals(host, (signal) => {
    if (!store.plotted.includes(signal)) store.toggle(signal);
  });

  /** The width of the panel when data was last loaded. */
  let loadedWidth = host.clientWidth;
  const load = () => {
    loadedWidth = host.clientWidth;
    drawTimeAxis(store, axis);
    strips.forEach((strip) => strip.load());
  };
  /** Divides the height of the panel among the plots. */
  const layOut = () => {
    if (host.clientWidth === 0) return;
    const all = store.plots.flatMap((plot) => strips.get(plot) ?? []);
    const heads = all.reduce((sum, strip) => sum + strip.headHeight, 0);
    const hint = empty.hidden ? 0 : empty.offsetHeight;
    const free = host.clientHeight - heads - hint - timeAxisHeight - 2;
    const low = all.filter(({ isLow }) => isLow).length;
    const even = free / Math.max(1, all.length - 0.5 * low);
    const lowHeight = Math.round(Math.min(mostLow, Math.max(leastLow, even / 2)));
    const highHeight = Math.max(
      leastHigh,
      Math.floor((free - low * lowHeight) / Math.max(1, all.length - low)),
    );
    for (const strip of all) strip.build(strip.isLow ? lowHeight : highHeight);
    drawTimeAxis(store, axis);
    const { clientWidth } = host;
    if (Math.abs(clientWidth - loadedWidth) > 0.1 * loadedWidth) load();
  };

  /** False while the first plots are created. Only plots that are added later are scrolled into
   * view. */
  let isStarted = false;
  const arrange = () => {
    for (const [plot, strip] of strips) {
      if (store.plots.includes(plot)) continue;
      strip.end();
      strips.delete(plot);
    }
    const changed: Strip[] = [];
    for (const plot of store.plots) {
      const strip = strips.get(plot) ?? new Strip(store, plot, axis);
      if (!strips.has(plot)) changed.push(strip);
      else if (strip.update()) changed.push(strip);
      strips.set(plot, strip);
    }
    list.append(...store.plots.flatMap((plot) => strips.get(plot)?.element ?? []));
    empty.hidden = store.plots.length > hinted;
    axis.hidden = store.plots.every(({ isXy }) => isXy);
    layOut();
    for (const strip of changed) strip.load();
    if (isStarted) changed.at(-1)?.element.scrollIntoView({ block: "nearest" });
  };
  store.on("plotted", arrange);
  store.on("sizes", layOut);
  store.on("range", load);
  store.on("what-if", () => {
    arrange();
    load();
  });
  store.on("resumed", load);
  store.on("instant", () => strips.forEach((strip) => strip.moved()));
  store.on("mark", () => strips.forEach((strip) => strip.moved()));
  store.on("extent", () => {
    if (!store.following) return;
    strips.forEach((strip) => strip.grow());
    drawTimeAxis(store, axis);
  });
  onTheme(() => {
    strips.forEach((strip) => strip.restyle());
    layOut();
  });
  new ResizeObserver(layOut).observe(host);
  arrange();
  isStarted = true;
}
