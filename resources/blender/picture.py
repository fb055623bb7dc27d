"""Draws a still of an export of Smithereens with Blender's Cycles: what the guide's picture was made by.

  blender --background --factory-startup --python picture.py -- FILE FRAME OUT.png [SAMPLES]
"""
import importlib.util
import pathlib
import sys

import bpy
from mathutils import Vector

here = pathlib.Path(__file__).parent
spec = importlib.util.spec_from_file_location("import_smithereens", here / "import_smithereens.py")
importer = importlib.util.module_from_spec(spec)
spec.loader.exec_module(importer)


def things():
    return [thing for thing in bpy.context.scene.objects
            if thing.type == "MESH" and thing.name != "ground" and not thing.hide_render]


def middle_of_most():
    """Middle and radius of what is nearest together, so that a shard that flew off makes nothing small."""
    graph = bpy.context.evaluated_depsgraph_get()
    points = []
    for thing in things():
        evaluated = thing.evaluated_get(graph)
        corners = [evaluated.matrix_world @ Vector(corner) for corner in evaluated.bound_box]
        points += [(sum(corners, Vector()) / 8, thing.dimensions.length)]
    # By volumes, which a few large pieces have nearly all of.
    points = [(point, size, size ** 3) for point, size in points]
    weight = sum(volume for _, _, volume in points)
    middle = sum((point * volume for point, _, volume in points), Vector()) / weight
    passed = 0.0
    for reach, volume in sorted(((point - middle).length + size / 2, volume) for point, size, volume in points):
        passed += volume
        if passed > 0.97 * weight:
            break
    return middle, reach


def add_light(middle, direction, distance, size, power):
    """A panel that looks at the middle: what glaze mirrors."""
    light = bpy.data.lights.new("light", "AREA")
    light.size, light.energy = size, power
    lamp = bpy.data.objects.new("light", light)
    lamp.location = middle + Vector(direction).normalized() * distance
    lamp.rotation_euler = (middle - lamp.location).to_track_quat("-Z", "Y").to_euler()
    bpy.context.collection.objects.link(lamp)


def add_camera(middle, radius):
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.lens = 70
    direction = Vector((0.42, -0.86, 0.28)).normalized()
    camera.location = middle + direction * radius * 4.9
    camera.rotation_euler = (-direction).to_track_quat("-Z", "Y").to_euler()
    bpy.context.collection.objects.link(camera)
    bpy.context.scene.camera = camera


source, frame, out = sys.argv[sys.argv.index("--") + 1:][:3]
samples = int((sys.argv[sys.argv.index("--") + 1:] + ["160"])[3])
bpy.ops.wm.read_factory_settings(use_empty=True)
importer.load(source)
scene = bpy.context.scene
scene.frame_set(int(frame))

bpy.ops.mesh.primitive_plane_add(size=20)
bpy.context.object.name = "ground"
ground = bpy.data.materials.new("ground")
ground.use_nodes = True
ground.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (0.11, 0.10, 0.095, 1)
ground.node_tree.nodes["Principled BSDF"].inputs["Roughness"].default_value = 0.6
bpy.context.object.data.materials.append(ground)

middle, radius = middle_of_most()
add_camera(middle, radius)
add_light(middle, (-0.5, -0.7, 0.5), 7 * radius, 1.3 * radius, 640 * radius * radius)
add_light(middle, (-1.0, -0.1, 0.45), 8 * radius, 3 * radius, 330 * radius * radius)
world = bpy.data.worlds.new("world")
world.use_nodes = True
world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.11, 0.117, 0.13, 1)
scene.world = world

scene.render.engine = "CYCLES"
scene.cycles.samples = samples
scene.cycles.use_denoising = False
scene.render.resolution_x, scene.render.resolution_y = 960, 600
scene.view_settings.view_transform = "Filmic"
scene.render.filepath = out
bpy.ops.render.render(write_still=True)

