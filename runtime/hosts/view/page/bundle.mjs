// usage: node bundle.mjs OUT
// Writes all files of the page, and licences.txt, to OUT.
import { build } from "esbuild";
import { copyFile, readFile, readdir, writeFile } from "node:fs/promises";
import { join } from "node:path";

const out = process.argv[2];

const { metafile } = await build({
  entryPoints: ["page.ts", "page.css"],
  outdir: out,
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  charset: "utf8",
  legalComments: "none",
  metafile: true,
  logLevel: "warning",
});
for (const name of ["page.html", "icon.svg"]) await copyFile(name, join(out, name));

// Collect the licence of each package that the bundle contains parts of.
const folders = Object.keys(metafile.inputs).flatMap((path) => {
  const found = /^node_modules\/(@[^/]+\/)?[^/]+/.exec(path);
  return found ? [found[0]] : [];
});
const licences = await Promise.all(
  [...new Set(folders)].sort().map(async (folder) => {
    const { name, version } = JSON.parse(await readFile(join(folder, "package.json"), "utf8"));
    const file = (await readdir(folder)).find((name) => /^licen[cs]e/i.test(name));
    return `${name} ${version}\n\n${(await readFile(join(folder, file), "utf8")).trim()}\n`;
  }),
);
await writeFile(join(out, "licences.txt"), licences.join(`\n${"-".repeat(72)}\n\n`));
