# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# blender --background --python render_in_blender.py -- MATERIAL_blender.py OUT.raw SIDE SAMPLES THETA
# Renders the unit sphere with the material in the light of a sun of irradiance pi, from the angle THETA (rad) to the view,
# to the right. OUT.raw: SIDE^2 pixels of three floats, the bottom row first. The camera is orthographic.
import array
import math
import os
import runpy
import sys

import bpy

script, out, side, samples, theta = sys.argv[sys.argv.index("--") + 1:]
side, samples, theta = int(side), int(samples), float(theta)

bpy.ops.wm.read_factory_settings(use_empty=True)
material = runpy.run_path(script, run_name="material")["make_material"]()

scene = bpy.context.scene
# Blender's own operator takes 20 s for a sphere as fine as this.
rings, segments = 256, 512
vertices = []
for ring in range(rings + 1):
    polar = math.pi * ring / rings
    for segment in range(segments):
        turn = 2 * math.pi * segment / segments
        vertices.append((math.sin(polar) * math.cos(turn), math.sin(polar) * math.sin(turn), math.cos(polar)))
faces = [(ring * segments + segment, (ring + 1) * segments + segment,
          (ring + 1) * segments + (segment + 1) % segments, ring * segments + (segment + 1) % segments)
         for ring in range(rings) for segment in range(segments)]
mesh = bpy.data.meshes.new("sphere")
mesh.from_pydata(vertices, [], faces)
mesh.polygons.foreach_set("use_smooth", [True] * len(faces))
mesh.materials.append(material)
# Tangents of anisotropic materials run along growing longitude, counter-clockwise about the camera's axis.
corners = mesh.uv_layers.new(name="sphere").data
for index, (ring, segment) in enumerate((ring, segment) for ring in range(rings) for segment in range(segments)):
    for corner, (down, right) in enumerate(((0, 0), (1, 0), (1, 1), (0, 1))):
        corners[4 * index + corner].uv = ((segment + right) / segments, 1 - (ring + down) / rings)
scene.collection.objects.link(bpy.data.objects.new("sphere", mesh))

bpy.ops.object.camera_add(location=(0, 0, 5))
camera = bpy.context.active_object
camera.data.type = 'ORTHO'
camera.data.ortho_scale = 2
scene.camera = camera
bpy.ops.object.light_add(type='SUN', rotation=(0, theta, 0))
sun = bpy.context.active_object.data
sun.energy = math.pi
sun.angle = 0

scene.world = None
scene.render.engine = 'CYCLES'
scene.cycles.device = 'CPU'
scene.cycles.samples = samples
scene.cycles.use_adaptive_sampling = False
scene.cycles.use_denoising = False
scene.cycles.pixel_filter_type = 'BOX'
scene.cycles.max_bounces = 0
scene.render.resolution_x = scene.render.resolution_y = side
scene.render.resolution_percentage = 100
scene.view_settings.view_transform = 'Raw'
scene.render.image_settings.file_format = 'OPEN_EXR'
scene.render.image_settings.color_depth = '32'
scene.render.filepath = out + ".exr"
bpy.ops.render.render(write_still=True)
image = bpy.data.images.load(out + ".exr")
pixels = image.pixels[:]
with open(out, "wb") as file:
    array.array("f", [value for index, value in enumerate(pixels) if index % 4 < 3]).tofile(file)
os.remove(out + ".exr")
