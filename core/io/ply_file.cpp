// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/mesh_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "core/geometry/polygon.h"
#include "core/io/byte_source.h"
#include "core/io/text_lines.h"
#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::io {

namespace {

constexpr std::uint64_t maxPlyBytes = std::uint64_t(2) << 30;
constexpr std::size_t maxPlyTriangles = 100'000'000, maxCorners = 10'000;

enum class NumberType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class PlyEncoding { text, littleEndian, bigEndian };

struct PlyProperty {
  std::string name;
  NumberType type;
  std::optional<NumberType> countType;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count;
  std::vector<PlyProperty> properties;

  /// Where a property of one of these names stands; -1: nowhere.
  int indexOf(std::initializer_list<std::string_view> names) const {
    for (std::size_t i = 0; i < properties.size(); ++i)
      if (std::ranges::find(names, properties[i].name) != names.end()) return int(i);
    return -1;
  }
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::text;
  std::vector<PlyElement> elements;
  std::size_t end = 0;  ///< where the values begin
};

std::optional<NumberType> numberType(std::string_view word) {
  constexpr std::pair<std::string_view, NumberType> types[] = {
      {"char", NumberType::int8},      {"int8", NumberType::int8},       {"uchar", NumberType::uint8},
      {"uint8", NumberType::uint8},    {"short", NumberType::int16},     {"int16", NumberType::int16},
      {"ushort", NumberType::uint16},  {"uint16", NumberType::uint16},   {"int", NumberType::int32},
      {"int32", NumberType::int32},    {"uint", NumberType::uint32},     {"uint32", NumberType::uint32},
      {"float", NumberType::float32},  {"float32", NumberType::float32}, {"double", NumberType::float64},
      {"float64", NumberType::float64}};
  for (const auto& [name, type] : types)
    if (name == word) return type;
  return std::nullopt;
}

PlyEncoding encodingOf(const TextLine& line, std::string_view word) {
  if (word == "ascii") return PlyEncoding::text;
  if (word == "binary_little_endian") return PlyEncoding::littleEndian;
  if (word == "binary_big_endian") return PlyEncoding::bigEndian;
  line.fail("'format ascii 1.0', 'format binary_little_endian 1.0' or 'format binary_big_endian 1.0'");
}

PlyProperty propertyOf(const TextLine& line, const std::vector<std::string_view>& part) {
  const bool isList = part.size() == 5 && part[1] == "list";
  if (!isList && part.size() != 3) line.fail("'property TYPE NAME' or 'property list TYPE TYPE NAME'");
  const auto type = numberType(part[isList ? 3 : 1]), countType = isList ? numberType(part[2]) : std::nullopt;
  if (!type || (isList && !countType)) line.fail("a type such as 'float' or 'uchar'");
  return {std::string(part.back()), *type, countType};
}

PlyHeader headerOf(std::string_view text) {
  if (!text.starts_with("ply")) throw Error("the file does not begin with 'ply', as PLY meshes do");
  PlyHeader header;
  std::size_t at = 0;
  for (std::size_t number = 1;; ++number) {
    const std::size_t end = text.find('\n', at);
    std::string_view content = text.substr(at, end == std::string_view::npos ? end : end - at);
    if (content.ends_with('\r')) content.remove_suffix(1);
    const TextLine line{number, content};
    const std::vector<std::string_view> part = words(content);
    if (number == 1 && content != "ply") line.fail("'ply'");
    if (end == std::string_view::npos) line.fail("'end_header' on a line of its own");
    at = header.end = end + 1;
    if (number == 1 || part.empty() || part[0] == "comment" || part[0] == "obj_info") continue;
    if (part[0] == "end_header") return header;
    if (part[0] == "format" && part.size() == 3) {
      header.encoding = encodingOf(line, part[1]);
    } else if (part[0] == "element" && part.size() == 3) {
      PlyElement element{std::string(part[1]), 0, {}};
      const auto [stop, error] = std::from_chars(part[2].data(), part[2].data() + part[2].size(), element.count);
      if (error != std::errc() || stop != part[2].data() + part[2].size()) line.fail("'element NAME COUNT'");
      header.elements.push_back(std::move(element));
    } else if (part[0] == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(propertyOf(line, part));
    } else {
      line.fail("format, element, property, comment or end_header");
    }
  }
}

/// The numbers behind the header, one after another.
class PlyNumbers {
 public:
  PlyNumbers(std::string_view data, PlyEncoding encoding) : rest_(data), encoding_(encoding) {}

