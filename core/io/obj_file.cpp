// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/mesh_file.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "core/geometry/polygon.h"
#include "core/io/text_lines.h"
#include "core/support/error.h"

namespace gonio::io {

namespace {

constexpr std::uint64_t maxObjBytes = std::uint64_t(1) << 31;
constexpr std::size_t maxTriangles = 100'000'000;

/// A piece of the file for an error's text: no control characters, no more than a few words.
std::string quoted(std::string_view text) {
  std::string result = "'";
  for (const char c : text.substr(0, 40)) result += c >= ' ' && c < 127 ? c : '?';
  return result + (text.size() > 40 ? "...'" : "'");
}

/// Takes words off the front of a line.
class Words {
 public:
  explicit Words(std::string_view line) : left_(line.substr(0, line.find('#'))) {}

  /// Empty at the end of the line.
  std::string_view next() {
    constexpr std::string_view blank = " \t\r\v\f";
    const std::size_t begin = std::min(left_.find_first_not_of(blank), left_.size());
    const std::size_t end = std::min(left_.find_first_of(blank, begin), left_.size());
    const std::string_view word = left_.substr(begin, end - begin);
    left_.remove_prefix(end);
    return word;
  }

 private:
  std::string_view left_;
};

/// Calls work(keyword, words) for each line; an Error of it is thrown again with the line's number. Lines end with LF,
/// CR LF or CR; a backslash at the end continues a line.
template <typename Work>
void forEachLine(std::string_view text, const TaskControl& control, Work work) {
  std::string joined;
  std::size_t number = 0, first = 1;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    begin = end + (text.substr(end).starts_with("\r\n") ? 2 : 1);
    if (++number % 4096 == 0) {
      control.throwIfStopped();
      control.report(double(std::min(begin, text.size())) / double(text.size()));
    }
    if (joined.empty()) first = number;
    if (line.ends_with('\\') && begin < text.size()) {
      joined.append(line.substr(0, line.size() - 1)) += ' ';
      continue;
    }
    if (!joined.empty()) line = joined.append(line);
    try {
      Words words(line);
      const std::string_view keyword = words.next();
      work(keyword, words);
    } catch (const Error& error) {
      throw Error("line " + std::to_string(first) + ": " + error.what());
    }
    joined.clear();
  }
}

/// In double precision, as coordinates of maps need it; NaN and infinity are numbers here.
double number(std::string_view word) {
  std::string_view digits = word;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (end != digits.data() + digits.size() || error == std::errc::invalid_argument)
    throw Error(word.empty() ? "found the end of the line, expected three numbers"
                             : "found " + quoted(word) + ", expected a number");
  // Too small a number is 0 there, too large a one infinite.
  if (error == std::errc::result_out_of_range) value = std::strtod(std::string(digits).c_str(), nullptr);
  return value;
}

double coordinate(std::string_view word) {
  const double value = number(word);
  if (!std::isfinite(static_cast<float>(value)))
    throw Error("found " + quoted(word) + ", expected a finite number in the range of single precision");
  return value;
}

glm::dvec3 position(Words& words) {
  const double x = coordinate(words.next()), y = coordinate(words.next());
  return {x, y, coordinate(words.next())};
}

glm::vec3 normalVector(Words& words) {
  const double x = number(words.next()), y = number(words.next());
  return {x, y, number(words.next())};
}

/// An index counted from 0, which may lie outside; a negative one counts back from the last of the `before` that stand
/// before the face. Empty if it has too many digits. @throws Error if the word is no index.
std::optional<long long> countedFromZero(std::string_view word, std::string_view what, std::size_t before) {
  long long value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::invalid_argument || end != word.data() + word.size())
    throw Error("found " + quoted(word) + ", expected the index of a " + std::string(what));
  if (error == std::errc::result_out_of_range) return std::nullopt;
  return value < 0 ? value + static_cast<long long>(before) : value - 1;
}

/// @throws Error if there is no such vertex.
std::uint32_t vertexIndex(std::string_view word, std::size_t before, std::size_t total) {
  const auto counted = countedFromZero(word, "vertex", before);
  if (!counted || *counted < 0 || *counted >= static_cast<long long>(total))
    throw Error("found vertex " + quoted(word) + ", but there are only " + std::to_string(total) +
                (word.starts_with('-') ? ", " + std::to_string(before) + " before this line" : ", counted from 1"));
  return std::uint32_t(*counted);
}

