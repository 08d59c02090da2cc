// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>
#include <initializer_list>
#include <random>
#include <span>
#include <string>

#include "core/brdf/utia_brdf.h"
#include "core/io/image_io.h"
#include "core/materials/material.h"
#include "core/support/text.h"
#include "tests/core/io/test_files.h"
#include "tests/support/random_directions.h"

/// Files of measuring instruments as tests write them: of closed forms, never of anybody's data.
namespace gonio::test {

using Reflectance = std::function<Rgb(const Direction& wi, const Direction& wo)>;

inline Bytes bytesOf(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

/// What a reader says of a text that it refuses; "" if it reads it.
template <typename Reader>
std::string refusal(Reader reader, const std::string& text) {
  return errorOf([&] { reader(text); });
}
#define VERIFY_REFUSED(reader, text, part) \
  QVERIFY2(contains(refusal(reader, text), part), refusal(reader, text).c_str())

/// A material of any format that tells itself by its content.
inline materials::Material materialOfText(const std::string& text) {
  return materials::readMaterial(io::MemorySource(bytesOf(text)));
}

/// The text with the first occurrence of a part replaced. @throws std::out_of_range if it has none.
inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

/// A direction of the UTIA grid, from 0 to 287.
inline Direction utiaDirection(std::size_t index) {
  return fromSpherical(double(index / UtiaBrdf::azimuthCount) * UtiaBrdf::polarStep,
                       double(index % UtiaBrdf::azimuthCount) * UtiaBrdf::azimuthStep);
}

/// [incident][viewing].
inline std::vector<Rgb> utiaValues(const Reflectance& reflectance) {
  std::vector<Rgb> values;
  for (std::size_t i = 0; i < UtiaBrdf::directionCount; ++i)
    for (std::size_t v = 0; v < UtiaBrdf::directionCount; ++v)
      values.push_back(reflectance(utiaDirection(i), utiaDirection(v)));
  return values;
}

/// A UTIA `.bin` file.
inline Bytes utiaFile(const std::vector<Rgb>& values) {
  Bytes bytes;
  bytes.reserve(values.size() * 24);
  for (int channel = 0; channel < 3; ++channel)
    for (const Rgb& value : values) append(bytes, value[channel]);
  return bytes;
}

/// A UTIA `.exr` file.
inline Bytes utiaPicture(const std::vector<Rgb>& values) {
  constexpr int side = UtiaBrdf::directionCount;
  Image image(side, side);
  for (std::size_t i = 0; i < values.size(); ++i) image.pixels[i] = values[i];
  const auto path = outputPath("io/utia.exr");
  io::writeExr(image, path);
  return readFile(path);
}

/// Numbers of a row, so that they are read back as they are.
inline std::string rowText(std::initializer_list<double> numbers, const char* separator) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : separator) + numberText(number);
  return text + "\n";
}

/// An ASTM E1392 file of R, G and B at pairs of directions; angles times `unit` are radians. The file states radians.
inline Bytes astmFile(const Reflectance& reflectance, const std::vector<DirectionPair>& pairs, double unit = 1) {
  std::string text = "FILE_FORMAT ASTM E1392\nSAMPLE closed form\nNUM_POINTS " + std::to_string(pairs.size()) +
                     "\nVARS theta_i" + (unit == 1 ? " [rad]" : "") + ",phi_i,theta_s,phi_s,R,G,B\n";
  for (const auto& [wi, wo] : pairs) {
    const Rgb value = reflectance(wi, wo);
    text += rowText({polarAngle(wi) / unit, azimuth(wi) / unit, polarAngle(wo) / unit, azimuth(wo) / unit, value.x,
                     value.y, value.z},
                    ",");
  }
  return bytesOf(text);
}

/// A pgII file of one light and some viewers, grey.
inline Bytes goniophotometerFile(const Reflectance& reflectance, const Direction& light,
                                 const std::vector<Direction>& viewers) {
  std::string text = "#sample_name \"closed form\"\n#format: theta phi BSDF\n#intheta " +
                     numberText(degrees(polarAngle(light))) + "\n#inphi " + numberText(degrees(azimuth(light))) + "\n";
  for (const Direction& viewer : viewers)
    text += rowText({degrees(polarAngle(viewer)), degrees(azimuth(viewer)), reflectance(light, viewer).y}, " ");
  return bytesOf(text);
}

