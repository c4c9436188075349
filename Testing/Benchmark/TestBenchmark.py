# SPDX-License-Identifier: BSD-3-Clause
"""skyline benchmark: the page, its figures, and that a stopped or failed run leaves no files."""
import csv
import html.parser
import json
import os
import signal
import subprocess
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Tools"))
import Program
from Program import ToolTest, UTM10, hills, make

# Seconds from the signal to the end: measurements are killed at once, references stop soon
# afterwards.
SOON = 10.0


class Page(html.parser.HTMLParser):
    """Collects the external resources of a page, its charts and its text."""

    def __init__(self, text):
        super().__init__()
        self.loads, self.charts, self.text, self.open = [], 0, "", []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.charts += tag == "svg"
        if tag not in ("meta", "path", "circle", "rect"):
            self.open.append(tag)
        self.loads += [(tag, name) for name, _ in attributes if name in ("src", "href")]
        self.loads += [(tag, "script")] * (tag == "script")

    def handle_endtag(self, tag):
        while self.open and self.open.pop() != tag:
            pass

    def handle_data(self, data):
        self.text += data


def beaten(findings):
    """How many measurements of sweep and pyramid exact or fast beats, and how many there are."""
    def place(finding):
        time = finding["wall_median_ns" if finding["quantity"] == "threads" else "cpu_median_ns"]
        return time, finding["wrong_percent" if finding["quantity"] == "sun" else "rmse"]

    charts = {}
    for finding in findings:
        if finding["ran"]:
            charts.setdefault((finding["quantity"], finding["scene"]), []).append(finding)
    counts = [0, 0]
    for chart in charts.values():
        ours = [place(f) for f in chart if f["method"] in ("exact", "fast")]
        for paper in (place(f) for f in chart if f["method"] in ("sweep", "pyramid")):
            counts[0] += any(o != paper and o[0] <= paper[0] and o[1] <= paper[1] for o in ours)
            counts[1] += bool(ours)
    return counts


