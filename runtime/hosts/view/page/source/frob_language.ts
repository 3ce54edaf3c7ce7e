// Syntax highlighting for Frob.
import { StreamLanguage, type StringStream } from "@codemirror/language";

const words = new Set([
  "case",
  "class",
  "data",
  "deriving",
  "do",
  "else",
  "foreign",
  "if",
  "import",
  "in",
  "infix",
  "infixl",
  "infixr",
  "instance",
  "let",
  "module",
  "of",
  "param",
  "proc",
  "then",
  "type",
  "unit",
  "where",
]);

interface State {
  /** Nesting depth of comments. */
  depth: number;
}

function comment(stream: StringStream, state: State): string {
  while (!stream.eol()) {
    if (stream.match("{-")) state.depth++;
    else if (stream.match("-}")) {
      if (--state.depth === 0) break;
    } else stream.next();
  }
  return "comment";
}

export const frob = StreamLanguage.define<State>({
  name: "frob",
  startState: () => ({ depth: 0 }),
  token(stream, state) {
    if (state.depth > 0) return comment(stream, state);
    if (stream.eatSpace()) return null;
    if (stream.match("{-")) {
      state.depth = 1;
      return comment(stream, state);
    }
    if (stream.match(/^--+(?![!#$%&*+./<=>?@\\^|~:-]).*/)) return "comment";
    if (stream.match(/^"([^"\\]|\\.)*"?/) || stream.match(/^'([^'\\]|\\.)'/)) return "string";
    if (stream.match(/^\d+(\.\d+)?([eE][-+]?\d+)?/)) {
      stream.match(/^\[[\w/^*. -]+\]/);
      return "number";
    }
    if (stream.match(/^[A-Z][\w']*/)) return "typeName";
    const word = stream.match(/^[a-z_][\w']*/);
    if (word && word !== true) return words.has(word[0] ?? "") ? "keyword" : "variableName";
    if (stream.match(/^[-!#$%&*+./<=>?@\\^|~:]+/)) return "operator";
    stream.next();
    return null;
  },
});
