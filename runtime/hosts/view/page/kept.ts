// Keeps the state of the page for each program: its plots, the sizes of the panels, the theme,
// and the edited text. The tab keeps it across a reload, and the viewer keeps it for the next
// run of the program.
import type { Link } from "./connection";

/** Delay between a change and saving the state, in ms. */
const soon = 500;
/** Maximum length of a request to the viewer; the viewer's limit is 64 kB. */
const longest = 60_000;

export type Json =
  | string
  | number
  | boolean
  | null
  | readonly Json[]
  | { readonly [key: string]: Json };

function parsed(text: string | null): Record<string, Json> | null {
  try {
    const value: unknown = JSON.parse(text ?? "null");
    return typeof value === "object" && value !== null && !Array.isArray(value)
      ? (value as Record<string, Json>)
      : null;
  } catch {
    return null;
  }
}

export class Kept {
  private readonly all: Record<string, Json>;
  private readonly key: string;
  private timer: number | undefined;

  constructor(
    program: string,
    /** The state that the viewer has kept, as JSON. */
    before: string,
    private readonly connection: Link,
  ) {
    this.key = `frob ${program}`;
    this.all = parsed(this.stored()) ?? parsed(before) ?? {};
  }

  private stored(): string | null {
    try {
      return sessionStorage.getItem(this.key);
    } catch {
      return null; // not available if the page was opened from a file
    }
  }

  /** Returns the state as JSON for a saved page, with these values added. */
  text(more: Record<string, Json>): string {
    return JSON.stringify({ ...this.all, edited: null, ...more });
  }

  get(name: string): Json | undefined {
    return this.all[name];
  }

  set(name: string, value: Json): void {
    if (JSON.stringify(this.all[name]) === JSON.stringify(value)) return;
    this.all[name] = value;
    this.timer ??= window.setTimeout(() => this.save(), soon);
  }

  private save(): void {
    this.timer = undefined;
    const text = JSON.stringify(this.all);
    try {
      sessionStorage.setItem(this.key, text);
    } catch {
      // The storage of the tab is full, but the viewer may still keep the state.
    }
    const isShort = new TextEncoder().encode(text).length < longest;
    this.connection.ask(`keep ${isShort ? text : JSON.stringify({ ...this.all, edited: null })}`);
  }
}
