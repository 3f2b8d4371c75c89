# SPDX-License-Identifier: MIT OR Apache-2.0
#
# Licensed as sinew itself is, by the MIT licence (LICENSE-MIT) or the Apache licence 2.0 (LICENSE-APACHE), at your option. Both
# are compatible with the GNU GPL 3 or later, under which Blender's own add-ons are.
"""Sends the selected mesh to sinew, and fetches its motion as a Mesh Cache on that same mesh.

What goes out are the mesh's own vertices, in their order, and its polygons uncut; what comes back are places of these
vertices. UV maps, materials, vertex groups and all other modifiers stay what they are. The motion begins where the object is:
where sinew has put the body, how large it has made it and which way is up there is found from the rest shape that it writes
beside the motion.

Install from *Preferences > Add-ons > Install from Disk*; the buttons are in the sidebar (N) of the 3D view, in the tab "sinew".
"""

bl_info = {
    "name": "sinew motion",
    "author": "The sinew authors",
    "version": (0, 1, 0),
    "blender": (3, 6, 0),
    "location": "3D View > Sidebar > sinew",
    "description": "Send the selected mesh to sinew, fetch its motion as a Mesh Cache",
    "category": "Animation",
}

import os
import re
import shutil
import struct
import subprocess
import tempfile

import bpy
import numpy as np

# What is kept with an object: the folder that it was sent to.
FOLDER = "sinew_folder"
MODIFIER = "sinew motion"

# The head of a PC2 file: twelve letters, version, points, first frame, frames a sample, samples.
HEAD = struct.Struct("<12siiffi")

# A rest shape that is further off than this share of its size is that of another mesh.
NEAR = 1e-3


class Refused(Exception):
    """What is wrong and what to do, in a sentence."""


# -- Shapes ---------------------------------------------------------------------------------------------------------


def safe_name(name):
    return re.sub(r"[^\w-]", "_", name.strip())[:80] or "body"


def vertices_of(obj):
    """The mesh's own vertices, in the object's frame."""
    obj.update_from_editmode()
    points = np.empty(3 * len(obj.data.vertices), dtype=np.float32)
    obj.data.vertices.foreach_get("co", points)
    return points.reshape(-1, 3).astype(np.float64)


def write_obj(path, obj, unit):
    """Writes a mesh in metres, Y up, where the object stands in the world: `unit` is the length of a unit [m]."""
    mesh = obj.data
    matrix = np.array(obj.matrix_world)
    world = (vertices_of(obj) @ matrix[:3, :3].T + matrix[:3, 3]) * unit
    uvs = mesh.uv_layers.active.data if mesh.uv_layers.active else None
    materials = [slot.material for slot in obj.material_slots]
    mirrored = np.linalg.det(matrix[:3, :3]) < 0.0
    name = safe_name(obj.name)
    stem, _ = os.path.splitext(path)
    with open(stem + ".mtl", "w", encoding="utf-8", newline="\n") as out:
        for material in filter(None, materials):
            red, green, blue, _ = material.diffuse_color
            # Colours of the format are meant for the screen.
            shown = [12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055 for c in (red, green, blue)]
            out.write(f"newmtl {safe_name(material.name)}\nKd {shown[0]:.6f} {shown[1]:.6f} {shown[2]:.6f}\n")
    with open(path, "w", encoding="utf-8", newline="\n") as out:
        out.write(f"mtllib {os.path.basename(stem)}.mtl\no {name}\n")
        for x, y, z in world:
            out.write(f"v {x:.9g} {z:.9g} {-y:.9g}\n")
        if uvs:
            for corner in uvs:
                out.write(f"vt {corner.uv[0]:.9g} {corner.uv[1]:.9g}\n")
        used = None
        for polygon in mesh.polygons:
            if materials and polygon.material_index != used:
                used = polygon.material_index
                material = materials[used] if used < len(materials) else None
                out.write(f"usemtl {safe_name(material.name) if material else 'none'}\n")
            corners = list(polygon.loop_indices)
            if mirrored:
                corners.reverse()
            words = (f"{mesh.loops[c].vertex_index + 1}" + (f"/{c + 1}" if uvs else "") for c in corners)
            out.write(f"f {' '.join(words)}\n")


def read_vertices(path):
    """The vertices of an OBJ file."""
    with open(path, encoding="utf-8", errors="replace") as lines:
        found = [line.split()[1:4] for line in lines if line.startswith("v ")]
    return np.array(found, dtype=np.float64).reshape(-1, 3)


# -- Point caches ---------------------------------------------------------------------------------------------------


def read_head(path):
    """Points, number of the first frame and samples of a PC2 file."""
    with open(path, "rb") as cache:
        head = cache.read(HEAD.size)
    if len(head) < HEAD.size:
        raise Refused(f"{path} is no PC2 cache; export it again")
    magic, version, points, first, _, samples = HEAD.unpack(head)
    if magic != b"POINTCACHE2\0" or version != 1 or points < 0 or samples < 1:
        raise Refused(f"{path} is no PC2 cache; export it again")
    return points, first, samples


