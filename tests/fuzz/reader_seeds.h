// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/formats/code.h"
#include "core/formats/formats.h"
#include "core/formats/neural.h"
#include "core/io/byte_source.h"
#include "core/materials/basis_file.h"
#include "core/materials/encode.h"
#include "tests/core/formats/instrument_files.h"
#include "tests/core/io/synthetic_tensors.h"
#include "tests/support/function_brdf.h"
#include "tests/support/smooth_materials.h"

/// Small valid files of every format, from which mutations start.
namespace gonio::fuzz {

using test::append;
using test::Bytes;
using test::bytesOf;

inline Bytes merlSeed() {
  Bytes bytes;
  for (const std::int32_t count : {2, 3, 4}) append(bytes, count);
  for (int i = 0; i < 72; ++i) append(bytes, i % 11 == 3 ? -1.0 : 10.0 * i);
  return bytes;
}

inline Bytes merlCircleSeed() {
  Bytes bytes;
  for (const std::int32_t count : {2, 3, 12}) append(bytes, count);
  for (int i = 0; i < 216; ++i) append(bytes, i % 11 == 3 ? -1.0 : 10.0 * i);
  return bytes;
}

inline Bytes rglSeed() {
  test::SyntheticRgl rgl;
  for (std::size_t i = 0; i < rgl.rgb.size(); ++i) rgl.rgb[i] = float(i) * 0.1f - 0.3f;
  for (std::size_t i = 0; i < rgl.vndf.size(); ++i) rgl.vndf[i] = float(i % 5);
  return rgl.file();
}

inline Bytes utiaSeed() {
  return test::utiaFile(test::utiaValues(
      [](const Direction& wi, const Direction& wo) { return Rgb(1 + wi.x, wo.y - 0.2, wi.z * wo.z); }));
}

inline Rgb seedReflectance(const Direction& wi, const Direction& wo) { return {0.2, wi.z * wo.z, 0.1 + wo.x * wi.x}; }

inline Bytes astmSeed() { return test::astmFile(seedReflectance, test::scatteredPairs(12)); }

inline Bytes goniophotometerSeed() {
  const Direction light = fromSpherical(0.5, 3);
  return test::goniophotometerFile(seedReflectance, light, {{0, 0, 1}, fromSpherical(0.6, 0.1), fromSpherical(2, 1)});
}

inline Bytes refletSeed() {
  std::string text;
  for (const double light : {10.0, 30.0, 60.0}) {
    text +=
        "Name / Comment :\tseed\t\nDate:\t7/12/2011 11:51:11 PM\t\nData file type :\tIntensity BRDF\t\nTheta sample "
        ":\t0\t\nPhi measure beginning :\t-90\t\nPhi measure end :\t90\t\nPhi measure step :\t45\t\nTheta "
        "Lighting\t" +
        numberText(light) + "\n";
    for (const double theta : {-60.0, -30.0, 0.0, 30.0, 60.0})
      text += test::rowText({theta, 0.1, 0.2, 0.3, 0.2, 0.1}, "\t");
  }
  return bytesOf(text + "\t\t\n");
}

inline Bytes altaSeed() {
  return bytesOf(
      "#ALTA_BEGIN_HEADER\n#DIM 4 3\n#PARAM_IN RUSIN_TH_PH_TD_PD\n#PARAM_OUT INV_STERADIAN_COSINE_FACTOR\n#VS 2 0\n"
      "#ALTA_END_HEADER\n0.1 0.2 0.3 0.4 1 2 3 0.9 1.1\n0.2 0 0.3 2 0.1 0.2 0.3\n");
}

inline Bytes openMaterialSeed() {
  std::string rows;
  for (const double wavelength : {4.5e-7, 5.5e-7, 6.5e-7})
    for (const double thetaI : {0.0, 0.5, 1.0})
      for (const double thetaO : {0.1, 0.5, 1.0})
        for (const double phi : {0.0, 0.7, 1.4, 2.1, 2.8}) {
          std::string row = test::rowText({wavelength, thetaI, thetaO, phi, 0.1}, ",");
          row.pop_back();
          rows += (rows.empty() ? "[" : ",[") + row + "]";
        }
  return bytesOf(R"({"metadata": {"name": "seed"}, "brdf": {"wavelengths": [], "lookupTable": [)" + rows + "]}}");
}

inline Bytes speosSeed() {
  std::string text =
      "OPTIS - Anisotropic BSDF surface file v8.0\n0\nA "
      "comment\n4\nText\n0\t1\t0\n1\t0\n0\n1\n0\n3\n10\t30\t50\n30\t0\n\n"
      "2\n400\t10\n700\t30\n";
  for (int block = 0; block < 3; ++block) {
    text += "4 5\n\t0\t45\t90\t135\t180\n";
    for (const double theta : {0.0, 25.0, 50.0, 75.0}) text += test::rowText({theta, 0.1, 0.2, 0.3, 0.2, 0.1}, "\t");
  }
  return bytesOf(text + "End of file\n");
}

inline Bytes spectralSpeosSeed() {
  std::string text = "OPTIS - brdf surface file v9.0\n0\nA comment\n0\n\n1\t0\n1\n3\t2\n10\t30\t50\n450\t650\n";
  for (int table = 0; table < 6; ++table) {
    text += numberText(5.0 * table) + "\n4 5\n\t0\t45\t90\t135\t180\n";
    for (const double theta : {0.0, 25.0, 50.0, 75.0}) text += test::rowText({theta, 0.1, 0.2, 0.3, 0.2, 0.1}, "\t");
  }
  return bytesOf(text);
}

/// Trees of both ranks: branches, grids, single values.
inline Bytes tensorTreeSeed(int rank) {
  std::string tree = "{";
  for (int child = 0; child < 1 << rank; ++child) {
    tree += "{";
    for (int i = 0; i < (child % 3 == 1 ? 1 << rank : 1); ++i) tree += child % 4 == 2 ? "{0.1}" : ".2, ";
    if (child % 4 == 2 && child % 3 != 1) tree = tree.substr(0, tree.size() - 5) + "-1e-3";
    tree += "}\n";
  }
  return bytesOf("<WindowElement><Optical><Layer><DataDefinition><IncidentDataStructure>TensorTree" +
                 std::to_string(rank) +
                 "</IncidentDataStructure></DataDefinition><WavelengthData><Wavelength>Visible</Wavelength>"
                 "<WavelengthDataBlock><WavelengthDataDirection>Reflection Back</WavelengthDataDirection>"
                 "<AngleBasis>LBNL/Shirley-Chiu</AngleBasis><ScatteringData>" +
                 tree + "}</ScatteringData></WavelengthDataBlock></WavelengthData></Layer></Optical></WindowElement>");
}

/// A quarter basis, in colour.
inline Bytes radianceSeed() {
  std::string values, data;
  for (int i = 0; i < 41 * 41; ++i) values += i % 7 == 3 ? "-.1," : ".2 ";
  for (const char* wavelength : {"Visible", "CIE-X", "CIE-Z"})
    data += std::string("<WavelengthData><Wavelength>") + wavelength +
            "</Wavelength><WavelengthDataBlock><WavelengthDataDirection>Reflection Front</WavelengthDataDirection>"
            "<ColumnAngleBasis>LBNL/Klems Quarter</ColumnAngleBasis><RowAngleBasis>LBNL/Klems Quarter</RowAngleBasis>"
            "<ScatteringData>" +
            values + "</ScatteringData></WavelengthDataBlock></WavelengthData>\n";
  return bytesOf(
      "<?xml version=\"1.0\"?><WindowElement><Optical><Layer><DataDefinition><IncidentDataStructure>Columns"
      "</IncidentDataStructure></DataDefinition>" +
      data + "</Layer></Optical></WindowElement>");
}

/// Zemax with sample rotations.
inline Bytes rotatedZemaxSeed() {
  return bytesOf(
      "Symmetry Asymmetrical4D\nSpectralContent Monochrome\nScatterType BRDF\nSampleRotation 3\n0 90 360\n"
      "AngleOfIncidence 2\n10 60\nScatterAzimuth 3\n0 120 240\nScatterRadial 2\n0 30\nMonochrome\nDataBegin\n"
      "TIS 1\n1 2\n1 3\n1 4\nTIS 1\n1 2\n1 3\n1 4\nTIS 1\n5 2\n5 3\n5 4\nTIS 1\n6 2\n6 3\n6 4\n"
      "TIS 1\n1 2\n1 3\n1 4\nTIS 1\n1 2\n1 3\n1 4\nDataEnd\n");
}

/// Rows of a grid: polar angles of the light and of the viewer, azimuths between them; degrees.
inline std::string csvRows(const std::string& names, const char* separator) {
  std::string text = names + "\n";
  for (const double thetaI : {0.0, 30.0, 60.0})
    for (const double thetaO : {0.0, 25.0, 50.0, 75.0})
      for (const double difference : {0.0, 45.0, 90.0, 135.0, 180.0})
        text += test::rowText({thetaI, thetaO, difference, 0.1 + 0.001 * thetaI + 0.002 * thetaO}, separator);
  return text;
}
inline Bytes csvGridSeed() { return bytesOf(csvRows("# grid\ntheta_i,theta_o,dphi,BRDF", ",")); }

/// With a byte order mark, semicolons, decimal commas and a spectrum.
inline Bytes csvSeed() {
  return bytesOf(
      "\xEF\xBB\xBFindex;theta_i [deg];phi_i;theta_r;phi_r;450nm;550nm;650nm\r\n1;10,5;0;20;180;0,1;0,2;0,3\r\n"
      "2;20;0;0;0;2e-1;3;4\r\n3;30;0;60,25;90;1;2;3\r\n");
}

inline Bytes curetSeed() { return test::curetFile(seedReflectance, test::scatteredPairs(205)); }

inline Bytes zemaxSeed() { return test::zemaxFile(seedReflectance, {{0, 30, 60}, {0, 90, 180}, {0, 10, 40, 90}}); }

inline Bytes lightToolsSeed() {
  return test::lightToolsFile(seedReflectance, {{10, 50}, {0, 90, 180, 270}, {0, 30, 60}});
}

inline Bytes pdvSeed() {
  Bytes bytes = bytesOf("GONIOPDV");
  for (const std::uint32_t number : {1u, 1u, 0u, 3u, 4u, 2u, 2u}) append(bytes, number);
  append(bytes, 20.0f);
  for (const float node : {0.0f, 0.5f, 1.5f, 0.0f, 0.1f, 0.5f, 2.0f, 0.0f, 3.0f}) append(bytes, node);
  for (int i = 0; i < 3 * 2 * 9; ++i) append(bytes, 1.5f - 0.3f * float(i % 7));
  return bytes;
}

/// Three coefficients per channel over a grid of 3 x 4 x 5, in half precision.
inline Bytes codeSeed() {
  dictionary::SparseCode code{.grid = {.thetaHCount = 3, .thetaDCount = 4, .phiDCount = 5},
                              .transform = DataTransform::cosineLog,
                              .channels = {}};
  for (dictionary::ChannelCode& channel : code.channels)
    channel = {.dictionary = 1, .coefficients = {{7, 3.0f}, {59, -1.5f}, {0, 0.25f}}, .highest = 4};
  return formats::encodeCode(code, 1234);
}

inline Bytes neuralSeed() {
  std::vector<float> weights(NeuralBrdf::weightCount);
  for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = 0.05f * float(i % 13) - 0.25f;
  return formats::encodeNeural(std::span<const float, NeuralBrdf::weightCount>(weights));
}

/// A file of a format of materials: one as other programs write it, or a small one; of other formats what Gonio writes.
inline Bytes formatSeed(const materials::MaterialFormat& format) {
  const std::map<const materials::MaterialFormat*, Bytes (*)()> seeds{
      {&formats::merlFormat, merlSeed},
      {&formats::merlCircleFormat, merlCircleSeed},
      {&formats::rglFormat, rglSeed},
      {&formats::utiaFormat, utiaSeed},
      {&formats::zemaxFormat, zemaxSeed},
      {&formats::lightToolsFormat, lightToolsSeed},
      {&formats::astmFormat, astmSeed},
      {&formats::goniophotometerFormat, goniophotometerSeed},
      {&formats::curetFormat, curetSeed},
      {&formats::csvFormat, csvSeed},
      {&formats::refletFormat, refletSeed},
      {&formats::altaFormat, altaSeed},
      {&formats::openMaterialFormat, openMaterialSeed},
      {&formats::radianceFormat, radianceSeed},
      {&formats::speosFormat, speosSeed},
      {&formats::pdvFormat, pdvSeed},
      {&formats::codeFormat, codeSeed},
      {&formats::neuralFormat, neuralSeed}};
  if (const auto found = seeds.find(&format); found != seeds.end()) return found->second();
  const auto material = materials::unedited("ggx", test::ggx(Rgb(0.3), Rgb(0.5), 0.5, 0.04));
  return materials::encode(material, format, {.snr = 20, .pictureSize = 16, .samples = 4}).bytes;
}

/// Two dictionaries of unit matrices over a grid of 2 x 3 x 2.
inline Bytes dictionarySeed() {
  dictionary::Ensemble ensemble{
      .grid = {.thetaHCount = 2, .thetaDCount = 3, .phiDCount = 2}, .dictionaries = {}, .learnedFrom = {"one"}};
  for (const int sparsity : {2, 3}) {
    dictionary::Dictionary& unit = ensemble.dictionaries.emplace_back();
    unit.sparsity = sparsity;
    for (std::size_t mode = 0; mode < 3; ++mode) {
      const int size = dictionary::modeSizes(ensemble.grid)[mode];
      unit.modes[mode] = Eigen::MatrixXd::Identity(size, size);
    }
  }
  const auto path = test::outputPath("fuzz/seed.dictionary");
  materials::writeDictionary(ensemble, path);
  return test::readFile(path);
}

/// With a byte order mark, comments, semicolons and decimal commas.
inline Bytes planSeed() {
  return bytesOf(
      "\xEF\xBB\xBF# method: somp\r\nindex;theta_i;phi_i;theta_o;phi_o;theta_h;order\r\n1;10,5;0;20;180;4;2\r\n"
      "2;30;-45,25;40;90;5;1\r\n3;85;359;\"0\";0;6;3\r\n");
}

inline Bytes valuesSeed() {
  return bytesOf("index,r,g,b,noise_r,noise_g,noise_b\n1,0.5,1e-3,7,0.1,0.2,0\n3,1,2,3,4,5,6\n2,+0,0,0,1,1,1\n");
}

inline Bytes spectraSeed() {
  return bytesOf("index,450,550nm,600 nm,noise\n1,0.5,1e-3,7,0.1\n3,1,2,3,4\n2,+0,0,1e300,1\n");
}

/// Two readings along the mirror direction and two across it.
inline Bytes factorReadingsSeed() {
  return bytesOf(
      "# method: factors, half-out\nindex,curve,theta_i,phi_i,theta_o,phi_o,order,r,g,b,noise\n"
      "1,along,30,180,30,0,1,0.5,0.4,0.3,0.1\n2,along,60,180,60,0,2,1,0.9,0.8,0\n"
      "3,across,60,180,60,0,3,1,0.9,0.8,0\n4,across,20,180,60,0,4,0.1,0.1,0,0.2\n");
}

/// Two components over a grid of 3 x 2 x 2.
inline Bytes basisSeed() {
  const auto basis = test::learnFrom(test::smoothMaterials(2, {.thetaHCount = 3, .thetaDCount = 2, .phiDCount = 2}));
  return materials::encodeBasis(basis, 2, {"one", "two"});
}

/// Names of the rows, a byte 0, then a table of two rows.
inline Bytes npfSeed() {
  Bytes bytes = bytesOf("row,material\n0,chrome\n1,red-fabric\n");
  bytes.push_back(std::byte(0));
  for (int i = 0; i < 2 * 512 * 3; ++i) append(bytes, 0.25f * float(i % 9));
  return bytes;
}

/// A tetrahedron with normals, a concave polygon, relative indices, a continued line.
inline Bytes objSeed() {
  return bytesOf(
      "# seed\nmtllib a.mtl\no one\nv 0 0 0\nv 1.5 0 0 1\nv 0 2e0 0\nv 0 0 +1\nvt 0 1\nvn 0 0 -1\nvn .5 .5 .5\n"
      "g side\nf 1//1 3//1 2//1\nf 1/1 2/1 4/1\r\nf -4 -1 \\\n -2\ns off\nf 2/1/2 3/1/2 4/1/2\n"
      "v 4 4 0\nv 8 4 0\nv 5 5 0\nv 4 8 0\nv 3 6 0\nusemtl red\nf -5 -4 -3 -2 -1\nl 1 2\n");
}

/// The cube [-1, 1]^3 of six quadrilaterals.
inline Bytes plySeed() {
  return bytesOf(
      "ply\nformat ascii 1.0\ncomment seed\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 6\nproperty list uchar int vertex_indices\nend_header\n-1 -1 -1\n-1 -1 1\n-1 1 -1\n-1 1 1\n1 -1 "
      "-1\n"
      "1 -1 1\n1 1 -1\n1 1 1\n4 0 1 3 2\n4 4 6 7 5\n4 0 4 5 1\n4 2 3 7 6\n4 0 2 6 4\n4 1 5 7 3\n");
}

/// A triangle with normals, twice: one scaled by 2, one moved up by 3.
inline Bytes glbSeed() {
  std::string json = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],
"nodes":[{"mesh":0,"scale":[2,2,2]},{"mesh":0,"translation":[0,3,0]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},"indices":2}]}],
"buffers":[{"byteLength":78}],
"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":36},
{"buffer":0,"byteOffset":72,"byteLength":6}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5126,"count":3,"type":"VEC3"},
{"bufferView":2,"componentType":5123,"count":3,"type":"SCALAR"}]})";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  Bytes binary;
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) append(binary, x);
  for (int i = 0; i < 3; ++i)
    for (const float x : {0.f, 0.f, 1.f}) append(binary, x);
  for (const int index : {0, 1, 2, 0}) append(binary, std::uint16_t(index));
  Bytes bytes = bytesOf("glTF");
  const auto chunk = [&](std::string_view kind, const Bytes& content) {
    append(bytes, std::uint32_t(content.size()));
    for (const char c : kind) bytes.push_back(std::byte(c));
    bytes.insert(bytes.end(), content.begin(), content.end());
  };
  append(bytes, std::uint32_t(2));
  append(bytes, std::uint32_t(12 + 8 + json.size() + 8 + binary.size()));
  chunk("JSON", bytesOf(json));
  chunk(std::string_view("BIN\0", 4), binary);
  return bytes;
}

