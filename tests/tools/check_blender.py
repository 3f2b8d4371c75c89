"""Takes a mesh of Blender's through sinew and back: by the add-on of assets/blender as a Mesh Cache on the same mesh, and by USD.

    python check_blender.py SINEW FOLDER

Needs `bpy`. What Blender shows at frames 1, 30 and 60 is held against the numbers in the files, which are put where they belong
by figures that are known here and not by those that the add-on finds. Ends with 1 at the first thing that differs.
"""

import importlib.util
import json
import math
import os
import subprocess
import sys
from pathlib import Path

SINEW, FOLDER = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
os.environ["SINEW"] = str(SINEW)

import bpy
import numpy as np
from mathutils import Euler, Matrix

ROOT = Path(__file__).resolve().parents[2]
FRAMES = (1, 30, 60)
RATE = 24

# Where the scene puts the mesh.
SHIFT = np.array([0.1, 0.3, -0.2])
DEGREES = 90.0


def check(holds, text):
    if not holds:
        sys.exit(f"FAILED: {text}")


def apart(a, b):
    check(a.shape == b.shape, f"{a.shape} numbers in place of {b.shape}")
    return float(np.abs(a - b).max())


def addon():
    spec = importlib.util.spec_from_file_location("sinew_motion", ROOT / "assets/blender/sinew_motion.py")
    module = importlib.util.module_from_spec(spec)
    sys.modules["sinew_motion"] = module
    spec.loader.exec_module(module)
    module.register()
    return module


def barrel():
    """A barrel whose caps are polygons of twelve corners and whose sides have a seam, two materials, a vertex group."""
    sides, rows = 12, 9
    ring = [(0.02 * math.cos(2 * math.pi * k / sides), 0.02 * math.sin(2 * math.pi * k / sides)) for k in range(sides)]
    vertices = [(x, y, 0.09 * row / (rows - 1)) for row in range(rows) for x, y in ring]
    faces, uvs = [list(reversed(range(sides)))], [(0.5 + 20 * x, 0.5 + 20 * y) for x, y in reversed(ring)]
    for row in range(rows - 1):
        for k in range(sides):
            a, b = row * sides + k, row * sides + (k + 1) % sides
            faces.append([a, b, b + sides, a + sides])
            left, right, low, high = k / sides, (k + 1) / sides, row / (rows - 1), (row + 1) / (rows - 1)
            uvs += [(left, low), (right, low), (right, high), (left, high)]
    faces.append(list(range((rows - 1) * sides, rows * sides)))
    uvs += [(0.5 + 20 * x, 0.5 + 20 * y) for x, y in ring]
    mesh = bpy.data.meshes.new("barrel")
    mesh.from_pydata(vertices, [], faces)
    layer = mesh.uv_layers.new(name="own")
    for corner, uv in zip(layer.data, uvs):
        corner.uv = uv
    for name, colour in (("paint", (0.8, 0.1, 0.1, 1)), ("cap", (0.1, 0.1, 0.8, 1))):
        material = bpy.data.materials.new(name)
        material.diffuse_color = colour
        mesh.materials.append(material)
    for polygon in mesh.polygons:
        polygon.material_index = int(len(polygon.vertices) > 4)
    mesh.validate()
    obj = bpy.data.objects.new("My barrel", mesh)
    bpy.context.collection.objects.link(obj)
    obj.vertex_groups.new(name="low").add(range(12), 1.0, "REPLACE")
    # Neither at the origin nor upright nor of size one.
    obj.matrix_world = Matrix.LocRotScale((1, 2, 3), Euler((0.3, -0.2, 0.5)), (2, 2, 2))
    bpy.context.view_layer.objects.active = obj
    obj.select_set(True)
    bpy.context.view_layer.update()
    return obj


def described(mesh):
    """All that must stay as it was."""
    uvs = [[round(c, 6) for corner in layer.data for c in corner.uv] for layer in mesh.uv_layers]
    return {
        "faces": [list(polygon.vertices) for polygon in mesh.polygons],
        "materials": [polygon.material_index for polygon in mesh.polygons],
        "groups": [[group.group for group in vertex.groups] for vertex in mesh.vertices],
        "uvs": uvs,
    }


def shown(obj, frame):
    """The vertices that Blender shows at a frame, in the object's frame, and the mesh that it shows."""
    bpy.context.scene.frame_set(frame)
    evaluated = obj.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = evaluated.data
    points = np.empty(3 * len(mesh.vertices), dtype=np.float32)
    mesh.vertices.foreach_get("co", points)
    return points.reshape(-1, 3).astype(np.float64), mesh, np.array(evaluated.matrix_world)


def write_scene(path, model):
    scene = {
        "version": 1,
        "name": "Barrel",
        # Within a fall of the mesh, which stands three metres up.
        "room": {"floor": 3.1},
        "time": {"duration": 2.5, "frames_per_second": RATE},
        "bodies": [
            {
                "id": "barrel",
                "name": "My barrel",
                "shape": {"mesh": {"path": model.name, "particles": 400}},
                "placement": {
                    "translation": list(SHIFT),
                    "rotation": {"axis": [0, 1, 0], "degrees": DEGREES},
                },
                "material": {"young_modulus": 2e5, "mass": {"density": 1000}, "support_radius": 0.02},
            }
        ],
    }
    path.write_text(json.dumps(scene))


