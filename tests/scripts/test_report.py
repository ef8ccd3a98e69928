#!/usr/bin/python3
"""scripts/report: what a page has, that texts of runs stay texts, that it loads nothing; and in a headless browser, where there is one, that
its curves and views work in three sizes of a window and no request leaves."""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import browser  # noqa: E402

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCRIPT = os.path.join(ROOT, "scripts", "report")
PROGRAM = os.environ.get("CONTINUA_PROGRAM", os.path.join(ROOT, "build", "release", "continua"))
HOSTILE = """</title></script><script>window.attacked = 1</script><img src=x onerror="window.attacked = 2">'"&"""
TUBE = {"Mesh/Axial cells": "12", "Mesh/Radial cells": "3", "Time/Time step": "1 ms", "Time/End time": "40 ms", "Output/Field interval": "10 ms",
        "Wave theory/Overlay": "false"}


def report(*arguments, **environment):
    done = subprocess.run([SCRIPT, *arguments], capture_output=True, text=True, check=False, env={**os.environ, "CONTINUA_PROGRAM": PROGRAM, **environment})
    return done.returncode, done.stdout, done.stderr


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)


def hostile_run(folder):
    """A run each of whose texts would run a script if it were not escaped."""
    os.makedirs(os.path.join(folder, "input"))
    quantity = {"name": f"frequency {HOSTILE}", "value": 2.5, "unit": "Hz", "probe": HOSTILE}
    summary = {"title": HOSTILE, "status": "failed", "failure": HOSTILE, "version": HOSTILE, "revision": HOSTILE, "command line": HOSTILE, "analysis": HOSTILE,
               "warnings": [HOSTILE], "quantities": [quantity], "checks": [{**quantity, "criterion": HOSTILE, "passed": False}],
               "absent": [{"name": HOSTILE, "probe": HOSTILE, "reason": HOSTILE}], "wall time [s]": {HOSTILE: 1.0}, "libraries": {HOSTILE: HOSTILE},
               "degrees of freedom": {HOSTILE: 3}, "linear solver": HOSTILE, "largest values": {HOSTILE + " [m]": 1.0}}
    with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as stream:
        json.dump(summary, stream)
    name = HOSTILE.replace('"', '""')
    rows = "".join(f"{0.1 * i},{i * i}\n" for i in range(20))
    write(os.path.join(folder, "probes.csv"), f'time [s],"{name}: displacement y [m]"\n{rows}')
    write(os.path.join(folder, "modes.csv"), f'mode [1],"{name} [Hz]"\n1,2.0\n')
    write(os.path.join(folder, "log.txt"), HOSTILE)
    write(os.path.join(folder, "input", "x' onload=alert(1)"), "")
    write(os.path.join(folder, "parameters.prm"), f"# {HOSTILE}\nset Title = {HOSTILE} # default: {HOSTILE}\nsubsection Materials\n  subsection <b>x\n"
                                                  f"    set Type = {HOSTILE}\n  end\nend\n")


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = cls.temporary.name
        cls.tube = os.path.join(cls.folder, "tube")
        sets = [part for key, value in TUBE.items() for part in ("--set", f"{key}={value}")]
        subprocess.run([PROGRAM, os.path.join(ROOT, "parameter_files", "new", "tube.prm"), *sets, "--output", cls.tube], capture_output=True, check=True)
        cls.hostile = os.path.join(cls.folder, "hostile")
        hostile_run(cls.hostile)
        cls.assets = os.path.join(cls.folder, "assets")
        there = os.path.join(os.environ.get("CONTINUA_BUILD_ROOT", os.path.join(ROOT, "build")), "report-assets")
        cls.has_library = os.path.exists(os.path.join(there, "uPlot.iife.min.js"))
        cls.pages = {"tube": cls.page("tube", cls.tube), "hostile": cls.page("hostile", cls.hostile)}

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def page(cls, name, *arguments, **environment):
        path = os.path.join(cls.folder, name + ".html")
        status, said, error = report(*arguments, "--output", path, **environment)
        if (status, error) != (0, ""):
            raise AssertionError(f"exit status {status}: {said}{error}")
        with open(path, encoding="utf-8") as stream:
            return stream.read()

    def test_page_of_a_run(self):
        page = self.pages["tube"]
        with open(os.path.join(self.tube, "summary.json"), encoding="utf-8") as stream:
            summary = json.load(stream)
        self.assertIn(f"<h1>{summary['title']}</h1>", page)
        for text in summary["warnings"]:
            self.assertIn(text.partition("'")[0], page)
        self.assertLess(page.index('id="warnings"'), page.index('id="answer"'))
        # An entry that differs from its default, beside it.
        self.assertRegex(page, r"<td>Axial cells</td>\s*<td>12</td>\s*<td><span[^>]*>20</span>")
        self.assertIn("with its regions and boundaries", page)
        self.assertLess(len(page), 5e6)
        data = json.loads(re.search(r'id="data">(.*?)</script>', page, re.S).group(1))
        view = data["views"][0]
        self.assertEqual(view["dim"], 2)
        self.assertEqual([text for text in view["times"]], ["t = 0 s", "t = 0.01 s", "t = 0.02 s", "t = 0.03 s", "t = 0.04 s"])
        self.assertEqual([field["name"] for field in view["fields"]][:3], ["pressure", "velocity", "displacement"])

    def test_nothing_from_outside(self):
        page = self.pages["tube"]
        policy = re.search(r'http-equiv="Content-Security-Policy" content="([^"]*)"', page).group(1)
        self.assertIn("default-src &#x27;none&#x27;", policy)
        self.assertNotIn("unsafe", policy)
        # Everything that a browser fetches stands in the page.
        for attribute in re.findall(r'\s(?:src|href|action|data|srcset)="([^"]*)"', re.sub(r"<script.*?</script>", "", page, flags=re.S)):
            self.assertRegex(attribute, r"^(data:image/png;base64,|#)")

    def test_hostile_texts(self):
        page = self.pages["hostile"]
        outside = re.sub(r"<(script|style)>.*?</\1>", "", page, flags=re.S)
        self.assertNotIn("<script>", outside)
        self.assertNotIn("<img src=x", outside)
        self.assertEqual(len(re.findall(r"<script[^>]*>", page)), len(re.findall(r"</script>", page)))
        self.assertIn("&lt;/title&gt;&lt;/script&gt;&lt;script&gt;window.attacked = 1", outside)

    def test_several_runs_without_the_library(self):
        other = os.path.join(self.folder, "other")
        shutil.copytree(self.hostile, other)
        os.makedirs(self.assets)
        page = self.page("several", self.hostile, other, CONTINUA_BUILD_ROOT=self.assets)
        self.assertIn("(hostile)</th>", page)
        self.assertIn("(other)</th>", page)
        self.assertNotIn("data-chart=", page)
        self.assertIn("they need uPlot", page)
        self.assertIn('alt="Displacement y"', page)

    def test_running_and_missing(self):
        status, _, error = report(os.path.join(self.folder, "nothing"))
        self.assertEqual(status, 1)
        self.assertIn("there is no such folder", error)
        status, _, error = report(self.tube, "--fields", "colour")
        self.assertEqual(status, 2)
        self.assertIn("there is no such field", error)
        status, _, error = report(self.tube, "--output", "/proc/page.html")
        self.assertEqual(status, 1)
        self.assertIn("cannot write /proc/page.html", error)
        self.assertNotIn("Traceback", error)

    @unittest.skipIf(browser.program() is None, "there is no Chromium: the Debian package chromium")
    def test_in_a_browser(self):
        for name in ("tube", "hostile"):
            path = os.path.join(self.folder, name + ".html")
            for width, height in ((1366, 768), (1920, 1080), (390, 844)):
                with self.subTest(page=name, width=width):
                    self.look(path, width, height, name == "tube")

    def look(self, path, width, height, has_view):
        page = browser.Browser(width, height, width < 500)
        try:
            page.open(path)
            boxes = page.evaluate("document.querySelectorAll('[data-chart], [data-view]').length")
            self.assertEqual(boxes > 0, has_view or self.has_library)
            for i in range(boxes):
                box = f"document.querySelectorAll('[data-chart], [data-view]')[{i}]"
                page.evaluate(f"{box}.scrollIntoView()")
                page.wait(f"{box}.dataset.done || {box}.classList.contains('failed')")
                self.assertEqual(page.evaluate(f"{box}.textContent.includes('cannot be shown')"), False)
            self.assertFalse(page.evaluate("window.attacked || document.querySelector('img[src=x]') !== null"))
            # Nothing is wider than the window.
            self.assertLessEqual(page.evaluate("document.documentElement.scrollWidth"), width)
            if has_view:
                self.check_view(page)
            self.assertEqual([request for request in page.requests if not request.startswith(("file://" + path, "data:"))], [])
            self.assertEqual(page.errors, [])
        finally:
            page.close()

    def check_view(self, page):
        """The body is drawn in the colours of the map, and what the pointer reads is the value of the node."""
        page.evaluate("document.querySelector('[data-view] canvas.body').scrollIntoView({block: 'center'})")
        colours = page.evaluate("""(() => { const v = document.querySelector('[data-view]').view, gl = v.gl, c = v.canvas;
            v.paint(v.seen); const p = new Uint8Array(4 * c.width * c.height); gl.readPixels(0, 0, c.width, c.height, gl.RGBA, gl.UNSIGNED_BYTE, p);
            let n = 0; for (let i = 0; i < p.length; i += 4) if (p[i] < 250 || p[i + 1] < 250 || p[i + 2] < 250) ++n; return n / (c.width * c.height); })()""")
        self.assertGreater(colours, 0.03)
        place = page.evaluate("(() => { const b = document.querySelector('[data-view]').view.canvas.getBoundingClientRect(); return [b.x, b.y, b.width, b.height]; })()")
        page.call("Input.dispatchMouseEvent", type="mouseMoved", x=place[0] + place[2] / 2, y=place[1] + place[3] / 2)
        page.drag(place[0] + place[2] / 2, place[1] + place[3] / 2, 40, 0)
        self.assertGreater(page.evaluate("Math.abs(document.querySelector('[data-view]').view.shift[0])"), 0.01)


