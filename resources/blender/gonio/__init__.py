# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: The Gonio authors
"""Opens materials of Gonio in Blender 3.4 and later, and reloads them when their files change.

File > Import > Gonio Material puts a file on the selected objects: a script that Gonio exported for Blender
(NAME_blender.py, NAME_principled.py), which is run, or a document or measured material, which goniotool exports first.
While "Keep up to date" is on in the properties of the material, the file is looked at every second and opened again when
it has changed. Nothing is opened or run because a .blend file is: only what was opened in this session is followed.
"""
import os
import runpy
import shutil
import subprocess
import tempfile

import bpy
from bpy_extras.io_utils import ImportHelper

bl_info = {
    "name": "Gonio",
    "author": "The Gonio authors",
    "version": (0, 2, 0),
    "blender": (3, 4, 0),
    "location": "File > Import > Gonio Material; Properties > Material > Gonio",
    "description": "Opens measured materials and their edits, and reloads them when the files change",
    "category": "Material",
}

TARGETS = (
    ("blender", "Lobes", "Looks closest in Cycles: a network of nodes"),
    ("principled", "Principled BSDF", "One node, which you can adjust further"),
)
SECONDS = 1.0


class Followed:
    """A material that was opened in this session. `stamp` identifies the content of its file that was opened last."""

    def __init__(self, path, target):
        self.path = path
        self.target = target
        self.on = True
        self.stamp = None
        self.export = None
        self.message = ""

    def is_changed(self):
        now = stamp_of(self.path)
        return now is not None and now != self.stamp


FOLLOWED = {}  # by the name of the material


def stamp_of(path):
    """None while the file is missing: programs replace files by renaming others."""
    try:
        status = os.stat(path)
    except OSError:
        return None
    return status.st_mtime_ns, status.st_size, status.st_ino


def is_script(path):
    return path.lower().endswith(".py")


def goniotool():
    addon = bpy.context.preferences.addons.get(__name__)
    name = addon.preferences.goniotool if addon else "goniotool"
    program = shutil.which(bpy.path.abspath(name) if os.sep in name else name)
    if program is None:
        raise RuntimeError("%s is not found: set it in the preferences of the add-on" % name)
    return program


class Export:
    """A running goniotool that exports a material as a script for this version of Blender."""

    def __init__(self, path, target):
        self.folder = tempfile.mkdtemp(prefix="gonio-")
        self.script = os.path.join(self.folder, "material_%s.py" % target)
        command = [goniotool(), "export", path, os.path.join(self.folder, "material"), "--for", target, "--blender",
                   str(bpy.app.version[0])]
        self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)

    def is_done(self):
        return self.process.poll() is not None

    def make_material(self):
        """Waits for the export."""
        try:
            message = self.process.communicate()[1].strip()
            if self.process.returncode != 0:
                raise RuntimeError(message or "goniotool failed")
            return run_script(self.script)
        finally:
            self.close()

    def close(self):
        if not self.is_done():
            self.process.kill()
            self.process.communicate()
        shutil.rmtree(self.folder, ignore_errors=True)


def run_script(path):
    """The new material of an exported script."""
    functions = runpy.run_path(path, run_name="gonio_material")
    if "make_material" not in functions:
        raise RuntimeError("%s is no material that Gonio exported for Blender" % path)
    return functions["make_material"]()


def show(name, made):
    """Gives the new material the users and the name of the old one."""
    old = bpy.data.materials.get(name)
    if old is None:
        made.name = name
        return made
    made.use_fake_user = old.use_fake_user
    old.user_remap(made)
    bpy.data.materials.remove(old)
    made.name = name
    return made


def reload(name):
    """Opens the file of a material again, and waits for it. Raises what prevents it; the material then stays."""
    entry = FOLLOWED[name]
    if entry.export is not None:
        entry.export.close()
        entry.export = None
    stamp = stamp_of(entry.path)
    if stamp is None:
        raise RuntimeError("%s is missing" % entry.path)
    entry.stamp = stamp
    made = run_script(entry.path) if is_script(entry.path) else Export(entry.path, entry.target).make_material()
    return show(name, made)


def attempt(entry, work):
    """Keeps the message of a failure for the panel."""
    try:
        work()
        entry.message = ""
    except Exception as error:  # of a script, anything
        entry.message = str(error)


def start_export(entry):
    entry.stamp = stamp_of(entry.path)
    entry.export = Export(entry.path, entry.target)


def finish_export(name, entry):
    export, entry.export = entry.export, None
    show(name, export.make_material())


def check():
    """Looks at the files once, without waiting for goniotool. Materials that are gone are no longer followed."""
    for name, entry in list(FOLLOWED.items()):
        if bpy.data.materials.get(name) is None:
            if entry.export is not None:
                entry.export.close()
            del FOLLOWED[name]
        elif entry.export is not None:
            if entry.export.is_done():
                attempt(entry, lambda: finish_export(name, entry))
        elif entry.on and entry.is_changed():
            if is_script(entry.path):
                attempt(entry, lambda: reload(name))
            else:
                attempt(entry, lambda: start_export(entry))
    return SECONDS


