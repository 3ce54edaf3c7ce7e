"""Tests sweeps on the workers of a local Dask cluster: with and without access to the client's
files, and with workers that are killed."""

import os
import shutil
import signal
import threading
import time
import unittest

from distributed import Client, LocalCluster
from distributed.diagnostics.plugin import WorkerPlugin

import checks
import frob
from frob import tools

FOLLOW = """import Robot
import Trial
import WallFollow

param gap :: Distance = 0.3[m]

main :: (HasSonar i, DiffDrive o) => Program i o
main = reactimateRobot (wallFollow1 gap)

trial "keeps off" = Trial {
    world = "room.toml", lasts = 30[s], seeds = 1 `to` 200, judge = proc t -> neverTouches t where
        error = meanOf (t.clearance - gap)
}
"""

PLAN = """program = "follow.frob"
robots = ["pioneer"]
[params]
gap = "0.2[m] to 0.4[m], 3 steps"
"""


def write(name, text):
    with open(name, "w") as file:
        file.write(text)


def rows(folder):
    """Returns the keys of all complete rows."""
    keys = []
    for name in os.listdir(folder):
        if name.endswith(".rows"):
            with open(os.path.join(folder, name)) as file:
                keys += [line.split("\t")[0] for line in file if line.endswith("\n")]
    return keys


def set_environment(changed):
    """Changes the environment of the worker that runs this. (`os.environ.update` itself would be
    sent with a copy of the client's environment, and change that.)"""
    os.environ.update(changed)


class Alone(WorkerPlugin):
    """A worker that does not see the client's row files."""

    def setup(self, worker):
        from frob import cluster

        cluster._shares = lambda work: False


class OnCluster(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        write("follow.frob", FOLLOW)
        write("gaps.toml", PLAN)
        cls.wanted = frob.sweep("gaps.toml", rows="whole")

    def setUp(self):
        shutil.rmtree("gaps.rows", ignore_errors=True)
        self.cluster = LocalCluster(
            n_workers=2,
            threads_per_worker=1,
            processes=True,
            dashboard_address=None,
            silence_logs="CRITICAL",
        )
        self.client = Client(self.cluster)

    def tearDown(self):
        self.client.close()
        self.cluster.close()

    def killer(self, enough):
        """Kills a worker when there are enough rows; reports how many there were."""
        seen = []

        def kill():
            victim = next(iter(self.client.run(os.getpid).values()))
            while not seen:
                found = len(rows("gaps.rows")) if os.path.isdir("gaps.rows") else 0
                if enough(found):
                    os.kill(victim, signal.SIGKILL)
                    seen.append(found)
                time.sleep(0.01)

        thread = threading.Thread(target=kill, daemon=True)
        thread.start()
        return thread, seen

    def test_killed(self):
        thread, seen = self.killer(lambda found: found >= 100)
        runs = frob.sweep("gaps.toml", self.client)
        thread.join(60)
        self.assertTrue(100 <= seen[0] < 600, seen)
        self.assertTrue(runs.equals(self.wanted))
        self.assertEqual(runs.attrs["summary"], self.wanted.attrs["summary"])
        self.assertEqual(len(set(rows("gaps.rows"))), 600)
        self.assertEqual(
            [name for name in os.listdir("gaps.rows") if not name.endswith(".rows")], []
        )
        os.utime("gaps.rows", (0, 0))
        self.assertTrue(frob.sweep("gaps.toml", self.client).equals(self.wanted))
        self.assertEqual(os.path.getmtime("gaps.rows"), 0)

    def test_killed_without_the_clients_files(self):
        self.client.register_plugin(Alone())
        write("some.toml", "seeds = [1, 50]\n" + PLAN)
        frob.sweep("some.toml", rows="gaps.rows")
        thread, seen = self.killer(lambda found: found >= 150 + 50)
        runs = frob.sweep("gaps.toml", self.client)
        thread.join(60)
        self.assertTrue(200 <= seen[0] < 600, seen)
        self.assertTrue(runs.equals(self.wanted))
        self.assertEqual(sorted(rows("gaps.rows")), sorted(set(rows("whole"))))

    def test_another_installation(self):
        """A missing or different installation on one worker is reported before the first run."""
        other = os.path.abspath("other")
        shutil.rmtree(other, ignore_errors=True)
        for part in ("lib/frobc", "share/frobc"):
            shutil.copytree(os.path.join(tools.prefix(), part), os.path.join(other, part))
        address = next(iter(self.client.run(os.getpid)))
        # A wheel's hosts find their libraries relative to their installation.
        libraries = os.path.join(os.path.dirname(os.path.dirname(frob.__file__)), "frob.libs")
        changed = {"FROB_HOME": other, "LD_LIBRARY_PATH": libraries}
        self.client.run(set_environment, changed, workers=[address])
        with open(os.path.join(other, "lib/frobc/frob-sim"), "ab") as file:
            file.write(b"\n")
        with self.assertRaises(frob.Error) as raised:
            frob.sweep("gaps.toml", self.client)
        self.assertEqual(
            str(raised.exception),
            f"the worker {address} cannot perform these runs: its plan, program, worlds or frobc "
            "differ from those of the client",
        )
        os.remove(os.path.join(other, "share/frobc/worlds/room.toml"))
        with self.assertRaises(frob.Error) as raised:
            frob.sweep("gaps.toml", self.client)
        self.assertIn(f"the worker {address} cannot perform these runs: ", str(raised.exception))
        self.assertIn("there is no world `room.toml` next to", str(raised.exception))
        self.assertEqual(os.listdir("gaps.rows"), [])

    def test_full_disk(self):
        """Finished rows are kept, and another call performs the rest."""
        import resource

        def limit(size):
            resource.setrlimit(resource.RLIMIT_FSIZE, (size, resource.RLIM_INFINITY))

        self.client.run(limit, 1500)
        with self.assertRaises(frob.Error) as raised:
            frob.sweep("gaps.toml", self.client)
        self.assertRegex(
            str(raised.exception),
            "(?s)^a worker on .* could not perform its runs: cannot write the result of a run: File too "
            "large.*\n[0-9]+ of 600 runs are done; repeat the call to continue$",
        )
        done = len(set(rows("gaps.rows")))
        self.assertTrue(0 < done < 600, done)
        self.assertTrue(frob.sweep("gaps.toml").equals(self.wanted))

    def test_errors(self):
        write("wrong.toml", PLAN.replace("0.2[m]", "0.5[m]"))
        with self.assertRaisesRegex(
            frob.Error, "^error: .*/wrong.toml:4:7: the range of `gap` ends at"
        ):
            frob.sweep("wrong.toml", self.client)
        with self.assertRaisesRegex(frob.InputError, "^jobs: a cluster's workers make one run at"):
            frob.sweep("gaps.toml", self.client, jobs=2)
        write("file", "")
        with self.assertRaisesRegex(frob.Error, "^error: cannot read .*/file: Not a directory$"):
            frob.sweep("gaps.toml", self.client, rows="file")


if __name__ == "__main__":
    checks.main("sweeps on a Dask cluster")
