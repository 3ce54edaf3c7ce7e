Invalid and unusual input: the server answers, and keeps running.

  $ export PYTHONPATH=$PWD PYTHONDONTWRITEBYTECODE=1

Requests before any text is open, and about texts that are not; input that is not JSON, not a
request, or not a known method.

  $ python3 - <<'END'
  > from client import *
  > c = Client(".")
  > at = {"textDocument": {"uri": c.uri("nowhere.frob")}, "position": {"line": 0, "character": 0}}
  > for method in ["hover", "definition", "completion", "rename", "codeLens", "formatting"]:
  >     print(method, c.request("textDocument/" + method, at))
  > def body(data):
  >     c.send_bytes(b"Content-Length: %d\r\n\r\n" % len(data) + data)
  >     print(c.receive()["error"])
  > body(b"{")
  > body(b"\xff\xfe\x00")
  > body(b"[" * 100000)
  > body(b"17")
  > body(b"{}")
  > c.send_bytes(b"Nonsense\r\n\r\n")
  > c.send_bytes(b"Content-Length: -5\r\n\r\n")
  > c.send_bytes(b"content-length: 99999999999999999999\r\n\r\n")
  > print(c.error("textDocument/fly", {}))
  > print(c.request("textDocument/hover", None), c.request("textDocument/hover", []))
  > print(c.request("textDocument/hover", {"textDocument": 3, "position": "x"}))
  > c.notify("textDocument/didChange", {"textDocument": {"uri": 7}, "contentChanges": 1})
  > c.notify("textDocument/didOpen", None)
  > c.notify("fly", {})
  > print(c.end())
  > END
  hover None
  definition None
  completion None
  rename None
  codeLens None
  formatting None
  {'code': -32700, 'message': 'the message is not valid JSON'}
  {'code': -32700, 'message': 'the message is not valid JSON'}
  {'code': -32700, 'message': 'the message is not valid JSON'}
  {'code': -32600, 'message': 'the message must be a JSON object'}
  {'code': -32600, 'message': 'no method'}
  {'code': -32601, 'message': 'there is no method textDocument/fly'}
  None None
  None
  0

A request that is cancelled before its turn has no other answer. The input may end at any time.

  $ python3 - <<'END'
  > from client import *
  > c = Client(".")
  > frames = b""
  > place = {"textDocument": {"uri": c.uri("closed.frob")}, "position": {"line": 0, "character": 0}}
  > for message in [{"id": 1000, "method": "textDocument/hover", "params": place},
  >                 {"id": 1001, "method": "textDocument/hover", "params": place},
  >                 {"method": "$/cancelRequest", "params": {"id": 1001}}]:
  >     data = json.dumps({"jsonrpc": "2.0", **message}).encode()
  >     frames += b"Content-Length: %d\r\n\r\n%s" % (len(data), data)
  > c.send_bytes(frames)
  > print(c.answer(1000)["result"], c.answer(1001)["error"])
  > c.process.stdin.close()
  > print(c.process.wait())
  > c = Client(".")
  > c.send_bytes(b"Content-Length: 100\r\n\r\n{")
  > c.process.stdin.close()
  > print(c.process.wait())
  > END
  None {'code': -32800, 'message': 'cancelled'}
  1
  1

Positions are counted in the negotiated encoding, which is UTF-16 by default.

  $ python3 - <<'END'
  > from client import *
  > text = '-- \U0001f916\nmain :: SF Float Float\nmain = proc x -> {- \U0001f916 ä -} y\r\n'
  > for encodings in [None, ["utf-16"], ["utf-8", "utf-16"], ["utf-32"], ["utf-7"]]:
  >     c = Client(".", encodings=encodings)
  >     u = c.open("robot.frob", text)
  >     print(c.capabilities["positionEncoding"], place(c.told(u)[0]["range"]))
  >     c.end()
  > c = Client(".")
  > u = c.open("robot.frob", text)
  > at = lambda line, a, b: {"start": {"line": line, "character": a}, "end": {"line": line, "character": b}}
  > c.edit(u, at(2, 20, 22), "\U0001f600\U0001f600")
  > print(place(c.told(u)[0]["range"]))
  > c.edit(u, at(2, 30, 31), "x")
  > print(c.told(u))
  > c.edit(u, at(99, 5, 99), "\nfoo = bar\n")
  > print(place(c.told(u)[0]["range"]))
  > c.end()
  > END
  utf-16 2:28-2:29
  utf-16 2:28-2:29
  utf-8 2:31-2:32
  utf-32 2:27-2:28
  utf-16 2:28-2:29
  2:30-2:31
  []
  4:6-4:9

