A test file, NAME.test.frob, is checked together with the program next to it: mistakes, hover,
definitions and lenses refer to its own text.

  $ export PYTHONPATH=$PWD PYTHONDONTWRITEBYTECODE=1
  $ cat > halves.frob <<'END'
  > import Trial
  > 
  > -- | Half a speed.
  > gentle :: Velocity -> Velocity
  > gentle v = v / 2
  > 
  > main :: SF Velocity Velocity
  > main = arr gentle
  > 
  > test "is linear" = during 1[s] (proc () -> gentle 0 == 0)
  > END
  $ cat > halves.test.frob <<'END'
  > import Sources (sine)
  > 
  > test "halves a speed" = during 1[s] (proc () -> gentle 0.4[m/s] == half)
  > 
  > half :: Velocity
  > half = 0.2[m/s]
  > END
  $ cat > session.py <<'END'
  > import json
  > from client import *
  > client = Client(".")
  > tests = client.open("halves.test.frob")
  > def show(*things):
  >     print(*(json.dumps(t) if isinstance(t, (dict, list)) else t for t in things))
  > def told():
  >     for d in client.told(tests):
  >         show(place(d["range"]), d["message"].split("\n")[0])
  > told()
  > show(client.ask("hover", tests, "gentle")["contents"]["value"])
  > found = client.ask("definition", tests, "gentle")
  > show(found["uri"].split("/")[-1], place(found["range"]))
  > found = client.ask("definition", tests, "half)")
  > show(found["uri"].split("/")[-1], place(found["range"]))
  > program = client.open("halves.frob")
  > client.told(program)
  > for uri in (program, tests):
  >     for l in client.ask_all("codeLens", uri):
  >         arguments = [a.split("/")[-1] for a in l["command"]["arguments"]]
  >         show(place(l["range"]), l["command"]["command"], l["command"]["title"], arguments)
  > for r in client.ask("references", program, "gentle v"):
  >     show(r["uri"].split("/")[-1], place(r["range"]))
  > client.change(tests, client.texts[tests][0].replace("gentle 0.4[m/s]", "gentle 0.4[s]"))
  > told()
  > client.change(tests, client.texts[tests][0].replace("gentle 0.4[s]", "gentle 0.4[m/s]"))
  > told()
  > del client.diagnostics[tests]
  > client.change(program, client.texts[program][0].replace("gentle", "soft"))
  > told()
  > client.end()
  > END
  $ python3 session.py
  0:16-0:20 `sine` is imported but not used
  ```frob
  gentle :: Velocity -> Velocity
  ```
  
  Half a speed.
  halves.frob 4:0-4:6
  halves.test.frob 5:0-5:4
  7:0-7:0 frob.report 1 byte of state, at most 1 operation in a step ["halves.frob"]
  9:0-9:0 frob.test run this test ["halves.frob", "is linear"]
  2:0-2:0 frob.test run this test ["halves.test.frob", "halves a speed"]
  halves.frob 3:0-3:6
  halves.frob 4:0-4:6
  halves.frob 7:11-7:17
  halves.frob 9:43-9:49
  halves.test.frob 2:48-2:54
  2:55-2:61 expected the unit `m/s`, found `s`
  0:16-0:20 `sine` is imported but not used
  2:48-2:54 unknown name `gentle`
