// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>
#include <cmath>
#include <cstring>

#include "core/coordinates/half_difference.h"
#include "core/export/export_target.h"
#include "core/export/shaders/shading_models.h"
#include "core/io/byte_source.h"
#include "core/io/exr_codec.h"
#include "core/materials/material.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace surface_files_test {
using namespace gonio;
using exports::GgxAlpha;
using exports::ReciprocalLobes;
using exports::SurfaceValues;

/// A name and an origin that no format takes as they are.
const std::string awkwardName = "red \"<paint>\" & co\\ \xff";
const std::string awkwardOrigin = "from <a> -- b ---\nc \"d\"";

SurfaceValues everything() {
  return {.baseColour = Rgb(0.6, 0.3, 0.1),
          .metalness = 0.2,
          .roughness = 0.4,
          .anisotropy = 0.5,
          .rotation = 0.3,
          .specularColour = Rgb(0.5, 1, 1),
          .ior = 1.7,
          .coat = 0.6,
          .coatRoughness = 0.1,
          .sheenColour = Rgb(0.1),
          .sheenRoughness = 0.3};
}

ReciprocalLobes twoLobes(bool grain) {
  return {.diffuse = Rgb(0.1, 0.2, 0.3),
          .lobes = {{grain ? GgxAlpha(0.4, 0.2) : GgxAlpha(0.3), Rgb(0.04), Rgb(0.9), Rgb(1)},
                    {GgxAlpha(0.05), Rgb(0.5, 0.4, 0.3), Rgb(1.5), Rgb(0.7)}},
          .rotation = grain ? 0.5 : 0};
}

QJsonObject parsed(const std::string& document) {
  QJsonParseError error;
  const QJsonDocument json = QJsonDocument::fromJson(QByteArray::fromStdString(document), &error);
  if (error.error != QJsonParseError::NoError) qWarning() << error.errorString();
  return json.object();
}

/// Elements of a document with their inputs, "open_pbr_surface.coat_weight"; empty where it is not well-formed.
QMap<QString, QString> inputsOf(const std::string& document) {
  QXmlStreamReader xml(QByteArray::fromStdString(document));
  QMap<QString, QString> inputs;
  QString element;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() != QLatin1String("input")) {
      element = xml.name().toString();
      inputs[element + "#" + xml.attributes().value("name").toString()] = xml.attributes().value("type").toString();
      continue;
    }
    const auto& attributes = xml.attributes();
    const QString value = attributes.hasAttribute("value") ? attributes.value("value").toString()
                                                           : "@" + attributes.value("nodename").toString();
    inputs[element + "." + attributes.value("name").toString()] = value;
  }
  if (xml.hasError()) {
    qWarning() << xml.errorString();
    return {};
  }
  return inputs;
}

class SurfaceFilesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The parts refer to each other within bounds, and every vertex is on the unit sphere.
  void gltfIsWhole() {
    const QJsonObject json = parsed(exports::gltfDocument(everything(), awkwardName, awkwardOrigin));
    QCOMPARE(json["asset"]["version"].toString(), QString("2.0"));
    QCOMPARE(json["asset"]["extras"]["origin"].toString(), QString::fromStdString(awkwardOrigin));
    const QString uri = json["buffers"][0]["uri"].toString();
    const QByteArray bytes =
        QByteArray::fromBase64(uri.section(',', 1).toLatin1(), QByteArray::AbortOnBase64DecodingErrors);
    QCOMPARE(bytes.size(), qsizetype(json["buffers"][0]["byteLength"].toInteger()));
    qsizetype end = 0;
    for (const QJsonValue view : json["bufferViews"].toArray()) {
      QCOMPARE(qsizetype(view["byteOffset"].toInteger()), end);
      QCOMPARE(end % 4, 0);
      end += qsizetype(view["byteLength"].toInteger());
    }
    QCOMPARE(end, bytes.size());
    const QJsonObject attributes = json["meshes"][0]["primitives"][0]["attributes"].toObject();
    QVERIFY(attributes.contains("TANGENT"));
    const auto accessor = [&](const char* name) { return json["accessors"][attributes[name].toInt()].toObject(); };
    const qint64 vertices = accessor("POSITION")["count"].toInteger();
    for (qint64 i = 0; i < vertices; ++i) {
      float p[3];
      std::memcpy(p, bytes.data() + 12 * i, sizeof p);
      QVERIFY(std::abs(p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - 1) < 1e-5f);
    }
    const QJsonValue indices = json["accessors"][json["meshes"][0]["primitives"][0]["indices"].toInt()];
    const auto first = qsizetype(json["bufferViews"][indices["bufferView"].toInt()]["byteOffset"].toInteger());
    for (qint64 i = 0; i < indices["count"].toInteger(); ++i) {
      std::uint16_t index;
      std::memcpy(&index, bytes.data() + first + 2 * i, sizeof index);
      QVERIFY(index < vertices);
    }
  }

  void gltfHasTheExtensionsThatCount() {
    const QJsonObject all = parsed(exports::gltfDocument(everything(), "a", ""));
    QCOMPARE(all["extensionsUsed"].toArray().size(), 4);
    const QJsonValue extensions = all["materials"][0]["extensions"];
    QCOMPARE(extensions["KHR_materials_clearcoat"]["clearcoatFactor"].toDouble(), double(0.6f));
    QCOMPARE(extensions["KHR_materials_anisotropy"]["anisotropyRotation"].toDouble(), double(0.3f));
    QCOMPARE(extensions["KHR_materials_sheen"]["sheenRoughnessFactor"].toDouble(), double(0.3f));
    QCOMPARE(extensions["KHR_materials_specular"]["specularColorFactor"][0].toDouble(), 0.5);
    const QJsonObject plain = parsed(exports::gltfDocument({}, "a", ""));
    QVERIFY(!plain.contains("extensionsUsed") && !plain["materials"][0].toObject().contains("extensions"));
    QVERIFY(!plain["meshes"][0]["primitives"][0]["attributes"].toObject().contains("TANGENT"));
  }

  /// Well-formed whatever the name and the origin, and every node that is referred to is there.
  void materialXIsWhole() {
    using namespace exports;
    for (const std::string& text :
         {schlickLobesDocument(twoLobes(true), awkwardName, awkwardOrigin),
          schlickLobesDocument(twoLobes(false), awkwardName, awkwardOrigin),
          openPbrDocument(everything(), awkwardName, awkwardOrigin), openPbrDocument({}, awkwardName, awkwardOrigin),
          standardSurfaceDocument(everything(), awkwardName, awkwardOrigin)}) {
      const QMap<QString, QString> inputs = inputsOf(text);
      QVERIFY(!inputs.isEmpty());
      for (const QString& value : inputs)
        if (value.startsWith('@')) {
          const QString node = "#" + value.mid(1);
          QVERIFY2(
              std::any_of(inputs.keyBegin(), inputs.keyEnd(), [&](const QString& key) { return key.endsWith(node); }),
              qPrintable(value));
        }
    }
  }

  void materialXHasTheValues() {
    const auto lobes = inputsOf(exports::schlickLobesDocument(twoLobes(false), "a", ""));
    QCOMPARE(lobes["generalized_schlick_bsdf.roughness"], QString("0.05, 0.05"));  // of the last lobe: alpha itself
    QCOMPARE(lobes["generalized_schlick_bsdf.color90"], QString("1.5, 1.5, 1.5"));
    QVERIFY(!lobes.contains("generalized_schlick_bsdf.tangent"));
    QCOMPARE(inputsOf(exports::schlickLobesDocument(twoLobes(true), "a", ""))["rotate3d.amount"], QString("28.6479"));
    const auto open = inputsOf(exports::openPbrDocument(everything(), "a", ""));
    QCOMPARE(open["open_pbr_surface.specular_roughness"], QString("0.4"));
    QCOMPARE(open["open_pbr_surface.geometry_tangent"], QString("@grain"));
    const auto standard = inputsOf(exports::standardSurfaceDocument(everything(), "a", ""));
    QCOMPARE(standard["standard_surface.specular_rotation"].toDouble(), 0.0477465);
    QCOMPARE(standard["standard_surface.coat"], QString("0.6"));
  }

  /// The arrays have one element a lobe, and braces and parentheses close.
  void glslIsWhole() {
    const QString text = QString::fromStdString(exports::glslFunction(twoLobes(true), awkwardOrigin));
    QVERIFY(text.contains("const int gonioLobeCount = 2;"));
    QVERIFY(text.contains("vec2[2](vec2(0.4, 0.2), vec2(0.05, 0.05))"));
    QCOMPARE(text.count('{'), text.count('}'));
    QCOMPARE(text.count('('), text.count(')'));
    for (const QString& line : text.split('\n').mid(0, 2)) QVERIFY(line.startsWith("// "));
    QVERIFY(QString::fromStdString(exports::glslFunction({}, "")).contains("gonioLobeCount = 1"));
    // A backslash would continue the comment.
    QVERIFY(exports::glslFunction({}, "a\\").starts_with("// a\\.\n// GLSL"));
  }

  /// Files of measured formats, read again, are what the export says that they show.
  void tablesAreReadAgain_data() {
    QTest::addColumn<QString>("target");
    for (const char* id : {"merl", "merl-360", "utia"}) QTest::newRow(id) << id;
  }
  void tablesAreReadAgain() {
    QFETCH(QString, target);
    const auto source = materials::unedited("test", test::ggx(Rgb(0.3, 0.1, 0.05), Rgb(0.5), 0.5, 0.05));
    const auto made = exports::makeExport(*exports::findExportTarget(target.toStdString()), source,
                                          {.snr = 20, .pictureSize = 16, .samples = 8});
    const auto read = materials::readMaterial(io::MemorySource(made.parts[0].bytes));
    const Direction wi = fromSpherical(0.6, 0.2), wo = fromSpherical(0.4, 2.9);
    const double stated = made.brdf->evaluate(wi, wo).x, found = read.brdf->evaluate(wi, wo).x;
    QVERIFY(std::abs(found / stated - 1) < 1e-5);
    QVERIFY(std::abs(stated / source.shown.brdf->evaluate(wi, wo).x - 1) < 0.1);
  }

  void csvHasTheValues() {
    const auto source = materials::unedited("test", test::ggx(Rgb(0.3), Rgb(0.5), 0.5, 0.05));
    const auto made = exports::makeExport(*exports::findExportTarget("csv"), source);
    const auto& bytes = made.parts[0].bytes;
    const QStringList lines = QString::fromUtf8(reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size()))
                                  .split('\n', Qt::SkipEmptyParts);
    const qsizetype title = lines.indexOf("theta_i,phi_i,theta_o,phi_o,red,green,blue");
    QVERIFY(title > 0);
    QCOMPARE(lines.size() - title - 1, 6 * 18 * 13);
    QCOMPARE(made.losses.at(0),
             std::string("the file contains values at 1404 pairs of directions and nothing between them"));
    const QStringList row = lines[title + 1 + (2 * 18 + 3) * 13 + 12].split(',');
    QCOMPARE(row.mid(0, 4).join(' '), QString("30 0 15 180"));
    const double expected =
        source.shown.brdf->evaluate(fromSpherical(radians(30), 0), fromSpherical(radians(15), pi)).x;
    QVERIFY(std::abs(row[4].toDouble() / expected - 1) < 1e-5);
  }

  /// A pixel is the BRDF at its half vector and difference vector; below the horizon it is 0.
  void slicesHaveTheValues() {
    const auto source = materials::unedited("test", test::ggx(Rgb(0.3), Rgb(0.5), 0.5, 0.05));
    const auto made = exports::makeExport(*exports::findExportTarget("slices"), source);
    const Image image = io::decodeExr(made.parts[0].bytes).image;
    QCOMPARE(std::pair(image.width, image.height), std::pair(4 * 180, 180));
    const int columns[] = {7, 180 + 40, 2 * 180 + 60, 3 * 180 + 90};
    for (const int column : columns) {
      const double u = (column % 180 + 0.5) / 180, thetaH = halfPi * u * u, thetaD = halfPi * 30.5 / 180;
      const DirectionPair pair = fromHalfDifference(thetaH, thetaD, radians(30.0 * (column / 180)));
      const double expected = source.shown.brdf->evaluate(pair.wi, pair.wo).x;
      QVERIFY(expected > 0 && std::abs(image.at(column, 180 - 31).x / expected - 1) < 1e-6);
    }
    QVERIFY(image.at(179, 0).x == 0);
  }

  /// Three programs, each with all its inputs once.
  void valuesHaveTheNamesOfThePrograms() {
    const auto source = materials::unedited("test", test::ggx(Rgb(0.3, 0.2, 0.1), Rgb(0.5), 0.3, 0.04));
    const auto made = exports::makeExport(*exports::findExportTarget("values"), source,
                                          {.snr = 20, .pictureSize = 24, .samples = 16});
    const auto& bytes = made.parts[0].bytes;
    const QString text = QString::fromUtf8(reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size()));
    for (const char* row : {"Unreal Engine (Default Lit),Specular,", "Unity (HDRP Lit),Smoothness,",
                            "Arnold (standard_surface),specular_IOR,"})
      QCOMPARE(text.count(row), 1);
    const QRegularExpression colour("Unity \\(HDRP Lit\\),Base Map,([0-9.]+) [0-9.]+ [0-9.]+,#([0-9a-f]{6})\n");
    const auto match = colour.match(text);
    QVERIFY(match.hasMatch());
    const double linear = match.captured(1).toDouble();
    const int expected = int(std::lround(255 * (1.055 * std::pow(linear, 1 / 2.4) - 0.055)));
    QCOMPARE(match.captured(2).left(2).toInt(nullptr, 16), expected);
    QVERIFY(made.snr > 20);
  }

  /// The validator of Khronos and MaterialX 1.39 take the documents, and reject broken ones (read_exports.cjs).
  void clientsTakeTheDocuments() {
    const QString modules = qEnvironmentVariable("GONIO_EXPORT_CLIENTS");
    if (modules.isEmpty() || QStandardPaths::findExecutable("node").isEmpty())
      QSKIP("node or the clients are not installed (scripts/install_export_clients.sh)");
    QTemporaryDir folder;
    const auto write = [&](const char* name, const std::string& text) {
      QFile file(folder.filePath(name));
      QVERIFY(file.open(QIODevice::WriteOnly));
      file.write(text.data(), qint64(text.size()));
    };
    using namespace exports;
    write("a.gltf", gltfDocument(everything(), "a", awkwardOrigin));
    write("plain.gltf", gltfDocument({}, "a", ""));
    write("lobes.mtlx", schlickLobesDocument(twoLobes(true), awkwardName, awkwardOrigin));
    write("open.mtlx", openPbrDocument(everything(), awkwardName, awkwardOrigin));
    write("standard.mtlx", standardSurfaceDocument(everything(), awkwardName, awkwardOrigin));
    std::string broken = openPbrDocument(everything(), "a", "");
    write("broken.mtlx", broken.replace(broken.find("coat_weight"), 4, "goat"));
    std::string brokenJson = gltfDocument(everything(), "a", "");
    write("broken.gltf", brokenJson.replace(brokenJson.find("VEC3"), 4, "VEC9"));
    for (const QString& name : QDir(folder.path()).entryList(QDir::Files)) {
      QProcess node;
      node.start("node", {READ_EXPORTS_SCRIPT, modules, folder.filePath(name)});
      QVERIFY(node.waitForFinished(120000));
      const QByteArray output = node.readAllStandardOutput() + node.readAllStandardError();
      QVERIFY2((node.exitCode() == 0) != name.startsWith("broken"), qPrintable(name + ": " + output));
    }
  }
};

GONIO_TEST(SurfaceFilesTest)
}  // namespace surface_files_test

#include "surface_files_test.moc"