class Benchmark(ToolTest):
    def read(self, *names):
        with open(os.path.join(self.folder, *names), encoding="utf-8") as file:
            return file.read()

    def test_page_table_and_json_tell_the_same(self):
        make(self.path("my hills.tif"), hills(70, 60), epsg=UTM10)
        done = self.succeed("benchmark", "my hills.tif", "-o", "report", "--scenes", "cone",
                            "--sizes", "64", "--quantities", "horizon,sun", "--methods",
                            "exact,fast,sweep,pyramid,every,shadow-height,gdaldem", "--budget", 30)
        self.assertIn("report/index.html: ", done.stdout)
        self.assertEqual(sorted(os.listdir(self.path("report"))),
                         ["index.html", "pareto.svg", "results.csv", "results.json"])
        page = Page(self.read("report", "index.html"))
        self.assertEqual([name for name in page.loads if name != ("a", "href")], [],
                         "a page without external resources")
        self.assertEqual(page.open, [], "every element is closed")
        self.assertEqual(page.charts, 4)
        for words in ["my hills", "cone", "'my hills.tif'", "exact over every crossing",
                      "sweep and pyramid"]:
            self.assertIn(words, page.text)
        session = json.loads(self.read("report", "results.json"))
        rows = list(csv.DictReader(self.read("report", "results.csv").splitlines()))
        self.assertEqual(len(rows), len(session["findings"]))
        for row, finding in zip(rows, session["findings"]):
            self.assertEqual((row["label"], row["scene"]), (finding["label"], finding["scene"]))
            self.assertEqual(row["rmse"], "" if "rmse" not in finding
                             else "%.9g" % finding["rmse"])
        # The text of the page must agree with the figures.
        self.assertIn("beats %d of the %d measurements of sweep" % tuple(beaten(session["findings"])),
                      page.text)
        found = {(f["quantity"], f["scene"], f["label"]): f for f in session["findings"]}
        for scene in ["my hills", "cone"]:
            exact = found["horizon", scene, "exact"]
            self.assertTrue(exact["ran"])
            self.assertLess(exact["max"], 0.01)
            self.assertGreater(exact["cpu_median_ns"], 0.0)
            self.assertLess(found["horizon", scene, "fast"]["max"], 0.26)
            self.assertGreater(found["horizon", scene, "pyramid"]["rmse"], exact["rmse"])
            self.assertEqual(found["sun", scene, "exact"]["wrong_percent"], 0.0)
            self.assertEqual(found["sun", scene, "shadow height"]["wrong_percent"], 0.0)
            self.assertAlmostEqual(found["sun", scene, "exact"]["ssim"], 1.0, 9)

    def test_light_is_near_the_truth(self):
        self.succeed("benchmark", "-o", "report", "--scenes", "hills", "--sizes", "64", "--quantities",
                     "sky,irradiance,lamp", "--methods", "exact,harmonics,lamp", "--budget", 30)
        findings = json.loads(self.read("report", "results.json"))["findings"]
        found = {(f["quantity"], f["label"]): f for f in findings}
        self.assertLess(found["sky", "exact 36"]["rmse"], 0.01)
        self.assertLess(found["irradiance", "exact 64"]["rmse"], 1.0)
        self.assertLess(found["irradiance", "SH 4, exact"]["rmse"], 10.0)
        # 1024 rays of the reference have an error of 1 / sqrt(1024) of a penumbra.
        self.assertLess(found["lamp", "lamp, 32 planes"]["rmse"], 3.0)

    def test_peers_are_given_the_same_sun(self):
        self.succeed("benchmark", "-o", "report", "--scenes", "cone", "--sizes", "64", "--quantities",
                     "beam,lamp,sky", "--methods", "exact,lamp,embree,grass,saga,gdaldem", "--budget",
                     60)
        findings = json.loads(self.read("report", "results.json"))["findings"]
        found = {(f["quantity"], f["label"]): f for f in findings}
        exact = found["beam", "exact"]
        self.assertLess(exact["rmse"], 0.01)
        self.assertEqual(exact["wrong_percent"], 0.0)
        ran = {key: f for key, f in found.items() if f["ran"]}
        for peer in ["GRASS r.sun", "SAGA hillshade", "gdaldem hillshade", "Embree"]:
            if ("beam", peer) in ran:
                with self.subTest(peer=peer):
                    # Another sun or slope, or an atmosphere, would change all posts by tens of
                    # percent. The edge of a shadow is a few posts, and gdaldem has no shadows.
                    self.assertLess(abs(ran["beam", peer]["bias"]), 10.0)
                    self.assertLess(ran["beam", peer]["wrong_percent"], 12.0)
                    self.assertGreater(ran["beam", peer]["floats_per_post"], 0.0)
        if ("lamp", "Embree 1024") in ran:
            # Two random samples of 1024 rays.
            self.assertLess(ran["lamp", "Embree 1024"]["rmse"], 3.0)
        if ("sky", "GRASS r.sun, diffuse") in ran:
            # A cone hides little of the sky of the level ground around it.
            self.assertLess(ran["sky", "GRASS r.sun, diffuse"]["rmse"], 0.1)

    def test_no_time_is_said(self):
        self.succeed("benchmark", "-o", "report", "--scenes", "hills", "--sizes", "32",
                     "--budget", 0)
        page = Page(self.read("report", "index.html"))
        for words in ["There was no time for", "0 of ", "--quantities horizon", "--budget 600"]:
            self.assertIn(words, page.text)
        self.assertEqual(page.open, [])
        session = json.loads(self.read("report", "results.json"))
        self.assertEqual(session["findings"], [])
        # The main setting of each method comes before other values of its parameter.
        labels = [task["label"] for task in session["left_out"]]
        self.assertLess(labels.index("pyramid"), labels.index("pyramid k=2"))
        self.assertLess(labels.index("GRASS r.sun"), labels.index("exact 180"))

    def test_failures(self):
        self.refused(2, "benchmark")
        self.refused(2, "benchmark", "-o", "report", "--scenes", "moon", says="smooth,hills,")
        self.refused(2, "benchmark", "-o", "report", "--methods", "magic", says="exact,fast,sweep,")
        self.refused(2, "benchmark", "-o", "report", "--quantities", "size", says="horizon,sky,")
        self.refused(2, "benchmark", "-o", "report", "--sizes", "8", says="32 to 4096")
        for budget in ["-1", "long", "inf", "nan"]:
            self.refused(2, "benchmark", "-o", "report", "--budget", budget,
                         says="give seconds from 0 to")
        self.refused(2, "benchmark", "-o", "report", "--scenes", "none", says="give a DEM")
        self.refused(2, "benchmark", "-o", "report", "--scenes", "none,hills", says="none cannot be combined")
        self.refused(1, "benchmark", "-o", "report", "--scenes", "cone", "--sizes", "32", "--methods",
                     "lamp", "--quantities", "sky", says="leave out --methods")
        self.refused(1, "benchmark", "-o", "report", "--scenes", "none", "gone.tif",
                     says="gone.tif")
        with open(self.path("file"), "w", encoding="utf-8"):
            pass
        self.refused(1, "benchmark", "-o", "file", says="name a folder")
        self.refused(1, "benchmark", "-o", "no/such/folder", says="name another with -o")

    def test_interrupted_leaves_nothing(self):
        os.mkdir(self.path("temporary"))
        environment = dict(os.environ, TMPDIR=self.path("temporary"))
        # In the middle of a reference, and of the measurements.
        for options, wait in [(["--sizes", "2048"], 3.0), (["--sizes", "256"], 4.0)]:
            with self.subTest(options=options):
                running = subprocess.Popen(
                    [Program.PROGRAM, "benchmark", "-o", "report", "--scenes", "hills", *options],
                    stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=self.folder,
                    env=environment)
                begun = time.monotonic()  # on a busy machine a program starts in seconds
                while not os.path.isdir(self.path("report")) and time.monotonic() < begun + 60.0:
                    time.sleep(0.05)
                time.sleep(wait)
                self.assertIsNone(running.poll())
                sent = time.monotonic()
                running.send_signal(signal.SIGINT)
                out, text = running.communicate(timeout=60)
                self.assertLess(time.monotonic() - sent, SOON)
                self.assertEqual((running.returncode, out, text), (-signal.SIGINT, "", "skyline: interrupted\n"))
                self.assertEqual(self.files(), ["temporary"])
                self.assertEqual(os.listdir(self.path("temporary")), [])


if __name__ == "__main__":
    Program.main()
