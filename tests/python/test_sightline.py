# The Python module: what it opens, runs, explains and hands out, and that the page about it is true.
# SPDX-License-Identifier: GPL-3.0-or-later
import doctest
import gc
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import warnings

import numpy as np
import sightline

root = pathlib.Path(__file__).parents[2]


def program_stats(program, *options):
    """What the program says of the same run."""
    command = [os.environ["SIGHTLINE_" + program], *options, "--headless", "--stats", "-"]
    said = subprocess.run(command, check=True, capture_output=True, text=True)
    return json.loads(said.stdout)


class SameAsTheProgram(unittest.TestCase):
    def same(self, session, stats):
        mine = session.stats()
        for name in stats:
            if name not in ("ms", "memory_bytes", "item_buffer"):
                self.assertEqual(mine[name], stats[name], name)
        self.assertEqual(session.state_hash, stats["state_hash"])
        self.assertEqual(len(session.rendered), stats["rendered"])
        self.assertEqual(len(session.visible), stats["visible"])
        self.assertEqual(len(session.missed), stats["visible"] - stats["visible_rendered"])
        self.assertEqual(session.coverage, stats["coverage"])

    def test_a_run_in_2d(self):
        session = sightline.open_2d("bottleneck", budget="20%", on_reenqueue="min", eye=(-2, 0.5))
        session.run()
        options = ["bottleneck", "--budget", "20%", "--set", "on_reenqueue=min", "--eye=-2,0.5"]
        self.same(session, program_stats("VIEWER2D", *options))

    def test_a_run_in_3d(self):
        session = sightline.open_3d("room", budget=300, method="layers", reference="software", fov=70)
        self.assertEqual(session.run(), "budget")
        options = ["room", "--budget", "300", "--method", "layers", "--set", "reference=software", "--fov", "70"]
        self.same(session, program_stats("VIEWER3D", *options))

    def test_a_file_in_its_own_coordinates(self):
        name = str(root / "examples/scenes/quarter.geojson")
        first = sightline.open_2d(name)
        self.assertGreater(first.origin[0], 1.5e6)
        eye, look_at, fov = first.view
        self.assertGreater(eye[1], 5e6)
        again = sightline.open_2d(pathlib.Path(name), eye=eye, look_at=look_at, fov=fov)
        self.assertEqual(first.run(), again.run())
        self.assertEqual(first.state_hash, again.state_hash)


class Steps(unittest.TestCase):
    def test_forward_and_back_are_one_way(self):
        session = sightline.open_2d("rooms", budget="10%")
        hashes = [session.state_hash]
        while session.step():
            hashes.append(session.state_hash)
        self.assertEqual(session.position, len(hashes) - 1)
        self.assertTrue(session.finished)
        for step in reversed(range(len(hashes) - 1)):
            self.assertTrue(session.back())
            self.assertEqual(session.state_hash, hashes[step])
        self.assertFalse(session.back())
        self.assertEqual(session.seek(7), "steps")
        self.assertEqual(session.state_hash, hashes[7])
        self.assertEqual(session.run(3), "steps")
        self.assertEqual(session.state_hash, hashes[10])

    def test_the_array_of_steps_is_what_the_records_say(self):
        session = sightline.open_2d("streets", budget="10%")
        session.run()
        steps = session.steps
        self.assertEqual(len(steps), session.position)
        before = 0
        for number, step in enumerate(steps, 1):
            record = session.record(number)
            self.assertEqual(record["item"], (sightline.kinds[step["kind"]], step["id"]))
            self.assertEqual(record["key"], step["key"])
            np.testing.assert_array_equal(record["rendered"], session.rendered[before : step["rendered"]])
            np.testing.assert_array_equal(record["rendered"], session.rendered_in(number))
            if record["runner_up"] is None:
                self.assertEqual(step["runner_up"], sightline.none)
            before = step["rendered"]
        self.assertEqual(before, len(session.rendered))
        traced = session.trace()["steps"]
        self.assertEqual([row["cell"] for row in traced], list(steps["id"]))
        for row, number in zip(traced[6]["facets"], range(3)):
            looked_at = session.record(7)["looked_at"][number]
            self.assertEqual(looked_at["rule"], row["rule"])
            if "terms" in row:
                self.assertEqual(looked_at["terms"], row["terms"])

    def test_conditions(self):
        session = sightline.open_2d("bottleneck")
        self.assertEqual(session.run_until("inversion == 1"), "breakpoint")
        record = session.record(session.position)
        self.assertEqual(record["visible_share"], 0)

    def test_another_view_starts_at_step_0(self):
        session = sightline.open_2d("bottleneck")
        session.run()
        one = session.state_hash
        eye, look_at, fov = session.view
        session.look(eye=(eye[0] + 0.5, eye[1]))
        self.assertEqual(session.position, 0)
        session.run()
        self.assertNotEqual(session.state_hash, one)
        session.look(eye, look_at, fov)
        session.run()
        self.assertEqual(session.state_hash, one)

    def test_a_copy_goes_its_own_way(self):
        session = sightline.open_2d("bottleneck")
        session.run()
        other = session.copy()
        other.change(method="layers", budget="5%")
        self.assertEqual(other.method, "layers")
        self.assertEqual(other.settings["budget"], "5%")
        self.assertNotEqual(other.state_hash, session.state_hash)
        self.assertEqual(session.settings["method"], "published")
        self.assertEqual(session.cells.first.ctypes.data, other.cells.first.ctypes.data)