/// A sample of CUReT with its directions in degrees: the first 205 pairs.
inline Bytes curetFile(const Reflectance& reflectance, const std::vector<DirectionPair>& pairs) {
  std::string text = "# closed form\n";
  for (std::size_t i = 0; i < 205; ++i) {
    const auto& [wi, wo] = pairs[i];
    const Rgb value = reflectance(wi, wo);
    text += rowText({degrees(polarAngle(wo)), degrees(azimuth(wo)), degrees(polarAngle(wi)), degrees(azimuth(wi)),
                     value.x, value.y, value.z},
                    " ");
  }
  return bytesOf(text);
}

/// "ScatterRadial 2\n0 10\n".
inline std::string anglesText(const char* key, const std::vector<double>& angles) {
  std::string text = std::string(key) + " " + std::to_string(angles.size()) + "\n";
  for (const double angle : angles) text += numberText(angle) + "\t";
  return text + "\n";
}

/// What the files of optical design programs hold: angles of incidence, azimuths and radial angles, degrees.
struct ScatterAngles {
  std::vector<double> incident, azimuths, radials;
};

/// A Zemax BSDF file, symmetric about the plane of incidence. The light stands at azimuth pi, its mirror direction at
/// 0.
inline Bytes zemaxFile(const Reflectance& reflectance, const ScatterAngles& angles) {
  std::string text =
      "# closed form\nSource  Measured\nSymmetry  PlaneSymmetrical\nSpectralContent  Monochrome\n"
      "ScatterType  BRDF\nSampleRotation  1\n0\n" +
      anglesText("AngleOfIncidence", angles.incident) + anglesText("ScatterAzimuth", angles.azimuths) +
      anglesText("ScatterRadial", angles.radials) + "\nMonochrome\nDataBegin\n";
  for (const double incident : angles.incident) {
    text += "TIS 0.5\n";
    const double theta = radians(incident);
    for (const double azimuth : angles.azimuths) {
      for (const double radial : angles.radials) {
        // Azimuth 0 leads from the mirror direction to the normal: toward smaller x.
        const Direction up = fromSpherical(radians(radial), radians(azimuth));
        const Direction wo(std::sin(theta) * up.z - std::cos(theta) * up.x, up.y,
                           std::cos(theta) * up.z + std::sin(theta) * up.x);
        text += numberText(wo.z < 0 ? 0.0 : reflectance(fromSpherical(theta, pi), wo).x) + "\t";
      }
      text += "\n";
    }
  }
  return bytesOf(text + "DataEnd\n");
}

/// A LightTools BSDF file of the front's reflection; the light stands at azimuth 90 degrees.
inline Bytes lightToolsFile(const Reflectance& reflectance, const ScatterAngles& angles) {
  std::string text = "# closed form\nSymmetry Asymmetric\nSpectralContent Monochrome\n" +
                     anglesText("ScatterAzimuth", angles.azimuths) + anglesText("ScatterRadial", angles.radials) +
                     "DataBegin\n";
  for (const double incident : angles.incident) {
    text += "AOI " + numberText(incident) + "\nPOI 0\nSide Front\nWavelength 550\nScatterType BRDF\nTIS 0.5\n";
    const Direction wi = fromSpherical(radians(incident), halfPi);
    for (const double azimuth : angles.azimuths) {
      for (const double radial : angles.radials)
        text += numberText(reflectance(wi, fromSpherical(radians(radial), radians(azimuth))).x) + " ";
      text += "\n";
    }
  }
  return bytesOf(text + "DataEnd\n");
}

/// Pairs of directions up to 75 degrees from the normal, the same in every run.
inline std::vector<DirectionPair> scatteredPairs(std::size_t count) {
  std::mt19937_64 random(7);
  std::vector<DirectionPair> pairs;
  while (pairs.size() < count)
    if (const DirectionPair pair{randomUpper(random), randomUpper(random)}; pair.wi.z > 0.26 && pair.wo.z > 0.26)
      pairs.push_back(pair);
  return pairs;
}

}  // namespace gonio::test
