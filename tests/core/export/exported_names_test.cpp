// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/support/hostile_names.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>
#include <algorithm>

#include "core/export/export_target.h"
#include "core/export/shaders/shading_models.h"
#include "core/export/target_table.h"
#include "core/io/tensor_file.h"
#include "core/support/text.h"
#include "tests/support/function_brdf.h"
#include "tests/support/simple_meshes.h"
#include "tests/support/spreadsheet.h"
#include "tests/support/test_program.h"

/// Names of any content in every file of every target: each file is read by the parser of its format, or by one written
/// here by its rules, which finds the name as plainText() where it belongs and nothing else.
namespace exported_names_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::geometry;
using exports::ExportPart;
using materials::EditedMaterial;

/// The input of exports for which a material, its source and its edit have a name.
EditedMaterial sourceNamed(const std::string& name) {
  const models::Model& model = models::findModel("lambert");
  const editing::EditList edits{
      {.content = editing::DifferentialEdit{&model, {{Rgb(0.2)}}, {{Rgb(0.4)}}}, .name = name}};
  materials::Material base;
  base.name = name;
  base.source.format = "MERL";
  base.brdf = test::ggx(Rgb(0.3, 0.1, 0.05), Rgb(0.5), 0.4, 0.05);
  EditedMaterial edited = materials::unedited(base);
  edited.edits = edits;
  return edited;
}

/// The files of targets whose text does not depend on the work of an export.
std::vector<ExportPart> textFiles(const EditedMaterial& source) {
  using namespace exports;
  const std::string origin = originText(source, 30);
  const ViewLobes viewLobes{.alphas = {0.1}, .thetas = {0}, .weights = {{Rgb(0.1)}, {Rgb(0.5)}}};
  const SurfaceValues values{.anisotropy = 0.5};
  return {
      textPart("_blender.py", blenderScript(viewLobes, materials::plainName(source), origin)),
      textPart("_principled.py", principledScript(values, BlenderVersion::v4, materials::plainName(source), origin)),
      textPart(".gltf", gltfDocument(values, materials::plainName(source), origin)),
      textPart(".mtlx", schlickLobesDocument({}, materials::plainName(source), origin)),
      textPart("_openpbr.mtlx", openPbrDocument(values, materials::plainName(source), origin)),
      textPart("_standard_surface.mtlx", standardSurfaceDocument(values, materials::plainName(source), origin)),
      textPart(".glsl", glslFunction({}, origin))};
}

/// A mesh and an environment, which are files of their own, and a sphere; all with a name.
Scene sceneNamed(const std::string& name) {
  Scene scene;
  scene.name = name;
  const auto mesh = test::shared(test::sphereMesh(0.5, 3, 4));
  scene.objects = {{.name = name, .shape = std::make_shared<const MeshIntersector>(mesh)},
                   {.name = name, .shape = Sphere{.centre = {0, 0, 1}, .radius = 0.5}}};
  scene.environment = std::make_shared<const EnvironmentMap>(Image(8, 4), name);
  return scene;
}

QByteArray bytesOf(const ExportPart& part) {
  return {reinterpret_cast<const char*>(part.bytes.data()), qsizetype(part.bytes.size())};
}

QString textOf(const std::string& text) { return QString::fromStdString(text); }

QString jsonFault(const QByteArray& bytes, const EditedMaterial& source) {
  QJsonParseError error;
  const QJsonDocument json = QJsonDocument::fromJson(bytes, &error);
  if (error.error != QJsonParseError::NoError) return error.errorString();
  if (json["materials"][0]["name"].toString() != textOf(materials::plainName(source))) return "other name";
  return json["asset"]["extras"]["origin"].toString().startsWith(textOf(materials::originOf(source))) ? ""
                                                                                                      : "other origin";
}

/// The names of the elements are those of a document without a special name, and one comment has the origin.
QString xmlFault(const QByteArray& bytes, const EditedMaterial& source) {
  QXmlStreamReader xml(bytes);
  int comments = 0, materials = 0;
  while (!xml.atEnd()) {
    xml.readNext();
    if (xml.isComment()) {
      // Hyphens are not compared: comments do not contain two.
      const auto compared = [](QString text) { return text.remove('-').remove(' '); };
      if (!compared(xml.text().toString()).startsWith(compared(textOf(materials::originOf(source)))))
        return "other comment";
      ++comments;
    }
    if (!xml.isStartElement()) continue;
    if (xml.name() == QLatin1String("surfacematerial")) ++materials;
    const QString name = xml.attributes().value("name").toString();
    if (!name.isEmpty() && !QRegularExpression("^[A-Za-z_][A-Za-z0-9_]*$").match(name).hasMatch()) return "bad name";
  }
  if (xml.hasError()) return xml.errorString();
  return comments == 1 && materials == 1 ? "" : "other elements";
}