def frames_of(path):
    """The samples of a PC2 file, one after another."""
    points, _, samples = read_head(path)
    with open(path, "rb") as cache:
        cache.seek(HEAD.size)
        for _ in range(samples):
            numbers = np.fromfile(cache, dtype="<f4", count=3 * points)
            if len(numbers) < 3 * points:
                raise Refused(f"{path} ends within a frame; export it again")
            yield numbers.reshape(-1, 3).astype(np.float64)


def similarity(given, wanted):
    """The turn, scale and shift that bring points nearest to others, and how far off the furthest is then.

    The turn is that of the singular value decomposition of the covariance; it never mirrors unless the points are mirrored.
    """
    from_centre, to_centre = given.mean(axis=0), wanted.mean(axis=0)
    a, b = given - from_centre, wanted - to_centre
    spread = (a * a).sum()
    if spread == 0.0:
        return np.eye(3), to_centre - from_centre, float(np.abs(b).max(initial=0.0))

    def fit(sign):
        u, values, vt = np.linalg.svd(b.T @ a)
        signs = np.array([1.0, 1.0, sign * np.sign(np.linalg.det(u) * np.linalg.det(vt))])
        linear = (values * signs).sum() / spread * (u * signs) @ vt
        shift = to_centre - linear @ from_centre
        return linear, shift, float(np.abs(given @ linear.T + shift - wanted).max())

    # A turn where it does: a flat or symmetric shape is met by a mirror as well.
    turn, mirror = fit(1.0), fit(-1.0)
    return mirror if mirror[2] < 0.1 * turn[2] else turn


def write_local(source, target, linear, shift):
    """Writes a PC2 file with all places mapped, whole or not at all."""
    points, first, samples = read_head(source)
    part = target + ".part"
    with open(part, "wb") as out:
        out.write(HEAD.pack(b"POINTCACHE2\0", 1, points, first, 1.0, samples))
        for frame in frames_of(source):
            (frame @ linear.T + shift).astype("<f4").tofile(out)
    os.replace(part, target)


# -- What the buttons do --------------------------------------------------------------------------------------------


def executable():
    addon = bpy.context.preferences.addons.get(__name__)
    given = addon.preferences.executable if addon else ""
    found = shutil.which(bpy.path.abspath(given) if given else os.environ.get("SINEW", "sinew"))
    if not found:
        raise Refused("sinew is not found; name its program in this add-on's preferences")
    return found


def mesh_object(context):
    obj = context.active_object
    if obj is None or obj.type != "MESH":
        raise Refused("no mesh is selected; select the one that is to move")
    if not obj.data.polygons:
        raise Refused(f"{obj.name} has no faces; sinew fills closed surfaces")
    return obj


def send(context, obj):
    """Writes the mesh into a folder of its own, beside the .blend file where there is one; gives the model's path."""
    if bpy.data.filepath:
        base = os.path.join(os.path.dirname(bpy.data.filepath), "sinew")
    else:
        base = tempfile.mkdtemp(prefix="sinew_")
    folder = os.path.join(base, safe_name(obj.name))
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, safe_name(obj.name) + ".obj")
    write_obj(path, obj, context.scene.unit_settings.scale_length)
    obj[FOLDER] = folder
    return path


def newest(folder, ending):
    """Files of a folder and of those in it whose names end so, the newest first."""
    found = [os.path.join(at, name) for at, _, names in os.walk(folder) for name in names if name.endswith(ending)]
    return sorted(found, key=os.path.getmtime, reverse=True)


def source_of(obj):
    """The scene that was saved beside the sent mesh, or the mesh itself."""
    folder = obj.get(FOLDER, "")
    if not os.path.isdir(folder):
        raise Refused(f"{obj.name} was not sent yet; send it to sinew first")
    scenes = newest(folder, ".json")
    model = os.path.join(folder, safe_name(obj.name) + ".obj")
    return scenes[0] if scenes else model


def cache_of(obj, folder):
    """The newest cache whose rest shape is this mesh, and the map from there to the object's frame."""
    own = vertices_of(obj)
    size = max(float(np.ptp(own, axis=0).max(initial=0.0)), 1e-9)
    looked = 0
    for cache in newest(folder, ".pc2"):
        rest = cache[: -len(".pc2")] + "_rest.obj"
        if not os.path.exists(rest):
            continue
        looked += 1
        points, _, _ = read_head(cache)
        if points != len(own):
            continue
        linear, shift, off = similarity(read_vertices(rest), own)
        if off < NEAR * size:
            return cache, linear, shift
    if looked:
        raise Refused(f"none of the {looked} caches in {folder} is of {obj.name} as it is now; send it again")
    raise Refused(f"{folder} holds no motion; export it there from sinew as PC2, with its rest shape")