  double next(NumberType type) {
    switch (type) {
      case NumberType::int8:
        return take<std::int8_t>();
      case NumberType::uint8:
        return take<std::uint8_t>();
      case NumberType::int16:
        return take<std::int16_t>();
      case NumberType::uint16:
        return take<std::uint16_t>();
      case NumberType::int32:
        return take<std::int32_t>();
      case NumberType::uint32:
        return take<std::uint32_t>();
      case NumberType::float32:
        return take<float>();
      case NumberType::float64:
        break;
    }
    return take<double>();
  }

 private:
  template <typename T>
  double take() {
    if (encoding_ == PlyEncoding::text) return word();
    std::array<char, sizeof(T)> bytes;
    if (rest_.size() < bytes.size()) throw Error("found the end of the file, expected another number");
    std::ranges::copy(rest_.substr(0, bytes.size()), bytes.begin());
    rest_.remove_prefix(bytes.size());
    if ((encoding_ == PlyEncoding::littleEndian) != (std::endian::native == std::endian::little))
      std::ranges::reverse(bytes);
    return double(std::bit_cast<T>(bytes));
  }

  double word() {
    constexpr std::string_view spaces = " \t\r\n";
    rest_.remove_prefix(std::min(rest_.find_first_not_of(spaces), rest_.size()));
    const std::string_view found = rest_.substr(0, rest_.find_first_of(spaces));
    if (found.empty()) throw Error("found the end of the file, expected another number");
    rest_.remove_prefix(found.size());
    const std::optional<double> value = finiteNumber(found);
    if (!value) throw Error("found '" + std::string(found.substr(0, 40)) + "', expected a finite number");
    return *value;
  }

  std::string_view rest_;
  PlyEncoding encoding_;
};

class PlyReader {
 public:
  explicit PlyReader(std::string_view data)
      : header_(headerOf(data)), numbers_(data.substr(header_.end), header_.encoding) {}

  MeshFile read() {
    for (const PlyElement& element : header_.elements) {
      // Rows without numbers: the file could state any count of them.
      if (element.properties.empty() && element.name != "vertex") continue;
      for (std::uint64_t i = 0; i < element.count; ++i) readRow(element, i);
    }
    if (faceEnds_.empty()) throw Error("a PLY mesh: found no faces, expected at least one");
    geometry::MeshArrays read = arrays();
    return {geometry::TriangleMesh(std::move(read)), origin_, {}};
  }

 private:
  void readRow(const PlyElement& element, std::uint64_t row) try {
    if (element.name == "vertex") return readVertex(element);
    const bool isStrips = element.name == "tristrips";
    const int corners = element.name == "face" || isStrips ? element.indexOf({"vertex_indices", "vertex_index"}) : -1;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (int(i) == corners && property.countType)
        isStrips ? readStrips(property) : readFace(property);
      else
        for (std::uint64_t left = property.countType ? listLength(property) : 1; left > 0; --left)
          numbers_.next(property.type);
    }
  } catch (const Error& error) {
    throw Error(element.name + " " + std::to_string(row) + ": " + error.what());
  }

  std::uint64_t listLength(const PlyProperty& property) {
    const double length = numbers_.next(*property.countType);
    if (!(length >= 0 && length <= 1e9 && length == std::floor(length)))
      throw Error("found a list of " + std::to_string(length) +
                  " numbers, expected a whole number from 0 to 1000000000");
    return std::uint64_t(length);
  }

  void readVertex(const PlyElement& element) {
    const int x = element.indexOf({"x"}), y = element.indexOf({"y"}), z = element.indexOf({"z"});
    const int nx = element.indexOf({"nx"}), ny = element.indexOf({"ny"}), nz = element.indexOf({"nz"});
    if (x < 0 || y < 0 || z < 0) throw Error("found a vertex element without x, y and z, expected all three");
    std::vector<double> values(element.properties.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      for (std::uint64_t left = property.countType ? listLength(property) : 1; left > 0; --left)
        values[i] = numbers_.next(property.type);
    }
    const auto at = [&](int i) { return values[std::size_t(i)]; };
    for (const int coordinate : {x, y, z})
      if (!std::isfinite(float(at(coordinate))))
        throw Error("found a coordinate of " + numberText(at(coordinate)) +
                    ", expected a finite number in the range of single precision");
    positions_.emplace_back(at(x), at(y), at(z));
    if (nx >= 0 && ny >= 0 && nz >= 0) normals_.emplace_back(at(nx), at(ny), at(nz));
  }

  /// The vertices may come later.
  std::uint32_t readIndex(const PlyProperty& property) {
    const double index = numbers_.next(property.type);
    if (!(index >= 0 && index <= 4294967295.0 && index == std::floor(index)))
      throw Error("found vertex " + numberText(index) + ", expected a whole number, 0 or more");
    return std::uint32_t(index);
  }

