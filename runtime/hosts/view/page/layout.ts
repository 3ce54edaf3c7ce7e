// Resizes the panels when the user drags the bars between them, or uses the arrow keys.

/** Each bar with the panels before and after it, given as names of CSS variables. */
const bars = {
  source: ["source", "middle"],
  side: ["middle", "side"],
  map: ["map", "plots"],
  camera: ["camera", "signals"],
} as const;
type Bar = keyof typeof bars;

/** Minimum size of a panel, in pixels. */
const least = 90;
const keyStep = 24;

export type Sizes = Readonly<Record<string, number>>;

function panel(name: string): HTMLElement | null {
  return document.getElementById(name);
}

function set(name: string, share: number): void {
  document.documentElement.style.setProperty(`--${name}`, share.toFixed(3));
}

export class Layout {
  /** For each panel whose size the user has chosen, its proportion of the row or column. */
  private shares: Record<string, number> = {};

  /** Called when the user has changed a size. */
  onChange: () => void = () => undefined;

  constructor() {
    for (const bar of document.querySelectorAll<HTMLElement>(".splitter"))
      this.start(bar, bar.dataset["split"] as Bar);
  }

  get sizes(): Sizes {
    return this.shares;
  }

  set sizes(sizes: Sizes) {
    const names = new Set<string>(Object.values(bars).flat());
    for (const [name, share] of Object.entries(sizes)) {
      if (!names.has(name) || !(share > 0)) continue;
      this.shares[name] = share;
      set(name, share);
    }
  }

  private start(bar: HTMLElement, name: Bar): void {
    const isUpright = bar.ariaOrientation === "vertical";
    let from = 0;
    bar.tabIndex = 0;
    bar.onpointerdown = (event) => {
      bar.setPointerCapture(event.pointerId);
      from = isUpright ? event.clientX : event.clientY;
      event.preventDefault();
    };
    bar.onpointermove = (event) => {
      if (!bar.hasPointerCapture(event.pointerId)) return;
      const to = isUpright ? event.clientX : event.clientY;
      from += this.move(name, to - from, isUpright);
    };
    bar.onpointerup = () => this.onChange();
    bar.ondblclick = () => this.reset(name);
    bar.onkeydown = (event) => {
      const keys = isUpright ? ["ArrowLeft", "ArrowRight"] : ["ArrowUp", "ArrowDown"];
      const at = keys.indexOf(event.key);
      if (event.key === "Enter") this.reset(name);
      else if (at < 0) return;
      else this.move(name, at === 0 ? -keyStep : keyStep, isUpright);
      event.preventDefault();
      event.stopPropagation();
      this.onChange();
    };
    new ResizeObserver(() => this.tell(bar, name, isUpright)).observe(bar);
    this.tell(bar, name, isUpright);
  }

  /** Moves a bar by a number of pixels. Returns the number of pixels by which it has moved. */
  private move(name: Bar, by: number, isUpright: boolean): number {
    // Sets the proportions of all panels in the row or column to their sizes in pixels, so that the
    // other panels keep their sizes.
    const names: readonly string[] = isUpright ? ["source", "middle", "side"] : bars[name];
    const size = (each: string) => {
      const box = panel(each)?.getBoundingClientRect();
      return (isUpright ? box?.width : box?.height) ?? 0;
    };
    const [before, after] = bars[name];
    const moved = Math.max(least - size(before), Math.min(size(after) - least, by));
    const sizes = Object.fromEntries(names.map((each) => [each, size(each)]));
    sizes[before] = size(before) + moved;
    sizes[after] = size(after) - moved;
    this.sizes = sizes;
    return moved;
  }

  private reset(name: Bar): void {
    for (const each of name === "source" || name === "side"
      ? ["source", "middle", "side"]
      : bars[name]) {
      delete this.shares[each];
      document.documentElement.style.removeProperty(`--${each}`);
    }
    this.onChange();
  }

  /** Reports the bar's position to screen readers. */
  private tell(bar: HTMLElement, name: Bar, isUpright: boolean): void {
    const [before, after] = bars[name].map((each) => {
      const box = panel(each)?.getBoundingClientRect();
      return (isUpright ? box?.width : box?.height) ?? 0;
    });
    const whole = (before ?? 0) + (after ?? 0);
    bar.ariaValueMin = "0";
    bar.ariaValueMax = "100";
    bar.ariaValueNow = String(whole > 0 ? Math.round((100 * (before ?? 0)) / whole) : 50);
  }
}
