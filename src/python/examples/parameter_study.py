"""How far a clamped rod sags by its own weight, over its Young's modulus: python parameter_study.py scenes/cantilever.json"""

import sys

import sinew

scene = sinew.load(sys.argv[1])
for modulus in [5e5, 1e6, 2e6]:
    scene["/bodies/0/material/young_modulus"] = modulus
    run = sinew.Simulation(scene)
    run.until_rest()
    print(f"{modulus:8.1e} Pa", *(f"{name} {value}" for name, value in run.measures.items()))