/// Two run-length coded lines of 16 pixels: a run of ten, then six of their own.
inline Bytes hdrSeed() {
  Bytes bytes = bytesOf("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 16\n");
  for (int row = 0; row < 2; ++row) {
    for (const int value : {2, 2, 0, 16}) bytes.push_back(std::byte(value));
    for (int channel = 0; channel < 4; ++channel)
      for (const int value : {128 + 10, 120 + channel, 6, 1, 2, 3, 4, 5, 6}) bytes.push_back(std::byte(value));
  }
  return bytes;
}

/// Old run-length coding, columns from right to left, and the headers that change values.
inline Bytes oldHdrSeed() {
  Bytes bytes = bytesOf(
      "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2\nCOLORCORR=1 2 4\n"
      "PRIMARIES=0.7 0.3 0.2 0.7 0.15 0.05 0.3333 0.3333\n\n-X 2 +Y 20\n");
  for (int line = 0; line < 2; ++line)
    for (const int value : {10, 20, 30, 128, 1, 1, 1, 12, 90, 80, 70, 129, 1, 1, 1, 6})
      bytes.push_back(std::byte(value));
  return bytes;
}

/// A skinned triangle with a morph target whose accessor is sparse, as text.
inline Bytes skinSeed() {
  Bytes binary;
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) append(binary, x);  // 0: positions
  for (int vertex = 0; vertex < 3; ++vertex)
    for (const int joint : {0, 1, 0, 0}) binary.push_back(std::byte(joint));  // 36: joints
  for (int vertex = 0; vertex < 3; ++vertex)
    for (const int weight : {51, 204, 0, 0}) binary.push_back(std::byte(weight));  // 48: weights, 0.2 and 0.8
  for (int joint = 0; joint < 2; ++joint)
    for (int i = 0; i < 16; ++i) append(binary, i % 5 == 0 ? 1.f : 0.f);  // 60: inverse bind matrices
  append(binary, std::uint32_t(2));                                       // 188: the vertex that is changed
  for (const float x : {0.f, 0.f, 4.f}) append(binary, x);                // 192: by this
  return bytesOf(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],