  void readFace(const PlyProperty& property) {
    const std::uint64_t count = listLength(property);
    if (count < 3 || count > maxCorners)
      throw Error("found " + std::to_string(count) + " corners, expected 3 to " + std::to_string(maxCorners));
    for (std::uint64_t i = 0; i < count; ++i) corners_.push_back(readIndex(property));
    endFace(count - 2);
  }

  /// A triangle for each vertex after the first two of a strip, every other one turned.
  void readStrips(const PlyProperty& property) {
    std::array<std::uint32_t, 2> last{};
    std::size_t length = 0;
    for (std::uint64_t left = listLength(property); left > 0; --left) {
      const double index = numbers_.next(property.type);
      if (index == -1) {
        length = 0;
        continue;
      }
      if (!(index >= 0 && index <= 4294967295.0 && index == std::floor(index)))
        throw Error("found vertex " + numberText(index) + ", expected a whole number, or -1 at the end of a strip");
      const auto vertex = std::uint32_t(index);
      if (length >= 2) {
        const bool isTurned = length % 2 == 1;
        corners_.insert(corners_.end(), {last[isTurned ? 1 : 0], last[isTurned ? 0 : 1], vertex});
        endFace(1);
      }
      last = {last[1], vertex};
      ++length;
    }
  }

  void endFace(std::uint64_t triangles) {
    triangles_ += triangles;
    if (triangles_ > maxPlyTriangles)
      throw Error("found more than " + std::to_string(maxPlyTriangles) + " triangles, the maximum");
    faceEnds_.push_back(corners_.size());
  }

  geometry::MeshArrays arrays() {
    geometry::MeshArrays arrays;
    arrays.positions = localPositions(positions_, origin_);
    std::size_t begin = 0;
    std::vector<glm::vec3> places;
    for (std::size_t face = 0; face < faceEnds_.size(); begin = faceEnds_[face++]) {
      const std::span corners = std::span(corners_).subspan(begin, faceEnds_[face] - begin);
      places.clear();
      for (const std::uint32_t corner : corners) {
        if (corner >= positions_.size())
          throw Error("face " + std::to_string(face) + ": found vertex " + std::to_string(corner) +
                      ", but there are only " + std::to_string(positions_.size()) + ", counted from 0");
        places.push_back(arrays.positions[corner]);
      }
      for (const geometry::TriangleIndices& triangle : geometry::triangulatePolygon(places))
        arrays.triangles.push_back({corners[triangle[0]], corners[triangle[1]], corners[triangle[2]]});
    }
    if (!normals_.empty())
      for (const geometry::TriangleIndices& triangle : arrays.triangles)
        for (int c = 0; c < 3; ++c) arrays.normals.push_back(normals_[triangle[c]]);
    return arrays;
  }

  PlyHeader header_;
  PlyNumbers numbers_;
  std::vector<glm::dvec3> positions_;
  glm::dvec3 origin_{0};
  std::vector<glm::vec3> normals_;
  std::vector<std::uint32_t> corners_;  ///< of all faces, one after another
  std::vector<std::size_t> faceEnds_;
  std::uint64_t triangles_ = 0;
};

}  // namespace

MeshFile readPly(const ByteSource& source) {
  const std::vector<std::byte> bytes = source.readAll(maxPlyBytes);
  return PlyReader(withoutByteOrderMark({reinterpret_cast<const char*>(bytes.data()), bytes.size()})).read();
}

std::vector<std::byte> encodePly(const geometry::TriangleMesh& mesh) {
  using Corner = std::tuple<std::uint32_t, float, float, float>;
  std::map<Corner, std::int32_t> indices;
  std::vector<std::byte> vertices, faces;
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    append(faces, std::uint8_t(3));
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t position = mesh.triangles()[i][k];
      const glm::vec3 normal = mesh.cornerNormals()[3 * i + std::size_t(k)];
      const auto [at, added] =
          indices.try_emplace({position, normal.x, normal.y, normal.z}, std::int32_t(indices.size()));
      if (added) {
        append(vertices, mesh.positions()[position]);
        append(vertices, normal);
      }
      append(faces, at->second);
    }
  }
  std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(indices.size());
  for (const char* property : {"x", "y", "z", "nx", "ny", "nz"}) header += std::string("\nproperty float ") + property;
  header += "\nelement face " + std::to_string(mesh.triangles().size()) +
            "\nproperty list uchar int vertex_indices\nend_header\n";
  std::vector<std::byte> bytes(header.size());
  std::memcpy(bytes.data(), header.data(), header.size());
  bytes.insert(bytes.end(), vertices.begin(), vertices.end());
  bytes.insert(bytes.end(), faces.begin(), faces.end());
  return bytes;
}

}  // namespace gonio::io
