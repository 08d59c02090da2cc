// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/scenes/scene_files.h"
#include "core/io/json_text.h"
#include "core/support/text.h"

namespace gonio::exports {

namespace {

constexpr const char* sceneProgramStart = R"(# -*- coding: utf-8 -*-
# A scene for Cycles, made by Gonio: Scripting > Open > Run Script, or
#   blender --background --python THIS_FILE -- picture.exr
#   blender --background --python THIS_FILE -- scene.blend
# The files that it names lie beside it.
import math
import os
import runpy
import struct
import sys

import bpy
import mathutils

SCENE = )";

constexpr const char* meshFunctions = R"(

def folder():
    """Of this file, which may be a text that Blender has opened."""
    text = bpy.data.texts.get(os.path.basename(__file__))
    path = bpy.path.abspath(text.filepath) if text is not None and text.filepath else __file__
    return os.path.dirname(os.path.abspath(path))


def read_ply(path):
    """Vertices and normals with y up, and triangles, of the form in which Gonio writes them."""
    with open(path, "rb") as file:
        data = file.read()
    start = data.index(b"end_header\n") + len(b"end_header\n")
    words = data[:start].split()
    counts = [int(words[index + 2]) for index, word in enumerate(words) if word == b"element"]
    vertices = list(struct.iter_unpack("<6f", data[start:start + 24 * counts[0]]))
    faces = [face[1:] for face in struct.iter_unpack("<B3i", data[start + 24 * counts[0]:])]
    return [vertex[:3] for vertex in vertices], [vertex[3:] for vertex in vertices], faces


def upright(vectors):
    """From y up to z up."""
    return [(x, -z, y) for x, y, z in vectors]


def mesh_from_file(name, path):
    vertices, normals, faces = read_ply(path)
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(upright(vertices), [], faces)
    mesh.polygons.foreach_set("use_smooth", [True] * len(faces))
    if hasattr(mesh, "use_auto_smooth"):
        mesh.use_auto_smooth = True
    mesh.normals_split_custom_set_from_vertices(upright(normals))
    return mesh


def set_corners(mesh, corners):
    """Texture coordinates, whose first axis is the direction of the grain."""
    layer = mesh.uv_layers.new(name="grain").data
    for corner, position in zip(layer, corners):
        corner.uv = position


def sphere_mesh(name, centre, radius, rings=128, segments=256):
    vertices = []
    for ring in range(rings + 1):
        polar = math.pi * ring / rings
        for segment in range(segments):
            turn = 2 * math.pi * segment / segments
            normal = (math.sin(polar) * math.cos(turn), math.sin(polar) * math.sin(turn), math.cos(polar))
            vertices.append([centre[axis] + radius * normal[axis] for axis in range(3)])
    places = [(ring, segment) for ring in range(rings) for segment in range(segments)]
    steps = ((0, 0), (1, 0), (1, 1), (0, 1))
    faces = [[(ring + down) * segments + (segment + right) % segments for down, right in steps]
             for ring, segment in places]
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, [], faces)
    mesh.polygons.foreach_set("use_smooth", [True] * len(faces))
    set_corners(mesh, [((segment + right) / segments, 1 - (ring + down) / rings)
                       for ring, segment in places for down, right in steps])
    return mesh


def rectangle_mesh(name, corners):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(corners, [], [[0, 1, 2, 3]])
    set_corners(mesh, [(0, 0), (1, 0), (1, 1), (0, 1)])
    return mesh
)";

constexpr const char* surfaceFunctions = R"(

def split(colour):
    """A colour of at most 1, and its strength."""
    peak = max(colour)
    return ([channel / peak for channel in colour] if peak > 0 else [0, 0, 0]), peak


def empty_material(name):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    material.node_tree.nodes.clear()
    return material, material.node_tree, material.node_tree.nodes.new("ShaderNodeOutputMaterial")


def diffuse_material(name, reflectance):
    material, tree, output = empty_material(name)
    shader = tree.nodes.new("ShaderNodeBsdfDiffuse")
    shader.inputs["Color"].default_value = reflectance + [1]
    tree.links.new(shader.outputs[0], output.inputs["Surface"])
    return material


def lamp_material(name, radiance):
    """Its front shines, its back is black."""
    material, tree, output = empty_material(name)
    shader = tree.nodes.new("ShaderNodeEmission")
    colour, strength = split(radiance)
    shader.inputs["Color"].default_value = colour + [1]
    front = tree.nodes.new("ShaderNodeMath")
    front.operation = 'MULTIPLY_ADD'
    tree.links.new(tree.nodes.new("ShaderNodeNewGeometry").outputs["Backfacing"], front.inputs[0])
    front.inputs[1].default_value = -strength
    front.inputs[2].default_value = strength
    tree.links.new(front.outputs[0], shader.inputs["Strength"])
    tree.links.new(shader.outputs[0], output.inputs["Surface"])
    return material


