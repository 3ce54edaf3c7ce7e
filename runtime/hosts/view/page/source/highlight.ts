// Syntax highlighting for Frob: marks the tokens on the visible lines.
import { RangeSetBuilder } from "@codemirror/state";
import { Decoration, ViewPlugin, type DecorationSet, type EditorView } from "@codemirror/view";

const words = new Set(
  (
    "case class data deriving do else foreign if import in infix infixl infixr instance let module " +
    "of param proc then type unit where"
  ).split(" "),
);

/** Patterns of tokens with their classes. Each pattern matches only at the current position in a
 * line. */
const patterns: readonly (readonly [RegExp, string])[] = [
  [/\s+/y, ""],
  [/--+(?![!#$%&*+./<=>?@\\^|~:-]).*/y, "comment"],
  [/"(?:[^"\\]|\\.)*"?|'(?:[^'\\]|\\.)'/y, "number"],
  [/\d+(?:\.\d+)?(?:[eE][-+]?\d+)?(?:\[[\w/^*. -]+\])?/y, "number"],
  [/[A-Z][\w']*/y, "type"],
  [/[a-z_][\w']*/y, "word"],
  [/[-!#$%&*+./<=>?@\\^|~:]+/y, "operator"],
];

const mark = (name: string) => Decoration.mark({ class: `token-${name}` });
const marks: Readonly<Record<string, Decoration>> = Object.fromEntries(
  ["comment", "number", "type", "keyword", "operator"].map((name) => [name, mark(name)]),
);

/** Returns the nesting depth of comments at the end of a text. */
function depthAfter(text: string, depth: number): number {
  for (const [bracket] of text.matchAll(
    /--+(?![!#$%&*+./<=>?@\\^|~:-]).*|\{-|-\}|"(?:[^"\\\n]|\\.)*"/g,
  ))
    if (bracket === "{-") depth++;
    else if (bracket === "-}") depth = Math.max(0, depth - 1);
  return depth;
}

type Add = (from: number, to: number, name: string) => void;

/** Calls `add` for each token of a line. Returns the nesting depth of comments after the line. */
function tokens(text: string, depth: number, add: Add): number {
  for (let at = 0; at < text.length; ) {
    if (depth > 0 || text.startsWith("{-", at)) {
      const from = at;
      do {
        if (text.startsWith("{-", at)) [depth, at] = [depth + 1, at + 2];
        else if (text.startsWith("-}", at)) [depth, at] = [depth - 1, at + 2];
        else at++;
      } while (depth > 0 && at < text.length);
      add(from, at, "comment");
      continue;
    }
    let next = at + 1;
    for (const [pattern, name] of patterns) {
      pattern.lastIndex = at;
      const found = pattern.exec(text)?.[0];
      if (!found) continue;
      next = at + found.length;
      const kind = name === "word" ? (words.has(found) ? "keyword" : "") : name;
      if (kind !== "") add(at, next, kind);
      break;
    }
    at = next;
  }
  return depth;
}

function highlighted({ state: { doc }, visibleRanges }: EditorView): DecorationSet {
  const builder = new RangeSetBuilder<Decoration>();
  for (const { from, to } of visibleRanges) {
    const first = doc.lineAt(from);
    let depth = depthAfter(doc.sliceString(0, first.from), 0);
    for (let number = first.number; number <= doc.lineAt(to).number; number++) {
      const line = doc.line(number);
      depth = tokens(line.text, depth, (a, b, name) => {
        const found = marks[name];
        if (found) builder.add(line.from + a, line.from + b, found);
      });
    }
  }
  return builder.finish();
}

export const highlight = ViewPlugin.define(
  (view) => ({
    decorations: highlighted(view),
    update(change) {
      if (change.docChanged || change.viewportChanged) this.decorations = highlighted(change.view);
    },
  }),
  { decorations: (plugin) => plugin.decorations },
);
