// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/mesh_file.h"

#include <openssl/evp.h>

#include <cstdint>
#include <cstring>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <span>
#include <string>
#include <string_view>

#include "core/io/json_text.h"
#include "core/support/error.h"
#include "core/support/json_object.h"

namespace gonio::io {

namespace {

using nlohmann::json;

constexpr std::uint64_t maxGltfBytes = std::uint64_t(2) << 30;
constexpr std::size_t maxGltfTriangles = 100'000'000;
constexpr double maxCount = 4294967295.0;
constexpr int maxDepth = 256;

enum ComponentType : std::uint32_t {
  unsignedByte = 5121,
  unsignedShort = 5123,
  unsignedInt = 5125,
  floatingPoint = 5126
};
enum PrimitiveMode { triangleList = 4, triangleStrip = 5, triangleFan = 6 };

std::size_t sizeOf(ComponentType type) { return type == unsignedByte ? 1 : type == unsignedShort ? 2 : 4; }

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

  geometry::MeshArrays read() {
    checkExtensions();
    if (root_.contains("scenes") && !root_.array("scenes").empty()) {
      const JsonObject scene = item(root_, "scenes", root_.contains("scene") ? index(root_, "scene") : 0);
      if (scene.contains("nodes"))
        for (std::size_t i = 0; i < scene.array("nodes").size(); ++i)
          addNode(indexIn(scene, "nodes", i), glm::dmat4(1), 0);
    } else if (root_.contains("meshes")) {
      for (std::size_t i = 0; i < root_.array("meshes").size(); ++i) addMesh(i, glm::dmat4(1));
    }
    if (arrays_.triangles.empty()) throw Error("a glTF mesh: found no triangles in its scene, expected at least one");
    return std::move(arrays_);
  }

 private:
  struct Accessor {
    std::span<const std::byte> bytes;
    std::size_t count = 0, stride = 0;
    ComponentType type = floatingPoint;
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
    for (const json& name : root_.array("extensionsRequired"))
      for (const char* packing : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_mesh_quantization",
                                  "KHR_meshopt_compression"})
        if (name == packing)
          throw Error(std::string("found geometry compressed with ") + packing + ", expected uncompressed geometry");
  }