def main():
    module = addon()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    module_path = module.__name__
    check(module_path == "sinew_motion", "the add-on has another name")
    scene = bpy.context.scene
    scene.render.fps, scene.render.fps_base = RATE, 1.0
    scene.frame_start, scene.frame_end = 1, 61
    bpy.ops.wm.save_as_mainfile(filepath=str(FOLDER / "work.blend"))
    obj = barrel()
    own = module.vertices_of(obj)
    before = described(obj.data)

    check(bpy.ops.sinew.send() == {"FINISHED"}, "the mesh is not sent")
    sent = Path(obj[module.FOLDER]) / "My_barrel.obj"
    matrix = np.array(obj.matrix_world)
    world = own @ matrix[:3, :3].T + matrix[:3, 3]
    written = module.read_vertices(sent)
    check(apart(written, world[:, [0, 2, 1]] * [1, 1, -1]) < 1e-6, "the sent vertices are elsewhere")
    write_scene(sent.with_name("scene.json"), sent)

    check(bpy.ops.sinew.fetch() == {"FINISHED"}, "no motion is fetched")
    _, first, samples = module.read_head(sent.parent / "motion/My_barrel.pc2")
    check((first, samples) == (0, 61), f"the cache has {samples} frames from {first}")
    frames = list(module.frames_of(sent.parent / "motion/My_barrel.pc2"))
    # From where the scene has put the body back to the file, to Blender's axes, to the object's frame.
    turn, local = math.radians(DEGREES), np.linalg.inv(matrix)
    about_y = np.array([[math.cos(turn), 0, math.sin(turn)], [0, 1, 0], [-math.sin(turn), 0, math.cos(turn)]])
    greatest = 0.0
    for frame in FRAMES:
        in_file = (frames[frame - 1] - SHIFT) @ about_y
        in_blender = in_file[:, [0, 2, 1]] * [1, -1, 1]
        expected = in_blender @ local[:3, :3].T + local[:3, 3]
        points, mesh, _ = shown(obj, frame)
        greatest = max(greatest, apart(points, expected))
        check(greatest < 2e-6, f"the Mesh Cache is {greatest} off at frame {frame}")
        check(described(mesh) == before, f"faces, UVs, materials or groups differ at frame {frame}")
    moved = apart(shown(obj, 60)[0], own)
    check(moved > 0.05, f"the mesh has moved by {moved} only")
    check(apart(module.vertices_of(obj), own) == 0.0 and described(obj.data) == before, "the mesh itself was changed")
    print(f"bpy {bpy.app.version_string}, Mesh Cache: frames 1, 30, 60 within {greatest:.1e} of the cache, on the mesh itself")

    # Once more, from a mesh that was changed since: a sentence, and what is there stays.
    obj.data.vertices[0].co.x += 0.01
    try:
        module.fetch(bpy.context, obj, str(sent.parent / "motion"))
        check(False, "a cache of another mesh is taken")
    except module.Refused as refused:
        check("send it again" in str(refused), str(refused))

    command = [SINEW, "simulate", sent.with_name("scene.json"), "--format", "usd,pc2", "--out", FOLDER / "usd"]
    subprocess.run([*command, "--fps", str(RATE)], check=True, stdout=subprocess.DEVNULL)
    frames = list(module.frames_of(FOLDER / "usd/My_barrel.pc2"))
    bpy.ops.wm.usd_import(filepath=str(FOLDER / "usd/motion.usda"), set_frame_range=False)
    imported = [o for o in bpy.context.selected_objects if o.type == "MESH"]
    check(len(imported) == 1, f"USD brings {len(imported)} meshes")
    greatest = 0.0
    for frame in FRAMES:
        points, mesh, matrix = shown(imported[0], frame)
        world = points @ matrix[:3, :3].T + matrix[:3, 3]
        greatest = max(greatest, apart(world, frames[frame][:, [0, 2, 1]] * [1, -1, 1]))
        check(greatest < 2e-6, f"USD is {greatest} off at frame {frame}")
        after = described(mesh)
        check(after["faces"] == before["faces"], f"USD's faces differ at frame {frame}")
        off = max(abs(a - b) for a, b in zip(after["uvs"][0], before["uvs"][0]))
        check(len(after["uvs"][0]) == len(before["uvs"][0]) and off < 1e-5, f"USD's UVs are {off} off")
    names = sorted(slot.material.name.split(".")[0] for slot in imported[0].material_slots if slot.material)
    check(names == ["cap", "paint"], f"USD's materials are {names}")
    print(f"bpy {bpy.app.version_string}, USD: frames 1, 30, 60 within {greatest:.1e}, faces, UVs and materials as they were")


if __name__ == "__main__":
    main()
