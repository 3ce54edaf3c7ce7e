"""usage: strangers.py FROBC RUN.csv FILE ROBOT

Tests how the viewer handles requests that are not from its page: from other hosts and sites,
without the token, malformed, or too many."""

import asyncio
import json
import random
import socket
import sys
import threading

import websockets

import viewer
from protocol import ask, connect, greet
from viewer import check


async def refused(v, **changes):
    """Whether the viewer refuses the handshake."""
    try:
        async with connect(v, **changes):
            return False
    except Exception:
        return True


async def closed(v, *messages, greets=False):
    """The code with which the viewer closes after these messages; None if it does not close."""

    async def hear():
        async with connect(v) as client:
            if greets:
                await greet(v, client)
            for message in messages:
                await client.send(message)
            while True:
                await client.recv()

    try:
        await asyncio.wait_for(hear(), 60)
    except websockets.exceptions.ConnectionClosed as end:
        return end.rcvd.code if end.rcvd else 1006
    except asyncio.TimeoutError:
        return None


def http(v, text, until=b"\r\n\r\n"):
    """The response to these bytes, up to `until` or the end; empty if there is none."""
    answer = b""
    with socket.create_connection(("127.0.0.1", v.port), timeout=30) as line:
        line.sendall(text if isinstance(text, bytes) else text.encode("latin-1"))
        try:
            while until not in answer and (more := line.recv(65536)):
                answer += more
        except OSError:
            pass
    return answer.decode("latin-1")


def get(path, host):
    return f"GET {path} HTTP/1.1\r\nHost: {host}\r\n\r\n"


def handshake(host, origin, query=""):
    """The request of a WebSocket handshake."""
    return (
        f"GET /{query} HTTP/1.1\r\nHost: {host}\r\nUpgrade: websocket\r\n"
        f"Connection: Upgrade\r\nOrigin: {origin}\r\n"
        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"
        "Sec-WebSocket-Protocol: frob-view\r\n\r\n"
    )


def strangers(v):
    for host in (
        f"localhost:{v.port}",
        f"127.0.0.1:{v.port}",
        f"[::1]:{v.port}",
        "localhost:9999",
        "localhost",
    ):
        name = host.replace(str(v.port), "PORT")
        check(f"the page is served as {name}", " 200" in http(v, get("/", host)))
        origin = f"http://{host}"
        shown = http(v, handshake(host, origin, f"?{v.token}"), b'"is":"program"')
        check("and answered, if it shows the token", '"is":"program"' in shown)
        check(
            "and else not",
            "the token is wrong"
            in http(v, handshake(host, origin, f"?{'0' * 32}"), b"not the token"),
        )
    for host in (
        "example.org",
        "localhost.example.org",
        f"{v.host}.example.org",
        "127.0.0.1:0",
        "127.0.0.1:65536",
        "127.0.0.1:1x",
        "127.0.0.2",
        "[::1",
        "",
        "localhost:",
        f"{v.host}\0.example.org",
        "localhost\0:9999",
        "\0localhost",
    ):
        name = repr(host.replace(str(v.port), "PORT"))
        check(f"the host {name} is refused", " 200" not in http(v, get("/", host)))
        check(
            "and its WebSocket",
            " 101" not in http(v, handshake(host, f"http://{v.host}", f"?{v.token}")),
        )
    for origin in (
        "http://example.org",
        f"https://{v.host}",
        v.host,
        "null",
        "",
        f"http://{v.host}\0.example.org",
        f"http://{v.host}.example.org",
        "http://localhost@example.org",
    ):
        name = repr(origin.replace(str(v.port), "PORT"))
        check(
            f"the origin {name} is refused",
            " 101" not in http(v, handshake(v.host, origin, f"?{v.token}")),
        )
    refusal = http(v, get("/", "example.org"), b"</html>")
    check("a refusal says what to do", " 403" in refusal and "ssh -L" in refusal)
    for path in (
        "/page.ts",
        "/etc/passwd",
        "//etc/passwd",
        "/%2e%2e/etc/passwd",
        "/page.js\0",
        "/page.js%00",
        "/page.js\0.ts",
    ):
        check(f"there is no {path!r}", " 200" not in http(v, get(path, v.host)))
    check(
        "only GET is answered",
        " 405" in http(v, f"POST / HTTP/1.1\r\nHost: {v.host}\r\nContent-Length: 0\r\n\r\n"),
    )


async def others(v):
    check("no origin is refused", await refused(v, origin=None))
    check("another protocol is refused", await refused(v, subprotocols=["chat"]))
    check("no protocol is refused", await refused(v, subprotocols=None))


async def answers_flood(v, count):
    """The number of answers to many requests at once, on a connection that stays open."""
    async with connect(v) as client:
        await greet(v, client)
        for _ in range(count):
            await client.send("series 0 0 10 1000")
        kinds = []
        while len(kinds) < count:
            kind = json.loads(await client.recv())["is"]
            if kind in ("series", "refused"):
                kinds.append(kind)
        return len(kinds) if (await ask(client, "instant 3"))["k"] == 3 else 0


async def wrong_messages(v):
    check("a token with more after a NUL closes", await closed(v, f"hello {v.token}\0x") == 1008)
    check("a wrong token closes", await closed(v, "hello " + "0" * 32) == 1008)
    check("half a token closes", await closed(v, "hello " + v.token[:16]) == 1008)
    check("a request before the token closes", await closed(v, "program") == 1008)
    check("silence closes", await closed(v) is not None)
    check("bytes that are no text close", await closed(v, b"\0\1", greets=True) == 1003)
    check("a long message before the token closes", await closed(v, "x" * 100) == 1009)
    check("a message over 64 kB closes", await closed(v, "x" * 65537, greets=True) == 1009)
    check("each request of a flood is answered or refused", await answers_flood(v, 500) == 500)


