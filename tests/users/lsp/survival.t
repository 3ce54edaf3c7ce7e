Any fault in the compiler itself results in a message at the top of the text and in the editor's
log. The server continues: other texts are not affected, and neither is this one once the fault
disappears.

  $ export PYTHONPATH=$PWD PYTHONDONTWRITEBYTECODE=1
  $ export FROB_HOME=$(dirname $(dirname $(which frobc)))
  $ for module in Bug Crash Deep Slow; do
  >   echo 'gain = 2[1/s]' > $module.frob; touch $module.fault
  > done
  $ OCAMLRUNPARAM=l=1M python3 - <<'END'    # a small stack, for OCaml 5: it is full in time
  > from client import *
  > c = Client(".", command=["./faulty_server.exe", "8"])
  > right = c.open("right.frob", "main :: SF Float Float\nmain = proc x -> y where\n    y = 2 * x\n")
  > print(c.told(right))
  > for module in ["Bug", "Crash", "Deep", "Slow"]:
  >     text = "import %s\n\nmain :: SF Float[s] Float\nmain = proc x -> gain * x\n" % module
  >     u = c.open("with_%s.frob" % module.lower(), text)
  >     print(*[(place(d["range"]), d["message"]) for d in c.told(u)])
  >     print(c.ask("hover", u, "gain"), c.ask("hover", right, "y where")["contents"]["value"].split("\n")[1])
  >     os.remove(module + ".fault")
  >     c.notify("workspace/didChangeWatchedFiles", {"changes": [{"uri": c.uri(module + ".frob"), "type": 2}]})
  >     c.diagnostics.clear()
  >     print(c.told(u), c.ask("hover", u, "gain")["contents"]["value"].split("\n")[1])
  > print(sorted(set(n["params"]["message"] for n in c.notifications if n["method"] == "window/logMessage")))
  > print(c.end())
  > END
  []
  ('0:0-0:0', 'internal error in Files: nobody knows why')
  None y :: Float
  [] gain :: n[1/s]
  ('0:0-0:0', 'internal error in frobc: Not_found')
  None y :: Float
  [] gain :: n[1/s]
  ('2:0-2:25', 'the program is too large, or nested too deeply, for the stack of frobc\nnote: this is its largest definition, with 26 characters\nhint: split it into several definitions\nhint: or run `ulimit -s unlimited` to allow a larger stack')
  None y :: Float
  [] gain :: n[1/s]
  ('0:0-0:0', 'frobc gave up after 8 s')
  None y :: Float
  [] gain :: n[1/s]
  ['frobc gave up after 8 s', 'internal error in Files: nobody knows why', 'internal error in frobc: Not_found']
  0

A server that is killed at any time leaves nothing behind that affects another one.

  $ cat > drive.frob <<'END'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = 0.5[1/s] * frontSonar j)
  > END
  $ cp drive.frob before.frob
  $ python3 - <<'END'
  > from client import *
  > for wait in [0, 0.01, 0.03, 0.1, 0.3]:
  >     c = Client(".")
  >     u = c.open("drive.frob")
  >     c.change(u, c.texts[u][0].replace("0.5", "0.25"))
  >     c.send_request("textDocument/formatting", {"textDocument": {"uri": u}, "options": {}})
  >     time.sleep(wait)
  >     c.process.kill()
  >     c.process.wait()
  > c = Client(".")
  > u = c.open("drive.frob")
  > print([(place(d["range"]), d["message"].split("\n")[0]) for d in c.told(u)], c.end())
  > END
  [('3:30-3:31', 'unknown name `j`')] 0
  $ cmp drive.frob before.frob; ls -a -I '*.t'
  .
  ..
  Bug.frob
  Crash.frob
  Deep.frob
  Slow.frob
  before.frob
  client.py
  drive.frob
  faulty_server.exe
  random_edits.py

In a program of 200 modules, the one on which all others depend is changed, and
fixed.

  $ mkdir large
  $ python3 - <<'END'
  > import time
  > from client import *
  > for n in range(200):
  >     with open("large/M%d.frob" % n, "w") as file:
  >         below = sorted({n // 2, n - 1}) if n else []
  >         file.write("".join("import qualified M%d\n" % k for k in below if k < n))
  >         file.write("\n-- | Number %d.\ngain%d :: Float[1/s]\n" % (n, n))
  >         file.write("gain%d = 1[1/s]%s\n" % (n, "".join(" + M%d.gain%d" % (k, k) for k in below if k < n)))
  > c = Client("large")
  > top = c.open("M199.frob")
  > base = c.open("M0.frob")
  > print(c.told(top), c.told(base))
  > c.change(base, "gain0 = 1[1/m]\n")
  > print([(place(d["range"]), d["message"].split("\n")[0]) for d in c.told(top, bool)])
  > c.change(base, "gain0 :: Float[1/s]\ngain0 = 1[1/s]\n")
  > print(c.told(top, lambda diagnostics: not diagnostics))
  > print(len(c.request("workspace/symbol", {"query": "gain"})))
  > print(len(c.ask("references", base, "gain0 =", context={"includeDeclaration": True})))
  > found = c.ask("rename", base, "gain0 =", newName="first")
  > print(sorted(u.split("/")[-1] for u in found["changes"]))
  > print(c.end(), [n for n in c.notifications if "logMessage" in n.get("method", "")])
  > END
  [] []
  [('0:0-0:0', 'in M1.frob: the operands of `+` have different units: `1/s` and `1/m`')]
  []
  200
  3
  ['M0.frob', 'M1.frob']
  0 []