  /// Each node has one parent, so that a tree is walked once; a circle is found by its depth.
  void addNode(std::size_t number, const glm::dmat4& parent, int depth) {
    const JsonObject node = item(root_, "nodes", number);
    if (depth > maxDepth || ++nodesSeen_ > root_.array("nodes").size())
      throw Error(node.place("children") + ": found a node with two parents or in a cycle");
    const glm::dmat4 placed = parent * transformOf(node);
    if (node.contains("mesh")) addMesh(index(node, "mesh"), placed);
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

  void addMesh(std::size_t number, const glm::dmat4& placed) {
    const JsonObject mesh = item(root_, "meshes", number);
    for (std::size_t i = 0; i < mesh.array("primitives").size(); ++i) addPrimitive(item(mesh, "primitives", i), placed);
  }

  void addPrimitive(const JsonObject& primitive, const glm::dmat4& placed) {
    const std::size_t mode = numberOr(primitive, "mode", triangleList);
    if (mode != triangleList && mode != triangleStrip && mode != triangleFan) return;
    const JsonObject attributes = primitive.object("attributes");
    const auto positions = vectors(attributes, "POSITION");
    const auto normals = attributes.contains("NORMAL") ? vectors(attributes, "NORMAL") : std::vector<glm::vec3>();
    const std::size_t first = arrays_.positions.size();
    if (double(first) + double(positions.size()) > maxCount)
      throw Error("found more than " + std::to_string(std::uint64_t(maxCount)) + " vertices, the maximum");
    for (const glm::vec3& p : positions) arrays_.positions.emplace_back(placed * glm::dvec4(p, 1));
    const glm::dmat3 turned = glm::transpose(glm::inverse(glm::dmat3(placed)));
    const bool isMirrored = glm::determinant(glm::dmat3(placed)) < 0;
    for (geometry::TriangleIndices corners : trianglesOf(primitive, mode, positions.size())) {
      if (isMirrored) std::swap(corners[0], corners[1]);
      if (arrays_.triangles.size() >= maxGltfTriangles)
        throw Error("found more than " + std::to_string(maxGltfTriangles) + " triangles, the maximum");
      geometry::TriangleIndices& triangle = arrays_.triangles.emplace_back();
      for (int c = 0; c < 3; ++c) {
        triangle[c] = std::uint32_t(first + corners[c]);
        // Missing ones have no length, so that they are made.
        arrays_.normals.push_back(corners[c] < normals.size() ? glm::vec3(turned * glm::dvec3(normals[corners[c]]))
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
    const Accessor accessor = accessorOf(number, "SCALAR", 1);
    if (accessor.type == floatingPoint)
      throw Error("accessors[" + std::to_string(number) + "]: found floating-point indices, expected integers");
    std::vector<std::uint32_t> indices(accessor.count);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      std::memcpy(&indices[i], accessor.bytes.data() + i * accessor.stride, sizeOf(accessor.type));
      if (indices[i] >= vertices)
        throw Error("accessors[" + std::to_string(number) + "]: found vertex " + std::to_string(indices[i]) +
                    ", but there are only " + std::to_string(vertices) + ", counted from 0");
    }
    return indices;
  }

  std::vector<glm::vec3> vectors(const JsonObject& attributes, const std::string& key) const {
    const Accessor accessor = accessorOf(index(attributes, key), "VEC3", 3);
    if (accessor.type != floatingPoint) attributes.fail(key, "an accessor of single-precision numbers");
    std::vector<glm::vec3> result(accessor.count);
    for (std::size_t i = 0; i < result.size(); ++i)
      std::memcpy(&result[i], accessor.bytes.data() + i * accessor.stride, sizeof(glm::vec3));
    return result;
  }

  Accessor accessorOf(std::size_t number, const std::string& type, std::size_t components) const {
    const JsonObject accessor = item(root_, "accessors", number);
    if (accessor.text("type") != type) accessor.fail("type", type);
    if (accessor.contains("sparse")) accessor.fail("sparse", "no sparse accessor (not supported)");
    const auto componentType = ComponentType(std::uint32_t(accessor.number("componentType", 0, 1e5)));
    if (componentType != unsignedByte && componentType != unsignedShort && componentType != unsignedInt &&
        componentType != floatingPoint)
      accessor.fail("componentType",
                    "5121 (unsigned byte), 5123 (unsigned short), 5125 (unsigned int) or 5126 (float)");
    const JsonObject view = item(root_, "bufferViews", index(accessor, "bufferView"));
    const std::size_t element = components * sizeOf(componentType), count = index(accessor, "count"),
                      stride = numberOr(view, "byteStride", double(element)),
                      offset = numberOr(accessor, "byteOffset", 0), begin = numberOr(view, "byteOffset", 0),
                      length = index(view, "byteLength");
    const std::span<const std::byte> buffer = bufferOf(index(view, "buffer"));
    if (begin > buffer.size() || length > buffer.size() - begin)
      view.fail("byteLength", "at most the size of its buffer, " + std::to_string(buffer.size()) + " bytes");
    if (stride < element) view.fail("byteStride", "at least " + std::to_string(element));
    // The last element needs no bytes behind it.
    if (count > 0 &&
        (offset > length || (length - offset) < element || (count - 1) > (length - offset - element) / stride))
      accessor.fail("count", "at most as many elements as its buffer view contains");
    return {buffer.subspan(begin + (count > 0 ? offset : 0)), count, stride, componentType};
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
  geometry::MeshArrays arrays_;
  std::size_t nodesSeen_ = 0;
  mutable std::vector<std::optional<std::vector<std::byte>>> buffers_;  ///< that have been opened
};

}  // namespace

geometry::TriangleMesh readGltf(const ByteSource& source, const std::optional<std::filesystem::path>& folder) {
  const std::vector<std::byte> bytes = source.readAll(maxGltfBytes);
  const GltfParts parts = gltfParts(bytes);
  const json root = parseJson({reinterpret_cast<const char*>(parts.text.data()), parts.text.size()});
  return geometry::TriangleMesh(GltfReader(root, parts.binary, folder).read());
}

}  // namespace gonio::io