/// The origin takes the first line, whatever separator a spreadsheet expects, and no cell is calculated.
QString csvFault(const QByteArray& bytes, const EditedMaterial& source) {
  const std::string text = bytes.toStdString();
  if (!text.starts_with("# ")) return "no comment";
  for (const char separator : {',', ';', '\t'}) {
    const test::SpreadsheetRows rows = test::spreadsheetRows(text, separator);
    if (qsizetype(rows.size()) != bytes.count('\n')) return "a cell has several lines";
    if (test::hasCalculatedCell(rows)) return "a cell is calculated";
  }
  const QString first = QString::fromUtf8(bytes).section('\n', 0, 0).mid(2);
  const auto compared = [](QString line) { return line.remove('\''); };
  return compared(first).startsWith(compared(textOf(materials::originOf(source)))) ? "" : "other comment";
}

/// The origin takes the first line, which no backslash continues.
QString glslFault(const QByteArray& bytes, const EditedMaterial& source) {
  const QStringList lines = QString::fromUtf8(bytes).split('\n');
  if (!lines[0].startsWith("// " + textOf(materials::originOf(source))) || lines[0].endsWith('\\'))
    return "other comment";
  for (const QChar c : lines[0])
    if (!c.isPrint() && !c.isSpace() && c.category() != QChar::Other_Format && !c.isSurrogate()) return "control";
  return lines[1].startsWith("// GLSL 3.30") ? "" : "several lines";
}

/// What is wrong with a file; empty if nothing is. Scripts are not parsed here.
QString fault(const ExportPart& part, const EditedMaterial& source) {
  const QByteArray bytes = bytesOf(part);
  const QString suffix = textOf(part.suffix);
  if (suffix.endsWith(".gltf")) return jsonFault(bytes, source);
  if (suffix.endsWith(".mtlx")) return xmlFault(bytes, source);
  if (suffix.endsWith(".csv")) return csvFault(bytes, source);
  if (suffix.endsWith(".glsl")) return glslFault(bytes, source);
  if (suffix.endsWith(".exr"))
    return bytes.contains(QByteArray::fromStdString(materials::originOf(source))) ? "" : "other comment";
  if (suffix.endsWith(".bsdf")) {
    const std::string description = io::TensorFile(io::MemorySource(part.bytes)).text("description");
    return description.starts_with(materials::originOf(source)) ? "" : "other description";
  }
  if (suffix.endsWith(".binary") || suffix.endsWith(".bin")) return {};  // formats without text
  return "no parser for this format";
}

/// The strings of a pbrt scene by the rules of its tokenizer; empty if it rejects one.
QStringList pbrtStrings(const QByteArray& bytes) {
  QStringList strings;
  for (qsizetype at = bytes.indexOf('"'); at >= 0; at = bytes.indexOf('"', at + 1)) {
    QByteArray string;
    for (++at; at < bytes.size() && bytes[at] != '"'; ++at) {
      if (bytes[at] == '\n') return {};
      if (bytes[at] == '\\' && !QByteArray("\\\"").contains(bytes[++at])) return {};
      string += bytes[at];
    }
    if (at == bytes.size()) return {};
    strings << QString::fromUtf8(string);
  }
  return strings;
}

/// The files that a scene for pbrt or Mitsuba names.
QStringList referencesOf(const QByteArray& text, const std::string& suffix) {
  QStringList files;
  if (suffix.ends_with(".pbrt")) {
    const QStringList strings = pbrtStrings(text);
    for (qsizetype i = 1; i < strings.size(); ++i)
      if (strings[i - 1] == "string filename") files << strings[i];
    return files;
  }
  QXmlStreamReader xml(text);
  while (!xml.atEnd())
    if (xml.readNext(); xml.isStartElement() && xml.attributes().value("name") == QLatin1String("filename"))
      files << xml.attributes().value("value").toString();
  return xml.hasError() ? QStringList() : files;
}

/// The files that a scene for Blender names.
QStringList referencesOf(const QJsonObject& scene) {
  QStringList files{scene["material"].toString(), scene["environment"]["picture"].toString()};
  for (const QJsonValue object : scene["objects"].toArray())
    if (object.toObject().contains("mesh")) files << object["mesh"].toString();
  return files;
}

class ExportedNamesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    std::string all;
    for (const test::HostileName& name : test::hostileNames()) {
      all += name.text + ", ";
      const EditedMaterial source = sourceNamed(name.text);
      QCOMPARE(materials::plainName(source), plainText(name.text));
      for (ExportPart& part : textFiles(source)) add(name.id, source, std::move(part));
      addScenes(name);
    }
    // All names at once, since an export takes its time.
    const EditedMaterial source = sourceNamed(all);
    for (const exports::ExportTarget& target : exports::exportTargets()) {
      auto made = target.make(source, {.snr = 0, .size = {{8, 16}}, .pictureSize = 8, .samples = 4}, {});
      for (ExportPart& part : made.parts) add(target.id, source, std::move(part));
    }
    runScripts();
  }

  void everyFileIsReadAsItIs_data() {
    QTest::addColumn<std::size_t>("index");
    for (std::size_t i = 0; i < m_files.size(); ++i) QTest::newRow(m_files[i].row.constData()) << i;
  }
  void everyFileIsReadAsItIs() {
    QFETCH(std::size_t, index);
    const auto& [row, source, part] = m_files[index];
    if (!part.suffix.ends_with(".py")) {
      QCOMPARE(fault(part, source), QString());
      return;
    }
    const QJsonObject script = scriptOf(row);
    if (script.isEmpty()) QSKIP("python3 is not installed");
    QCOMPARE(script["name"].toString(), textOf(materials::plainName(source)));
    QVERIFY(script["origin"].toString().startsWith(textOf(materials::originOf(source))));
  }

  void scenesNameTheirFiles_data() {
    QTest::addColumn<std::size_t>("index");
    for (std::size_t i = 0; i < m_scenes.size(); ++i) QTest::newRow(m_scenes[i].row.constData()) << i;
  }
  /// The material, and all files that are written beside the scene.
  void scenesNameTheirFiles() {
    QFETCH(std::size_t, index);
    const auto& [row, format, name, parts] = m_scenes[index];
    QStringList expected{textOf(name + std::string(format->materialSuffix))}, found;
    for (std::size_t i = 1; i < parts.size(); ++i) expected << textOf(name + parts[i].suffix);
    if (parts[0].suffix.ends_with(".py")) {
      const QJsonObject scene = scriptOf(row);
      if (scene.isEmpty()) QSKIP("python3 is not installed");
      for (const QJsonValue object : scene["objects"].toArray())
        QCOMPARE(object["name"].toString(), textOf(plainText(name)));
      found = referencesOf(scene);
    } else {
      found = referencesOf(bytesOf(parts[0]), parts[0].suffix);
      found.removeOne(textOf(name + "_pbrt.exr"));  // written by pbrt
    }
    std::ranges::sort(found);
    std::ranges::sort(expected);
    QCOMPARE(found, expected);
  }

  /// Names that a scene cannot contain are an error that states them; all others are written.
  void otherScenesAreRefused() {
    for (const test::HostileName& name : test::hostileNames())
      for (const exports::ExportTarget& target : exports::exportTargets()) {
        if (!target.scene) continue;
        const bool hasDollar = target.id == "mitsuba" && name.text.find('$') != std::string::npos;
        try {
          exports::sceneParts(*target.scene, sceneNamed(name.text), name.text);
          QVERIFY2(!hasDollar && plainText(name.text) == name.text, name.id);
        } catch (const Error& error) {
          QVERIFY2(hasDollar || plainText(name.text) != name.text, name.id);
          QVERIFY2(std::string(error.what()).starts_with(plainText(name.text) + ": found "), error.what());
        }
      }
  }

  void proposedNamesAreScenes() {
    for (const test::HostileName& name : test::hostileNames())
      exports::checkSceneName(exports::findExportTarget("pbrt")->scene[0], exports::proposedName(name.text, {}));
  }

 private:
  struct File {
    QByteArray row;
    EditedMaterial source;
    ExportPart part;
  };
  struct SceneFiles {
    QByteArray row;
    const exports::SceneFormat* format;
    std::string name;
    std::vector<ExportPart> parts;
  };

  void add(std::string_view id, const EditedMaterial& source, ExportPart part) {
    const QByteArray row = QByteArray::fromStdString(std::string(id) + part.suffix);
    if (part.suffix.ends_with(".py")) writeScript(row, part);
    m_files.push_back({row, source, std::move(part)});
  }

  void addScenes(const test::HostileName& name) {
    for (const exports::ExportTarget& target : exports::exportTargets()) {
      if (!target.scene) continue;
      const QByteArray row = QByteArray(name.id) + "-" + target.id.data() + "-scene";
      try {
        auto parts = exports::sceneParts(*target.scene, sceneNamed(name.text), name.text);
        if (parts[0].suffix.ends_with(".py")) writeScript(row, parts[0]);
        m_scenes.push_back({row, target.scene, name.text, std::move(parts)});
      } catch (const Error&) {
        // Tested by otherScenesAreRefused().
      }
    }
  }

  void writeScript(const QByteArray& row, const ExportPart& part) {
    QFile file(m_folder.filePath(QString::fromLatin1(row)));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytesOf(part));
  }

  /// Once for all: Python takes its time to start. A name that runs ends it (hostile_names.h).
  void runScripts() {
    if (QStandardPaths::findExecutable("python3").isEmpty()) return;
    QProcess python;
    python.start("python3", {RUN_SCRIPTS_SCRIPT, m_folder.path()});
    QVERIFY(python.waitForFinished(60000));
    QVERIFY2(python.exitStatus() == QProcess::NormalExit && python.exitCode() == 0,
             python.readAllStandardError().constData());
    m_scripts = QJsonDocument::fromJson(python.readAllStandardOutput()).object();
    QCOMPARE(m_scripts.size(), QDir(m_folder.path()).entryList(QDir::Files).size());
  }

  QJsonObject scriptOf(const QByteArray& row) const { return m_scripts[QString::fromLatin1(row)].toObject(); }

  QTemporaryDir m_folder;
  std::vector<File> m_files;
  std::vector<SceneFiles> m_scenes;
  QJsonObject m_scripts;  ///< by the names of their files; empty without Python
};

GONIO_TEST(ExportedNamesTest)
}  // namespace exported_names_test

#include "exported_names_test.moc"
