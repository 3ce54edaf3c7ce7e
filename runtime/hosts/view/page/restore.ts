// Restores the state of the page from its address, from the tab's storage after a reload, or from
// an earlier run of the program. Saves every change to the state.
import { shown, update } from "./address";
import type { Kept, Json } from "./kept";
import type { Layout, Sizes } from "./layout";
import type { View, ViewState } from "./map/view";
import { newPlot, readPlots, spell } from "./plots/model";
import type { Program } from "./protocol";
import type { Store } from "./store";
import { chooseTheme, chosenTheme, onThemeChosen } from "./theme";

/** Returns the signals to plot first: the program's outputs. */
function firstPlots({ signals }: Program): number[] {
  const numbers = signals.map((_, number) => number);
  return numbers.filter((number) => signals[number]?.side === "output").slice(0, 4);
}

function isObject(value: Json | undefined): value is { readonly [key: string]: Json } {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** Returns a hash of a text, for detecting that a program has changed. */
function hash(text: string): number {
  let sum = 0;
  for (const character of text) sum = (sum * 31 + (character.codePointAt(0) ?? 0)) | 0;
  return sum;
}

/** Sets the plots, before the panels are built. */
export function restorePlots(store: Store, kept: Kept): void {
  const { program } = store;
  const text = shown().plots ?? kept.get("plots");
  const plots = typeof text === "string" ? readPlots(text, program) : [];
  store.plots =
    plots.length > 0 || text === ""
      ? plots
      : firstPlots(program).map((number) => newPlot([number]));
}

function restoreTheme(kept: Kept): void {
  const theme = kept.get("theme");
  if (theme === "dark" || theme === "light") chooseTheme(theme);
  onThemeChosen(() => kept.set("theme", chosenTheme()));
}

function restoreMap(store: Store, kept: Kept, view: View | null): void {
  const state = kept.get("map");
  if (!view) return;
  if (isObject(state)) {
    view.state = state as unknown as ViewState;
    store.changed("view");
  }
  store.on("view", () => {
    kept.set("map", view.mode === "all" ? null : { ...view.state });
  });
}

/** Restores the edited text, unless it belongs to a different version of the program. */
function restoreEdited(store: Store, kept: Kept): void {
  const own = store.program.sources.find(({ library }) => !library);
  const before = kept.get("edited");
  const of = hash(own?.text ?? "");
  if (isObject(before) && before["of"] === of && typeof before["text"] === "string") {
    store.edited = before["text"];
    if (before["open"] !== false) store.continueEditing(store.edited);
  }
  store.on("edited", () => {
    const { edited, isEditing } = store;
    kept.set("edited", edited === null ? null : { of, text: edited, open: isEditing });
  });
}

/** The range that a saved page shows first, because its address contains none. */
function keptRange(kept: Kept): readonly [number, number] | undefined {
  const range = kept.get("range");
  const [from, to] = Array.isArray(range) ? (range as readonly Json[]) : [];
  return typeof from === "number" && typeof to === "number" ? [from, to] : undefined;
}

/** Shows the instant and the range given in the address, or the defaults. Then keeps the address up
 * to date. */
function restoreTime(store: Store, kept: Kept): void {
  const { at, range = keptRange(kept) } = shown();
  const { program } = store;
  if (program.live && at === undefined) store.follow();
  else store.goToTime(at ?? program.at);
  if (range && !store.following) store.setRange(...range);
  const now = () => {
    const [from, to] = store.range;
    const isWhole = from <= program.start && to >= program.end;
    return {
      at: store.following ? undefined : store.instant?.time,
      range: store.following || isWhole ? undefined : ([from, to] as const),
      plots: spell(store.plots, program),
    };
  };
  for (const change of ["instant", "range", "plotted", "following"] as const)
    store.on(change, () => update(now));
  // Handles an address that the user has edited, or a link to another view.
  window.addEventListener("hashchange", () => {
    const wanted = shown();
    if (wanted.plots !== undefined) store.setPlots(readPlots(wanted.plots, program));
    if (wanted.range) store.setRange(...wanted.range);
    if (wanted.at !== undefined) store.goToTime(wanted.at);
  });
}

export function restore(store: Store, kept: Kept, layout: Layout, view: View | null): void {
  const sizes = kept.get("sizes");
  if (isObject(sizes)) layout.sizes = sizes as Sizes;
  layout.onChange = () => kept.set("sizes", { ...layout.sizes });
  store.on("plotted", () => kept.set("plots", spell(store.plots, store.program)));
  restoreTheme(kept);
  restoreMap(store, kept, view);
  restoreTime(store, kept);
  restoreEdited(store, kept);
}
