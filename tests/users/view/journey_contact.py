"""usage: journey_contact.py FROBC RUN.csv FILE ROBOT

Tests what the page shows when the viewer or the host is frozen or killed, or the connection is cut;
what a Stop does then; and that the page reconnects by itself.

The page measures the times, from the last news until it reports the silence, minus the time in
which the browser blocked it."""

import os
import select
import signal
import socket
import sys
import threading

from selenium.webdriver.common.keys import Keys

import viewer
from journey import Page, start
from viewer import check

stick = "../../../examples/safe_stick/safe_stick.frob"
LATE = 700

# Records all texts that some elements show, in order.
watch = """
addEventListener("DOMContentLoaded", () => {
  window.said = {};
  for (const id of ["stop", "fate", "follow", "state", "contact"]) {
    const said = (window.said[id] = []), element = document.getElementById(id);
    new MutationObserver(() => {
      if (said.at(-1) !== element.textContent) said.push(element.textContent);
    }).observe(element, { childList: true, characterData: true, subtree: true });
  }
});
"""


class Tunnel:
    """A tunnel from its own port to that of a viewer, like `ssh -L`. The test can cut it."""

    def __init__(self, port):
        self.to = port
        self.pairs = []
        self.open()
        self.port = self.listener.getsockname()[1]

    def open(self, port=0):
        self.listener = socket.create_server(("127.0.0.1", port))
        threading.Thread(target=self.accept, args=[self.listener], daemon=True).start()

    def accept(self, listener):
        while True:
            try:
                near = listener.accept()[0]
                far = socket.create_connection(("127.0.0.1", self.to))
            except OSError:
                return
            self.pairs.append((near, far))
            threading.Thread(target=self.carry, args=[near, far], daemon=True).start()

    def carry(self, near, far):
        try:
            while True:
                for line in select.select([near, far], [], [])[0]:
                    data = line.recv(65536)
                    (far if line is near else near).sendall(data)
                    if not data:
                        return
        except (OSError, ValueError):
            pass
        finally:
            near.close()
            far.close()

    def cut(self):
        self.listener.shutdown(socket.SHUT_RDWR)
        self.listener.close()
        for pair in self.pairs:
            for line in pair:
                try:
                    line.shutdown(socket.SHUT_RDWR)
                except OSError:
                    pass

    def mend(self):
        self.open(self.port)


def said(page, id):
    return page.driver.execute_script("return window.said[arguments[0]]", id)


def is_grey(page):
    return (
        page.driver.execute_script("return getComputedStyle(document.querySelector('main')).filter")
        == "grayscale(1)"
    )


def is_live(page):
    return page.text("#follow") == "Live" and page.text("#state") == "live: outputs as computed"


def loses(page, name, reason):
    """Checks that the page reports the lost contact in time, and nothing else."""
    page.wait(
        lambda: page.text("#contact").startswith("No contact since ")
        and reason in page.text("#contact")
    )
    after, late = (
        int(page.all("#contact")[0].get_attribute(f"data-{name}")) for name in ("after", "late")
    )
    check(f"{name}: the page says so in time ({LATE} ms)", after - late <= LATE)
    check(
        "and nothing looks as if it were so now",
        is_grey(page)
        and page.text("#follow") == "No contact"
        and page.text("#state").startswith("no contact since ")
        and page.driver.title.startswith("⚠ no contact"),
    )


def finds_back(page):
    page.wait(lambda: page.text("#contact").startswith("Contact again, after "))
    page.wait(lambda: is_live(page) and not is_grey(page))
    check("it finds back by itself, and says so", True)


def stop_is_missed(page):
    page.all("#stop")[0].click()
    page.wait(lambda: page.text("#stop") == "Not reached")
    check(
        "a Stop says that it is not reached",
        said(page, "stop")[-2:] == ["Stopping …", "Not reached"]
        and "has not reached the run" in page.text("#fate"),
    )


