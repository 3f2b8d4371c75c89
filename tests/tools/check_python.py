"""What the Python package gives, held against the program (SINEW) and against what it must be."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np

import sinew

SCENE = {
    "version": 1,
    "name": "Pulled bar",
    "gravity": [0, 0, 0],
    "time": {"duration": 0.1},
    "bodies": [{
        "id": "bar",
        "shape": {"box": {"center": [0, 0.018, 0], "size": [0.018, 0.036, 0.018]}},
        "material": {"young_modulus": 1e5, "mass": {"density": 1000}, "support_radius": 0.015, "damping": {"air": 100}},
        "fibres": [{"id": "axis", "source": {"vertices": [[0, 0.006, 0], [0, 0.015, 0], [0, 0.024, 0]]},
                    "stiffness": {"rigidity": {"ea": 20, "ei": 1e-5}}}],
        "regions": [{"id": "foot", "select": {"layers": {"axis": "y", "side": "min", "count": 1}}},
                    {"id": "top", "select": {"layers": {"axis": "y", "side": "max", "count": 1}}}],
        "pins": [{"id": "hold", "region": "foot"},
                 {"id": "pull", "region": "top", "axes": ["y"], "motion": {"ramp": {
                     "direction": [0, 1, 0], "distance": {"metres": 0.001}, "duration": 0.05}}}],
    }],
    "measures": [{"name": "pull", "body": "bar", "kind": {"reaction_force": {"region": "top", "along": [0, -1, 0]}}},
                 {"name": "moved", "body": "bar", "kind": {"mean_displacement": {"region": "top"}}}],
}
MODULUS = "/bodies/0/material/young_modulus"


def scene():
    return sinew.from_json(json.dumps(SCENE))


class Python(unittest.TestCase):
    def test_arrays_are_what_the_body_is(self):
        run = sinew.Simulation(scene())
        rest, places = run.rest(), run.positions("bar")
        self.assertEqual((places.shape, places.dtype), ((3 * 6 * 3, 3), np.float64))
        np.testing.assert_array_equal(rest, places)
        self.assertFalse(run.velocities().any())
        np.testing.assert_allclose(run.strains(0), 0, atol=1e-12)
        self.assertAlmostEqual(run.masses().sum(), 1000 * 0.018 * 0.036 * 0.018)
        places += 1  # A copy: nothing moves.
        np.testing.assert_array_equal(run.positions(), rest)
        run.step(3)
        self.assertEqual((run.frame_number, run.bodies), (3, ["bar"]))
        self.assertGreater(run.velocities()[:, 1].max(), 0)
        self.assertTrue((run.stresses() >= 0).all() and run.stresses().max() > 100)
        np.testing.assert_allclose(run.fibres()["axis"][:, 0], 0, atol=1e-9)
        self.assertRaisesRegex(KeyError, "there are bar", run.positions, "rod")

    def test_a_study_of_ten_lines_gives_twice_the_force_for_twice_the_stiffness(self):
        document, forces = scene(), []
        document["/bodies/0/fibres"] = []
        for modulus in np.array([1e5, 2e5, 4e5]):
            document[MODULUS] = modulus
            run = sinew.Simulation(document)
            self.assertTrue(run.until_rest())
            forces.append(run.measures["pull"])
        np.testing.assert_allclose(np.divide(forces, forces[0]), [1, 2, 4], rtol=1e-3)
        self.assertAlmostEqual(run.measures["moved"][1], 1.0)

    def test_what_a_scene_cannot_have_is_refused_in_the_same_words(self):
        document = scene()
        self.assertRaisesRegex(ValueError, MODULUS + ".* is not above zero", document.__setitem__, MODULUS, -1)
        self.assertRaisesRegex(ValueError, "is no member of", document.__setitem__, "/bodies/0/weight", 1)
        self.assertRaisesRegex(ValueError, "[Oo]ut of range|JSON", document.__setitem__, MODULUS, float("nan"))
        self.assertRaises(KeyError, document.__getitem__, "/bodies/7")
        self.assertRaisesRegex(ValueError, "no-such.json", sinew.load, "no-such.json")
        self.assertEqual((document[MODULUS], document.name), (1e5, "Pulled bar"))
        other = document.copy()
        other[MODULUS] = 3e5
        self.assertEqual((document[MODULUS], sinew.from_json(other.to_json())[MODULUS]), (1e5, 3e5))

    def test_what_diverges_raises_and_stays_to_be_read(self):
        document = scene()
        document["/time/step"] = {"manual": {"dt": 0.05, "substeps_per_frame": 2}}
        run = sinew.Simulation(document)
        self.assertRaisesRegex(RuntimeError, "diverged", run.run, 10)
        self.assertTrue(np.isfinite(run.positions()).all())
        self.assertIn("diverged", run.report()["bodies"][0]["diverged"])

    @unittest.skipUnless(os.environ.get("SINEW"), "no program to hold it against")
    def test_the_program_comes_to_the_same_bits(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            scene().save(folder / "scene.json")
            subprocess.run([os.environ["SINEW"], "simulate", "scene.json", "--report", "r.json", "--series", "s.csv"],
                           cwd=folder, check=True, capture_output=True)
            theirs = json.loads((folder / "r.json").read_text())
            head, *rows = (folder / "s.csv").read_text().splitlines()
            run = sinew.Simulation(sinew.load(folder / "scene.json"))
        run.run()
        ours = run.report()
        self.assertEqual(ours["bodies"], theirs["bodies"])
        self.assertEqual(ours["measures"], theirs["measures"])
        self.assertEqual(list(run.series()), head.split(","))
        table = np.array([[float(value) for value in row.split(",")] for row in rows])
        np.testing.assert_array_equal(np.column_stack(list(run.series().values())), table)


if __name__ == "__main__":
    unittest.main()
