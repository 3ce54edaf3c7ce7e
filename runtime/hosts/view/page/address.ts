// After `#`, the address of the page contains the token and the current view, so that a link
// opens the same view: `#TOKEN&at=12.5&range=10..20&plots=out.forward,out.turn;in.battery`.

export interface Shown {
  /** The time of the instant, in seconds. */
  readonly at?: number | undefined;
  readonly range?: readonly [number, number] | undefined;
  readonly plots?: string | undefined;
}

/** Minimum time between changes of the address, in ms. Browsers limit how often a page may change
 * it. */
const pause = 400;

export function token(): string {
  return location.hash.slice(1).split("&", 1)[0] ?? "";
}

export function shown(): Shown {
  const parts = new Map(
    location.hash
      .split("&")
      .slice(1)
      .map((part) => {
        const at = part.indexOf("=");
        return [part.slice(0, at), part.slice(at + 1)];
      }),
  );
  const number = (text: string | undefined) => {
    const x = text === undefined || text === "" ? NaN : Number(text);
    return Number.isFinite(x) ? x : undefined;
  };
  const [from, to] = (parts.get("range") ?? "").split("..").map(number);
  return {
    at: number(parts.get("at")),
    range: from !== undefined && to !== undefined && from < to ? [from, to] : undefined,
    plots: parts.get("plots"),
  };
}

let timer: number | undefined;

/** Writes the current view to the address, after a delay. */
export function update(now: () => Shown): void {
  timer ??= window.setTimeout(() => {
    timer = undefined;
    const { at, range, plots } = now();
    const hash = [
      token(),
      ...(at === undefined ? [] : [`at=${at}`]),
      ...(range ? [`range=${range.join("..")}`] : []),
      ...(plots === undefined ? [] : [`plots=${plots}`]),
    ].join("&");
    if (`#${hash}` !== location.hash) history.replaceState(null, "", `#${hash}`);
  }, pause);
}
