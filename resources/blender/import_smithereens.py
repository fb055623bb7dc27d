"""Brings an export of Smithereens into Blender (3.4 or later), with its frame rate, materials and caches.

In Blender: Scripting > Open this file, set FILE below, Run. Or from a shell:

  blender --python import_smithereens.py -- FILE [--play-at RATE]

FILE is one of
  NAME.glb   fragments as objects, or as one skin where there are more than 500
  NAME.pc2   the deforming surface: NAME.obj beside it, moved by a Mesh Cache modifier

The scene gets the frame rate of the recording, so that a second is a second. --play-at 24 shows every recorded
frame at 24 frames a second instead: slow motion, where more were recorded.
"""
import json
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


def extras_of(path):
    """What the file's scene says of itself."""
    with open(path, "rb") as file:
        head = file.read(20)
        text = file.read(int.from_bytes(head[12:16], "little"))
    return json.loads(text)["scenes"][0].get("extras", {})


def load_glb(path):
    extras = extras_of(path)
    rate = extras.get("frames_per_second", 24.0)
    # Seconds become frames while importing, by the rate the scene has then; the importer reads it without
    # its divisor, so a rate that is no whole number is imported as the nearest and corrected afterwards.
    set_rate(max(1.0, round(rate)))
    bpy.ops.import_scene.gltf(filepath=str(path))
    set_rate(rate)
    set_range(extras.get("frames", 1))
    for action in bpy.data.actions:
        for curve in action.fcurves:
            for key in curve.keyframe_points:
                frame = key.co.x * (rate / max(1.0, round(rate)))
                # A key at a whole frame but for rounding belongs to it.
                key.co.x = round(frame) if abs(frame - round(frame)) < 1e-3 else frame
                key.interpolation = "LINEAR"
            curve.update()


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
