// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <pugixml.hpp>
#include <set>

#include "core/formats/formats.h"
#include "core/io/byte_source.h"
#include "core/io/text_lines.h"
#include "core/math/colour.h"
#include "core/math/fast_functions.h"
#include "core/support/text.h"

/// BSDF files of Radiance and WINDOW (LBNL), `.xml`: matrices over the patches of a Klems basis (full, half or quarter:
/// 145, 73 or 41 patches; Klems 1994, "A New Method for Predicting the Solar Heat Gain of Complex Fenestration
/// Systems"). The layer's WavelengthData hold one block for each side, reflection and transmission:
///
///     <WindowElement><Optical><Layer>
///       <DataDefinition><IncidentDataStructure>Columns</IncidentDataStructure></DataDefinition>
///       <WavelengthData><Wavelength unit="Integral">Visible</Wavelength><WavelengthDataBlock>
///         <WavelengthDataDirection>Reflection Front</WavelengthDataDirection>
///         <ColumnAngleBasis>LBNL/Klems Full</ColumnAngleBasis><RowAngleBasis>LBNL/Klems Full</RowAngleBasis>
///         <ScatteringData>0.1, 0.1, ..</ScatteringData>
///
/// A matrix has a row for each outgoing patch and a column for each incident one (IncidentDataStructure Columns; with
/// Rows it is transposed): BRDF in 1/sr, without the cosine. Patches are numbered by polar angle, then by azimuth, the
/// first one about azimuth 0. The azimuth of an incident patch is that of the travelling light, so that the light
/// stands opposite (as Radiance reads it): patch i is mirrored into patch i. Values are constant in a patch. The
/// visible block is grey; with CIE-X and CIE-Z it is a colour, whose white is that of equal energy. Reflection Front is
/// read, or Reflection Back if there is no other; transmission is left out.
///
/// With IncidentDataStructure TensorTree3 or TensorTree4 (Ward, Kurt and Bonneel 2012, "A Practical Framework for
/// Sharing and Rendering Real-World Bidirectional Scattering Distribution Functions"), ScatteringData is a tree over a
/// cube of 3 or 4 coordinates: braces with 8 or 16 subtrees, one for each half of each coordinate (the lowest bit is
/// the first coordinate), or with the values of a grid of 1, 2, 4, .. cells per side (the last coordinate runs
/// fastest). Directions are projected to the unit disk, which the concentric map of Shirley and Chiu takes to a square.
/// Four coordinates: those of the travelling light, then those of the viewer. Three: 1/2 - sin(theta_i) / 2, then those
/// of the viewer turned so that the light travels along x; isotropic. Values are constant in a cell and grey.
namespace gonio::formats {

using materials::Material;

namespace {

const std::string expectedRadiance = "XML with the element WindowElement (Radiance BSDF)";

/// Patches of the hemisphere: bands of polar angle, each divided evenly by azimuth.
struct KlemsBasis {
  struct Band {
    double begin;  ///< polar angle, degrees
    std::size_t azimuths;
  };
  std::string_view name;
  std::span<const Band> bands;

  std::size_t size() const {
    std::size_t count = 0;
    for (const Band& band : bands) count += band.azimuths;
    return count;
  }
  /// The patch of a direction above the horizon. @param turn added to its azimuth, rad.
  std::size_t patch(const Direction& w, double turn) const {
    const double theta = degrees(polarAngle(w));
    std::size_t first = 0, band = 0;
    for (; band + 1 < bands.size() && theta >= bands[band + 1].begin; ++band) first += bands[band].azimuths;
    const double count = double(bands[band].azimuths);
    // The first patch lies on both sides of azimuth 0.
    const double position = (azimuth(w) + turn) / (2 * pi) * count + 0.5;
    return first + std::size_t(position - count * std::floor(position / count)) % bands[band].azimuths;
  }
};

constexpr KlemsBasis::Band fullBands[] = {{0, 1},   {5, 8},   {15, 16}, {25, 20}, {35, 24},
                                          {45, 24}, {55, 24}, {65, 16}, {75, 12}},
                           halfBands[] = {{0, 1}, {6.5, 8}, {19.5, 12}, {32.5, 16}, {46.5, 20}, {61.5, 12}, {76.5, 4}},
                           quarterBands[] = {{0, 1}, {9, 8}, {27, 12}, {46, 12}, {66, 8}};
constexpr KlemsBasis klemsBases[] = {
    {"LBNL/Klems Full", fullBands}, {"LBNL/Klems Half", halfBands}, {"LBNL/Klems Quarter", quarterBands}};

/// A matrix of BRDF values over patches. Anisotropic, not reciprocal. About 0.1 us per pair.
class KlemsBrdf final : public Brdf {
 public:
  /// @param values [outgoing][incident], finite, 0 or more.
  KlemsBrdf(const KlemsBasis& incident, const KlemsBasis& outgoing, std::vector<glm::vec3> values)
      : incident_(incident), outgoing_(outgoing), incidentCount_(incident.size()), values_(std::move(values)) {}

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto& [wi, wo] = pairs[i];
      values[i] = isBelowHorizon(wi) || isBelowHorizon(wo)
                      ? Rgb(0)
                      : Rgb(values_[outgoing_.patch(wo, 0) * incidentCount_ + incident_.patch(wi, pi)]);
    }
  }
  bool isIsotropic() const override { return false; }
  bool isReciprocal() const override { return false; }

