"""Reads what `sinew simulate --format usd,gltf,obj,ply --out FOLDER` wrote with other programs' readers.

    check_exports.py FOLDER [MODEL]    looks at a run, whose first body is of the file MODEL
    check_exports.py --make FOLDER     makes a scene there of a model with seams, polygons, normals, colours and materials

The OBJ files of the same run are what all else is held against, and of MODEL its vertices and faces, their number and order. Needs `pxr` (usd-core); `trimesh`, `plyfile` and the node
package `gltf-validator` (in the folder NODE_PATH) are used where they are there, and told to be missing where they are not.
Ends with 1 at the first thing that differs.
"""

import json
import math
import os
import subprocess
import sys
from pathlib import Path

from pxr import Usd, UsdGeom, UsdShade

# Single precision of places within a few metres.
NEAR = 1e-6

# Normals and colours go out with six digits.
ROUGHLY = 3e-6


def fail(text):
    sys.exit(f"FAILED: {text}")


def check(holds, text):
    if not holds:
        fail(text)


class Obj:
    """Objects of an OBJ file: vertices and their colours, faces as vertices, texture coordinates, normals and looks, lines."""

    def __init__(self, path):
        self.objects, self.uvs, self.normals, vertices = [], [], [], 0
        group, material = "", ""
        for line in path.read_text().splitlines():
            kind, _, rest = line.partition(" ")
            words = rest.split()
            if kind == "o":
                first = vertices
                self.objects.append({"name": rest} | {key: [] for key in ("v", "c", "f", "t", "n", "look", "l")})
            elif kind == "g":
                group = rest
            elif kind == "usemtl":
                material = rest
            elif kind == "v":
                vertices += 1
                numbers = [float(word) for word in words]
                self.objects[-1]["v"].append(numbers[:3])
                if len(numbers) == 6:
                    self.objects[-1]["c"].append([linear(share) for share in numbers[3:]])
            elif kind == "vn":
                self.normals.append([float(word) for word in words])
            elif kind == "vt":
                self.uvs.append([float(word) for word in words])
            elif kind == "f":
                corners = [word.split("/") for word in words]
                self.objects[-1]["f"].append([int(corner[0]) - 1 - first for corner in corners])
                number = lambda corner, at: int(corner[at]) - 1 if len(corner) > at and corner[at] else None
                self.objects[-1]["t"].append([number(corner, 1) for corner in corners])
                self.objects[-1]["n"].append([number(corner, 2) for corner in corners])
                self.objects[-1]["look"].append((group, material))
            elif kind == "l":
                self.objects[-1]["l"].append([int(word) - 1 - first for word in words])


def linear(share):
    """Colours of OBJ are meant for the screen."""
    return share / 12.92 if share <= 0.04045 else ((share + 0.055) / 1.055) ** 2.4


def apart(a, b):
    check(len(a) == len(b), f"{len(a)} points in place of {len(b)}")
    return max((abs(x - y) for p, q in zip(a, b) for x, y in zip(p, q)), default=0.0)


