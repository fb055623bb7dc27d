"""Run by Blender: imports a file as resources/blender/import_smithereens.py does, and writes where every vertex that is seen is.

blender --background --factory-startup --python read_animation.py -- FILE FRAMES OUT
Writes a line "FRAME OBJECT x y z" for each vertex, cm.
"""
import importlib.util
import pathlib
import sys

import bpy

source, frames, out = sys.argv[sys.argv.index("--") + 1:]
script = pathlib.Path(__file__).parents[2] / "resources/blender/import_smithereens.py"
spec = importlib.util.spec_from_file_location("import_smithereens", script)
importer = importlib.util.module_from_spec(spec)
spec.loader.exec_module(importer)

bpy.ops.wm.read_factory_settings(use_empty=True)
importer.load(source)
scene = bpy.context.scene
with open(out, "w") as file:
    file.write(f"rate {scene.render.fps / scene.render.fps_base} {scene.frame_start} {scene.frame_end}\n")
    for frame in range(int(frames)):
        scene.frame_set(scene.frame_start + frame)
        graph = bpy.context.evaluated_depsgraph_get()
        for thing in sorted(scene.objects, key=lambda thing: thing.name):
            if thing.type != "MESH" or thing.hide_viewport:
                continue
            evaluated = thing.evaluated_get(graph)
            mesh = evaluated.to_mesh()
            for vertex in mesh.vertices:
                x, y, z = 100 * (evaluated.matrix_world @ vertex.co)
                file.write(f"{frame} {thing.name} {x:.9g} {y:.9g} {z:.9g}\n")
            evaluated.to_mesh_clear()
