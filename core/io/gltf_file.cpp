// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/mesh_file.h"

#include <openssl/evp.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/io/json_text.h"
#include "core/support/error.h"
#include "core/support/json_object.h"
#include "core/support/text.h"

namespace gonio::io {

namespace {

using nlohmann::json;

constexpr std::uint64_t maxGltfBytes = std::uint64_t(2) << 30;
constexpr std::size_t maxGltfTriangles = 100'000'000;
constexpr double maxCount = 4294967295.0;
constexpr int maxDepth = 256;

/// Elements of an accessor that has no bytes in the file.
constexpr std::size_t maxEmptyElements = std::size_t(1) << 24;

enum ComponentType : std::uint32_t {
  signedByte = 5120,
  unsignedByte = 5121,
  signedShort = 5122,
  unsignedShort = 5123,
  unsignedInt = 5125,
  floatingPoint = 5126
};
enum PrimitiveMode { triangleList = 4, triangleStrip = 5, triangleFan = 6 };

std::size_t sizeOf(ComponentType type) {
  switch (type) {
    case signedByte:
    case unsignedByte:
      return 1;
    case signedShort:
    case unsignedShort:
      return 2;
    default:
      return 4;
  }
}

template <typename T>
T loaded(const std::byte* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

/// A component; normalised ones are from -1 or 0 to 1 (glTF 2.0, 3.11).
double component(const std::byte* from, ComponentType type, bool isNormalised) {
  const auto scaled = [&](double value, double most) { return isNormalised ? std::max(value / most, -1.0) : value; };
  switch (type) {
    case signedByte:
      return scaled(loaded<std::int8_t>(from), 127);
    case unsignedByte:
      return scaled(loaded<std::uint8_t>(from), 255);
    case signedShort:
      return scaled(loaded<std::int16_t>(from), 32767);
    case unsignedShort:
      return scaled(loaded<std::uint16_t>(from), 65535);
    case unsignedInt:
      return loaded<std::uint32_t>(from);
    case floatingPoint:
      break;
  }
  return loaded<float>(from);
}

/// Whether a mesh has the same shape without an extension.
bool keepsShape(const std::string& extension) {
  constexpr std::string_view beginnings[] = {"KHR_materials_", "KHR_texture_", "EXT_texture_",     "MSFT_texture_",
                                             "KHR_lights_",    "EXT_lights_",  "ADOBE_materials_", "KHR_xmp"};
  // Quantised geometry is read (accessors of any type).
  return extension == "KHR_mesh_quantization" || extension == "KHR_animation_pointer" ||
         std::ranges::any_of(beginnings, [&](std::string_view beginning) { return extension.starts_with(beginning); });
}

/// The JSON text of a file, and its binary part if it has one.
struct GltfParts {
  std::span<const std::byte> text, binary;
};

std::uint32_t uint32At(std::span<const std::byte> bytes, std::size_t at) {
  if (at + 4 > bytes.size())
    throw Error("a binary glTF file: found the end of the file, expected the header or a chunk");
  std::uint32_t value;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

/// The chunks of a binary file; if the file is not binary, all its bytes as `text`. @throws Error if a chunk is
/// truncated or the version is not supported.
GltfParts gltfParts(std::span<const std::byte> bytes) {
  constexpr std::uint32_t magic = 0x46546C67, jsonChunk = 0x4E4F534A, binaryChunk = 0x004E4942;
  if (bytes.size() < 4 || uint32At(bytes, 0) != magic) return {bytes, {}};
  if (const std::uint32_t version = uint32At(bytes, 4); version != 2)
    throw Error("found glTF version " + std::to_string(version) + ", expected 2");
  GltfParts parts;
  for (std::size_t at = 12; at < bytes.size();) {
    const std::uint32_t length = uint32At(bytes, at), kind = uint32At(bytes, at + 4);
    at += 8;
    if (length > bytes.size() - at)
      throw Error("found " + std::to_string(bytes.size() - at) + " bytes of a chunk, expected " +
                  std::to_string(length));
    if (kind == jsonChunk) parts.text = bytes.subspan(at, length);
    if (kind == binaryChunk) parts.binary = bytes.subspan(at, length);
    at += length;
  }
  return parts;
}

/// @throws Error that names the buffer if the text is not base64.
std::vector<std::byte> decodedBase64(const JsonObject& buffer, std::string_view text) {
  std::vector<std::byte> bytes(text.size() / 4 * 3 + 3);
  const int length = text.size() > std::size_t(1) << 30 || text.size() % 4 != 0
                         ? -1
                         : EVP_DecodeBlock(reinterpret_cast<unsigned char*>(bytes.data()),
                                           reinterpret_cast<const unsigned char*>(text.data()), int(text.size()));
  if (length < 0) buffer.fail("uri", "base64 data");
  bytes.resize(std::size_t(length));
  return bytes;
}

/// A relative URI, with its percent-encoding decoded, as a path.
std::filesystem::path decodedPath(std::string_view address) {
  std::string path;
  for (std::size_t i = 0; i < address.size(); ++i) {
    const auto digit = [&](std::size_t at) {
      const char c = at < address.size() ? address[at] : ' ';
      return c >= '0' && c <= '9'   ? c - '0'
             : c >= 'A' && c <= 'F' ? c - 'A' + 10
             : c >= 'a' && c <= 'f' ? c - 'a' + 10
                                    : -1;
    };
    const bool coded = address[i] == '%' && digit(i + 1) >= 0 && digit(i + 2) >= 0;
    path += coded ? char(16 * digit(i + 1) + digit(i + 2)) : address[i];
    if (coded) i += 2;
  }
  return path;
}

class GltfReader {
 public:
  GltfReader(const json& root, std::span<const std::byte> binary, const std::optional<std::filesystem::path>& folder)
      : root_(root, ""), binary_(binary), folder_(folder) {}

  MeshFile read() {
    checkExtensions();
    findParents();
    if (root_.contains("scenes") && !root_.array("scenes").empty()) {
      const JsonObject scene = item(root_, "scenes", root_.contains("scene") ? index(root_, "scene") : 0);
      if (scene.contains("nodes"))
        for (std::size_t i = 0; i < scene.array("nodes").size(); ++i)
          addNode(indexIn(scene, "nodes", i), glm::dmat4(1), 0);
    } else if (root_.contains("meshes")) {
      for (std::size_t i = 0; i < root_.array("meshes").size(); ++i) addMesh(i, {}, nullptr);
    }
    if (arrays_.triangles.empty()) throw Error("a glTF mesh: found no triangles in its scene, expected at least one");
    glm::dvec3 origin;
    arrays_.positions = localPositions(positions_, origin);
    return {geometry::TriangleMesh(std::move(arrays_)), origin, {}};
  }

 private:
  /// Some elements of a buffer.
  struct Elements {
    std::span<const std::byte> bytes;
    std::size_t stride = 0;

    const std::byte* at(std::size_t i) const { return bytes.data() + i * stride; }
  };
  /// Where a mesh is placed: by its node, or, with a skin, by its joints.
  struct Placement {
    glm::dmat4 node{1};
    const std::vector<glm::dmat4>* joints = nullptr;  ///< null: no skin
  };

  static std::size_t numberOr(const JsonObject& object, std::string_view key, double otherwise) {
    return std::size_t(object.contains(key) ? object.number(key, 0, maxCount) : otherwise);
  }
  static std::size_t index(const JsonObject& object, std::string_view key) {
    return std::size_t(object.number(key, 0, maxCount));
  }
  static std::size_t indexIn(const JsonObject& object, std::string_view key, std::size_t i) {
    const json& value = object.array(key)[i];
    if (!value.is_number_unsigned()) object.fail(key, "indices");
    return value.get<std::size_t>();
  }
  JsonObject item(const JsonObject& object, const std::string& key, std::size_t i) const {
    const json& list = object.array(key);
    if (i >= list.size()) throw Error(object.place(key) + ": there is no element " + std::to_string(i));
    return {list[i], object.place(key) + "[" + std::to_string(i) + "]"};
  }

  void checkExtensions() const {
    if (!root_.contains("extensionsRequired")) return;
    for (const json& name : root_.array("extensionsRequired")) {
      if (!name.is_string()) root_.fail("extensionsRequired", "names of extensions");
      const std::string extension = name.get<std::string>();
      for (const char* packing : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"})
        if (extension == packing)
          throw Error("found geometry compressed with " + extension + ", expected uncompressed geometry");
      if (!keepsShape(extension))
        throw Error("found the required extension '" + plainText(extension) +
                    "', which may change the shape, expected a file that does not require it");
    }
  }

  void findParents() {
    if (!root_.contains("nodes")) return;
    const std::size_t count = root_.array("nodes").size();
    parents_.assign(count, count);
    for (std::size_t number = 0; number < count; ++number) {
      const JsonObject node = item(root_, "nodes", number);
      if (!node.contains("children")) continue;
      for (std::size_t i = 0; i < node.array("children").size(); ++i)
        if (const std::size_t child = indexIn(node, "children", i); child < count) parents_[child] = number;
    }
  }

  /// From a node's coordinates to those of the scene.
  glm::dmat4 placeOf(std::size_t number) const {
    glm::dmat4 result = transformOf(item(root_, "nodes", number));
    for (int depth = 0; (number = parents_[number]) < parents_.size(); ++depth) {
      if (depth > maxDepth) throw Error("nodes: found a node with two parents or in a cycle");
      result = transformOf(item(root_, "nodes", number)) * result;
    }
    return result;
  }

  /// For each joint of a skin, where it takes the vertices of the mesh (glTF 2.0, 3.7.3).
  const std::vector<glm::dmat4>& jointsOf(std::size_t number) {
    if (const auto known = skins_.find(number); known != skins_.end()) return known->second;
    const JsonObject skin = item(root_, "skins", number);
    const std::size_t count = skin.array("joints").size();
    std::vector<float> inverse;
    if (skin.contains("inverseBindMatrices")) {
      inverse = numbers<float>(index(skin, "inverseBindMatrices"), "MAT4", 16);
      if (inverse.size() < 16 * count) skin.fail("inverseBindMatrices", "a matrix for each joint");
    }
    std::vector<glm::dmat4> result;
    for (std::size_t i = 0; i < count; ++i) {
      result.push_back(placeOf(indexIn(skin, "joints", i)));
      if (!inverse.empty()) result.back() *= glm::dmat4(glm::make_mat4(inverse.data() + 16 * i));
    }
    if (result.empty()) skin.fail("joints", "at least one joint");
    return skins_.emplace(number, std::move(result)).first->second;
  }

  /// Each node has one parent, so that a tree is walked once; a circle is found by its depth.
  void addNode(std::size_t number, const glm::dmat4& parent, int depth) {
    const JsonObject node = item(root_, "nodes", number);
    if (depth > maxDepth || ++nodesSeen_ > root_.array("nodes").size())
      throw Error(node.place("children") + ": found a node with two parents or in a cycle");
    const glm::dmat4 placed = parent * transformOf(node);
    if (node.contains("mesh"))
      addMesh(index(node, "mesh"), {placed, node.contains("skin") ? &jointsOf(index(node, "skin")) : nullptr}, &node);
    if (node.contains("children"))
      for (std::size_t i = 0; i < node.array("children").size(); ++i)
        addNode(indexIn(node, "children", i), placed, depth + 1);
  }

  static std::vector<double> numbersOf(const JsonObject& object, std::string_view key, std::vector<double> otherwise) {
    if (!object.contains(key)) return otherwise;
    const json& list = object.array(key);
    if (list.size() != otherwise.size()) object.fail(key, std::to_string(otherwise.size()) + " numbers");
    for (std::size_t i = 0; i < otherwise.size(); ++i) {
      if (!list[i].is_number()) object.fail(key, "numbers");
      otherwise[i] = list[i].get<double>();
    }
    return otherwise;
  }

  static glm::dmat4 transformOf(const JsonObject& node) {
    if (node.contains("matrix")) return glm::make_mat4(numbersOf(node, "matrix", std::vector<double>(16)).data());
    const auto move = numbersOf(node, "translation", {0, 0, 0}), turn = numbersOf(node, "rotation", {0, 0, 0, 1}),
               scale = numbersOf(node, "scale", {1, 1, 1});
    glm::dmat4 placed = glm::mat4_cast(glm::dquat(turn[3], turn[0], turn[1], turn[2]));
    for (int i = 0; i < 3; ++i) placed[i] *= scale[std::size_t(i)];
    placed[3] = glm::dvec4(move[0], move[1], move[2], 1);
    return placed;
  }

  /// @param node that has the mesh; null: none.
  void addMesh(std::size_t number, const Placement& placed, const JsonObject* node) {
    const JsonObject mesh = item(root_, "meshes", number);
    std::vector<double> weights;
    for (const JsonObject* object : {&mesh, node})
      if (object && object->contains("weights")) {
        weights.clear();
        for (const json& weight : object->array("weights")) {
          if (!weight.is_number()) object->fail("weights", "numbers");
          weights.push_back(weight.get<double>());
        }
      }
    for (std::size_t i = 0; i < mesh.array("primitives").size(); ++i)
      addPrimitive(item(mesh, "primitives", i), placed, weights);
  }

  /// Vectors of an attribute with those of the morph targets by their weights; empty if there are none.
  std::vector<glm::dvec3> morphed(const JsonObject& primitive, const std::string& key,
                                  const std::vector<double>& weights) const {
    const JsonObject attributes = primitive.object("attributes");
    if (!attributes.contains(key)) return {};
    const std::vector<float> base = numbers<float>(index(attributes, key), "VEC3", 3);
    std::vector<glm::dvec3> result(base.size() / 3);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = {base[3 * i], base[3 * i + 1], base[3 * i + 2]};
    for (std::size_t t = 0; primitive.contains("targets") && t < weights.size(); ++t) {
      if (weights[t] == 0) continue;
      const JsonObject target = item(primitive, "targets", t);
      if (!target.contains(key)) continue;
      const std::vector<float> change = numbers<float>(index(target, key), "VEC3", 3);
      if (change.size() != base.size()) target.fail(key, "as many vectors as the primitive has");
      for (std::size_t i = 0; i < result.size(); ++i)
        result[i] += weights[t] * glm::dvec3(change[3 * i], change[3 * i + 1], change[3 * i + 2]);
    }
    return result;
  }

  /// The transform of each vertex: one for all, or the weighted mean of its joints.
  std::vector<glm::dmat4> transformsOf(const JsonObject& attributes, const Placement& placed, std::size_t count) const {
    if (!placed.joints) return {placed.node};
    std::vector<glm::dmat4> result(count, glm::dmat4(0));
    std::vector<double> totals(count);
    for (int set = 0; attributes.contains("JOINTS_" + std::to_string(set)); ++set) {
      const std::string number = std::to_string(set);
      const auto joints = numbers<std::uint32_t>(index(attributes, "JOINTS_" + number), "VEC4", 4);
      const auto weights = numbers<float>(index(attributes, "WEIGHTS_" + number), "VEC4", 4);
      if (joints.size() != 4 * count || weights.size() != 4 * count)
        attributes.fail("JOINTS_" + number, "as many joints and weights as positions");
      for (std::size_t i = 0; i < joints.size(); ++i) {
        if (weights[i] == 0) continue;
        if (joints[i] >= placed.joints->size())
          attributes.fail("JOINTS_" + number,
                          "joints of the skin, at most " + std::to_string(placed.joints->size() - 1));
        result[i / 4] += double(weights[i]) * (*placed.joints)[joints[i]];
        totals[i / 4] += weights[i];
      }
    }
    // Without weights nothing says where the vertex is; weights need not have the sum 1 exactly.
    for (std::size_t i = 0; i < count; ++i) result[i] = totals[i] > 0 ? result[i] / totals[i] : glm::dmat4(1);
    return result;
  }

  void addPrimitive(const JsonObject& primitive, const Placement& placed, const std::vector<double>& weights) {
    const std::size_t mode = numberOr(primitive, "mode", triangleList);
    if (mode != triangleList && mode != triangleStrip && mode != triangleFan) return;
    const JsonObject attributes = primitive.object("attributes");
    if (!attributes.contains("POSITION")) attributes.fail("POSITION", "an accessor");
    const auto positions = morphed(primitive, "POSITION", weights), normals = morphed(primitive, "NORMAL", weights);
    const std::size_t first = positions_.size();
    if (double(first) + double(positions.size()) > maxCount)
      throw Error("found more than " + std::to_string(std::uint64_t(maxCount)) + " vertices, the maximum");
    const std::vector<glm::dmat4> transforms = transformsOf(attributes, placed, positions.size());
    const auto transform = [&](std::size_t vertex) -> const glm::dmat4& {
      return transforms[transforms.size() == 1 ? 0 : vertex];
    };
    for (std::size_t i = 0; i < positions.size(); ++i)
      positions_.emplace_back(transform(i) * glm::dvec4(positions[i], 1));
    for (geometry::TriangleIndices corners : trianglesOf(primitive, mode, positions.size())) {
      if (glm::determinant(glm::dmat3(transform(corners[0]))) < 0) std::swap(corners[0], corners[1]);
      if (arrays_.triangles.size() >= maxGltfTriangles)
        throw Error("found more than " + std::to_string(maxGltfTriangles) + " triangles, the maximum");
      geometry::TriangleIndices& triangle = arrays_.triangles.emplace_back();
      for (int c = 0; c < 3; ++c) {
        triangle[c] = std::uint32_t(first + corners[c]);
        // Missing ones have no length, so that they are made.
        arrays_.normals.push_back(
            corners[c] < normals.size()
                ? glm::vec3(glm::transpose(glm::inverse(glm::dmat3(transform(corners[c])))) * normals[corners[c]])
                : glm::vec3(0));
      }
    }
  }

  std::vector<geometry::TriangleIndices> trianglesOf(const JsonObject& primitive, std::size_t mode,
                                                     std::size_t vertices) const {
    std::vector<std::uint32_t> indices;
    if (primitive.contains("indices")) {
      indices = indicesOf(index(primitive, "indices"), vertices);
    } else {
      for (std::size_t i = 0; i < vertices; ++i) indices.push_back(std::uint32_t(i));
    }
    std::vector<geometry::TriangleIndices> triangles;
    for (std::size_t i = 2; i < indices.size(); ++i) {
      if (mode == triangleList && i % 3 != 2) continue;
      const bool swapped = mode == triangleStrip && i % 2 == 1;
      triangles.push_back({indices[mode == triangleFan ? 0
                                   : swapped           ? i - 1
                                                       : i - 2],
                           indices[swapped ? i - 2 : i - 1], indices[i]});
    }
    return triangles;
  }

  std::vector<std::uint32_t> indicesOf(std::size_t number, std::size_t vertices) const {
    if (typeOf(item(root_, "accessors", number)) == floatingPoint)
      throw Error("accessors[" + std::to_string(number) + "]: found floating-point indices, expected integers");
    std::vector<std::uint32_t> indices = numbers<std::uint32_t>(number, "SCALAR", 1);
    for (const std::uint32_t vertex : indices)
      if (vertex >= vertices)
        throw Error("accessors[" + std::to_string(number) + "]: found vertex " + std::to_string(vertex) +
                    ", but there are only " + std::to_string(vertices) + ", counted from 0");
    return indices;
  }

  static ComponentType typeOf(const JsonObject& object) {
    const auto type = ComponentType(std::uint32_t(object.number("componentType", 0, 1e5)));
    for (const ComponentType known : {signedByte, unsignedByte, signedShort, unsignedShort, unsignedInt, floatingPoint})
      if (type == known) return type;
    object.fail("componentType",
                "5120 (byte), 5121 (unsigned byte), 5122 (short), 5123 (unsigned short), 5125 (unsigned int) or 5126 "
                "(float)");
  }

  /// All components of an accessor, one element after another. @throws Error that names the accessor if it has another
  /// type, or integers are negative or too large.
  template <typename T>
  std::vector<T> numbers(std::size_t number, const std::string& type, std::size_t components) const {
    const JsonObject accessor = item(root_, "accessors", number);
    if (accessor.text("type") != type) accessor.fail("type", type);
    const ComponentType componentType = typeOf(accessor);
    const bool isNormalised = accessor.contains("normalized") && accessor.flag("normalized");
    if (std::is_integral_v<T> &&
        (isNormalised || componentType == signedByte || componentType == signedShort || componentType == floatingPoint))
      accessor.fail("componentType", "unsigned integers");
    const std::size_t count = index(accessor, "count");
    const auto load = [&](const std::byte* from, std::size_t i) {
      return T(component(from + i * sizeOf(componentType), componentType, isNormalised));
    };
    std::vector<T> result;
    if (accessor.contains("bufferView")) {
      const Elements elements = elementsOf(accessor, "count", count, components * sizeOf(componentType));
      result.reserve(count * components);
      for (std::size_t e = 0; e < count; ++e)
        for (std::size_t i = 0; i < components; ++i) result.push_back(load(elements.at(e), i));
    } else {
      // Zeros, which a sparse accessor replaces in part.
      if (count > maxEmptyElements)
        accessor.fail("count", "at most " + std::to_string(maxEmptyElements) + " elements without a buffer view");
      result.resize(count * components);
    }
    if (!accessor.contains("sparse")) return result;
    const JsonObject sparse = accessor.object("sparse"), places = sparse.object("indices"),
                     values = sparse.object("values");
    const ComponentType placeType = typeOf(places);
    const std::size_t changed = index(sparse, "count");
    const Elements at = elementsOf(places, "bufferView", changed, sizeOf(placeType)),
                   to = elementsOf(values, "bufferView", changed, components * sizeOf(componentType));
    for (std::size_t e = 0; e < changed; ++e) {
      const double place = component(at.at(e), placeType, false);
      if (!(place >= 0 && place < double(count))) places.fail("bufferView", "indices below the count of the accessor");
      for (std::size_t i = 0; i < components; ++i) result[std::size_t(place) * components + i] = load(to.at(e), i);
    }
    return result;
  }

  /// Elements in the buffer view of an object. @param key to name if the view has too few.
  Elements elementsOf(const JsonObject& object, std::string_view key, std::size_t count, std::size_t element) const {
    const JsonObject view = item(root_, "bufferViews", index(object, "bufferView"));
    const std::size_t stride = numberOr(view, "byteStride", double(element)),
                      offset = numberOr(object, "byteOffset", 0), begin = numberOr(view, "byteOffset", 0),
                      length = index(view, "byteLength");
    const std::span<const std::byte> buffer = bufferOf(index(view, "buffer"));
    if (begin > buffer.size() || length > buffer.size() - begin)
      view.fail("byteLength", "at most the size of its buffer, " + std::to_string(buffer.size()) + " bytes");
    if (stride < element) view.fail("byteStride", "at least " + std::to_string(element));
    // The last element needs no bytes behind it.
    if (count > 0 &&
        (offset > length || (length - offset) < element || (count - 1) > (length - offset - element) / stride))
      object.fail(key, "at most as many elements as its buffer view contains");
    return {buffer.subspan(begin + (count > 0 ? offset : 0)), stride};
  }

  std::span<const std::byte> bufferOf(std::size_t number) const {
    const JsonObject buffer = item(root_, "buffers", number);
    if (!buffer.contains("uri")) return binary_;
    if (number >= buffers_.size()) buffers_.resize(number + 1);
    if (std::optional<std::vector<std::byte>>& known = buffers_[number]; !known) known = opened(buffer);
    return *buffers_[number];
  }

  std::vector<std::byte> opened(const JsonObject& buffer) const {
    const std::string address = buffer.text("uri");
    if (address.starts_with("data:")) {
      const std::size_t comma = address.find(";base64,");
      if (comma == std::string::npos) buffer.fail("uri", "base64 data");
      return decodedBase64(buffer, std::string_view(address).substr(comma + 8));
    }
    if (!folder_ || address.find("://") != std::string::npos) buffer.fail("uri", "a file in the same folder");
    const std::filesystem::path path = *folder_ / decodedPath(address);
    return withFileInErrors(path, [&] { return FileSource(path).readAll(maxGltfBytes); });
  }

  JsonObject root_;
  std::span<const std::byte> binary_;
  const std::optional<std::filesystem::path>& folder_;
  geometry::MeshArrays arrays_;  ///< but the positions
  std::vector<glm::dvec3> positions_;
  std::vector<std::size_t> parents_;                      ///< of each node; the number of nodes: none
  std::map<std::size_t, std::vector<glm::dmat4>> skins_;  ///< jointsOf() of those that were needed
  std::size_t nodesSeen_ = 0;
  mutable std::vector<std::optional<std::vector<std::byte>>> buffers_;  ///< that have been opened
};

}  // namespace

MeshFile readGltf(const ByteSource& source, const std::optional<std::filesystem::path>& folder) {
  const std::vector<std::byte> bytes = source.readAll(maxGltfBytes);
  const GltfParts parts = gltfParts(bytes);
  const json root = parseJson({reinterpret_cast<const char*>(parts.text.data()), parts.text.size()});
  return GltfReader(root, parts.binary, folder).read();
}

}  // namespace gonio::io