 private:
  const KlemsBasis &incident_, &outgoing_;
  std::size_t incidentCount_;
  std::vector<glm::vec3> values_;
};

/// The unit square of a point of the unit disk (Shirley and Chiu 1997, "A Low Distortion Map Between Disk and Square").
glm::dvec2 squareOf(double x, double y) {
  const double radius = std::min(std::sqrt(x * x + y * y), 1.0);
  double phi = fastAtan2(y, x);
  if (phi < -pi / 4) phi += 2 * pi;
  const auto quarter = std::min<std::size_t>(std::size_t((phi + pi / 4) / (pi / 2)), 3);
  const double across = (phi - double(quarter) * pi / 2) * radius / (pi / 4);
  const double sign = quarter < 2 ? 1 : -1;
  const glm::dvec2 point =
      quarter % 2 == 0 ? glm::dvec2(sign * radius, sign * across) : glm::dvec2(-sign * across, sign * radius);
  return (point + 1.0) / 2.0;
}

/// A tree of values over a cube. The children and the values of a node are stored one after the other.
struct TensorTree {
  struct Node {
    bool isBranch = false;
    std::size_t first = 0;  ///< child or value
    std::size_t cells = 1;  ///< per side, of a leaf
  };
  std::size_t rank = 4;
  std::vector<Node> nodes;  ///< the root first
  std::vector<float> values;

  float at(std::array<double, 4> position) const {
    for (double& coordinate : position) coordinate = std::clamp(coordinate, 0.0, std::nextafter(1.0, 0.0));
    const Node* node = &nodes[0];
    while (node->isBranch) {
      std::size_t child = 0;
      for (std::size_t i = 0; i < rank; ++i) {
        position[i] *= 2;
        if (position[i] < 1) continue;
        position[i] -= 1;
        child |= std::size_t(1) << i;
      }
      node = &nodes[node->first + child];
    }
    std::size_t cell = 0;
    for (std::size_t i = 0; i < rank; ++i) cell = cell * node->cells + std::size_t(position[i] * double(node->cells));
    return values[node->first + cell];
  }
};

/// Reads the braces of a tree.
class TensorTreeReader {
 public:
  /// @throws Error that states the place in the text.
  static TensorTree read(std::string_view text, std::size_t rank) {
    TensorTreeReader reader(text, rank);
    reader.tree_.nodes.emplace_back();
    reader.readNode(0, 0);
    if (!reader.next().empty()) reader.fail("the end of the data");
    return std::move(reader.tree_);
  }

 private:
  TensorTreeReader(std::string_view text, std::size_t rank) : text_(text) { tree_.rank = rank; }

  /// The next brace or number without taking it; empty at the end.
  std::string_view next() {
    position_ = std::min(text_.find_first_not_of(" \t\r\n,", position_), text_.size());
    const std::string_view rest = text_.substr(position_);
    if (rest.starts_with('{') || rest.starts_with('}')) return rest.substr(0, 1);
    return rest.substr(0, std::min(rest.find_first_of(" \t\r\n,{}"), rest.size()));
  }
  [[noreturn]] void fail(const std::string& expected) {
    const std::string_view found = next();
    throw Error("byte " + std::to_string(position_) + " of the tree: found " +
                (found.empty() ? "its end" : "'" + std::string(found.substr(0, 40)) + "'") + ", expected " + expected);
  }
  void take(std::string_view brace) {
    if (next() != brace) fail("'" + std::string(brace) + "'");
    position_ += brace.size();
  }

