The features that the server offers to editors, one after the other.

  $ export PYTHONPATH=$PWD PYTHONDONTWRITEBYTECODE=1
  $ cat > Gains.frob <<'END'
  > -- | How fast to turn for each metre off the wall.
  > kTurn :: Float[1/(m s)]
  > kTurn = 4[1/(m s)]
  > 
  > -- | Where to stop.
  > data Stop = Stop { ahead :: Distance, after :: Time }
  > END
  $ cat > drive.frob <<'END'
  > import Gains
  > import Robot
  > 
  > stop = Stop { ahead = 0.5[m], after = 3[s] }
  > 
  > -- | Slower, the nearer it is.
  > approach :: Distance -> SF Distance Velocity
  > approach d = proc x -> v where
  >     way = x - d
  >     v = 0.5[1/s] * way
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (approach stop.ahead (frontSonar i)) omega) where
  >     omega = kTurn * (sideSonar i - 0.3[m]))
  > END
  $ cat > ask.py <<'END'
  > import json, sys
  > from client import *
  > client = Client(".", options={"inlayHints": True})
  > drive = client.open("drive.frob")
  > client.told(drive)
  > def hover(mark, inside=0, nth=1):
  >     found = client.ask("hover", drive, mark, inside, nth)
  >     print(found["contents"]["value"] if found else None)
  > def short(location):
  >     return location["uri"].split("/")[-1] + " " + place(location["range"])
  > def show(*things):
  >     print(*(json.dumps(t) if isinstance(t, (dict, list)) else t for t in things))
  > def change(before, after):
  >     client.change(drive, client.texts[drive][0].replace(before, after))
  > def labels(mark, inside):
  >     items = client.ask("completion", drive, mark, inside)["items"]
  >     return [i["label"] for i in sorted(items, key=lambda i: i["sortText"])]
  > END

Hover: a name's type with units, its level, its doc comment; for other expressions the type.

  $ python3 - <<'END'
  > from ask import *
  > for mark in ["approach", "kTurn *", "way\n", "ahead (", "Stop {", "m])", "0.5[1/s]", "frontSonar"]:
  >     print("--", mark.strip())
  >     hover(mark)
  > client.end()
  > END
  -- approach
  ```frob
  approach :: Distance -> SF Distance Velocity
  ```
  
  Slower, the nearer it is.
  -- kTurn *
  ```frob
  kTurn :: Float[1/(m s)]
  ```
  
  How fast to turn for each metre off the wall.
  
  *from `Gains`*
  -- way
  ```frob
  way :: Float[m]
  ```
  
  *signal*
  -- ahead (
  ```frob
  ahead :: Distance
  ```
  
  *field of `Stop`*
  -- Stop {
  ```frob
  data Stop = Stop { ahead :: Distance, after :: Time }
  ```
  
  Where to stop.
  
  *from `Gains`*
  -- m])
  ```frob
  unit m
  ```
  
  *from `Prelude`*
  -- 0.5[1/s]
  ```frob
  :: Float[1/s]
  ```
  -- frontSonar
  ```frob
  frontSonar :: SF i Distance
  ```
  
  The distance from the robot's front to the nearest object ahead.
  
  *from `Capability`*

