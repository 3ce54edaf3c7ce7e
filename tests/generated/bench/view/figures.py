"""Code that the viewer's benchmarks share: paths, and output of the figures."""

import os
import subprocess
import sys

here = os.path.dirname(os.path.abspath(__file__))
root = os.path.normpath(os.path.join(here, "..", "..", "..", ".."))
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(root, "tests", "users", "view"))


def example(name):
    return os.path.join(root, "examples", name, name + ".frob")


def figure(program, measure, value, aim, unit):
    print(
        '{"program": "%s", "measure": "%s", "compiler": "", "value": %.6g, "reference": %g, '
        '"ratio": %.2f, "unit": "%s"}' % (program, measure, value, aim, value / aim, unit),
        flush=True,
    )


def quantile(values, share):
    return sorted(values)[min(len(values) - 1, int(share * len(values)))]


def memory(pid, share="Private"):
    """Memory of a process in MB: its private memory, or its proportional share (Pss)."""
    with open(f"/proc/{pid}/smaps_rollup") as file:
        lines = [line.split() for line in file if line.startswith(share)]
    return sum(int(words[1]) for words in lines) / 1024


def processor_time(pid):
    """Processor time so far, in seconds, of a process and of the children that it has waited for.
    The machine's other work does not count."""
    with open(f"/proc/{pid}/stat") as file:
        fields = file.read().rsplit(")", 1)[1].split()
    return sum(map(int, fields[11:15])) / os.sysconf("SC_CLK_TCK")


# Clicks at a place on the timeline, given as a fraction of its width. Calls `done` with the time
# until the element that shows the instant has changed and is on the screen.
scrub = """
const [shows, to, done] = arguments;
const canvas = document.querySelector("#timeline canvas");
const box = canvas.getBoundingClientRect();
const now = document.querySelector(shows);
const before = performance.now();
const seen = new MutationObserver(() => {
  seen.disconnect();
  requestAnimationFrame(() => {
    const next = new MessageChannel();
    next.port1.onmessage = () => done(performance.now() - before);
    next.port2.postMessage(null);
  });
});
seen.observe(now, { childList: true, characterData: true, subtree: true });
for (const type of ["pointerdown", "pointerup"])
  canvas.dispatchEvent(new PointerEvent(type, {
    bubbles: true, pointerId: 1, button: 0, isPrimary: true,
    clientX: box.left + to * box.width, clientY: box.top + box.height / 2 }));
"""


class Clock:
    """The host in clock_host.c, which keeps time, with or without a viewer."""

    def __init__(self, frobc, folder):
        recording, program = os.path.join(folder, "clock.csv"), os.path.join(here, "clock.frob")
        with open(recording, "w") as file:
            file.write("time,in.1,in.2\n0,0,0\n")
        self.host = os.path.join(folder, "clock_host")
        self.shared = subprocess.run(
            [frobc, "view", "--only-build", recording, program],
            check=True,
            stdout=subprocess.PIPE,
            text=True,
        ).stdout.strip()
        viewer = os.path.join(os.path.dirname(frobc), "..", "lib", "frobc", "frob-view")
        self.viewer = [viewer, "--print", "--source", program, self.shared, "-"]

    def command(self, count, period_us, priority, viewer=True):
        return [
            self.host,
            self.shared,
            str(count),
            str(period_us),
            str(priority),
            *(self.viewer if viewer else []),
        ]
