"""check_vsix.py FILE VERSION: checks that the extension has this version, contains what its
manifest names, and starts the server. Node runs its bundle, with a stub for the API that Visual
Studio Code provides to extensions."""

import json
import pathlib
import subprocess
import sys
import tempfile
import zipfile

STAND_IN = """
const Module = require("module");
const registered = [];
const any = new Proxy(function () {}, {
    get: (_, name) => name === Symbol.toPrimitive ? () => "" : name === "then" ? undefined : any,
    apply: () => any, construct: () => any,
});
const vscode = new Proxy({
    commands: { registerCommand: (name) => { registered.push(name); return any; } },
    version: "1.75.0",
}, { get: (own, name) => name in own ? own[name] : any });
const load = Module._load;
Module._load = (name, ...rest) => name === "vscode" ? vscode : load(name, ...rest);
const extension = require(process.argv[1]);
extension.activate({ subscriptions: [] }).catch(() => {}).finally(() => {
    console.log(JSON.stringify(registered));
    process.exit(0);
});
setTimeout(() => { console.log(JSON.stringify(registered)); process.exit(0); }, 2000);
"""

with tempfile.TemporaryDirectory() as folder:
    zipfile.ZipFile(sys.argv[1]).extractall(folder)
    extension = pathlib.Path(folder) / "extension"
    manifest = json.loads((extension / "package.json").read_text())
    if manifest["version"] != sys.argv[2]:
        sys.exit("the extension has version %s, not %s" % (manifest["version"], sys.argv[2]))
    contributes = manifest["contributes"]
    named = [manifest["main"]]
    named += [language["configuration"] for language in contributes["languages"]]
    named += [grammar["path"] for grammar in contributes["grammars"]]
    missing = [name for name in named if not (extension / name).is_file()]
    if missing:
        sys.exit("the extension lacks " + ", ".join(missing))
    run = subprocess.run(
        ["node", "-e", STAND_IN, str(extension / manifest["main"])], capture_output=True, text=True
    )
    if run.returncode != 0:
        sys.exit("the bundle does not run: " + run.stderr)
    commands = sorted(command["command"] for command in contributes["commands"])
    if sorted(json.loads(run.stdout)) != commands:
        sys.exit("it registers %s, but promises %s" % (run.stdout.strip(), commands))
print("the extension is whole, and starts")
