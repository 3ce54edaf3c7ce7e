"""server.py FRAMES.mjpeg PORT_FILE -- a network camera, working or failing: the requested path
selects its behaviour. It writes its port to PORT_FILE, or, if the file exists, uses the port in it,
like a camera that comes back."""

import os
import re
import socket
import sys
import threading
import time

frames = [b"\xff\xd8" + part for part in open(sys.argv[1], "rb").read().split(b"\xff\xd8")[1:]]
HEAD = b"HTTP/1.1 200 OK\r\nContent-Type: multipart/x-mixed-replace; boundary=x\r\n"
PERIOD = 0.03


def part(frame):
    return (
        b"--x\r\nContent-Type: image/jpeg\r\nContent-Length: %d\r\n\r\n" % len(frame)
        + frame
        + b"\r\n"
    )


def endless():
    while True:
        yield from frames


def good(send):
    send(HEAD + b"\r\n")
    for frame in endless():
        send(part(frame))


def bare(send):
    """Sends JPEGs without lengths or boundaries."""
    send(b"HTTP/1.0 200 OK\n\n")
    for frame in endless():
        send(frame)


def chunked(send):
    send(HEAD + b"Transfer-Encoding: chunked\r\n\r\n")
    for frame in endless():
        body = part(frame)
        for piece in (body[:7], body[7:500], body[500:]):
            send(b"%x;note\r\n" % len(piece) + piece + b"\r\n", 0.0)
        time.sleep(PERIOD)


def hangs(send):
    """Stops in the middle of a frame of a good stream, and keeps the connection open."""
    send(HEAD + b"\r\n")
    for frame in frames[:20]:
        send(part(frame))
    send(part(frames[20])[:2000])
    time.sleep(1000)


def silent(send):
    time.sleep(1000)


def rubbish(send):
    """Sends bytes in which no JPEG begins."""
    send(HEAD + b"\r\n")
    while True:
        send(os.urandom(3000).translate(None, b"\xffP"))


def noise(send):
    while True:
        send(os.urandom(3000))


def truncated(send):
    """Omits the second half of every other frame."""
    send(HEAD + b"\r\n")
    for k, frame in enumerate(endless()):
        send(part(frame if k % 2 == 0 else frame[: len(frame) // 2]))


def cut(send):
    """Truncates all frames, but ends each with an end marker."""
    send(HEAD + b"\r\n")
    for frame in endless():
        send(part(frame[: len(frame) * 2 // 3] + b"\xff\xd9"))


def frozen(send):
    send(HEAD + b"\r\n")
    for frame in frames[:20]:
        send(part(frame))
    while True:
        send(part(frames[20]))


def ends(send):
    send(HEAD + b"\r\n")
    for frame in frames[:20]:
        send(part(frame))


def page(send):
    send(b"HTTP/1.1 200 OK\r\nContent-Type: text/html\r\n\r\n<h1>A camera</h1>")


def forbidden(send):
    send(b"HTTP/1.1 401 Unauthorized\r\n\r\n")


def missing(send):
    send(b"HTTP/1.1 404 Not Found\r\n\r\n")


def serve(client):
    def send(data, pause=PERIOD):
        client.sendall(data)
        time.sleep(pause)

    try:
        request = client.recv(4096).decode()
        name = re.match(r"GET /(\w+) ", request).group(1)
        globals().get(name, missing)(send)
    except OSError:
        pass
    client.close()


listener = socket.socket()
listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
known = os.path.exists(sys.argv[2])
listener.bind(("127.0.0.1", int(open(sys.argv[2]).read()) if known else 0))
listener.listen()
with open(sys.argv[2] + ".new", "w") as file:
    file.write("%d" % listener.getsockname()[1])
os.rename(sys.argv[2] + ".new", sys.argv[2])
while True:
    threading.Thread(target=serve, args=(listener.accept()[0],), daemon=True).start()