Unsaved texts, in several folders, and one without a file; when a module changes, all texts that
import it are checked again.

  $ mkdir one two
  $ python3 - <<'END'
  > from client import *
  > c = Client("one")
  > c.notify("workspace/didChangeWorkspaceFolders", {"event": {
  >     "added": [{"uri": c.uri("../two"), "name": "two"}], "removed": []}})
  > gains = c.open("Gains.frob", "kTurn = 4[1/s]\n")
  > main = c.open("main.frob", "import Gains\n\nmain :: SF Float[s] Float\nmain = proc x -> kTurn * x\n")
  > print(c.told(gains), c.told(main))
  > c.change(gains, "kTurn = 4[1/m]\n")
  > c.diagnostics.clear()
  > print([d["message"].split("\n")[0] for d in c.told(main)])
  > c.change(gains, "kTurn = 4[1/s]\nkSpeed = \n")
  > c.diagnostics.clear()
  > print([(place(d["range"]), d["message"].split("\n")[0]) for d in c.told(main)])
  > other = c.open(c.uri("../two/other.frob").replace("one/../", ""), "speed = 1[m/s]\n")
  > c.told(other)
  > print(sorted(s["name"] for s in c.request("workspace/symbol", {"query": ""})))
  > new = c.open("untitled:Untitled-1", "main :: SF Float Float\nmain = proc x -> x + 1[m]\n")
  > print([d["code"] for d in c.told(new)])
  > c.notify("textDocument/didClose", {"textDocument": {"uri": new}})
  > print(c.request("textDocument/hover", {"textDocument": {"uri": new}, "position": {"line": 0, "character": 0}}), c.diagnostics[new])
  > print(c.end())
  > END
  [] []
  ['expected no unit, found `s/m`']
  [('0:0-0:12', 'in Gains.frob: expected the value of the definition after `=`, found the end of the file')]
  ['main', 'speed']
  ['E0320']
  None []
  0

A file that is not UTF-8, a missing file, and a folder: the error is reported where it is imported.

  $ printf 'x = "\377"\n' > Bytes.frob
  $ mkdir Folder.frob
  $ python3 - <<'END'
  > from client import *
  > c = Client(".")
  > u = c.open("main.frob", "import Bytes\nimport Folder\nimport Gone\n\nmain :: SF Float Float\nmain = proc x -> x\n")
  > for d in c.told(u):
  >     print(place(d["range"]), d["message"].split("\n")[0])
  > c.end()
  > END
  0:0-0:12 in Bytes.frob: this file is not valid UTF-8: byte 255 is not allowed here
  1:7-1:13 cannot read `$TESTCASE_ROOT/Folder.frob`: it is a directory
  2:7-2:11 there is no module `Gone`

A text of 100,000 lines, one with a single line, and one that is nested too
deeply.

  $ python3 - <<'END'
  > from client import *
  > c = Client(".")
  > for name, text in [("long", "main :: SF Float Float\nmain = proc x -> x\n" + "-- and so on\n" * 100000),
  >                    ("wide", "main :: SF Float Float\nmain = proc x -> x" + " + x" * 20000 + "\n"),
  >                    ("deep", "main :: SF Float Float\nmain = proc x -> " + "(" * 50000 + "x" + ")" * 50000)]:
  >     u = c.open(name + ".frob", text)
  >     print(name, [d["code"] for d in c.told(u)])
  >     at = {"textDocument": {"uri": u}, "position": {"line": 1, "character": 17}}
  >     for method in ["hover", "completion", "foldingRange", "documentSymbol", "semanticTokens/full", "formatting"]:
  >         c.request("textDocument/" + method, at)
  >     c.notify("textDocument/didClose", {"textDocument": {"uri": u}})
  > print(c.end(), [n for n in c.notifications if "logMessage" in n.get("method", "")])
  > END
  long []
  wide ['E0106']
  deep ['E0106']
  0 []
