// Finds the signals whose types are angles or turn rates. The unit of a signal does not show this,
// because radians are dimensionless. Therefore this module reads the types in the source text of
// the program.
import type { Program, Signal, Source } from "../protocol";

const units: Readonly<Record<string, string>> = { Angle: "rad", AngularVelocity: "rad/s" };
/** Maps each of these units to the unit that the compiler reports, which has no radians. */
const plain: Readonly<Record<string, string>> = { rad: "", "rad/s": "1/s" };

/** A name with its unit, valid in lines `first` to `last` of a file. */
interface Named {
  readonly file: string;
  readonly first: number;
  readonly last: number;
  readonly name: string;
  readonly unit: string;
}

/** Splits at commas or arrows that are not within brackets. */
function split(text: string, at: "," | "->"): string[] {
  const parts = [""];
  let depth = 0;
  for (let i = 0; i < text.length; i++) {
    const character = text[i] ?? "";
    if (character === "(" || character === "[") depth++;
    if (character === ")" || character === "]") depth--;
    if (depth === 0 && text.startsWith(at, i)) {
      parts.push("");
      i += at.length - 1;
    } else parts[parts.length - 1] += character;
  }
  return parts.map((part) => part.trim());
}

const withoutBrackets = (text: string) =>
  text.startsWith("(") && text.endsWith(")") ? text.slice(1, -1) : text;

/** Pairs the variables of a pattern with the parts of a type. */
function pairs(pattern: string, type: string): [string, string][] {
  const names = split(withoutBrackets(pattern), ","),
    types = split(withoutBrackets(type), ",");
  return names.length === types.length ? names.map((name, i) => [name, types[i] ?? ""]) : [];
}

/** Returns the two arguments of `SF a b`. */
function ofSignalFunction(type: string): [string, string] | null {
  const found =
    /^SF\s+(\([^()]*\)|[\w.]+(?:\[[^\]]*\])?)\s+(\([^()]*\)|[\w.]+(?:\[[^\]]*\])?)$/.exec(type);
  return found ? [found[1] ?? "", found[2] ?? ""] : null;
}

/** Pairs the variables of a definition with the types in its signature. */
function ofDefinition(signature: string, definition: string): [string, string][] {
  const types = split(signature.replace(/^.*=>/s, ""), "->");
  const head =
    /^[\w']+((?:\s+[\w']+)*)\s*=\s*(?:proc\s+(\([^()]*\)|[\w']+)\s*->\s*(\([^()]*\)|[\w']+))?/.exec(
      definition,
    );
  if (!head) return [];
  const parameters = (head[1] ?? "").trim().split(/\s+/).filter(Boolean);
  const result = ofSignalFunction(types.at(-1) ?? "");
  return [
    ...parameters.map((name, i): [string, string] => [name, types[i] ?? ""]),
    ...(result && head[2] && head[3]
      ? [...pairs(head[2], result[0]), ...pairs(head[3], result[1])]
      : []),
  ];
}

/** Maps each function that has a signature to its result type or, if it returns a signal function,
 * to the type of that signal function's output. The type is null if functions with the same name
 * have different types. */
type Results = ReadonlyMap<string, string | null>;

function resultsOf(sources: readonly Source[]): Results {
  const results = new Map<string, string | null>();
  for (const { text } of sources)
    for (const [, name = "", signature = ""] of text.matchAll(
      /^([a-z][\w']*)\s*::\s*(.*(?:\n\s+.*)*)/gm,
    )) {
      const type = signature.replace(/--.*$/gm, "").replace(/\s+/g, " ").replace(/^.*=>/, "");
      const last = split(type, "->").at(-1) ?? "";
      const result = ofSignalFunction(last)?.[1] ?? last;
      results.set(name, (results.get(name) ?? result) === result ? result : null);
    }
  return results;
}

/** Pairs the variables of equations such as `(v, omega) = wallFollow …` with the types of the
 * function's result. */
function ofEquations(definition: string, results: Results): [string, string][] {
  const equations = definition.matchAll(/(\([\w', ]+\))\s*(?:=|<-)\s*([a-z][\w']*)(?=\s)/g);
  return [...equations].flatMap(([, pattern = "", callee = ""]) =>
    pairs(pattern, results.get(callee) ?? ""),
  );
}

/** Returns the names in a file whose types are angles or turn rates. */
function namesIn({ name: file, text }: Source, results: Results): Named[] {
  const found: Named[] = [];
  const lines = text.split("\n");
  const add = (name: string, type: string, first: number, last: number) => {
    const unit = units[type.trim()];
    if (unit !== undefined) found.push({ file, first, last, name, unit });
  };
  // Splits the file into the parts that begin at the left margin: signatures and definitions.
  const starts = lines.flatMap((line, i) => (/^[\w(]/.test(line) ? [i] : []));
  let signature: { readonly name: string; readonly type: string } | null = null;
  starts.forEach((start, i) => {
    const end = starts[i + 1] ?? lines.length;
    const part = lines
      .slice(start, end)
      .map((line) => line.replace(/--.*$/, ""))
      .join(" ");
    const signed = /^([\w']+)\s*::\s*(.*)$/s.exec(part);
    if (signed) signature = { name: signed[1] ?? "", type: (signed[2] ?? "").trim() };
    else if (signature && part.startsWith(`${signature.name} `))
      for (const [name, type] of ofDefinition(signature.type, part))
        add(name, type, start + 1, end);
    if (!signed)
      for (const [name, type] of ofEquations(part, results)) add(name, type, start + 1, end);
    // Fields of records, and variables with their own signature.
    for (const [, name = "", type = ""] of part.matchAll(
      /(?:^|[{,]|\s)([a-z]\w*)\s*::\s*(\w+)(?=\s*[,}]|\s{2,}|\s*$)/g,
    ))
      add(name, type, start + 1, end);
  });
  return found;
}

/** Adds radians to the units of the signals that are angles or turn rates. */
export function withRadians(program: Program): Program {
  const results = resultsOf(program.sources);
  const names = program.sources.flatMap((source) => namesIn(source, results));
  /** The unit of a field, if it is the same in all records. */
  const fields = new Map<string, string | null>();
  for (const { name, unit } of names)
    fields.set(name, (fields.get(name) ?? unit) === unit ? unit : null);
  const unitOf = (signal: Signal): string | null | undefined => {
    const own = signal.own.split(".").at(-1) ?? "";
    if (signal.side === "probe")
      return names.find(
        ({ file, first, last, name }) =>
          file === signal.file && signal.line >= first && signal.line <= last && name === own,
      )?.unit;
    return signal.side === "mode" ? null : fields.get(signal.name.split(".").at(-1) ?? "");
  };
  const signals = program.signals.map((signal) => {
    const unit = unitOf(signal);
    const isPlain =
      unit && plain[unit] === signal.unit && (signal.kind === "float" || signal.kind === "event");
    return isPlain ? { ...signal, unit } : signal;
  });
  return { ...program, signals };
}
