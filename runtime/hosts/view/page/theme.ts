// The dark and light themes, and the colours for drawing.

/** Okabe and Ito's colours, which are distinguishable with any form of colour vision. Yellow is
 * omitted on a light background, and blue on a dark one. */
const light = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00"];
const dark = ["#56b4e9", "#e69f00", "#00c08b", "#e69ac4", "#f0e442", "#ff8552"];

/** Colours for modes: Paul Tol's light colours, which differ from those of plots. Text on them is
 * dark. */
const modes = [
  "#77aadd",
  "#44bb99",
  "#ee8866",
  "#bbcc33",
  "#ffaabb",
  "#99ddff",
  "#eedd88",
  "#aaaa00",
];

const preferred = matchMedia("(prefers-color-scheme: dark)");
const listeners: (() => void)[] = [];

export function isDark(): boolean {
  return document.documentElement.dataset["theme"] === "dark";
}

export function lineColour(index: number): string {
  const colours = isDark() ? dark : light;
  return colours[index % colours.length] ?? "gray";
}

export function modeColour(index: number): string {
  return modes[index % modes.length] ?? "gray";
}

/** Caches colours, because computing a style makes the browser perform pending layout
 * changes. */
const known = new Map<string, string>();

export function colour(name: string): string {
  const found =
    known.get(name) ??
    getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
  known.set(name, found);
  return found;
}

export function onTheme(listener: () => void): void {
  listeners.push(listener);
}

function set(theme: string): void {
  document.documentElement.dataset["theme"] = theme;
  known.clear();
  for (const listener of listeners) listener();
}

export function toggleTheme(): void {
  set(isDark() ? "light" : "dark");
  isChosen = true;
  for (const listener of choices) listener();
}

/** Whether the user has chosen the theme, so that it does not follow the desktop's. */
let isChosen = false;
const choices: (() => void)[] = [];

/** The theme that the user has chosen; null to follow the desktop's. */
export function chosenTheme(): "dark" | "light" | null {
  return !isChosen ? null : isDark() ? "dark" : "light";
}

export function chooseTheme(theme: "dark" | "light"): void {
  isChosen = true;
  set(theme);
}

export function onThemeChosen(listener: () => void): void {
  choices.push(listener);
}

export function startTheme(): void {
  set(preferred.matches ? "dark" : "light");
  preferred.addEventListener("change", () => {
    if (!isChosen) set(preferred.matches ? "dark" : "light");
  });
}