"extensionsRequired":["KHR_mesh_quantization"],
"nodes":[{"mesh":0,"skin":0,"translation":[50,60,70]},{"children":[2],"translation":[0,10,0]},{"translation":[10,0,0]}],
"skins":[{"joints":[1,2],"inverseBindMatrices":3}],
"meshes":[{"weights":[0.5],"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2},
"targets":[{"POSITION":4}]}]}],
"buffers":[{"byteLength":204,"uri":"data:application/octet-stream;base64,)" +
                 io::base64Text(binary) + R"("}],
"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":12},
{"buffer":0,"byteOffset":48,"byteLength":12},{"buffer":0,"byteOffset":60,"byteLength":128},
{"buffer":0,"byteOffset":188,"byteLength":4},{"buffer":0,"byteOffset":192,"byteLength":12}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
{"bufferView":1,"componentType":5121,"count":3,"type":"VEC4"},
{"bufferView":2,"componentType":5121,"normalized":true,"count":3,"type":"VEC4"},
{"bufferView":3,"componentType":5126,"count":2,"type":"MAT4"},
{"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,
"indices":{"bufferView":4,"componentType":5125},"values":{"bufferView":5}}}]})");
}

/// Faces and strips before the vertices.
inline Bytes stripsSeed() {
  return bytesOf(
      "ply\nformat ascii 1.0\nelement tristrips 1\nproperty list int int vertex_indices\nelement face 1\n"
      "property list uchar int vertex_index\nelement vertex 5\nproperty double x\nproperty double y\n"
      "property double z\nend_header\n8 0 1 2 3 -1 4 1 0\n3 0 2 4\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n");
}