class ByTheRun(unittest.TestCase):
    """Output/Report = true: the program starts the script that came with it. It stands here in a prefix of its own, with another script."""

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory(dir=os.path.dirname(PROGRAM))  # of the same file system: a link will do
        self.addCleanup(self.temporary.cleanup)
        self.prefix = self.temporary.name
        for folder in ("bin", "share/continua/parameter_files", "share/continua/scripts"):
            os.makedirs(os.path.join(self.prefix, folder))
        self.program = os.path.join(self.prefix, "bin", "continua")
        os.link(PROGRAM, self.program)

    def run_beam(self, name, script=None, *arguments, ranks=1):
        path = os.path.join(self.prefix, "share", "continua", "scripts", "report")
        if script is not None:
            write(path, script)
            os.chmod(path, 0o755)
        sets = ["--set", "Mesh/Refinements=0", "--set", "Time/End time=2 ms", "--set", "Output/Final fields=false"]
        launcher = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks)] if ranks > 1 else []
        done = subprocess.run([*launcher, self.program, os.path.join(ROOT, "parameter_files", "new", "beam.prm"), *sets, "--output", name, *arguments],
                              capture_output=True, text=True, check=False, cwd=self.prefix,
                              env={name: value for name, value in os.environ.items() if name != "CONTINUA_PROGRAM"})
        with open(os.path.join(self.prefix, name, "summary.json"), encoding="utf-8") as stream:
            self.assertEqual(json.load(stream)["status"], "finished")
        return done.returncode, done.stdout, done.stderr

    SCRIPT = """#!/bin/sh
[ ! -e "$1/lock" ] || { echo "the run has not ended"; exit 1; }
[ -z "$OMPI_COMM_WORLD_SIZE" ] || { echo "it takes itself for a rank"; exit 1; }
echo "$CONTINUA_PROGRAM" >> "$1/report.html"
echo "$1/report.html: 0.10 MB"
"""

    def test_report(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                name = f"with-{ranks}"
                status, said, error = self.run_beam(name, self.SCRIPT, "--set", "Output/Report=true", ranks=ranks)
                self.assertEqual(status, 0)
                self.assertNotIn("warning: Output/Report", error)
                self.assertIn(f"Report: {name}/report.html: 0.10 MB\n", said)
                with open(os.path.join(self.prefix, name, "report.html"), encoding="utf-8") as stream:
                    self.assertEqual(stream.read(), self.program + "\n")

    def test_none(self):
        status, said, error = self.run_beam("without", self.SCRIPT)
        self.assertEqual(status, 0)
        self.assertNotIn("Report", said + error)
        self.assertFalse(os.path.exists(os.path.join(self.prefix, "without", "report.html")))

    def test_what_is_missing(self):
        for script, reason in ((None, r"share/continua/scripts/report is not there"),
                               ("#!/bin/sh\necho \"ModuleNotFoundError: No module named 'vtk'\"; exit 1\n", "No module named 'vtk'"),
                               ("#!/nowhere/python3\n", "its process cannot be started: No such file")):
            with self.subTest(reason=reason):
                status, said, error = self.run_beam("warned", script, "--overwrite", "--set", "Output/Report=true")
                self.assertEqual(status, 0)
                self.assertNotIn("Report:", said)
                self.assertRegex(error, r"(?m)^warning: Output/Report: there is no report, since .*" + reason)
                self.assertIn("'continua report warned' makes the report", error)

    def test_runs_of_a_study_have_none(self):
        status, said, error = self.run_beam("sweep", self.SCRIPT, "--set", "Output/Report=true", "--sweep", "Materials/beam/Density=998 kg/m^3, 999 kg/m^3",
                                            "--set", "Sweep/Parallel runs=2")
        self.assertEqual(status, 0, error)
        self.assertIn("Report: sweep/report.html", said)
        made = [folder for folder, _, files in os.walk(os.path.join(self.prefix, "sweep")) if "report.html" in files]
        self.assertEqual(made, [os.path.join(self.prefix, "sweep")])


if __name__ == "__main__":
    unittest.main()