def check_usd(folder, frames):
    stage = Usd.Stage.Open(str(folder / "motion.usda"))
    numbers = sorted(frames)
    span = (stage.GetStartTimeCode(), stage.GetEndTimeCode())
    check(span == (numbers[0], numbers[-1]), f"USD goes over {span}")
    check(stage.GetDefaultPrim().GetName() == "Scene", "USD has no default prim")
    surfaces = [prim for prim in stage.Traverse() if prim.IsA(UsdGeom.Mesh) or prim.IsA(UsdGeom.Points)]
    greatest = 0.0
    for number, obj in frames.items():
        bodies = [o for o in obj.objects if "." not in o["name"]]
        check(len(bodies) == len(surfaces), f"USD has {len(surfaces)} surfaces in place of {len(bodies)}")
        for prim, body in zip(surfaces, bodies):
            points = UsdGeom.PointBased(prim).GetPointsAttr().Get(number)
            greatest = max(greatest, apart(points, body["v"]))
            check(greatest < NEAR, f"USD's {prim.GetPath()} is {greatest} off in frame {number}")
            low, high = UsdGeom.Boundable(prim).GetExtentAttr().Get(number)
            # Points are as large as they are drawn.
            half = 0.5 * UsdGeom.Points(prim).GetWidthsAttr().Get()[0] if prim.IsA(UsdGeom.Points) else 0.0
            check(apart([low], [[min(p[k] for p in points) - half for k in range(3)]]) < NEAR, "USD's extent")
            check(apart([high], [[max(p[k] for p in points) + half for k in range(3)]]) < NEAR, "USD's extent")
            if not prim.IsA(UsdGeom.Mesh):
                continue
            mesh = UsdGeom.Mesh(prim)
            check(list(mesh.GetFaceVertexCountsAttr().Get()) == [len(face) for face in body["f"]], "USD's face counts")
            corners = [corner for face in body["f"] for corner in face]
            check(list(mesh.GetFaceVertexIndicesAttr().Get()) == corners, "USD's face vertices")
            check(len(mesh.GetVelocitiesAttr().Get(number)) == len(points), "USD's velocities")
            textures = [corner for face in body["t"] for corner in face]
            if any(texture is not None for texture in textures):
                st = UsdGeom.PrimvarsAPI(prim).GetPrimvar("st")
                check(st.GetInterpolation() == "faceVarying", "USD's texture coordinates are not corner by corner")
                # A corner without any has the origin.
                uvs = [[0.0, 0.0] if texture is None else obj.uvs[texture] for texture in textures]
                check(apart(st.ComputeFlattened(), uvs) < NEAR, "USD's UVs")
            lit = [obj.normals[normal] for face in body["n"] for normal in face if normal is not None]
            if lit:
                found = mesh.GetNormalsAttr().Get(number)
                if mesh.GetNormalsInterpolation() == "vertex":
                    found = [found[vertex] for face in body["f"] for vertex in face]
                check(apart(found, lit) < ROUGHLY, f"USD's normals in frame {number}")
            if body["c"]:
                colours = UsdGeom.PrimvarsAPI(prim).GetPrimvar("displayColor")
                check(colours.GetInterpolation() == "vertex", "USD's colours are not vertex by vertex")
                check(apart(colours.Get(), body["c"]) < ROUGHLY, "USD's colours")
            check_looks(prim, body)
        check_curves(stage, obj, number)
    check_materials(surfaces)
    check_velocities(stage, surfaces, numbers)
    print(f"usd-core: {len(frames)} frames, places within {greatest:.1e}")


def check_looks(prim, body):
    """Every face is of the part and of the material that it is of in the OBJ file, by their names."""
    word = lambda name: "".join("_" if c.isspace() else c for c in name)
    subsets = UsdGeom.Subset.GetAllGeomSubsets(UsdGeom.Imageable(prim))
    if not subsets:
        return
    found = [None] * len(body["f"])
    for subset in subsets:
        material = "none"
        if subset.GetPrim().HasAPI(UsdShade.MaterialBindingAPI):
            bound, _ = UsdShade.MaterialBindingAPI(subset).ComputeBoundMaterial()
            material = bound.GetPrim().GetDisplayName() or bound.GetPrim().GetName()
        for face in subset.GetIndicesAttr().Get():
            check(found[face] is None, f"USD's face {face} is in two parts")
            found[face] = (word(subset.GetPrim().GetDisplayName()), word(material))
    check(found == body["look"], f"USD's parts are {set(found)} in place of {set(body['look'])}")


def check_curves(stage, obj, number):
    lines = [o["v"] for o in obj.objects if "." in o["name"]]
    found = []
    for prim in stage.Traverse():
        if prim.IsA(UsdGeom.BasisCurves) and prim.GetName().endswith("_fibres"):
            curves = UsdGeom.BasisCurves(prim)
            points, first = curves.GetPointsAttr().Get(number), 0
            tensions = UsdGeom.PrimvarsAPI(prim).GetPrimvar("tension").Get(number)
            check(len(tensions) == len(points), "USD's tensions")
            check(len(curves.GetWidthsAttr().Get()) == len(curves.GetCurveVertexCountsAttr().Get()), "USD's widths")
            for count in curves.GetCurveVertexCountsAttr().Get():
                found.append(points[first : first + count])
                first += count
    check(len(found) == len(lines), f"USD has {len(found)} fibres in place of {len(lines)}")
    for a, b in zip(found, lines):
        check(apart(a, b) < NEAR, "USD's fibres lie elsewhere")


def check_materials(surfaces):
    for prim in surfaces:
        for subset in UsdGeom.Subset.GetAllGeomSubsets(UsdGeom.Imageable(prim)):
            if subset.GetPrim().HasAPI(UsdShade.MaterialBindingAPI):
                material, _ = UsdShade.MaterialBindingAPI(subset).ComputeBoundMaterial()
                check(bool(material), f"USD's {subset.GetPath()} has no material")


