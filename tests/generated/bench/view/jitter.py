"""usage: jitter.py FROBC FOLDER ROUNDS

Measures how much later a host wakes up while a viewer and a browser show its run: the median and
the 99 % quantile over rounds of ten seconds at 200 Hz, alternately with and without a viewer. The
host has real-time priority if that is allowed, as a host that drives a robot should."""

import re
import subprocess
import sys

from figures import Clock, figure, memory, quantile

import viewer
from journey import Page, start

COUNT, PERIOD_US, PRIORITY = 2000, 5000, 50


def late(text):
    return [float(number) for number in re.search(r"^late: (\S+) (\S+)$", text, re.M).groups()]


def main():
    frobc, folder, rounds = sys.argv[1], sys.argv[2], int(sys.argv[3])
    clock = Clock(frobc, folder)
    alone, looked_at, sizes = [], [], []
    driver = start(1280, 720)
    try:
        for _ in range(rounds):
            command = clock.command(COUNT, PERIOD_US, PRIORITY, viewer=False)
            host = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
            try:
                host.wait(5)
            except subprocess.TimeoutExpired:
                size = memory(host.pid)
            alone.append(late(host.communicate()[0]))
            run = viewer.Process(clock.command(COUNT, PERIOD_US, PRIORITY))
            page = Page(driver, run.address)
            page.wait(lambda: page.text("#follow") == "Live" and page.instant() > 50)
            sizes.append(memory(run.process.pid, "Pss") - size)
            looked_at.append(late(run.process.stdout.read()))
            run.kill()
    finally:
        driver.quit()
    for name, which, aim in (("median", 0, 20), ("99 %", 1, 20)):
        with_, without = (
            [quantile([r[which] for r in results], 0.5)] for results in (looked_at, alone)
        )
        figure("clock", f"wake-up later when looked at, {name}", with_[0] - without[0], aim, "us")
    figure("clock", "memory of a host that is looked at, more", quantile(sizes, 0.5), 4, "MB")


main()
