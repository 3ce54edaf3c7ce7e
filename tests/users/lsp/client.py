"""A client of `frobc lsp` for tests: starts the server, and communicates with it as an editor
does.
"""

import json
import os
import select
import subprocess
import time


class Client:
    def __init__(self, folder, encodings=None, options=None, start=True, command=("frobc", "lsp")):
        self.process = subprocess.Popen(
            list(command), stdin=subprocess.PIPE, stdout=subprocess.PIPE
        )
        self.buffer = b""
        self.last_id = 0
        self.diagnostics = {}  # the latest ones, by URI
        self.versions = {}
        self.notifications = []
        self.texts = {}
        self.folder = folder
        if start:
            general = {"positionEncodings": encodings} if encodings else {}
            self.capabilities = self.request(
                "initialize",
                {
                    "processId": os.getpid(),
                    "rootUri": None,
                    "workspaceFolders": [{"uri": self.uri(""), "name": "here"}],
                    "initializationOptions": options or {},
                    "capabilities": {
                        "general": general,
                        "textDocument": {
                            "completion": {"completionItem": {"snippetSupport": True}}
                        },
                    },
                },
            )["capabilities"]
            self.notify("initialized", {})

    def uri(self, name):
        path = (
            os.path.join(os.path.abspath(self.folder), name)
            if name
            else os.path.abspath(self.folder)
        )
        return "file://" + path

    def send_bytes(self, data):
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def send(self, message):
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.send_bytes(b"Content-Length: %d\r\n\r\n%s" % (len(body), body))

    def receive(self, timeout=60):
        """Returns the next message, or None."""
        deadline = time.monotonic() + timeout
        while True:
            head, sep, rest = self.buffer.partition(b"\r\n\r\n")
            if sep:
                length = int(head.split(b":")[1])
                if len(rest) >= length:
                    self.buffer = rest[length:]
                    return json.loads(rest[:length])
            left = deadline - time.monotonic()
            if left <= 0 or not select.select([self.process.stdout], [], [], left)[0]:
                return None
            data = os.read(self.process.stdout.fileno(), 1 << 16)
            if not data:
                return None
            self.buffer += data

    def note(self, message):
        if message.get("method") == "textDocument/publishDiagnostics":
            params = message["params"]
            self.diagnostics[params["uri"]] = params["diagnostics"]
            self.versions[params["uri"]] = params.get("version")
        else:
            self.notifications.append(message)

    def send_request(self, method, params):
        self.last_id += 1
        self.send({"id": self.last_id, "method": method, "params": params})
        return self.last_id

    def answer(self, id):
        while True:
            message = self.receive()
            assert message is not None, "no answer: status %s" % self.process.poll()
            if message.get("id") == id and "method" not in message:
                return message
            self.note(message)

    def request(self, method, params):
        message = self.answer(self.send_request(method, params))
        assert "error" not in message, message
        return message["result"]

    def error(self, method, params):
        return self.answer(self.send_request(method, params))["error"]

    def notify(self, method, params):
        self.send({"method": method, "params": params})

    # Texts and positions

    def open(self, name, text=None):
        uri = self.uri(name) if ":" not in name else name
        if text is None:
            with open(os.path.join(self.folder, name), newline="") as file:
                text = file.read()
        self.texts[uri] = (text, 1)
        self.diagnostics.pop(uri, None)
        self.notify(
            "textDocument/didOpen",
            {"textDocument": {"uri": uri, "languageId": "frob", "version": 1, "text": text}},
        )
        return uri

    def change(self, uri, text):
        version = self.texts[uri][1] + 1
        self.texts[uri] = (text, version)
        self.notify(
            "textDocument/didChange",
            {"textDocument": {"uri": uri, "version": version}, "contentChanges": [{"text": text}]},
        )

    def edit(self, uri, range, text):
        version = self.texts[uri][1] + 1
        self.texts[uri] = (None, version)
        self.notify(
            "textDocument/didChange",
            {
                "textDocument": {"uri": uri, "version": version},
                "contentChanges": [{"range": range, "text": text}],
            },
        )

    def told(self, uri, are_there=lambda diagnostics: True):
        """Returns the diagnostics of the current text. After a change of another file, waits until
        `are_there` holds for them."""
        while (
            self.versions.get(uri) != self.texts[uri][1]
            or uri not in self.diagnostics
            or not are_there(self.diagnostics[uri])
        ):
            message = self.receive()
            assert message is not None, "no diagnostics: status %s" % self.process.poll()
            self.note(message)
        return self.diagnostics[uri]

    def at(self, uri, mark, inside=0, nth=1):
        """Returns the position of a piece of the text, in UTF-16 units."""
        text = self.texts[uri][0]
        offset = -1
        for _ in range(nth):
            offset = text.index(mark, offset + 1)
        offset += inside
        before = text[:offset]
        line = before.count("\n")
        column = len(before[before.rfind("\n") + 1 :].encode("utf-16-le")) // 2
        return {"textDocument": {"uri": uri}, "position": {"line": line, "character": column}}

    def ask(self, method, uri, mark, inside=0, nth=1, **more):
        """Sends a request about a position; returns the result, or the error's message."""
        answer = self.answer(
            self.send_request("textDocument/" + method, {**self.at(uri, mark, inside, nth), **more})
        )
        return answer["error"]["message"] if "error" in answer else answer["result"]

    def ask_all(self, method, uri, **more):
        return self.request("textDocument/" + method, {"textDocument": {"uri": uri}, **more})

    def end(self):
        self.request("shutdown", None)
        self.notify("exit", None)
        return self.process.wait(timeout=30)


def place(range):
    """Formats a range: line:character-line:character, from 0."""
    start, end = range["start"], range["end"]
    return "%d:%d-%d:%d" % (start["line"], start["character"], end["line"], end["character"])