def fetch(context, obj, folder):
    """Puts the motion that lies in a folder on a mesh, as its first modifier."""
    cache, linear, shift = cache_of(obj, folder)
    target = os.path.join(obj.get(FOLDER, folder), safe_name(obj.name) + ".cache")
    write_local(cache, target, linear, shift)
    modifier = obj.modifiers.get(MODIFIER) or obj.modifiers.new(MODIFIER, "MESH_CACHE")
    obj.modifiers.move(list(obj.modifiers).index(modifier), 0)
    _, first, samples = read_head(target)
    modifier.cache_format = "PC2"
    # One and the same path, which Blender may hold open, may hold other places now.
    modifier.filepath = ""
    modifier.filepath = target
    modifier.deform_mode = "OVERWRITE"
    modifier.interpolation = "LINEAR"
    modifier.forward_axis, modifier.up_axis = "POS_Y", "POS_Z"
    modifier.play_mode, modifier.time_mode = "SCENE", "FRAME"
    # sinew's frame 0 is the scene's first.
    modifier.frame_start = context.scene.frame_start + first
    return samples


def simulation(context, obj):
    """The command that makes the motion of a mesh, at the scene's rate and over its frames, and the folder it goes to."""
    scene = context.scene
    rate = scene.render.fps / scene.render.fps_base
    seconds = max(scene.frame_end - scene.frame_start, 1) / rate
    folder = os.path.join(obj[FOLDER], "motion")
    command = [executable(), "simulate", source_of(obj), "--fps", f"{rate:.9g}", "--seconds", f"{seconds:.9g}"]
    return [*command, "--format", "pc2", "--out", folder], folder


class SINEW_OT_send(bpy.types.Operator):
    """Write the selected mesh and open it in sinew, where fibres are drawn into it; save the scene there beside it"""

    bl_idname = "sinew.send"
    bl_label = "Send to sinew"

    def execute(self, context):
        try:
            path = send(context, mesh_object(context))
            if not bpy.app.background:
                scenes = newest(os.path.dirname(path), ".json")
                subprocess.Popen([executable(), scenes[0] if scenes else path])
        except (Refused, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self.report({"INFO"}, f"Written to {path}")
        return {"FINISHED"}


class SINEW_OT_fetch(bpy.types.Operator):
    """Run the scene that was saved beside the sent mesh, or the mesh by itself, over this scene's frames, and put the motion
    on the mesh as a Mesh Cache"""

    bl_idname = "sinew.fetch"
    bl_label = "Fetch motion"

    def execute(self, context):
        return self.begin(context, wait=True)

    def invoke(self, context, _event):
        return self.begin(context, wait=bpy.app.background)

    def begin(self, context, wait):
        try:
            self.obj = mesh_object(context)
            source_of(self.obj)
            command, self.folder = simulation(context, self.obj)
            self.said = tempfile.TemporaryFile()
            self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=self.said)
            if wait:
                self.process.wait()
                return self.end(context)
        except (Refused, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self.timer = context.window_manager.event_timer_add(0.2, window=context.window)
        context.window_manager.modal_handler_add(self)
        context.workspace.status_text_set("sinew is at work; Esc ends it and takes the frames so far")
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC":
            # It writes what it has and ends.
            self.process.terminate()
            self.process.wait()
        if self.process.poll() is None:
            return {"PASS_THROUGH"}
        context.window_manager.event_timer_remove(self.timer)
        context.workspace.status_text_set(None)
        try:
            return self.end(context)
        except (Refused, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}

    def end(self, context):
        code = self.process.returncode
        self.said.seek(0)
        said = [line for line in self.said.read().decode(errors="replace").splitlines() if line.startswith("error")]
        # Interrupted, and diverged: what was good until then is there.
        if code not in (0, 3, 130, 143, -15):
            raise Refused(said[0] if said else f"sinew ended with {code}")
        samples = fetch(context, self.obj, self.folder)
        kind = {"WARNING"} if said else {"INFO"}
        self.report(kind, f"{samples} frames on {self.obj.name}" + (f"; {said[0]}" if said else ""))
        return {"FINISHED"}


class SINEW_PT_panel(bpy.types.Panel):
    bl_idname = "SINEW_PT_panel"
    bl_label = "sinew"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "sinew"

    def draw(self, _context):
        self.layout.operator(SINEW_OT_send.bl_idname, icon="EXPORT")
        self.layout.operator(SINEW_OT_fetch.bl_idname, icon="IMPORT")


class SinewPreferences(bpy.types.AddonPreferences):
    bl_idname = __name__

    executable: bpy.props.StringProperty(
        name="Program",
        description="The program sinew; what the system finds by that name unless given",
        subtype="FILE_PATH",
    )

    def draw(self, _context):
        self.layout.prop(self, "executable")


CLASSES = (SINEW_OT_send, SINEW_OT_fetch, SINEW_PT_panel, SinewPreferences)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)


def unregister():
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)


if __name__ == "__main__":
    register()