@bpy.app.handlers.persistent
def forget(*_):
    """Another .blend file has other materials of these names."""
    for entry in FOLLOWED.values():
        if entry.export is not None:
            entry.export.close()
    FOLLOWED.clear()


class GONIO_OT_open(bpy.types.Operator, ImportHelper):
    """Put a material of Gonio on the selected objects"""
    bl_idname = "gonio.open"
    bl_label = "Open Gonio Material"
    bl_options = {'REGISTER', 'UNDO'}

    filter_glob: bpy.props.StringProperty(default="*.gonio;*.py;*.binary;*.bsdf;*.bin;*.astm;*.code;*.pdv;*.nbrdf",
                                          options={'HIDDEN'})
    target: bpy.props.EnumProperty(name="As", items=TARGETS, description="Ignored for exported scripts")
    keep: bpy.props.BoolProperty(name="Keep up to date", default=True, description="Open the file again when it changes")

    def execute(self, context):
        path = os.path.abspath(bpy.path.abspath(self.filepath))
        objects = [one for one in context.selected_objects if hasattr(one.data, "materials")]
        entry = Followed(path, self.target)
        entry.on = self.keep
        entry.stamp = stamp_of(path)
        if entry.stamp is None:
            self.report({'ERROR'}, "%s is missing" % path)
            return {'CANCELLED'}
        try:
            material = run_script(path) if is_script(path) else Export(path, self.target).make_material()
        except Exception as error:
            self.report({'ERROR'}, str(error))
            return {'CANCELLED'}
        FOLLOWED[material.name] = entry
        for one in objects:
            one.data.materials.clear()
            one.data.materials.append(material)
        material.use_fake_user = not objects
        return {'FINISHED'}


class GONIO_OT_reload(bpy.types.Operator):
    """Open the file of this material again"""
    bl_idname = "gonio.reload"
    bl_label = "Reload"

    @classmethod
    def poll(cls, context):
        return followed_of(context) is not None

    def execute(self, context):
        try:
            reload(context.object.active_material.name)
        except Exception as error:
            self.report({'ERROR'}, str(error))
            return {'CANCELLED'}
        return {'FINISHED'}


class GONIO_OT_keep(bpy.types.Operator):
    """Open the file again when it changes, or no longer"""
    bl_idname = "gonio.keep"
    bl_label = "Keep up to date"

    @classmethod
    def poll(cls, context):
        return followed_of(context) is not None

    def execute(self, context):
        entry = followed_of(context)
        entry.on = not entry.on
        return {'FINISHED'}


def followed_of(context):
    material = context.object.active_material if context.object is not None else None
    return FOLLOWED.get(material.name) if material is not None else None


class GONIO_PT_material(bpy.types.Panel):
    bl_label = "Gonio"
    bl_space_type = 'PROPERTIES'
    bl_region_type = 'WINDOW'
    bl_context = "material"

    def draw(self, context):
        entry = followed_of(context)
        if entry is None:
            self.layout.operator(GONIO_OT_open.bl_idname, icon='FILE_FOLDER')
            return
        self.layout.label(text=os.path.basename(entry.path), icon='FILE')
        row = self.layout.row()
        row.operator(GONIO_OT_keep.bl_idname, icon='CHECKBOX_HLT' if entry.on else 'CHECKBOX_DEHLT')
        row.operator(GONIO_OT_reload.bl_idname, icon='FILE_REFRESH')
        if entry.message:
            self.layout.label(text=entry.message, icon='ERROR')


class GonioPreferences(bpy.types.AddonPreferences):
    bl_idname = __name__

    goniotool: bpy.props.StringProperty(name="goniotool", default="goniotool", subtype='FILE_PATH',
                                        description="The program that exports documents and measured materials")

    def draw(self, context):
        self.layout.prop(self, "goniotool")


def menu(self, context):
    self.layout.operator(GONIO_OT_open.bl_idname, text="Gonio Material (.gonio, .py, measured)")


CLASSES = (GonioPreferences, GONIO_OT_open, GONIO_OT_reload, GONIO_OT_keep, GONIO_PT_material)


def register():
    for one in CLASSES:
        bpy.utils.register_class(one)
    bpy.types.TOPBAR_MT_file_import.append(menu)
    bpy.app.handlers.load_pre.append(forget)
    bpy.app.timers.register(check, first_interval=SECONDS, persistent=True)


def unregister():
    bpy.app.timers.unregister(check)
    bpy.app.handlers.load_pre.remove(forget)
    bpy.types.TOPBAR_MT_file_import.remove(menu)
    forget()
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
