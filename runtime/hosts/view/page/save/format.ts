// The data of a run in a saved page.
import type { Claims, Contacts, Instant, Program, WhatIf } from "../protocol";

export interface SavedRun {
  readonly program: Program;
  readonly claims: Claims;
  readonly contacts: Contacts["all"];
  readonly times: readonly number[];
  readonly dts: readonly number[];
  /** For each signal, the instants at which its cell changes, each followed by the new cell. */
  readonly cells: readonly (readonly (number | string)[])[];
  /** The values of the other recording or the edited program; null if there is none. */
  readonly others?: readonly (readonly (number | string | null)[])[];
  readonly whatIf?: WhatIf;
  /** For a simulated run: the true state of the robots at each instant. */
  readonly truth: readonly Instant["truth"][];
  /** The instants at which an object moves, each followed by the poses of all objects. */
  readonly objects: readonly (number | Instant["objects"])[];
}

/** Maximum number of instants in a saved page. */
export const mostInstants = 20_000;

async function through(bytes: BlobPart, stream: GenericTransformStream): Promise<ArrayBuffer> {
  return new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer();
}

/** Compresses a run and encodes it as base64. */
export async function pack(run: SavedRun): Promise<string> {
  const packed = new Uint8Array(await through(JSON.stringify(run), new CompressionStream("gzip")));
  let text = "";
  const piece = 0x8000;
  for (let at = 0; at < packed.length; at += piece)
    text += String.fromCharCode(...packed.subarray(at, at + piece));
  return btoa(text);
}

export async function unpack(text: string): Promise<SavedRun> {
  const packed = Uint8Array.from(atob(text.trim()), (character) => character.charCodeAt(0));
  const bytes = await through(packed, new DecompressionStream("gzip"));
  return JSON.parse(new TextDecoder().decode(bytes)) as SavedRun;
}