def stop_is_made_up_for(page, run):
    page.wait(lambda: page.text("#fate") == "Stopped.")
    check(
        "it is sent when there is contact, and only then says that it has stopped",
        page.text("#follow") == "The run is over" and said(page, "fate").count("Stopped.") == 1,
    )
    check("which is so", "time simulated:" in run.process.stdout.read())


def open_run(driver, frobc, through=None):
    run = viewer.Run(frobc, ["--robot", "pioneer", stick])
    tunnel = through(run.port) if through else None
    page = Page(driver, f"http://localhost:{tunnel.port}/#{run.token}" if tunnel else run.address)
    page.wait(lambda: is_live(page))
    return run, page, tunnel


def lost_and_found(driver, frobc):
    run, page, tunnel = open_run(driver, frobc, Tunnel)
    check("a page is shown under another name and port", True)
    os.kill(run.host_process, signal.SIGSTOP)
    page.all("#type")[0].send_keys("w")
    loses(page, "a host that is frozen", "the process that runs the program does not respond")
    page.press(Keys.ESCAPE, "p")
    page.wait(lambda: any("not done: no contact" in text for text in said(page, "state")))
    os.kill(run.host_process, signal.SIGCONT)
    finds_back(page)
    page.wait(
        lambda: any("too late" in text or "does not answer" in text for text in said(page, "state"))
    )
    check(
        "what it could not do it does not do when it goes on, and the page says so",
        page.text("#hold") == "Pause" and float(page.cells()["out.forward"]) == 0,
    )
    page.driver.execute_script("window.said.state.length = 0")

    os.kill(run.viewer, signal.SIGSTOP)
    page.all("#type")[0].send_keys("w")
    loses(page, "a viewer that is frozen", "the viewer does not respond")
    page.press(Keys.ESCAPE)
    os.kill(run.viewer, signal.SIGCONT)
    finds_back(page)
    page.wait(lambda: any("too late" in text for text in said(page, "state")))
    check(
        "a key that it finds when it goes on is not pressed, and the page says so",
        float(page.cells()["out.forward"]) == 0,
    )

    tunnel.cut()
    loses(page, "a line that is cut", "cannot reach the viewer")
    tunnel.mend()
    finds_back(page)
    page.press(Keys.HOME)
    page.at(0)
    check("and what is asked for is answered again", True)
    tunnel.cut()
    page.press(*3 * [Keys.ARROW_RIGHT])
    stop_is_missed(page)
    tunnel.mend()
    stop_is_made_up_for(page, run)
    page.at(3)
    check("what was asked for without a line is answered too", True)


def frozen_viewer(driver, frobc):
    run, page, _ = open_run(driver, frobc)
    os.kill(run.viewer, signal.SIGSTOP)
    stop_is_missed(page)
    os.kill(run.viewer, signal.SIGCONT)
    stop_is_made_up_for(page, run)


def killed_viewer(driver, frobc):
    run, page, _ = open_run(driver, frobc)
    os.kill(run.viewer, signal.SIGKILL)
    loses(page, "a viewer that is killed", "cannot reach the viewer")
    stop_is_missed(page)
    run.kill()


def killed_host(driver, frobc):
    run, page, _ = open_run(driver, frobc)
    os.kill(run.host_process, signal.SIGSTOP)
    stop_is_missed(page)
    os.kill(run.host_process, signal.SIGKILL)
    page.wait(lambda: "has ended without a result" in page.text("#fate"))
    check(
        "of a host that is killed the page says that it knows nothing",
        page.text("#follow") == "The run is over" and "Stopped." not in said(page, "fate"),
    )


def main():
    frobc = sys.argv[1]
    driver = start(1280, 720)
    driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": watch})
    try:
        for visit in lost_and_found, frozen_viewer, killed_viewer, killed_host:
            visit(driver, frobc)
        faults = [
            entry["message"]
            for entry in driver.get_log("browser")
            if "ERR_CONNECTION_REFUSED" not in entry["message"]
        ]
        check("the page has no faults of its own", faults == [])
        for fault in faults:
            print(fault)
    finally:
        driver.quit()


if __name__ == "__main__":
    main()
    sys.exit(viewer.failures > 0)