Definitions in any module; symbols of the text and of all programs.

  $ python3 - <<'END'
  > from ask import *
  > for mark, inside in [("kTurn *", 0), ("way\n", 0), ("ahead (", 0), ("import Gains", 8), ("frontSonar", 0)]:
  >     show(mark.strip(), short(client.ask("definition", drive, mark, inside)))
  > def tree(symbols, depth=0):
  >     for s in symbols:
  >         show("  " * depth + s["name"], s["kind"], place(s["range"]))
  >         tree(s["children"], depth + 1)
  > tree(client.ask_all("documentSymbol", drive))
  > for s in client.request("workspace/symbol", {"query": "ktn"}):
  >     show(s["name"], s["containerName"], short(s["location"]))
  > client.end()
  > END
  kTurn * Gains.frob 2:0-2:5
  way drive.frob 8:4-8:7
  ahead ( Gains.frob 5:19-5:24
  import Gains Gains.frob 0:0-0:0
  frontSonar Capability.frob 47:4-47:14
  stop 14 3:0-3:44
  approach 12 7:0-9:22
    way 13 8:4-8:15
    v 13 9:4-9:22
  main 12 11:0-12:43
    omega 13 12:4-12:42
  kTurn Gains Gains.frob 2:0-2:5

References and renaming cover all programs of the folders. A renaming that would change the meaning
of a name is rejected.

  $ python3 - <<'END'
  > from ask import *
  > for mark in ["kTurn *", "ahead (", "x - d"]:
  >     for r in client.ask("references", drive, mark, context={"includeDeclaration": True}):
  >         show(mark, short(r))
  > def rename(mark, name):
  >     found = client.ask("rename", drive, mark, newName=name)
  >     show(mark, "->", name, *([found] if isinstance(found, str) else
  >         ["%s: %s" % (u.split("/")[-1], ", ".join(place(e["range"]) for e in es))
  >          for u, es in sorted(found["changes"].items())]))
  > rename("kTurn *", "kOmega")
  > rename("ahead (", "wayAhead")
  > rename("way\n", "x")
  > rename("way\n", "Way")
  > rename("way\n", "where")
  > rename("kTurn *", "approach")
  > rename("Stop {", "Halt")
  > rename("frontSonar", "sonar")
  > show(client.ask("prepareRename", drive, "frontSonar"), client.ask("prepareRename", drive, "way\n"))
  > client.end()
  > END
  kTurn * drive.frob 12:12-12:17
  kTurn * Gains.frob 1:0-1:5
  kTurn * Gains.frob 2:0-2:5
  ahead ( drive.frob 3:14-3:19
  ahead ( drive.frob 11:66-11:71
  ahead ( Gains.frob 5:19-5:24
  x - d drive.frob 7:18-7:19
  x - d drive.frob 8:10-8:11
  kTurn * -> kOmega Gains.frob: 2:0-2:5, 1:0-1:5 drive.frob: 12:12-12:17
  ahead ( -> wayAhead Gains.frob: 5:19-5:24 drive.frob: 11:66-11:71, 3:14-3:19
  way
   -> x `x` already has a different meaning in drive.frob
  way
   -> Way this name must begin with a lower-case letter, unlike `Way`
  way
   -> where `where` is not a valid name
  kTurn * -> approach `approach` already has a different meaning in drive.frob
  Stop { -> Halt Gains.frob: 5:12-5:16 drive.frob: 3:7-3:11
  frontSonar -> sonar `frontSonar` belongs to the library
  None {"range": {"start": {"line": 9, "character": 19}, "end": {"line": 9, "character": 22}}, "placeholder": "way"}

Code actions: fixes for messages, and a signature.

  $ python3 - <<'END'
  > from ask import *
  > def actions(mark):
  >     client.told(drive)
  >     at = client.at(drive, mark)["position"]
  >     for a in client.ask_all("codeAction", drive, range={"start": at, "end": at}, context={"diagnostics": []}):
  >         edits = [e for es in a["edit"]["changes"].values() for e in es]
  >         show(a["kind"], a["title"], [[place(e["range"]), e["newText"]] for e in edits])
  > actions("stop =")
  > change("kTurn *", "kTrun *")
  > actions("kTrun *")
  > change("kTrun *", "kTurn *")
  > change("import Robot\n", "")
  > actions("reactimateRobot")
  > client.end()
  > END
  refactor.rewrite add the signature of `stop` [["3:0-3:0", "stop :: Stop\n"]]
  quickfix write `kTurn` [["12:12-12:17", "kTurn"]]
  quickfix add `import Robot` [["0:12-0:12", "\nimport Robot"]]

Completion according to the text around the cursor, also while the text is
invalid.

  $ python3 - <<'END'
  > from ask import *
  > change("0.5[1/s] * way", "0.5[1/s] * w")
  > show(labels("* w", 3)[:4])
  > change("stop.ahead", "stop.")
  > show(labels("stop.", 5))
  > change("3[s]", "3[")
  > show([l for l in labels("3[", 2) if l in ["m", "s", "kg", "deg", "way", "sin"]])
  > change("import Gains", "import ")
  > show([l for l in labels("import ", 7) if l in ["Control", "Gains", "drive", "sin"]])
  > change("import \n", "import Gains (\n")
  > show(labels("Gains (", 7))
  > change("SF Distance Velocity", "SF Di")
  > show([l for l in labels("SF Di", 5) if l.startswith("Dis")])
  > change("omega = kTurn", "omega = lim")
  > items = client.ask("completion", drive, "= lim", 5)["items"]
  > show([[i["label"], i["detail"], i["additionalTextEdits"]] for i in items if i["label"] == "limit"])
  > items = client.ask("completion", drive, "= lim", 5)["items"]
  > item = client.request("completionItem/resolve", [i for i in items if i["label"] == "integral"][0])
  > show(item["detail"], item["documentation"]["value"])
  > client.end()
  > END
  ["d", "v", "way", "x"]
  ["after", "ahead"]
  ["deg", "kg", "m", "s"]
  ["Control", "Gains"]
  ["Stop", "kTurn"]
  ["Distance"]
  [["limit", "import Control", [{"range": {"start": {"line": 1, "character": 12}, "end": {"line": 1, "character": 12}}, "newText": "\nimport Control"}]]]
  SF Float[u] Float[u s] 0 at the first instant; each later step adds its length times the previous input.

Signature help while arguments are typed.

  $ python3 - <<'END'
  > from ask import *
  > def help(mark):
  >     found = client.ask("signatureHelp", drive, mark, len(mark))
  >     show(found and [found["signatures"][0]["label"], found["activeParameter"]])
  > change("0.5[1/s] * way", "approach ")
  > help("v = approach ")
  > change("v = approach ", "v = approach 3[m] ")
  > help("v = approach 3[m] ")
  > change("v = approach 3[m] ", "v = approach (3[m] + d) x ")
  > help("v = approach (3[m] + d) x ")
  > help("v = approach (3[m] + ")
  > client.end()
  > END
  ["approach :: Distance -> SF Distance Velocity", 0]
  ["approach :: Distance -> SF Distance Velocity", 1]
  None
  None

Lenses above the entry, hints after names without a signature, colours by level, folding and
selections.

  $ python3 - <<'END'
  > from ask import *
  > for l in client.ask_all("codeLens", drive):
  >     show(place(l["range"]), l["command"]["command"], l["command"]["title"])
  > whole = {"start": {"line": 0, "character": 0}, "end": {"line": 99, "character": 0}}
  > for h in client.ask_all("inlayHint", drive, range=whole):
  >     show(h["position"]["line"], h["label"])
  > legend = client.capabilities["semanticTokensProvider"]["legend"]
  > data = client.ask_all("semanticTokens/full", drive)["data"]
  > lines = client.texts[drive][0].split("\n")
  > line = column = 0
  > for i in range(0, len(data), 5):
  >     if data[i]: column = 0
  >     line += data[i]; column += data[i + 1]
  >     word = lines[line][column:column + data[i + 2]]
  >     modifiers = [m for k, m in enumerate(legend["tokenModifiers"]) if data[i + 4] >> k & 1]
  >     if line >= 7: show(word, legend["tokenTypes"][data[i + 3]], *modifiers)
  > for f in client.ask_all("foldingRange", drive):
  >     show("fold", f["startLine"], f["endLine"], f.get("kind", ""))
  > at = client.at(drive, "way\n")["position"]
  > s = client.ask_all("selectionRange", drive, positions=[at])[0]
  > while s:
  >     show("select", place(s["range"])); s = s.get("parent")
  > client.end()
  > END
  11:0-11:0 frob.report 248 bytes of state, at most 638 operations in a step
  11:0-11:0 frob.run run in the simulator
  3  :: Stop
  8  :: Float[m]
  9  :: Float[m/s]
  11  :: (HasSonar a, DiffDrive b) => Program a b
  12  :: Float[1/s]
  approach function declaration
  d parameter declaration
  x variable declaration signal
  v variable signal
  way variable declaration signal
  x variable signal
  - function defaultLibrary
  d parameter
  v variable declaration signal
  s unit defaultLibrary
  * function defaultLibrary
  way variable signal
  main variable declaration readonly
  reactimateRobot function defaultLibrary
  i variable declaration signal
  roMake function defaultLibrary
  setVelTR function defaultLibrary
  approach function
  stop variable readonly
  ahead property
  frontSonar function defaultLibrary
  i variable signal
  omega variable signal
  omega variable declaration signal
  kTurn variable readonly
  * function defaultLibrary
  sideSonar function defaultLibrary
  i variable signal
  - function defaultLibrary
  m unit defaultLibrary
  fold 7 9 
  fold 11 12 
  fold 0 1 imports
  select 9:19-9:22
  select 9:8-9:22
  select 9:4-9:22
  select 7:13-9:22
  select 7:0-9:22
  select 0:0-13:0

If a text never was without mistakes, its valid parts still provide information.

  $ python3 - <<'END'
  > from client import *
  > client = Client(".")
  > u = client.open("broken.frob", "f :: Float[m] -> Float[m]\nf x = 2 * x\n\ng = f (3[m] + nothing)\n\nh = = 3\n\nmain :: SF Float[m] Float[m]\nmain = proc x -> y where\n    y = f x\n")
  > print([d["code"] for d in client.told(u)])
  > for mark in ["f x\n", "y where", "x\n\ng"]:
  >     print(client.ask("hover", u, mark)["contents"]["value"].split("\n")[1])
  > print([s["name"] for s in client.ask_all("documentSymbol", u)])
  > print(place(client.ask("definition", u, "y where")["range"]))
  > print(client.ask("rename", u, "y where", newName="z"))
  > client.end()
  > END
  ['E0110']
  f :: Float[m] -> Float[m]
  y :: Float[m]
  x :: Float[m]
  ['f', 'g', 'main']
  9:4-9:5
  frobc cannot resolve the names in this program: fix its errors first
