# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
# blender --background --python check_addon.py -- ADDON.zip GONIOTOOL FOLDER
# Installs the add-on, opens a script and a document in it, changes both files, and looks at what Cycles shows. GONIOTOOL may
# be empty: then no document is opened. FOLDER is empty.
import os
import shutil
import subprocess
import sys
import time

import bpy

addon_file, goniotool, folder = sys.argv[sys.argv.index("--") + 1:]
BUNDLED = "library:merl-copy/"


def picture():
    """The mean colour of the sphere."""
    scene = bpy.context.scene
    scene.render.filepath = os.path.join(folder, "picture.exr")
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(scene.render.filepath)
    pixels = image.pixels[:]
    bpy.data.images.remove(image)
    return [sum(pixels[channel::4]) / (len(pixels) // 4) for channel in range(3)]


def set_up():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.preferences.addon_install(filepath=addon_file, overwrite=True)
    bpy.ops.preferences.addon_enable(module="gonio")
    scene = bpy.context.scene
    bpy.ops.mesh.primitive_uv_sphere_add()
    sphere = bpy.context.active_object
    bpy.ops.object.camera_add(location=(0, 0, 5))
    camera = bpy.context.active_object
    camera.data.type, camera.data.ortho_scale = 'ORTHO', 2
    scene.camera = camera
    bpy.ops.object.light_add(type='SUN', rotation=(0, 0.5, 0))
    scene.world = None
    scene.render.engine = 'CYCLES'
    scene.cycles.device = 'CPU'
    scene.cycles.samples = 4
    scene.cycles.use_denoising = False
    scene.render.resolution_x = scene.render.resolution_y = 32
    scene.render.image_settings.file_format = 'OPEN_EXR'
    for one in bpy.context.selected_objects:
        one.select_set(False)
    sphere.select_set(True)
    bpy.context.view_layer.objects.active = sphere
    return sphere


def script(colour):
    """As Gonio exports it, but short."""
    return ("import bpy\n\n\ndef make_material():\n    material = bpy.data.materials.new('paint')\n"
            "    material.use_nodes = True\n    nodes = material.node_tree.nodes\n    nodes.clear()\n"
            "    shader, output = nodes.new('ShaderNodeBsdfDiffuse'), nodes.new('ShaderNodeOutputMaterial')\n"
            "    shader.inputs['Color'].default_value = %r\n"
            "    material.node_tree.links.new(shader.outputs[0], output.inputs['Surface'])\n    return material\n" % (colour,))


def write(path, text):
    with open(path + ".new", "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(path + ".new", path)


def look_until(addon, is_done):
    """What the timer does where Blender has a window."""
    for _ in range(600):
        addon.check()
        if is_done():
            return
        time.sleep(0.1)
    raise AssertionError("nothing changed within a minute: %s" % {name: one.message for name, one in addon.FOLLOWED.items()})


def check_script(addon, sphere):
    path = os.path.join(folder, "paint_blender.py")
    write(path, script((0.8, 0, 0, 1)))
    assert bpy.ops.gonio.open(filepath=path) == {'FINISHED'}
    assert [one.name for one in sphere.data.materials] == ["paint"]
    red = picture()
    assert red[0] > 10 * red[2], red
    addon.check()
    assert picture() == red
    write(path, script((0, 0, 0.8, 1)))
    addon.check()
    blue = picture()
    assert blue[2] > 10 * blue[0], blue
    assert [one.name for one in sphere.data.materials] == ["paint"] and len(bpy.data.materials) == 1
    write(path, "this is no Python")  # the material stays, the panel tells why
    addon.check()
    assert picture() == blue and addon.FOLLOWED["paint"].message
    bpy.ops.gonio.keep()
    write(path, script((0.8, 0, 0, 1)))
    addon.check()
    assert picture() == blue  # no longer kept up to date
    assert bpy.ops.gonio.reload() == {'FINISHED'}
    assert picture() == red
    print("the script is followed: red", red, "blue", blue)


def check_document(addon, sphere):
    """An edit saved by goniotool shows in Blender."""
    bpy.context.preferences.addons["gonio"].preferences.goniotool = goniotool
    path = os.path.join(folder, "paint.gonio")

    def save(*controls):
        command = [goniotool, "edit", BUNDLED + "blue-metallic-paint", "--model", "ggx", "--force", "--out", path]
        for control in controls:
            command += ["--control", control]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)

    save("roughness=1.2")
    assert bpy.ops.gonio.open(filepath=path, target='principled') == {'FINISHED'}
    name = sphere.data.materials[0].name
    before, first = picture(), bpy.data.materials[name].as_pointer()
    save("roughness=1.2", "specular-strength=4")
    look_until(addon, lambda: bpy.data.materials[name].as_pointer() != first)
    after = picture()
    assert max(after) > 1.2 * max(before), (before, after)
    print("the document is followed: before", before, "after", after)


sphere = set_up()
import gonio as addon  # noqa: E402, the module of the add-on

assert addon.bl_info["name"] == "Gonio", addon
check_script(addon, sphere)
if goniotool:
    check_document(addon, sphere)
bpy.ops.preferences.addon_disable(module="gonio")