class Arrays(unittest.TestCase):
    def test_they_share_memory_and_keep_it(self):
        session = sightline.open_2d("bottleneck")
        cells = session.cells
        views = [session.primitives, cells.first, cells.primitives, cells.points, cells.corners]
        for array, again in zip(views, [session.primitives, session.cells.first, session.cells.primitives]):
            self.assertEqual(array.ctypes.data, again.ctypes.data)
        copies = [array.copy() for array in views]
        for array in views:
            self.assertFalse(array.flags.owndata)
            with self.assertRaises(ValueError):
                array[...] = 0
        del session, cells
        gc.collect()
        noise = [sightline.open_2d("rooms") for _ in range(3)]  # takes memory that was given back
        for array, copy in zip(views, copies):
            np.testing.assert_array_equal(array, copy)
        del noise

    def test_what_a_run_rendered_stays_as_it_was_taken(self):
        session = sightline.open_2d("bottleneck")
        session.run(5)
        five = session.rendered
        kept = five.copy()
        session.run()
        self.assertGreater(len(session.rendered), len(five))
        np.testing.assert_array_equal(five, kept)
        np.testing.assert_array_equal(session.rendered[: len(five)], five)
        del session
        gc.collect()
        np.testing.assert_array_equal(five, kept)

    def test_cells_hold_the_primitives(self):
        session = sightline.open_3d("room", error_bound=0.1, tessellation="kd")
        cells = session.cells
        self.assertEqual(cells.kind, "kd")
        self.assertEqual(len(cells.first), len(cells) + 1)
        counts = np.diff(cells.first)
        self.assertEqual(counts.max(), cells.rho_max)
        self.assertEqual(cells.corners.shape, (len(cells), 8))
        self.assertEqual(session.primitives.shape[1:], (3, 3))
        session.run(20)
        np.testing.assert_array_equal(session.field("count"), counts)
        states = session.cell_states
        projected = sightline.cell_states.index("projected")
        self.assertEqual(set(np.flatnonzero(states == projected)), set(session.steps["id"]))
        keys = session.field("rho")
        for step in session.steps:
            self.assertEqual(keys[step["id"]], step["key"])
        self.assertTrue(np.isnan(keys[states == sightline.cell_states.index("clean")]).all())
        for cell in range(0, len(cells), 97):
            for other in cells.neighbours(cell):
                if other is not None:
                    self.assertIn(cell, cells.neighbours(other))

    def test_a_scene_from_an_array(self):
        walls = np.array([[(0, y), (10, y)] for y in (2, 3, 4)], float)
        session = sightline.open_2d(walls, eye=(5, 0), look_at=(5, 1), fov=90)
        np.testing.assert_array_equal(session.primitives, walls)
        session.run()
        np.testing.assert_array_equal(session.visible, [0])
        self.assertIn(0, session.rendered)
        cube = np.array([[(0, 5, 0), (1, 5, 0), (0, 5, 1)], [(0, 9, 0), (1, 9, 0), (0, 9, 1)]], np.float32)
        session = sightline.open_3d(cube, eye=(0.3, 0, 0.3), look_at=(0.3, 1, 0.3))
        session.run()
        np.testing.assert_array_equal(session.visible, [0])
        self.assertGreater(session.pixels[0], 0)
        self.assertEqual(session.wrong_pixels, 0)
        with self.assertWarnsRegex(UserWarning, "1 of zero length, 1 duplicates"):
            session = sightline.open_2d([[(0, 0), (1, 0)], [(1, 1), (1, 1)], [(1, 0), (0, 0)]])
        self.assertEqual(len(session.primitives), 1)