def surface(item, material):
    if "radiance" in item:
        return lamp_material(item["name"], item["radiance"])
    if "diffuse" in item:
        return diffuse_material(item["name"], item["diffuse"])
    return material


def mesh_of(item):
    if "sphere" in item:
        return sphere_mesh(item["name"], item["sphere"]["centre"], item["sphere"]["radius"])
    if "rectangle" in item:
        return rectangle_mesh(item["name"], item["rectangle"])
    return mesh_from_file(item["name"], os.path.join(folder(), item["mesh"]))
)";

constexpr const char* sceneFunctions = R"(

def add(scene, name, data, place):
    made = bpy.data.objects.new(name, data)
    made.matrix_world = place
    scene.collection.objects.link(made)
    return made


def add_sun(scene, sun):
    light = bpy.data.lights.new("sun", 'SUN')
    light.color, light.energy = split(sun["irradiance"])
    light.angle = 0
    add(scene, "sun", light, mathutils.Vector(sun["to_light"]).to_track_quat('Z', 'Y').to_matrix().to_4x4())


def add_point(scene, point):
    light = bpy.data.lights.new("point", 'POINT')
    light.color, strength = split(point["intensity"])
    light.energy = 4 * math.pi * strength
    light.shadow_soft_size = 0
    add(scene, "point", light, mathutils.Matrix.Translation(point["position"]))


def add_camera(scene, view):
    camera = bpy.data.cameras.new("camera")
    if "width" in view:
        camera.type = 'ORTHO'
        camera.ortho_scale = view["width"]
    else:
        camera.angle = view["field_of_view"]
    camera.clip_start, camera.clip_end = 0.001, 100000
    columns = mathutils.Matrix([view["right"], view["up"], view["back"]]).transposed().to_4x4()
    scene.camera = add(scene, "camera", camera, mathutils.Matrix.Translation(view["eye"]) @ columns)


def make_world(name, environment):
    world = bpy.data.worlds.new(name)
    world.use_nodes = True
    tree = world.node_tree
    tree.nodes.clear()
    background = tree.nodes.new("ShaderNodeBackground")
    tree.links.new(background.outputs[0], tree.nodes.new("ShaderNodeOutputWorld").inputs["Surface"])
    if environment is None:
        background.inputs["Strength"].default_value = 0
        return world
    picture = tree.nodes.new("ShaderNodeTexEnvironment")
    picture.image = bpy.data.images.load(os.path.join(folder(), environment["picture"]))
    mapping = tree.nodes.new("ShaderNodeMapping")
    mapping.inputs["Rotation"].default_value = (0, 0, environment["turn"])
    coordinates = tree.nodes.new("ShaderNodeTexCoord")
    tree.links.new(coordinates.outputs["Generated"], mapping.inputs["Vector"])
    tree.links.new(mapping.outputs["Vector"], picture.inputs["Vector"])
    tree.links.new(picture.outputs["Color"], background.inputs["Color"])
    return world


def set_up_cycles(scene, transparent):
    """As Gonio renders: no clamping, no filtering of reflections, linear values."""
    scene.render.engine = 'CYCLES'
    scene.render.film_transparent = transparent
    scene.render.resolution_x = scene.render.resolution_y = SCENE["pixels"]
    scene.render.resolution_percentage = 100
    scene.view_settings.view_transform = 'Standard'
    cycles = scene.cycles
    cycles.samples = SCENE["samples"]
    cycles.use_adaptive_sampling = False
    cycles.use_denoising = False
    cycles.pixel_filter_type = 'BOX'
    cycles.sample_clamp_indirect = 0
    cycles.blur_glossy = 0
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = 64


def make_scene():
    scene = bpy.data.scenes.new(SCENE["name"])
    environment = SCENE.get("environment")
    scene.world = make_world(SCENE["name"], environment)
    path = os.path.join(folder(), SCENE["material"])
    material = runpy.run_path(path, run_name="gonio_material")["make_material"]()
    for item in SCENE["objects"]:
        mesh = mesh_of(item)
        mesh.materials.append(surface(item, material))
        add(scene, item["name"], mesh, mathutils.Matrix.Identity(4))
    for sun in SCENE["suns"]:
        add_sun(scene, sun)
    for point in SCENE["points"]:
        add_point(scene, point)
    add_camera(scene, SCENE["camera"])
    set_up_cycles(scene, environment is not None and not environment["shown"])
    return scene