  void readNode(std::size_t node, std::size_t depth) {
    constexpr std::size_t maxDepth = 32;
    if (depth > maxDepth) fail("at most " + std::to_string(maxDepth) + " levels");
    take("{");
    if (next() == "{")
      readChildren(node, depth);
    else
      readValues(node);
    take("}");
  }
  void readChildren(std::size_t node, std::size_t depth) {
    const std::size_t first = tree_.nodes.size(), count = std::size_t(1) << tree_.rank;
    tree_.nodes.resize(first + count);
    tree_.nodes[node] = {.isBranch = true, .first = first};
    for (std::size_t child = 0; child < count; ++child) readNode(first + child, depth + 1);
  }
  void readValues(std::size_t node) {
    const std::size_t first = tree_.values.size();
    while (next() != "}") {
      const auto value = io::finiteNumber(next());
      if (!value || !std::isfinite(float(*value))) fail("a finite number or a brace");
      tree_.values.push_back(float(*value));
      position_ += next().size();
    }
    const auto sizeOf = [&](std::size_t side) {
      std::size_t size = 1;
      for (std::size_t i = 0; i < tree_.rank; ++i) size *= side;
      return size;
    };
    const std::size_t count = tree_.values.size() - first;
    std::size_t cells = 1;
    while (sizeOf(cells) < count) cells *= 2;
    if (sizeOf(cells) != count)
      fail("1, " + std::to_string(sizeOf(2)) + ", " + std::to_string(sizeOf(4)) + ", .. values before it, not " +
           std::to_string(count));
    tree_.nodes[node] = {.isBranch = false, .first = first, .cells = cells};
  }

  std::string_view text_;
  std::size_t position_ = 0;
  TensorTree tree_;
};

/// Grey values of a tree; isotropic with three coordinates. Not reciprocal. About 0.1 us per pair.
class TensorTreeBrdf final : public Brdf {
 public:
  /// @param tree values finite, 0 or more.
  explicit TensorTreeBrdf(TensorTree tree) : tree_(std::move(tree)) {}

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    for (std::size_t i = 0; i < pairs.size(); ++i)
      values[i] = isBelowHorizon(pairs[i].wi) || isBelowHorizon(pairs[i].wo) ? Rgb(0) : Rgb(value(pairs[i]));
  }
  bool isIsotropic() const override { return tree_.rank == 3; }
  bool isReciprocal() const override { return false; }

 private:
  double value(const DirectionPair& pair) const {
    const auto& [wi, wo] = pair;
    if (tree_.rank == 3) {
      const Direction turned = AzimuthRotation::toZero({-wi.x, -wi.y, wi.z})(wo);
      const glm::dvec2 outgoing = squareOf(turned.x, turned.y);
      // The light at the normal belongs to the lower half, as in Radiance.
      const double incident = std::nextafter(0.5, 0.0) - 0.5 * std::sqrt(wi.x * wi.x + wi.y * wi.y);
      return tree_.at({incident, outgoing.x, outgoing.y, 0});
    }
    const glm::dvec2 incident = squareOf(-wi.x, -wi.y), outgoing = squareOf(wo.x, wo.y);
    return tree_.at({incident.x, incident.y, outgoing.x, outgoing.y});
  }

  TensorTree tree_;
};

std::string textOf(const pugi::xml_node& parent, const char* name) {
  const std::string text = parent.child(name).text().get();
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r\n") + 1 - begin);
}

/// One matrix as the file has it.
struct KlemsMatrix {
  const KlemsBasis *incident = nullptr, *outgoing = nullptr;
  std::vector<double> values;  ///< [outgoing][incident]
};

const KlemsBasis& basisOf(const pugi::xml_node& block, const char* key) {
  const std::string name = textOf(block, key);
  for (const KlemsBasis& basis : klemsBases)
    if (lowerCase(name) == lowerCase(std::string(basis.name))) return basis;
  throw Error("found the " + std::string(key) + " '" + name +
              "', expected LBNL/Klems Full, LBNL/Klems Half or LBNL/Klems Quarter");
}