class Reader {
 public:
  Reader(std::string_view text, const TaskControl& control) : text_(text), control_(control) {}

  MeshFile read() {
    // Faces may name vertices of later lines.
    std::vector<glm::dvec3> positions;
    forEachLine(text_, control_.between(0, 0.3), [&](std::string_view keyword, Words& words) {
      if (keyword == "v") positions.push_back(position(words));
      if (keyword == "vn") normals_.push_back(normalVector(words));
    });
    glm::dvec3 origin;
    arrays_.positions = localPositions(positions, origin);
    forEachLine(text_, control_.between(0.3, 1), [&](std::string_view keyword, Words& words) {
      positionsBefore_ += keyword == "v";
      normalsBefore_ += keyword == "vn";
      if (keyword == "f") addFace(words);
    });
    if (arrays_.triangles.empty())
      throw Error("an OBJ mesh: found no faces (" + std::to_string(arrays_.positions.size()) +
                  " vertices), expected lines such as 'f 1 2 3'");
    if (!anyNormal_) arrays_.normals.clear();
    std::vector<std::string> notes;
    if (missingNormals_ > 0)
      notes.push_back(std::to_string(missingNormals_) +
                      " corners of faces have normals that are missing or not finite; they were computed");
    if (shortFaces_ > 0) notes.push_back(std::to_string(shortFaces_) + " faces of fewer than 3 corners were left out");
    return {geometry::TriangleMesh(std::move(arrays_)), origin, std::move(notes)};
  }

 private:
  struct Corner {
    std::uint32_t position;
    std::optional<std::uint32_t> normal;
  };

  /// Empty if the normal does not exist. @throws Error if the word is not an index.
  std::optional<std::uint32_t> normalIndex(std::string_view word) const {
    const auto counted = countedFromZero(word, "normal", normalsBefore_);
    if (!counted || *counted < 0 || *counted >= static_cast<long long>(normals_.size())) return std::nullopt;
    return std::uint32_t(*counted);
  }

  Corner corner(std::string_view word) {
    const std::size_t slash = std::min(word.find('/'), word.size());
    Corner result{vertexIndex(word.substr(0, slash), positionsBefore_, arrays_.positions.size()), {}};
    const std::size_t second = word.find('/', slash + 1);
    if (slash == word.size() || second == std::string_view::npos || second + 1 == word.size()) return result;
    result.normal = normalIndex(word.substr(second + 1));
    const bool isMissing = !result.normal || !std::isfinite(glm::dot(normals_[*result.normal], glm::vec3(1)));
    missingNormals_ += isMissing;
    if (isMissing) result.normal.reset();
    return result;
  }

  void addFace(Words& words) {
    corners_.clear();
    places_.clear();
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
      corners_.push_back(corner(word));
      places_.push_back(arrays_.positions[corners_.back().position]);
    }
    if (corners_.size() < 3) {
      ++shortFaces_;
      return;
    }
    if (arrays_.triangles.size() + corners_.size() - 2 > maxTriangles)
      throw Error("found more than " + std::to_string(maxTriangles) + " triangles, the maximum");
    for (const geometry::TriangleIndices& triangle : geometry::triangulatePolygon(places_)) {
      geometry::TriangleIndices& added = arrays_.triangles.emplace_back();
      for (int i = 0; i < 3; ++i) {
        const Corner& from = corners_[triangle[i]];
        added[i] = from.position;
        arrays_.normals.push_back(from.normal ? normals_[*from.normal] : glm::vec3(0));
        anyNormal_ = anyNormal_ || from.normal;
      }
    }
  }

  std::string_view text_;
  const TaskControl& control_;
  geometry::MeshArrays arrays_;
  std::vector<glm::vec3> normals_;
  std::size_t positionsBefore_ = 0, normalsBefore_ = 0, missingNormals_ = 0, shortFaces_ = 0;
  bool anyNormal_ = false;
  std::vector<Corner> corners_;    ///< of the face at hand
  std::vector<glm::vec3> places_;  ///< their positions
};

}  // namespace

MeshFile readObj(const ByteSource& source, const TaskControl& control) {
  const std::vector<std::byte> bytes = source.readAll(maxObjBytes);
  const std::string_view text = withoutByteOrderMark({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  return Reader(text, control.between(0, 0.7)).read();
}

MeshFile readObj(const std::filesystem::path& path, const TaskControl& control) {
  return withFileInErrors(path, [&] { return readObj(FileSource(path), control); });
}

}  // namespace gonio::io