/// A binary tetrahedron.
inline Bytes stlSeed() {
  Bytes bytes = bytesOf("solid as text files begin");
  bytes.resize(80);
  append(bytes, std::uint32_t(4));
  const glm::vec3 corners[] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 1},
                               {0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (std::size_t i = 0; i < 12; ++i) {
    if (i % 3 == 0) append(bytes, glm::vec3(0));
    append(bytes, corners[i]);
    if (i % 3 == 2) append(bytes, std::uint16_t(0));
  }
  return bytes;
}

/// The same points as of an ASTM file, as a spreadsheet of another locale writes them.
inline Bytes localeAstmSeed() {
  return bytesOf(
      "NUM_POINTS;3;;\r\nVARS;theta_i [deg];phi_i;theta_s;phi_s;0,45um;0.55um;650nm;BRDF\r\n"
      "10,5;0;20;180;0,1;0,2;0,3;0,4\r\n20;0;0;0;1;2e-1;3;4\r\n30;0;60,25;90;1;2;3;4\r\n");
}

inline Bytes localeGoniophotometerSeed() {
  return bytesOf(
      "#format: theta phi DSF\n#incident_angle 30,5 180\n#colorimetry: CIE-XYZ\n"
      "0\t0,0\t0,1\t0,2\t0,3\n20,5;60;1;2;3 # bright\n");
}