KlemsMatrix matrixOf(const pugi::xml_node& block, bool isTransposed, const std::string& what) {
  KlemsMatrix matrix{&basisOf(block, "ColumnAngleBasis"), &basisOf(block, "RowAngleBasis"), {}};
  std::string text = block.child("ScatteringData").text().get();
  std::ranges::replace_if(
      text, [](char c) { return c == '\r' || c == '\n' || c == ','; }, ' ');
  for (const std::string_view word : io::words(text)) {
    const auto value = io::finiteNumber(word);
    if (!value)
      throw Error("found '" + std::string(word.substr(0, 40)) + "' as value " +
                  std::to_string(matrix.values.size() + 1) + " of " + what + ", expected a finite number");
    matrix.values.push_back(*value);
  }
  const std::size_t incidents = matrix.incident->size(), outgoings = matrix.outgoing->size();
  if (matrix.values.size() != incidents * outgoings)
    throw Error("found " + std::to_string(matrix.values.size()) + " values of " + what + ", expected " +
                std::to_string(outgoings) + " x " + std::to_string(incidents) + " for " +
                std::string(matrix.outgoing->name) + " by " + std::string(matrix.incident->name));
  if (!isTransposed) return matrix;
  std::vector<double> transposed(matrix.values.size());
  for (std::size_t i = 0; i < incidents; ++i)
    for (std::size_t o = 0; o < outgoings; ++o) transposed[o * incidents + i] = matrix.values[i * outgoings + o];
  matrix.values = std::move(transposed);
  return matrix;
}

/// The reflection blocks of a side by their wavelength, in lower case; and what was left out.
struct RadianceBlocks {
  std::map<std::string, pugi::xml_node> front, back;
  std::set<std::string> leftOut;
};

RadianceBlocks blocksOf(const pugi::xml_node& layer) {
  RadianceBlocks blocks;
  for (const pugi::xml_node& data : layer.children("WavelengthData"))
    for (const pugi::xml_node& block : data.children("WavelengthDataBlock")) {
      const std::string wavelength = lowerCase(textOf(data, "Wavelength")),
                        side = textOf(block, "WavelengthDataDirection");
      const std::string name = lowerCase(side);
      if (name != "reflection front" && name != "reflection back") {
        blocks.leftOut.insert(side);
        continue;
      }
      auto& found = name == "reflection front" ? blocks.front : blocks.back;
      if (!found.emplace(wavelength, block).second)
        throw Error("found two blocks '" + side + "' for the wavelength '" + wavelength + "', expected one");
    }
  return blocks;
}

/// The name of the block that is read as luminance. @throws Error that lists the wavelengths if none of several is.
std::string luminanceOf(const std::map<std::string, pugi::xml_node>& blocks) {
  for (const char* name : {"visible", "cie-y"})
    if (blocks.contains(name)) return name;
  if (blocks.size() == 1) return blocks.begin()->first;
  std::string list;
  for (const auto& [name, block] : blocks) list += (list.empty() ? "'" : ", '") + name + "'";
  throw Error("found reflection for the wavelengths " + list + ", expected Visible");
}

/// Linear sRGB; X, Y and Z of a neutral value are equal.
Rgb colourOf(double x, double y, double z) {
  static const glm::dvec3 white{0.95047, 1, 1.08883};  // of D65
  return linearSrgb(glm::dvec3(x, y, z) * white);
}

void sniffRadiance(const io::ByteSource& source) {
  const std::string head = io::textHead(source, expectedRadiance);
  if (head.find("<WindowElement") == std::string::npos)
    throw io::FormatMismatch("a file of another format", expectedRadiance);
}

/// What was read, with its notes.
struct RadianceData {
  std::shared_ptr<const Brdf> brdf;
  std::vector<int> grid;
  std::string text;            ///< basis and colour, for the note
  std::set<std::string> used;  ///< wavelengths
  std::size_t negatives = 0;
};

/// @param isTransposed whether rows are incident patches.
RadianceData klemsData(const std::map<std::string, pugi::xml_node>& side, bool isTransposed) {
  RadianceData data;
  const auto read = [&](const std::string& wavelength) {
    data.used.insert(wavelength);
    return matrixOf(side.at(wavelength), isTransposed, "the block '" + wavelength + "'");
  };
  const std::string luminance = luminanceOf(side);
  const KlemsMatrix y = read(luminance);
  const bool isColour = side.contains("cie-x") && side.contains("cie-z");
  const KlemsMatrix x = isColour ? read("cie-x") : y, z = isColour ? read("cie-z") : y;
  for (const KlemsMatrix* other : {&x, &z})
    if (other->incident != y.incident || other->outgoing != y.outgoing)
      throw Error("found CIE-X, CIE-Z and '" + luminance + "' over different patches, expected the same");
  std::vector<glm::vec3> values;
  for (std::size_t i = 0; i < y.values.size(); ++i) {
    const Rgb colour = isColour ? colourOf(x.values[i], y.values[i], z.values[i]) : Rgb(y.values[i]);
    for (int channel = 0; channel < 3; ++channel) data.negatives += colour[channel] < 0;
    values.emplace_back(glm::max(colour, Rgb(0)));
    if (!std::isfinite(values.back().x + values.back().y + values.back().z))
      throw Error("found the value " + numberText(y.values[i]) + ", expected BRDF values");
  }
  data.grid = {int(y.incident->size()), int(y.outgoing->size())};
  data.text = std::string(y.incident->name) + ", constant in each patch; '" + luminance + "' " +
              (isColour ? "with CIE-X and CIE-Z (equal-energy white)" : "as grey");
  data.brdf = std::make_shared<const KlemsBrdf>(*y.incident, *y.outgoing, std::move(values));
  return data;
}