def check_velocities(stage, surfaces, numbers):
    """Where a vertex keeps its velocity, more or less, the mean of two is the way between two frames."""
    rate, looked, off = stage.GetTimeCodesPerSecond(), 0, 0
    for prim in surfaces:
        body = UsdGeom.PointBased(prim)
        for a, b in zip(numbers, numbers[1:]):
            points = [body.GetPointsAttr().Get(at) for at in (a, b)]
            velocities = [body.GetVelocitiesAttr().Get(at) for at in (a, b)]
            for p, q, v, w in zip(*points, *velocities):
                way = [(y - x) * rate for x, y in zip(p, q)]
                size = max(max(map(abs, way)), 0.05)
                if max(abs(x - y) for x, y in zip(v, w)) < 0.2 * size:
                    looked += 1
                    off += max(abs(0.5 * (x + y) - z) for x, y, z in zip(v, w, way)) > 0.2 * size
    check(looked == 0 or off < 0.25 * looked, f"{off} of {looked} of USD's velocities are not those of the motion")


def check_gltf(folder, frames):
    path = folder / "motion.glb"
    script = (
        "const v = require('gltf-validator'), fs = require('fs');"
        "v.validateBytes(new Uint8Array(fs.readFileSync(process.argv[1])))"
        ".then(r => console.log(JSON.stringify(r))).catch(e => { console.error(e); process.exit(3) })"
    )
    try:
        run = subprocess.run(["node", "-e", script, str(path)], capture_output=True, text=True)
    except FileNotFoundError:
        run = None
    if run is None or run.returncode != 0:
        print("gltf-validator: skipped, it is not there")
    else:
        issues = json.loads(run.stdout)["issues"]
        check(issues["numErrors"] == 0 and issues["numWarnings"] == 0, f"gltf-validator: {issues['messages'][:5]}")
        print(f"gltf-validator: {issues['numErrors']} errors, {issues['numWarnings']} warnings")
    data = path.read_bytes()
    length = int.from_bytes(data[12:16], "little")
    document, binary = json.loads(data[20 : 20 + length]), data[28 + length :]
    greatest = 0.0
    for index, (number, obj) in enumerate(sorted(frames.items())):
        bodies = [o for o in obj.objects if "." not in o["name"]]
        for mesh, body in zip(document["meshes"], bodies):
            primitive = mesh["primitives"][0]
            base = vectors(document, binary, primitive["attributes"]["POSITION"])
            moved = vectors(document, binary, primitive["targets"][index]["POSITION"])
            points = [[a + b for a, b in zip(*pair)] for pair in zip(base, moved)]
            # The file's own vertices come first, copies at seams behind them.
            greatest = max(greatest, apart(points[: len(body["v"])], body["v"]))
            if "NORMAL" in primitive["attributes"]:
                base = vectors(document, binary, primitive["attributes"]["NORMAL"])
                turned = vectors(document, binary, primitive["targets"][index]["NORMAL"])
                own = {}
                for face, normals in zip(body["f"], body["n"]):
                    for vertex, normal in zip(face, normals):
                        own.setdefault(vertex, []).append(obj.normals[normal])
                for vertex, normals in own.items():
                    is_now = [a + b for a, b in zip(base[vertex], turned[vertex])]
                    off = min(apart([is_now], [normal]) for normal in normals)
                    check(off < ROUGHLY, f"glTF's normal of vertex {vertex} is {off} off in frame {number}")
    check(greatest < NEAR, f"glTF is {greatest} off")
    print(f"glTF: {len(frames)} targets, the file's vertices first, places within {greatest:.1e}")


def vectors(document, binary, number):
    import struct

    accessor = document["accessors"][number]
    view = document["bufferViews"][accessor["bufferView"]]
    at = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    return [struct.unpack_from("<3f", binary, at + 12 * k) for k in range(accessor["count"])]


def check_ply(folder, frames):
    try:
        import trimesh
        from plyfile import PlyData
    except ImportError as missing:
        print(f"PLY: skipped, {missing.name} is not there")
        return
    for number, obj in frames.items():
        bodies = [o for o in obj.objects if "." not in o["name"]]
        points = [v for o in bodies for v in o["v"]]
        first, faces = 0, []
        for body in bodies:
            faces += [[first + corner for corner in face] for face in body["f"]]
            first += len(body["v"])
        path = folder / f"frame_{number:06}.ply"
        mesh = PlyData.read(path)
        read = [[float(row[axis]) for axis in "xyz"] for row in mesh["vertex"]]
        check(apart(read, points) < NEAR, f"plyfile finds other places in frame {number}")
        check([list(row[0]) for row in mesh["face"]] == faces, f"plyfile finds other faces in frame {number}")
        check(all(math.isfinite(row[name]) for row in mesh["vertex"] for name in ("vx", "vy", "vz")), "PLY's velocities")
        if any(body["c"] for body in bodies):
            colours = [[linear(int(row[name]) / 255) for name in ("red", "green", "blue")] for row in mesh["vertex"]]
            wanted = [colour for body in bodies for colour in body["c"] or [[1.0] * 3] * len(body["v"])]
            check(apart(colours, wanted) < 0.01, "PLY's colours")
        # trimesh reads faces of one number of corners only.
        if len({len(face) for face in faces}) == 1:
            mesh = trimesh.load(path, process=False)
            check(len(mesh.vertices) == len(points) or "texcoord" in str(PlyData.read(path)["face"]), "trimesh's vertices")
        cloud = trimesh.load(folder / f"particles_{number:06}.ply", process=False)
        check(len(cloud.vertices) > 0, "trimesh finds no particles")
    print(f"plyfile, trimesh: {len(frames)} meshes and clouds of particles")