inline Bytes documentSeed() {
  return bytesOf(R"({"format": "gonio document", "version": 1,
    "source": {"path": "a.binary", "sha256": "0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef"},
    "edits": [{"type": "differential", "model": "lambert", "fitted": {"diffuse": [0.1, 0.2, 0.3]},
               "edited": {"diffuse": 0.5}, "strength": 0.75, "enabled": true}],
    "view": {"exposure": 1, "light": [0, 0, 1]}})");
}

/// Without a mesh: its bounding volumes would be built for every mutation.
inline Bytes sceneSeed() {
  return bytesOf(
      R"({"format": "gonio scene", "version": 1, "camera": {"yaw": 3, "distance": "fit", "target": [0, 1, 0]},
    "objects": [{"name": "a", "shape": "sphere", "centre": [0, 1, 2], "radius": 0.5, "material": "each", "spacing": 2},
                {"name": "b", "shape": "rectangle", "halfU": [0, 0, 9], "halfV": [9, 0, 0],
                 "material": {"diffuse": [0.4, 0.5, 0.6]}},
                {"name": "c", "shape": "rectangle", "halfU": [1, 0, 0], "halfV": [0, 1, 0], "radiance": [5, 6, 7]}],
    "lights": [{"kind": "directional", "toLight": [1, 2, 3], "irradiance": [1, 1, 1]},
               {"kind": "point", "position": [0, 3, 0], "intensity": [4, 4, 4]}],
    "environment": {"picture": "sky", "rotation": 30, "shown": true}})");
}

inline Bytes figureSeed() {
  return bytesOf(
      R"({"format": "gonio figure", "version": 1, "title": "T", "columns": "one", "font": "Times", "fontSize": 6.5,
    "materials": [{"path": "library:sgd/chrome", "label": "chrome"}, {"path": "a.binary"}],
    "representations": [{"id": "ggx"}, {"id": "factors-3d", "budget": 10, "label": "PDV"}, {"id": "code", "budget": 64}],
    "pictures": {"scene": "row", "environment": "sky", "size": 32, "samples": 8, "exposure": -1, "toneMap": "filmic"},
    "numbers": ["rendered-snr", "bytes"], "inset": {"x": 0.25, "y": 0.5, "size": 0.125},
    "errorMaps": false, "errorMaximum": 0.25})");
}

}  // namespace gonio::fuzz