class Objects(unittest.TestCase):
    def test_names(self):
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "two.obj")
            pathlib.Path(name).write_text(
                "o near\nv 0 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\no far\nv 5 0 0\nv 5 1 0\nv 5 0 1\nf 4 5 6\n"
            )
            session = sightline.open_3d(name)
        self.assertEqual(len(session.objects), 2)
        self.assertEqual(len(session.object_of), len(session.primitives))
        said = session.explain_primitive(1)
        self.assertEqual(said["object"], session.objects[session.object_of[1]])


class Why(unittest.TestCase):
    def test_verdicts_are_those_of_the_program(self):
        session = sightline.open_2d("rooms", budget="10%")
        session.run()
        missed = int(session.missed[0])
        primitive = session.explain_primitive(missed, changes=True)
        self.assertTrue(primitive["visible"])
        self.assertIsNone(primitive["met_at"])
        self.assertIn(f"Segment {missed} is", primitive["sentences"][0])
        cell = session.explain_cell(primitive["held_by"][0])
        self.assertNotEqual(cell["state"], "projected")
        self.assertTrue(cell["verdict"]["sentence"])
        self.assertNotIn("changes", cell)
        # A change that brings it does so in a run.
        helped = [row for row in primitive["changes"] if row["step"]]
        self.assertTrue(helped)
        other = session.copy()
        name, value = helped[0]["change"].split("=")
        other.change(**{name: value})
        other.run()
        self.assertIn(missed, other.rendered)
        self.assertIn(missed, other.rendered_in(helped[0]["step"]))


