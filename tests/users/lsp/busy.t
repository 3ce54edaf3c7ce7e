A text that uses its whole budget does not delay other texts, and work that an edit made useless is
dropped. The test checks the order of answers, not their times.

  $ export PYTHONPATH=$PWD PYTHONDONTWRITEBYTECODE=1
  $ export FROB_HOME=$(dirname $(dirname $(which frobc)))
  $ cat > session.py <<'END'
  > from client import *
  > 
  > def next_answers(c, count):
  >     """The ids of the next answers, in the order in which they come."""
  >     ids = []
  >     while len(ids) < count:
  >         message = c.receive()
  >         if "id" in message and "method" not in message:
  >             ids.append(message["id"])
  >             c.answers[message["id"]] = message
  >         else:
  >             c.note(message)
  >     return ids
  > 
  > def hover(c, uri, line, character):
  >     return c.send_request("textDocument/hover", {
  >         "textDocument": {"uri": uri}, "position": {"line": line, "character": character}})
  > 
  > def together(c, *sends):
  >     """As one piece, so that the server has all of it when it begins."""
  >     pieces = []
  >     send_bytes, c.send_bytes = c.send_bytes, pieces.append
  >     ids = [send() for send in sends]
  >     c.send_bytes = send_bytes
  >     c.send_bytes(b"".join(pieces))
  >     return ids
  > 
  > def firsts(c):
  >     return {uri.split("/")[-1]: [(d.get("code"), d["message"].split("\n")[0]) for d in ds]
  >             for uri, ds in sorted(c.diagnostics.items())}
  > 
  > small = "main :: SF Float Float\nmain = proc x -> y where\n    y = 2 * x\n"
  > 
  > # Modes in all combinations of fourteen signal functions.
  > n = range(14)
  > row = lambda j: " ".join("b" if i == j else "s%d" % i for i in n)
  > combinations = (
  >     "a, b :: SF Float Float\na = delay 1\nb = delay 2 >>> delay 3\n"
  >     "go :: " + "SF Float Float -> " * 14 + "SF (Float, Bool) Float\n"
  >     "go " + " ".join("s%d" % i for i in n) + " = switch (proc (x, e) -> (s0 x, tag (edge e) x)) (\\v -> "
  >     + "".join("if v > %d then go %s else " % (j, row(j)) for j in n) + "s0 <<< arr fst)\n"
  >     "main :: SF (Float, Bool) Float\nmain = go" + " a" * 14 + "\n")
  > END

The request about the large text comes first. Its answer comes last, after those about the small
text.

  $ python3 - <<'END'
  > from session import *
  > c = Client(".")
  > c.answers = {}
  > large, other = c.open("large.frob", combinations), c.open("small.frob", small)
  > asked = together(c,
  >     lambda: hover(c, large, 5, 0), lambda: hover(c, other, 2, 4),
  >     lambda: hover(c, other, 1, 7))
  > order = next_answers(c, 3)
  > print([asked.index(id) for id in order])
  > print(c.answers[asked[1]]["result"]["contents"]["value"].split("\n")[1])
  > print(c.answers[asked[0]]["result"]["contents"]["value"].split("\n")[1])
  > print(firsts(c))
  > print(c.end())
  > END
  [1, 2, 0]
  y :: Float
  main :: SF (Float, Bool) Float
  {'large.frob': [('E0413', 'the state machine of `go` has too many modes: more than 5452')], 'small.frob': []}
  0

Even if the compiler never terminates on one text, the server answers requests about the small text,
which can be edited. The edit that removes the fault ends the work, whose result is discarded. A
cancelled request is answered immediately, closing a text ends its work too, and no process is left
behind.

  $ echo 'gain = 2[1/s]' > Slow.frob; touch Slow.fault
  $ python3 - <<'END'
  > from session import *
  > c = Client(".", command=["./faulty_server.exe", "600"])
  > c.answers = {}
  > endless = "import Slow\n\nmain :: SF Float[s] Float\nmain = proc x -> gain * x\n"
  > slow, other = c.open("slow.frob", endless), c.open("small.frob", small)
  > asked = together(c, lambda: hover(c, slow, 3, 0), lambda: hover(c, other, 2, 4))
  > print([asked.index(id) for id in next_answers(c, 1)])
  > c.change(other, small.replace("2", "z"))
  > print([(place(d["range"]), d["message"].split("\n")[0]) for d in c.told(other)])
  > cancelled = hover(c, slow, 3, 0)
  > c.notify("$/cancelRequest", {"id": cancelled})
  > print([id == cancelled for id in next_answers(c, 1)], c.answers[cancelled]["error"]["message"])
  > c.change(slow, small)
  > print([id == asked[0] for id in next_answers(c, 1)], c.told(slow), c.versions[slow])
  > second = c.open("second.frob", endless)
  > question = hover(c, second, 3, 0)
  > c.notify("textDocument/didClose", {"textDocument": {"uri": second}})
  > print(next_answers(c, 1) == [question], c.answers[question]["result"])
  > third = c.open("third.frob", endless)
  > hover(c, third, 3, 0)
  > print(c.ask("hover", slow, "y where")["contents"]["value"].split("\n")[1])
  > with open("/proc/%d/task/%d/children" % (c.process.pid, c.process.pid)) as file:
  >     workers = file.read().split()
  > print(c.end(), [n for n in c.notifications if "logMessage" in n.get("method", "")])
  > print(len(workers), [pid for pid in workers if os.path.exists("/proc/" + pid)])
  > END
  [1]
  [('2:8-2:9', 'unknown name `z`')]
  [True] cancelled
  [True] [] 2
  True None
  y :: Float
  0 []
  1 []