def make(folder):
    """A prism of seven sides with caps of seven corners, a vertex that nothing uses, a seam, normals that are those of no face."""
    sides, rows, lines = 7, 5, ["mtllib prism.mtl", "o shell", "v 0.5 0.5 0.5 1 1 1"]
    angle = lambda k: 2 * math.pi * k / sides
    for row in range(rows):
        for k in range(sides):
            place = (0.03 * math.cos(angle(k)), 0.03 * math.sin(angle(k)), 0.08 * row / (rows - 1))
            lines.append("v %.6f %.6f %.6f %.4f 0.5 0.25" % (*place, k / sides))
            lines.append("vn %.6f %.6f %.6f" % (0.8 * math.cos(angle(k)), 0.8 * math.sin(angle(k)), 0.6))
    lines += ["vn 0 0 -1", "vn 0 0 1"]
    lines += [f"vt {k / sides:.6f} {row / (rows - 1):.6f}" for row in range(rows) for k in range(sides + 1)]
    vertex = lambda row, k: row * sides + k % sides
    lines.append("usemtl red paint")
    for row in range(rows - 1):
        for k in range(sides):
            around = [(row, k), (row, k + 1), (row + 1, k + 1), (row + 1, k)]
            corner = lambda r, c: f"{vertex(r, c) + 2}/{r * (sides + 1) + c + 1}/{vertex(r, c) + 1}"
            lines.append("f " + " ".join(corner(r, c) for r, c in around))
    lines += ["o caps", "usemtl blue"]
    lines.append("f " + " ".join(f"{vertex(0, k) + 2}//{sides * rows + 1}" for k in reversed(range(sides))))
    lines.append("f " + " ".join(f"{vertex(rows - 1, k) + 2}//{sides * rows + 2}" for k in range(sides)))
    (folder / "prism.obj").write_text("\n".join(lines) + "\n")
    (folder / "prism.mtl").write_text("newmtl red paint\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n")
    body = {
        "id": "prism",
        "name": "Soft prism",
        "shape": {"mesh": {"path": "prism.obj", "up": "z", "particles": 400}},
        "placement": {"translation": [0, 0.02, 0], "rotation": {"axis": [1, 0, 0.5], "degrees": 40}},
        "material": {"young_modulus": 2e4, "mass": {"density": 1000}, "support_radius": 0.02},
    }
    panel = {"id": "lid", "name": "Lid", "height": 0.16, "size": [0.2, 0.2], "motion": "falls"}
    scene = {"version": 1, "name": "Prism", "room": {"floor": 0}, "bodies": [body], "panels": [panel]}
    (folder / "scene.json").write_text(json.dumps(scene))


def check_model(path, obj):
    """The vertices and faces of a model, in their order, are those of the first body; whose vertices it names by itself."""
    given, vertices = [], 0
    for line in path.read_text().splitlines():
        vertices += line.startswith("v ")
        if line.startswith("f "):
            given.append([int(word.split("/")[0]) - 1 for word in line.split()[1:]])
    check(len(obj.objects[0]["v"]) == vertices, f"{len(obj.objects[0]['v'])} vertices in place of the {vertices} of {path}")
    check(obj.objects[0]["f"] == given, f"the faces are not those of {path}")


def main():
    if sys.argv[1] == "--make":
        make(Path(sys.argv[2]))
        return
    folder = Path(sys.argv[1])
    frames = {int(path.stem[6:]): Obj(path) for path in sorted(folder.glob("frame_*.obj"))}
    check(len(frames) > 0, f"{folder} holds no frame_*.obj")
    if len(sys.argv) > 2:
        check_model(Path(sys.argv[2]), next(iter(frames.values())))
    check_usd(folder, frames)
    if (folder / "motion.glb").exists():
        check_gltf(folder, frames)
    if list(folder.glob("frame_*.ply")):
        check_ply(folder, frames)


if __name__ == "__main__":
    main()
