"""Brings an export of Smithereens into Blender (3.4 or later), with its frame rate, materials and caches.

In Blender: Scripting > Open this file, set FILE below, Run. Or from a shell:

  blender --python import_smithereens.py -- FILE [--play-at RATE]

FILE is one of
  NAME.glb   fragments as objects; each is there from its birth on
  NAME.pc2   the deforming surface: NAME.obj beside it, moved by a Mesh Cache modifier

The scene gets the frame rate of the recording, so that a second is a second. --play-at 24 shows every recorded
frame at 24 frames a second instead: slow motion, where more were recorded.
"""
import json
import math
import pathlib
import sys

import bpy
import numpy

FILE = ""

# The glTF importer of Blender 3.4 says numpy.bool, which numpy has dropped.
if not hasattr(numpy, "bool"):
    numpy.bool = bool


def set_rate(rate):
    """Blender's rate is a whole number over a divisor."""
    render = bpy.context.scene.render
    render.fps = max(1, round(rate))
    render.fps_base = render.fps / rate


def set_range(frames):
    scene = bpy.context.scene
    scene.frame_start = 0
    scene.frame_end = max(0, frames - 1)
    scene.frame_set(0)


def contents_of(path):
    """The two parts of a .glb: what describes it, and its numbers."""
    with open(path, "rb") as file:
        head = file.read(20)
        text = file.read(int.from_bytes(head[12:16], "little"))
        file.read(8)
        return json.loads(text), file.read()


def numbers_of(about, binary, accessor):
    """Of an accessor with one number each."""
    read = about["accessors"][accessor]
    view = about["bufferViews"][read["bufferView"]]
    kind = {5126: "<f4", 5125: "<u4", 5123: "<u2"}[read["componentType"]]
    offset = view.get("byteOffset", 0) + read.get("byteOffset", 0)
    return numpy.frombuffer(binary, kind, read["count"], offset)


def add_damage(about, binary):
    """Importers before Blender 4 leave attributes out that they do not know. A mesh has the vertices that its
    primitives use, one primitive after the other."""
    for mesh in about.get("meshes", []):
        made = bpy.data.meshes.get(mesh["name"])
        if made is None or "_DAMAGE" in made.attributes:
            continue
        damage = [numbers_of(about, binary, part["attributes"]["_DAMAGE"])[
            numpy.unique(numbers_of(about, binary, part["indices"]))] for part in mesh["primitives"]]
        damage = numpy.concatenate(damage)
        if len(damage) == len(made.vertices):
            made.attributes.new("_DAMAGE", "FLOAT", "POINT").data.foreach_set("value", damage)


def set_absorption(about):
    """What is left of light behind a metre of Blender's absorption is exp(-density (1 - colour)); of glTF's, the
    attenuation colour is left behind the attenuation distance."""
    for material in about.get("materials", []):
        volume = material.get("extensions", {}).get("KHR_materials_volume")
        made = bpy.data.materials.get(material["name"])
        if volume is None or made is None:
            continue
        rates = [-math.log(max(colour, 1e-6)) / volume["attenuationDistance"] for colour in volume["attenuationColor"]]
        for node in made.node_tree.nodes:
            if node.type == "VOLUME_ABSORPTION" and max(rates) > 0:
                node.inputs["Density"].default_value = max(rates)
                node.inputs["Color"].default_value = [1 - rate / max(rates) for rate in rates] + [1]


def hide_where_scaled_away(thing):
    """What is not there has the scale 0 in the file. An object that is hidden costs nothing and can be picked
    when it is there."""
    action = thing.animation_data.action if thing.animation_data else None
    scales = [curve for curve in action.fcurves if curve.data_path == "scale"] if action else []
    if not scales:
        return
    for key in scales[0].keyframe_points:
        thing.hide_viewport = thing.hide_render = key.co.y == 0
        for path in ("hide_viewport", "hide_render"):
            thing.keyframe_insert(path, frame=key.co.x)
    for curve in scales:
        action.fcurves.remove(curve)
    thing.scale = (1, 1, 1)


def load_glb(path):
    about, binary = contents_of(path)
    extras = about["scenes"][0].get("extras", {})
    rate = extras.get("frames_per_second", 24.0)
    # Seconds become frames while importing, by the rate the scene has then; the importer reads it without
    # its divisor, so a rate that is no whole number is imported as the nearest and corrected afterwards.
    set_rate(max(1.0, round(rate)))
    bpy.ops.import_scene.gltf(filepath=str(path))
    set_rate(rate)
    for action in bpy.data.actions:
        for curve in action.fcurves:
            for key in curve.keyframe_points:
                frame = key.co.x * (rate / max(1.0, round(rate)))
                # A key at a whole frame but for rounding belongs to it.
                key.co.x = round(frame) if abs(frame - round(frame)) < 1e-3 else frame
                key.interpolation = "CONSTANT" if curve.data_path == "scale" else "LINEAR"
            curve.update()
    add_damage(about, binary)
    set_absorption(about)
    for thing in bpy.data.objects:
        hide_where_scaled_away(thing)
    set_range(extras.get("frames", 1))


def head_of(path):
    """The "# key value" lines at the head of an .obj."""
    about = {}
    with open(path) as file:
        for line in file:
            if not line.startswith("#"):
                break
            words = line[1:].split()
            if len(words) == 2:
                about[words[0]] = float(words[1])
    return about


def load_pc2(path):
    about = head_of(path.with_suffix(".obj"))
    # Axes as they are: the file is z up already, and the cache's points are in the file's order.
    bpy.ops.import_scene.obj(filepath=str(path.with_suffix(".obj")), axis_forward="Y", axis_up="Z",
                             split_mode="OFF", use_split_objects=False, use_split_groups=False)
    surface = bpy.context.selected_objects[0]
    surface.name = path.stem
    surface.scale = (0.01, 0.01, 0.01)  # centimetres
    cache = surface.modifiers.new("take", "MESH_CACHE")
    cache.cache_format = "PC2"
    cache.filepath = str(path)
    cache.interpolation = "NONE"
    cache.play_mode = "SCENE"
    cache.frame_start = 0
    set_rate(about["frames_per_second"])
    set_range(int(about["frames"]))


def load(path, play_at=None):
    path = pathlib.Path(path).resolve()
    loaders = {".glb": load_glb, ".pc2": load_pc2}
    if path.suffix not in loaders:
        raise SystemExit(f"{path}: this imports {' and '.join(loaders)} files")
    loaders[path.suffix](path)
    if play_at:
        set_rate(play_at)


if __name__ == "__main__":
    arguments = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    speed = None
    if "--play-at" in arguments:
        at = arguments.index("--play-at")
        speed = float(arguments[at + 1])
        del arguments[at:at + 2]
    chosen = arguments[0] if arguments else FILE
    if not chosen:
        raise SystemExit("which file? set FILE at the top of this script, or name it behind --")
    load(chosen, speed)