async def nonsense(v, count):
    """Random requests, and random bytes in frames."""
    chance = random.Random(7)
    words = [
        "instant",
        "time",
        "why",
        "find",
        "path",
        "(",
        "not",
        "out.turn",
        "<",
        "/=",
        "[",
        "mode.bug",
        "series",
        "program",
        "hello",
        "-1",
        "0",
        "7",
        "99999999999999999999",
        "1e308",
        "nan",
        "inf",
        "",
        "é",
        "\0",
        '"',
        "\\",
        "0x10",
        "1.5",
    ]
    async with connect(v) as client:
        await greet(v, client)
        cut = await ask(client, "instant 3\0instant 4")
        check("a request with a NUL in it is refused", cut["is"] == "refused")
        answers = [
            await ask(client, " ".join(chance.choices(words, k=chance.randrange(6))))
            for _ in range(count)
        ]
        kinds = {answer["is"] for answer in answers}
        check("nonsense is refused, and harmless", "refused" in kinds)


def frame(chance, opcode, payload, is_last=True, lies=False):
    """A client's WebSocket frame, correct or slightly wrong."""
    length = len(payload)
    if lies:
        length = chance.choice([0, length + 1, 125, 126, 65535, 65536, 2**31, 2**63 - 1, 2**64 - 1])
    flags = (0x80 if is_last else 0) | opcode | (chance.choice([0x10, 0x40, 0x70]) if lies else 0)
    form = (
        chance.choice([7, 16, 64]) if lies else 7 if length < 126 else 16 if length < 65536 else 64
    )
    mask = chance.randbytes(4)
    head = bytes([flags, 0x80 | {7: length & 127, 16: 126, 64: 127}[form]])
    if form != 7:
        head += (length % 2**form).to_bytes(form // 8, "big")
    return head + mask + bytes(byte ^ mask[i % 4] for i, byte in enumerate(payload))


def talk(v, chance):
    """A stranger's connection, who may know the token: sends frames of all kinds, split at random
    places.
    """
    greeting = handshake(v.host, f"http://{v.host}").encode()
    yield greeting if chance.random() < 0.9 else greeting[: chance.randrange(len(greeting))]
    if chance.random() < 0.5:
        yield frame(chance, 1, f"hello {v.token}".encode())
    for _ in range(chance.randrange(1, 20)):
        if chance.random() < 0.1:
            yield chance.randbytes(chance.randrange(1, 3000))
            continue
        text = chance.choice(
            [
                b"instant 3",
                b"series 0 0 1 100",
                b"stop",
                b"program",
                b"\xff\xfe",
                b"",
                chance.randbytes(chance.randrange(200)),
                b"x" * 70000,
            ]
        )
        made = frame(
            chance,
            chance.choice([0, 1, 1, 1, 2, 3, 8, 9, 10, 15]),
            text,
            chance.random() < 0.7,
            chance.random() < 0.2,
        )
        yield made[: chance.randrange(len(made))] if chance.random() < 0.1 else made


def frames(v, count):
    chance = random.Random(11)
    for _ in range(count):
        with socket.create_connection(("127.0.0.1", v.port), timeout=30) as line:
            line.settimeout(0.003)
            for piece in talk(v, chance):
                try:
                    line.sendall(piece)
                    line.recv(65536)
                except OSError:
                    pass  # no data, or closed, which is allowed


class Flood(threading.Thread):
    """Opens connections as fast as it can, and keeps the newest of them open."""

    def __init__(self, v, greeting):
        super().__init__(daemon=True)
        self.v, self.greeting, self.lines, self.over = v, greeting, [], False

    def run(self):
        while not self.over:
            try:
                line = socket.create_connection(("127.0.0.1", self.v.port), timeout=1)
                line.sendall(self.greeting)
                self.lines.append(line)
            except OSError:
                pass
            if len(self.lines) > 200:
                self.lines.pop(0).close()

    def end(self):
        self.over = True
        self.join()
        for line in self.lines:
            line.close()


def is_admitted(v):
    """Whether a page that shows the token in its WebSocket address gets an answer."""
    greeting = handshake(v.host, f"http://{v.host}", f"?{v.token}")
    return '"is":"program"' in http(v, greeting, b'"is":"program"')


async def pages(v):
    clients = [await connect(v) for _ in range(4)]
    for client in clients:
        await greet(v, client)
    check("a fifth page is turned away", await closed(v, greets=True) == 1013)
    check("the four go on", [(await ask(c, "instant 3"))["k"] for c in clients] == [3] * 4)
    await clients.pop().close()
    silent = handshake(v.host, f"http://{v.host}").encode()
    for name, greeting in ("say nothing", b""), ("do not show the token", silent):
        floods = [Flood(v, greeting) for _ in range(2)]
        for flood in floods:
            flood.start()
        while min(len(flood.lines) for flood in floods) < 200:
            await asyncio.sleep(0.01)
        admitted = await asyncio.to_thread(lambda: sum(is_admitted(v) for _ in range(20)))
        check(f"connections that {name} keep no page out", admitted == 20)
        check("nor do they end one", (await ask(clients[0], "instant 3"))["k"] == 3)
        for flood in floods:
            flood.end()
    for client in clients:
        await client.close()


async def main():
    frobc, recording, program, _ = sys.argv[1:]
    v = viewer.Viewer(frobc, recording, program)
    strangers(v)
    await others(v)
    await wrong_messages(v)
    await nonsense(v, 2000)
    frames(v, 300)
    await pages(v)
    check("it has outlived all that", v.process.poll() is None)
    check("and ends when it is told to", v.end() == 0)


if __name__ == "__main__":
    asyncio.run(main())
    sys.exit(viewer.failures > 0)
