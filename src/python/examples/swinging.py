"""A soft bar is held at its foot, bent and let go: how it swings, where its energy goes and how it is stressed.

Cell by cell in an editor that knows `# %%`, or as a whole: python swinging.py [PICTURE.png]
"""

# %% A scene, written here: a file would do as well (sinew.load).
import json
import sys

import numpy as np

import sinew

scene = sinew.from_json(json.dumps({
    "version": 1,
    "name": "Swinging bar",
    "gravity": [0, 0, 0],
    "time": {"duration": 0.6, "frames_per_second": 120},
    "bodies": [{
        "id": "bar",
        "shape": {"box": {"center": [0, 0.045, 0], "size": [0.018, 0.09, 0.018]}},
        "material": {"young_modulus": 2e5, "mass": {"density": 1000}, "support_radius": 0.015, "damping": {"air": 2}},
        "initial": {"deformation": [[1, 0.25, 0], [0, 1, 0], [0, 0, 1]]},
        "regions": [{"id": "foot", "select": {"layers": {"axis": "y", "side": "min", "count": 2}}}],
        "pins": [{"id": "hold", "region": "foot"}],
    }],
}))

# %% Three stiffnesses, one run each; the tip is the mean of the topmost particles.
swings, stressed = {}, None
for modulus in [1e5, 2e5, 4e5]:
    scene["/bodies/0/material/young_modulus"] = modulus
    run = sinew.Simulation(scene)
    top = run.rest("bar")[:, 1] > run.rest("bar")[:, 1].max() - 1e-9
    times, tip = [run.time], [run.positions("bar")[top, 0].mean()]
    while run.time < scene["/time/duration"]:
        run.step()
        times.append(run.time)
        tip.append(run.positions("bar")[top, 0].mean())
    swings[modulus] = np.array(times), np.array(tip)
    stressed = run.positions("bar"), run.stresses("bar"), run.series()
    print(f"{modulus:.0e} Pa: from {1e3 * tip[0]:.2f} mm to {1e3 * tip[-1]:.2f} mm")

# %% How fast they swing: twice as stiff, the square root of two as fast.
def frequency(times, values):
    """Of the strongest swing [Hz]."""
    spectrum = np.abs(np.fft.rfft((values - values.mean()) * np.hanning(len(values)), 16 * len(values)))
    return np.fft.rfftfreq(16 * len(values), times[1] - times[0])[spectrum.argmax()]

found = {modulus: frequency(*swing) for modulus, swing in swings.items()}
for modulus, hertz in found.items():
    print(f"{modulus:.0e} Pa: {hertz:.2f} Hz, {hertz / found[1e5]:.3f} of the softest's")

# %% A picture, where Matplotlib is there.
if len(sys.argv) > 1:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(12, 3.6), layout="constrained")
    for modulus, (times, tip) in swings.items():
        left.plot(times, 1e3 * tip, label=f"{modulus:.0e} Pa")
    left.set(xlabel="time [s]", ylabel="tip [mm]")
    left.legend()
    places, stresses, series = stressed
    for name in ["bar: kinetic [J]", "bar: matrix [J]", "total_energy [J]"]:
        middle.plot(series["time [s]"], 1e3 * series[name], label=name.replace(" [J]", ""))
    middle.set(xlabel="time [s]", ylabel="energy [mJ]")
    middle.legend()
    colours = right.scatter(places[:, 0], places[:, 1], c=stresses, s=14)
    right.set(xlabel="x [m]", ylabel="y [m]", aspect="equal")
    figure.colorbar(colours, ax=right, label="stress [Pa]")
    figure.savefig(sys.argv[1], dpi=110)
    print(f"wrote {sys.argv[1]}")
