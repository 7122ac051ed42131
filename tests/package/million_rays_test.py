"""The example of examples/million_rays: its answer, and its speed beside the harness's.

usage: million_rays_test.py MILLION_RAYS RAYSHOOT [answer|speed]

The answer. A chord between two points that are uniform on a sphere is an isotropic random line, so
it meets a convex body inside with the ratio of their surfaces (Cauchy): 2 / pi for the cube on the
sphere's own points. And brute force, asked through `rayshoot count`, counts the very same hits.

The speed. Example and `rayshoot bench` trace the same million rays through the same library; each
is run in turns, and the best rate of each is compared, because what disturbs a run only slows it.
"""

import json
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

EXAMPLE, RAYSHOOT = sys.argv[1], sys.argv[2]
RAYS = 1000000
LEAST_TURNS, MOST_TURNS = 3, 8
LEAST_RATIO = 0.9  # of the best rates; a turn wavers by some 3 % on a quiet machine


def cube(steps):
    """A cube whose faces are grids of steps x steps squares, as OBJ."""
    corners, faces = [], []
    for axis in range(3):
        for side in (-1, 1):
            first = len(corners) + 1
            for i in range(steps + 1):
                for j in range(steps + 1):
                    point = [side, side, side]
                    point[(axis + 1) % 3] = 2 * i / steps - 1
                    point[(axis + 2) % 3] = 2 * j / steps - 1
                    corners.append("v %.9g %.9g %.9g\n" % tuple(point))
            for i in range(steps):
                for j in range(steps):
                    at = first + i * (steps + 1) + j
                    faces.append(f"f {at} {at + 1} {at + steps + 2} {at + steps + 1}\n")
    return "".join(corners + faces)


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def example(mesh):
    """Hits, and million rays a second."""
    words = output(EXAMPLE, mesh).split()
    return int(words[0]), float(words[2])


class MillionRays(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def mesh(self, steps):
        path = self.folder / f"cube{steps}.obj"
        path.write_text(cube(steps), encoding="ascii")
        return str(path)


class Answer(MillionRays):
    def test_is_brute_force_s_count(self):
        mesh, rays = self.mesh(1), str(self.folder / "random.rays")
        output(RAYSHOOT, "rays", "--scene", mesh, "--kind", "random", "--size", "1000x1000",
               "--out", rays)
        counted = json.loads(output(RAYSHOOT, "count", "--scene", mesh, "--structure",
                                    "brute_force", "--rays-file", rays, "--json"))
        secondary = counted["rays"]["secondary"]
        self.assertEqual(secondary["rays"], RAYS)
        self.assertEqual(example(mesh)[0], secondary["hits"])

    def test_is_the_ratio_of_surfaces(self):
        """H0: hits are binomial with p = 2 / pi. Two-sided at 5 standard deviations, 10^6 rays."""
        share = 2 / math.pi
        deviation = math.sqrt(RAYS * share * (1 - share))
        self.assertAlmostEqual(example(self.mesh(64))[0], RAYS * share, delta=5 * deviation)

    def test_without_a_mesh_is_an_error(self):
        missing = str(self.folder / "missing.obj")
        for arguments, named in (([], "give a file"), ([missing], missing)):
            done = subprocess.run([EXAMPLE, *arguments], capture_output=True, text=True)
            self.assertEqual(done.returncode, 1)
            self.assertIn(named, done.stderr)


class Shown(unittest.TestCase):
    def test_in_the_readme_as_it_is(self):
        root = Path(__file__).resolve().parents[2]
        code = (root / "examples/million_rays/main.cpp").read_text(encoding="utf-8")
        self.assertIn(f"```cpp\n{code}```", (root / "README.md").read_text(encoding="utf-8"))


class Speed(MillionRays):
    def harness(self, mesh):
        document = json.loads(output(RAYSHOOT, "bench", "--scene", mesh, "--structure", "bvh8",
                                     "--rays", "random", "--size", "1000x1000",
                                     "--repetitions", "3", "--json"))
        row, = document["rows"]
        self.assertEqual(row["rays"], RAYS)
        return max(1e-6 * RAYS / seconds for seconds in row["seconds_samples"])

    def test_is_the_harness_s(self):
        mesh = self.mesh(64)
        own, harness = 0, 0
        for turn in range(1, MOST_TURNS + 1):
            own = max(own, *(example(mesh)[1] for _ in range(3)))
            harness = max(harness, self.harness(mesh))
            if turn >= LEAST_TURNS and own >= LEAST_RATIO * harness:
                break
        print(f"example {own:.2f}, rayshoot bench {harness:.2f} Mrays/s: {own / harness:.3f}")
        self.assertGreaterEqual(own, LEAST_RATIO * harness)


if __name__ == "__main__":
    chosen = {"answer": ["Answer", "Shown"], "speed": ["Speed"]}
    names = [test for name in sys.argv[3:] for test in chosen[name]]
    unittest.main(argv=sys.argv[:1] + names, verbosity=2)