class OwnHeuristic(unittest.TestCase):
    def test_it_runs_as_the_same_formula_does(self):
        for open_scene, scene, limit in ((sightline.open_2d, "streets", "unlimited"), (sightline.open_3d, "room", "20%")):
            for key, text in (
                (lambda f: f.handed_on + f.content, "handed_on + content"),
                (lambda f: f.content + f.angle * f.handed_on + f.hops / 100, "content + angle * handed_on + hops / 100"),
                (lambda f: f.depth + f.own_content * f.star + f.facing + f.area, "depth + own_content * star + facing + area"),
            ):
                mine = open_scene(scene, method=key, on_reenqueue="min", budget=limit)
                formula = open_scene(scene, method="formula", key=text, on_reenqueue="min", budget=limit)
                self.assertEqual(mine.run(), formula.run())
                self.assertEqual(mine.state_hash, formula.state_hash, text)
                self.assertEqual(mine.coverage, formula.coverage)
                end = mine.state_hash
                mine.seek(mine.position // 2)
                mine.run()
                self.assertEqual(mine.state_hash, end)

    def test_it_is_explained(self):
        def crowd(facet):
            return facet.handed_on + facet.content

        session = sightline.open_2d("rooms", method=crowd, budget="10%")
        session.run()
        self.assertIn("crowd", session.methods)
        self.assertEqual(session.method, "crowd")
        rows = [row for row in session.record(9)["looked_at"] if "key" in row]
        self.assertTrue(rows)
        for row in rows:
            self.assertEqual(set(row["terms"]), {"handed_on", "content", "key"})
            self.assertEqual(row["terms"]["handed_on"] + row["terms"]["content"], row["key"])
            self.assertIn("crowd(facet) = ", row["formula"])
        changes = session.explain_primitive(int(session.missed[0]), changes=True)["changes"]
        self.assertIn("on_reenqueue=min", [row["change"] for row in changes])

    def test_it_has_an_id_and_parameters(self):
        near = sightline.Heuristic(lambda f: (f.distance, f.star == 0), id="near-2", seed_key=-1, title="nearest")
        session = sightline.open_2d("rooms", heuristics=[near], method="near-2 on_reenqueue=max", budget="5%")
        session.run()
        self.assertEqual(session.method, "near-2 on_reenqueue=max")
        self.assertEqual(session.steps["key"][0], -1)
        session.change(method="layers")
        session.run()
        session.change(method="near-2")
        self.assertEqual(session.settings["on_reenqueue"], "max")

    def test_the_geometry_that_it_sees(self):
        seen = []

        def key(facet):
            seen.append((facet.cell, facet.neighbour, facet.centroid, facet.normal, facet.centre, facet.eye, facet.facet))
            return facet.handed_on + 1

        session = sightline.open_3d("room", method=key, budget=50)
        session.run()
        self.assertTrue(seen)
        eye = session.view[0]
        for cell, neighbour, centroid, normal, centre, at, _ in seen:
            self.assertIn(neighbour, session.cells.neighbours(cell))
            np.testing.assert_allclose(np.linalg.norm(normal), 1)
            self.assertGreater(np.dot(np.subtract(centre, centroid), normal), 0)
            self.assertEqual(at, eye)

    def test_what_goes_wrong_in_it_is_told(self):
        calls = []

        def fails(facet):
            calls.append(facet)
            if len(calls) > 20:
                raise KeyError("no such wall")
            return facet.handed_on

        session = sightline.open_2d("streets", method=fails)
        with self.assertRaisesRegex(KeyError, "no such wall"):
            session.run()
        with self.assertRaisesRegex(sightline.WorkError, "failed inside step"):
            session.run()
        with self.assertRaisesRegex(RuntimeError, "only while the function"):
            calls[0].content
        for result, error in (("high", TypeError), (None, TypeError), (math.nan, ValueError)):
            with self.assertRaises(error):
                sightline.open_2d("streets", method=lambda facet: result).run()
        with self.assertRaisesRegex(sightline.InputError, "published already"):
            sightline.open_2d("streets", method=sightline.Heuristic(lambda f: 0, id="published"))
        with self.assertRaises(sightline.InputError):
            sightline.Heuristic(lambda f: 0, id="two words")

    def test_sessions_with_it_go_away(self):
        import weakref

        class Key:
            __name__ = "key"

            def __call__(self, facet):
                return facet.handed_on + 1

        key = Key()
        gone = weakref.ref(key)
        session = sightline.open_2d("bottleneck", method=key.__call__)
        session.run()
        del session, key
        gc.collect()
        self.assertIsNone(gone())


class Errors(unittest.TestCase):
    def test_they_say_what_the_program_says(self):
        for message, call in (
            ("nope: no such file", lambda: sightline.open_2d("nope")),
            ("method 'x' does not exist; there are published", lambda: sightline.open_3d("room", method="x")),
            ("budget 'much'", lambda: sightline.open_2d("bottleneck", budget="much")),
            ("setting 'foo' does not exist", lambda: sightline.open_2d("bottleneck", foo=3)),
            ("auto=on is for the viewers", lambda: sightline.open_2d("bottleneck", auto="on")),
            ("a point has 2 numbers", lambda: sightline.open_2d("bottleneck", eye=(1, 2, 3))),
            ("shape \\(n, 2, 2\\)", lambda: sightline.open_2d(np.zeros((3, 2, 3)))),
            ("no field height: it has rho", lambda: sightline.open_2d("bottleneck").field("height")),
            ("two_sided decides", lambda: sightline.open_3d("room").change(two_sided=True)),
        ):
            with self.assertRaisesRegex(sightline.InputError, message):
                call()
            with self.assertRaises(ValueError):
                call()
        session = sightline.open_2d("bottleneck")
        for call in (
            lambda: session.explain_cell(10**7),
            lambda: session.explain_primitive(-1 % 2**40),
            lambda: session.record(1),
            lambda: session.rendered_in(0),
            lambda: session.cells.neighbours(10**7),
        ):
            with self.assertRaises(IndexError):
                call()


class Pages(unittest.TestCase):
    def test_what_the_page_shows_is_so(self):
        text = (root / "docs/python.md").read_text()
        blocks = re.findall(r"```pycon\n(.*?)```", text, re.S)
        self.assertGreater(len(blocks), 3)
        test = doctest.DocTestParser().get_doctest("\n".join(blocks), {}, "docs/python.md", "docs/python.md", 0)
        runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
        os.chdir(root)
        self.assertEqual(runner.run(test).failed, 0)

    def test_the_page_names_all_there_is(self):
        text = (root / "docs/python.md").read_text()
        for of in (sightline.Session2d, sightline.Session3d, sightline.Cells2d, sightline.Facet2d):
            for name in vars(of):
                if not name.startswith("_"):
                    self.assertTrue(f"`{name}" in text, f"{of}: {name} is not there")

    def test_the_example_runs(self):
        said = subprocess.run(
            [sys.executable, str(root / "examples/python/own_heuristic.py")], check=True, capture_output=True, text=True
        )
        self.assertRegex(said.stdout, r"crowd +coverage 0\.\d+ \(median\), 0\.\d+ \(lowest\)\npublished +coverage 0\.")


if __name__ == "__main__":
    warnings.simplefilter("error")
    unittest.main()
