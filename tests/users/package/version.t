The version of Frob is defined in one place, dune-project. The compiler, the language server, the
opam package, the Python distribution and the extension for Visual Studio Code have the same
version. So does the Debian package; see deb.t.

  $ top=../../..
  $ version=$(sed -n 's/^(version \(.*\))$/\1/p' $top/dune-project)
  $ echo "$version" | grep -cE '^[0-9]+\.[0-9]+\.[0-9]+$'
  1
  $ same() { [ "$2" = "$version" ] || echo "$1: version $2, but dune-project has $version"; }
  $ same frobc "$(frobc --version)"
  $ same frobc.opam "$(sed -n 's/^version: "\(.*\)"$/\1/p' $top/frobc.opam)"

  $ cat > server.py <<'END'
  > import json, subprocess
  > text = json.dumps({"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": {"capabilities": {}}})
  > answer = subprocess.run(["frobc", "lsp"], input=f"Content-Length: {len(text)}\r\n\r\n{text}",
  >                         capture_output=True, text=True).stdout
  > print(json.loads(answer[answer.index("{"):])["result"]["serverInfo"]["version"])
  > END
  $ same "frobc lsp" "$(python3 server.py)"

setuptools need not be installed, so this test reads the version that setup.py passes to it.

  $ cat > setup_version.py <<'END'
  > import runpy, sys, types
  > given = {}
  > setuptools = types.ModuleType("setuptools")
  > setuptools.Distribution, setuptools.setup = object, lambda **settings: given.update(settings)
  > wheel = types.ModuleType("setuptools.command.bdist_wheel")
  > wheel.bdist_wheel = object
  > sys.modules.update({"setuptools": setuptools, "setuptools.command": types.ModuleType("command"),
  >                     wheel.__name__: wheel})
  > runpy.run_path(sys.argv[1])
  > print(given["version"])
  > END
  $ same "the wheel" "$(python3 -B setup_version.py $top/runtime/python/setup.py)"
  $ mkdir copy && cp $top/runtime/python/setup.py $top/dune-project copy
  $ same "a copy as wheel.sh makes it" "$(python3 -B setup_version.py copy/setup.py)"
  $ rm copy/dune-project && python3 -B setup_version.py copy/setup.py
  setup.py: no dune-project with a (version ...) here or two folders up
  [1]

  $ sh $top/compiler/editors/vscode/sources.sh extension
  $ same "the extension" "$(sed -n 's/^  "version": "\(.*\)",$/\1/p' extension/package.json)"

The newest entry of the changelog is for this version.

  $ same CHANGELOG.md "$(sed -n 's/^## \[\([0-9.]*\)\].*/\1/p' $top/CHANGELOG.md | head -n 1)"
