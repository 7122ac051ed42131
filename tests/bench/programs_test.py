"""The Google Benchmark programs and the HTML page, as a user calls them.

usage: programs_test.py FOLDER_OF_PROGRAMS PYTHON_OF_THE_PAGE PAGE.py
"""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAMS, PAGE_PYTHON, PAGE = Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3]
SCENE = "soup:count=50"
STRUCTURES = ["brute_force", "bvh", "bvh8"]


def call(program, *arguments):
    return subprocess.run([PROGRAMS / program, *arguments], capture_output=True, text=True)


def asked(*more):
    structures = [word for name in STRUCTURES for word in ("--structure", name)]
    return ["--scene", SCENE, *structures, "--repetitions", "1", "--size", "32x32", *more]


class Programs(unittest.TestCase):
    def rows(self, family, *more):
        done = call(f"bench_{family}", *asked("--json", *more))
        self.assertEqual(done.returncode, 0, done.stderr)
        document = json.loads(done.stdout)
        self.assertEqual(document["schema"], 1)
        return {row["name"]: row for row in document["rows"]}

    def test_each_times_a_row_per_structure(self):
        for family, more in (("build", []), ("rays", ["--rays", "camera"]), ("render", [])):
            rows = self.rows(family, *more)
            self.assertEqual(len(rows), len(STRUCTURES), rows.keys())
            prefix = f"{family}/{SCENE}/"
            found = {name.removeprefix(prefix).split("/")[0] for name in rows}
            self.assertEqual(found, set(STRUCTURES), rows.keys())

    def test_builds_have_a_rate_and_a_peak(self):
        """The soup is large enough for the kernel to tell; 50 triangles are not: null, never 0."""
        for count, measurable in ((50, False), (20000, sys.platform == "linux")):
            done = call("bench_build", "--scene", f"soup:count={count}", "--structure", "bvh",
                        "--structure", "bvh8", "--repetitions", "3", "--json",
                        "--benchmark_min_time=0.01")
            self.assertEqual(done.returncode, 0, done.stderr)
            for row in json.loads(done.stdout)["rows"]:
                rate, peak = row["build_mprimitives_per_second"], row["build_peak_bytes"]
                self.assertGreater(rate["low"], 0)
                self.assertAlmostEqual(rate["median"] * row["seconds"]["median"], 1e-6 * count,
                                       delta=1e-9 * count)
                if measurable:
                    self.assertGreater(peak, 16 * count, row["name"])
                    self.assertLess(peak, 4096 * count, row["name"])
                else:
                    self.assertIsNone(peak, row["name"])

    def test_rates_of_rays_are_positive_and_ordered(self):
        for row in self.rows("rays", "--rays", "camera,random").values():
            rate = row["mrays_per_second"]
            self.assertGreater(rate["low"], 0)
            self.assertLessEqual(rate["low"], rate["median"])
            self.assertLessEqual(rate["median"], rate["high"])

    def test_one_row_is_asked_for_by_its_exact_name(self):
        name = f"rays/{SCENE}/bvh8/camera"
        self.assertEqual(list(self.rows("rays", "--rays", "camera", "--row", name)), [name])

    def test_a_row_that_is_not_there_is_an_error_that_names_what_is(self):
        done = call("bench_rays", *asked("--row", f"rays/{SCENE}/nothing/camera"))
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("nothing", done.stderr)
        self.assertIn("bvh", done.stderr)


class Page(unittest.TestCase):
    def setUp(self):
        if not PAGE_PYTHON.exists():
            self.skipTest(f"{PAGE_PYTHON} is missing; ./setup.sh makes it")

    def make(self, raw):
        return subprocess.run([PAGE_PYTHON, PAGE, raw], capture_output=True, text=True)

    def test_shows_every_row_and_draws_them(self):
        with tempfile.TemporaryDirectory() as folder:
            raw = Path(folder) / "raw.json"
            done = call("rayshoot", "bench", *asked("--rays", "camera,shadow", "--out", str(raw)))
            self.assertEqual(done.returncode, 0, done.stderr)
            made = self.make(raw)
            self.assertEqual(made.returncode, 0, made.stderr)
            page = raw.with_name("comparison.html").read_text(encoding="utf-8")
            for structure in STRUCTURES:
                self.assertIn(structure, page)
            self.assertIn(SCENE, page)
            self.assertIn("<svg", page)
            self.assertNotIn("{{", page)

    def test_is_not_made_of_anything_else(self):
        with tempfile.TemporaryDirectory() as folder:
            for number, text in enumerate(("", "[]", "{}", '{"schema": 2, "rows": []}')):
                raw = Path(folder) / f"{number}.json"
                raw.write_text(text, encoding="utf-8")
                made = self.make(raw)
                self.assertNotEqual(made.returncode, 0, text)
                self.assertIn(raw.name, made.stderr)
                self.assertNotIn("Traceback", made.stderr, text)
            self.assertFalse((Path(folder) / "comparison.html").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