RadianceData treeData(const std::map<std::string, pugi::xml_node>& side, std::size_t rank) {
  RadianceData data;
  const std::string luminance = luminanceOf(side);
  const pugi::xml_node& block = side.at(luminance);
  if (const std::string basis = textOf(block, "AngleBasis"); lowerCase(basis) != "lbnl/shirley-chiu")
    throw Error("found the AngleBasis '" + basis + "', expected LBNL/Shirley-Chiu");
  TensorTree tree = TensorTreeReader::read(block.child("ScatteringData").text().get(), rank);
  for (float& value : tree.values) {
    data.negatives += value < 0;
    value = std::max(value, 0.0f);
  }
  data.used.insert(luminance);
  data.grid = {int(tree.values.size())};
  data.text = "TensorTree" + std::to_string(rank) + " of " + std::to_string(tree.values.size()) +
              " cells, constant in each; '" + luminance + "' as grey";
  data.brdf = std::make_shared<const TensorTreeBrdf>(std::move(tree));
  return data;
}

/// @throws Error that states the line of a fault of the XML, or names the block and what was expected of it.
void readRadiance(const io::ByteSource& source, const TaskControl& control, Material& material) {
  control.throwIfStopped();
  const std::string text = io::allText(source);
  pugi::xml_document document;
  if (const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size()); !result) {
    const auto end = text.begin() + std::ptrdiff_t(std::min<std::size_t>(std::size_t(result.offset), text.size()));
    throw Error("line " + std::to_string(1 + std::count(text.begin(), end, '\n')) + ": found text that is not XML (" +
                result.description() + ")");
  }
  const pugi::xml_node layer = document.child("WindowElement").child("Optical").child("Layer");
  const std::string structure = textOf(layer.child("DataDefinition"), "IncidentDataStructure");
  const RadianceBlocks blocks = blocksOf(layer);
  const bool isFront = !blocks.front.empty();
  const auto& side = isFront ? blocks.front : blocks.back;
  if (side.empty()) throw io::FormatMismatch("no block of reflection", "a WavelengthDataBlock with Reflection Front");
  const bool isRows = structure == "Rows", isTree3 = structure == "TensorTree3", isTree4 = structure == "TensorTree4";
  if (structure != "Columns" && !isRows && !isTree3 && !isTree4)
    throw Error("found the IncidentDataStructure '" + structure +
                "', expected Columns, Rows, TensorTree3 or TensorTree4");
  const RadianceData data = isTree3 || isTree4 ? treeData(side, isTree3 ? 3 : 4) : klemsData(side, isRows);
  material.source.grid = data.grid;
  material.source.description = textOf(layer.child("Material"), "Name");
  std::vector<std::string>& notes = material.source.notes;
  notes.push_back("read as: Reflection " + std::string(isFront ? "Front" : "Back") + ", BRDF in 1/sr; " + data.text);
  if (isFront && !blocks.back.empty()) notes.push_back("Reflection Back was left out");
  for (const std::string& name : blocks.leftOut) notes.push_back("'" + name + "' was left out");
  for (const auto& [wavelength, block] : side)
    if (!data.used.contains(wavelength)) notes.push_back("the wavelength '" + wavelength + "' was left out");
  if (data.negatives > 0) notes.push_back(std::to_string(data.negatives) + " negative values were set to 0");
  material.brdf = data.brdf;
}

constexpr std::string_view radianceSuffixes[] = {".xml"};

}  // namespace

constinit const MaterialFormat radianceFormat{.name = "Radiance",
                                              .label = "Radiance BSDF",
                                              .suffixes = radianceSuffixes,
                                              .isSuffixAmbiguous = true,
                                              .holds = {.nonReciprocal = true, .anisotropic = true},
                                              .sniff = sniffRadiance,
                                              .read = readRadiance};

}  // namespace gonio::formats
