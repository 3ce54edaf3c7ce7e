// The program's source, read-only.
import { HighlightStyle, syntaxHighlighting } from "@codemirror/language";
import { EditorState } from "@codemirror/state";
import { EditorView, lineNumbers } from "@codemirror/view";
import { tags } from "@lezer/highlight";
import { frob } from "./frob_language";
import type { Store } from "./store";

const colours = HighlightStyle.define([
  { tag: tags.keyword, color: "var(--keyword)", fontWeight: "600" },
  { tag: tags.comment, color: "var(--dim)", fontStyle: "italic" },
  { tag: tags.number, color: "var(--number)" },
  { tag: tags.string, color: "var(--number)" },
  { tag: tags.typeName, color: "var(--type)" },
  { tag: tags.operator, color: "var(--operator)" },
]);

const look = EditorView.theme({
  "&": { height: "100%", color: "var(--text)", backgroundColor: "transparent", fontSize: "13px" },
  ".cm-scroller": { fontFamily: "var(--mono)", lineHeight: "1.55" },
  ".cm-gutters": { backgroundColor: "transparent", color: "var(--faint)", border: "none" },
  "&.cm-focused": { outline: "none" },
});

/** In a shadow tree, where the editor's styles are style sheets and no `<style>` elements,
 *  which the page's security policy would refuse. */
export function startSource(store: Store, host: HTMLElement): void {
  const root = host.attachShadow({ mode: "open" });
  const [source] = store.program.sources;
  new EditorView({
    root,
    parent: root,
    state: EditorState.create({
      doc: source?.text ?? "",
      extensions: [
        lineNumbers(),
        EditorState.readOnly.of(true),
        EditorView.contentAttributes.of({ "aria-label": source?.name ?? "Source" }),
        frob,
        syntaxHighlighting(colours),
        look,
      ],
    }),
  });
}