def main():
    scene = make_scene()
    if bpy.context.window is not None:
        bpy.context.window.scene = scene
    out = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    if not out:
        return
    path = os.path.abspath(out[0])
    if path.endswith(".blend"):
        bpy.ops.wm.save_as_mainfile(filepath=path)
        return
    settings = scene.render.image_settings
    settings.file_format = 'OPEN_EXR' if path.endswith(".exr") else 'PNG'
    if path.endswith(".exr"):
        settings.color_depth = '32'
    scene.render.filepath = path
    bpy.ops.render.render(write_still=True, scene=scene.name)


if __name__ == "__main__":
    main()
)";

/// The Python script of a scene. @param description Python code of the dictionary SCENE: directions and positions with
/// z up; "environment" is omitted if there is none.
std::string blenderSceneProgram(const std::string& description) {
  return sceneProgramStart + description + "\n" + meshFunctions + surfaceFunctions + sceneFunctions;
}

using SceneJson = nlohmann::ordered_json;

SceneJson triple(const Rgb& v) { return {float(v.x), float(v.y), float(v.z)}; }

/// From y up to z up.
SceneJson blenderAxes(const Direction& v) { return triple({v.x, -v.z, v.y}); }

SceneJson blenderCamera(const rendering::OrbitCamera& view) {
  const rendering::CameraFrame camera = rendering::cameraFrame(view);
  SceneJson json{{"eye", blenderAxes(camera.eye)},
                 {"right", blenderAxes(camera.right)},
                 {"up", blenderAxes(camera.up)},
                 {"back", blenderAxes(-camera.forward)}};
  if (camera.orthographic)
    json["width"] = 2 * camera.halfExtent;
  else
    json["field_of_view"] = view.fieldOfView;
  return json;
}

SceneJson blenderObject(const rendering::SceneObject& object, const std::string& mesh) {
  SceneJson json{{"name", plainText(object.name)}};
  if (const auto* sphere = std::get_if<rendering::Sphere>(&object.shape)) {
    json["sphere"] = {{"centre", blenderAxes(sphere->centre)}, {"radius", sphere->radius}};
  } else if (const auto* rectangle = std::get_if<rendering::Rectangle>(&object.shape)) {
    for (const auto& [u, v] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
      json["rectangle"].push_back(blenderAxes(rectangle->at(u, v)));
  } else {
    json["mesh"] = mesh;
  }
  if (object.emits())
    json["radiance"] = triple(object.radiance);
  else if (const auto* diffuse = std::get_if<rendering::Diffuse>(&object.material))
    json["diffuse"] = triple(diffuse->reflectance);
  return json;
}

std::string blenderSceneText(const rendering::Scene& scene, const SceneFileNames& files) {
  SceneJson json{
      {"name", files.name},         {"material", files.material},     {"camera", blenderCamera(scene.camera)},
      {"pixels", scenePixels},      {"samples", scenePictureSamples}, {"objects", SceneJson::array()},
      {"suns", SceneJson::array()}, {"points", SceneJson::array()}};
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    json["objects"].push_back(blenderObject(scene.objects[i], files.meshes[i]));
  for (const rendering::DirectionalLight& light : scene.directionalLights)
    json["suns"].push_back({{"to_light", blenderAxes(light.toLight)}, {"irradiance", triple(light.irradiance)}});
  for (const rendering::PointLight& light : scene.pointLights)
    json["points"].push_back({{"position", blenderAxes(light.position)}, {"intensity", triple(light.intensity)}});
  if (scene.environment)
    // The centre of Blender's picture is at +x, of Gonio's at +y (-z with y up).
    json["environment"] = {{"picture", files.environment},
                           {"turn", scene.environmentRotation - halfPi},
                           {"shown", scene.showEnvironment ? 1 : 0}};
  return blenderSceneProgram(io::jsonText(json, 2));
}

SceneFormat blenderFormat(std::string_view materialSuffix) {
  return {.textSuffix = "_scene.py",
          .environmentSuffix = "_environment.exr",
          .materialSuffix = materialSuffix,
          .text = blenderSceneText,
          .environment = [](const rendering::Scene& scene) { return scene.environment->image(); }};
}

}  // namespace

const SceneFormat& blenderSceneFormat() {
  static const SceneFormat format = blenderFormat("_blender.py");
  return format;
}

const SceneFormat& principledSceneFormat() {
  static const SceneFormat format = blenderFormat("_principled.py");
  return format;
}

}  // namespace gonio::exports
