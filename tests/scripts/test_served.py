"""A served command is as one that is started: what it prints, its folder, its environment, its exit status and its end; the client's own
failures have the status 125."""

import os
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("CONTINUA_PROGRAM", os.path.join(ROOT, "build", "release", "continua"))
BEAM = os.path.join(ROOT, "parameter_files", "thesis", "chapter-4", "beam.prm")


class Served(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.addCleanup(self.stop_servers)
        self.folder = place.name
        self.client = os.path.join(self.folder, "served")
        subprocess.run(["cc", "-o", self.client, os.path.join(ROOT, "tests", "served.c")], check=True)
        self.times = os.path.join(self.folder, "times")
        self.environment = {**os.environ, "CONTINUA_SERVERS": os.path.join(self.folder, "servers"), "CONTINUA_SERVED_TIMES": self.times}

    def servers(self):
        """The numbers of the servers of this test's folder."""
        found = []
        for number in filter(str.isdigit, os.listdir("/proc")):
            try:
                with open(f"/proc/{number}/cmdline", "rb") as stream:
                    is_server = b"\0--serve\0" in stream.read()
            except OSError:  # it has just ended
                continue
            if is_server and os.path.realpath(f"/proc/{number}/cwd").startswith(self.folder):
                found.append(int(number))
        return found

    def stop_servers(self):
        for number in self.servers():
            os.kill(number, signal.SIGKILL)

    def served(self, *arguments, program=PROGRAM, **options):
        return subprocess.run([self.client, program, *arguments], capture_output=True, text=True, check=False, cwd=self.folder,
                              env={**self.environment, **options})

    def test_as_started(self):
        plain = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, check=True)
        for _ in range(2):
            self.assertEqual(self.served("--version").stdout, plain.stdout)
        self.assertEqual(len(self.servers()), 1)
        done = self.served("missing.prm")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("missing.prm", done.stderr)
        with open(self.times, "w", encoding="utf-8"):
            pass
        done = self.served("--new", "beam", "my beam.prm")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(os.path.exists(os.path.join(self.folder, "my beam.prm")))
        self.assertEqual(self.served("my beam.prm", "--validate").returncode, 0)
        with open(self.times, encoding="utf-8") as stream:
            times = [float(line.split()[0]) for line in stream]
        self.assertEqual(len(times), 2)
        # A start would take half a second more. The environment is the client's.
        self.assertTrue(all(0.0 <= spent < 0.4 for spent in times), times)
        self.assertNotEqual(self.served("my beam.prm", "--mesh", "a/b.vtu", TMPDIR="/nowhere").returncode, 0)

    def test_end_of_the_client(self):
        client = subprocess.Popen([self.client, PROGRAM, BEAM, "--output", os.path.join(self.folder, "run")], env=self.environment,
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        log = os.path.join(self.folder, "run", "log.txt")
        deadline = time.monotonic() + 60
        while not os.path.exists(log) and time.monotonic() < deadline:
            time.sleep(0.02)
        lock = [number for number in os.listdir("/proc") if number.isdigit() and self.has_open(number, "run")]
        self.assertTrue(lock, "the run works in its folder")
        client.kill()
        client.wait()
        while any(self.has_open(number, "run") for number in lock) and time.monotonic() < deadline:
            time.sleep(0.02)
        self.assertFalse(any(self.has_open(number, "run") for number in lock))

    def has_open(self, number, name):
        """Whether a process has a file below the folder open."""
        folder = os.path.join(self.folder, name)
        try:
            return any(os.path.realpath(os.path.join("/proc", number, "fd", fd)).startswith(folder)
                       for fd in os.listdir(os.path.join("/proc", number, "fd")))
        except OSError:
            return False

    def test_failures_of_the_client(self):
        done = self.served(program="/no/such/program")
        self.assertEqual(done.returncode, 125)
        self.assertIn("/no/such/program", done.stderr)
        # A program that is no server.
        done = self.served(program=shutil.which("false"))
        self.assertEqual(done.returncode, 125)
        self.assertIn("--serve ended with the status 1", done.stderr)
        done = subprocess.run([self.client, PROGRAM], capture_output=True, text=True, check=False, env={"PATH": os.environ["PATH"]})
        self.assertEqual(done.returncode, 125)
        self.assertIn("usage: ", done.stderr)


if __name__ == "__main__":
    unittest.main()
