// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cstring>

#include "core/io/image_io.h"
#include "core/rendering/effect_plan.h"
#include "core/rendering/scene_file.h"
#include "tests/app/goniotool/goniotool_runner.h"
#include "tests/support/test_program.h"

namespace goniotool_render_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::test;

/// The text attribute of an OpenEXR file: its name, the type "string", the length in four bytes, the text.
std::string exrAttribute(const QString& path, const QByteArray& name) {
  const QByteArray bytes = bytesOf(path), head = name + '\0' + QByteArray("string") + '\0';
  const qsizetype place = bytes.indexOf(head);
  if (place < 0) return "none";
  std::int32_t length = 0;
  std::memcpy(&length, bytes.data() + place + head.size(), sizeof length);
  return bytes.mid(place + head.size() + 4, length).toStdString();
}

const nlohmann::json& decision(const nlohmann::json& plan, const std::string& effect) {
  for (const nlohmann::json& one : plan)
    if (one["effect"] == effect) return one;
  throw Error("a plan without " + effect);
}

Image pictureAt(const QString& path) { return io::readImage(std::filesystem::path(path.toStdString())); }

double mean(const Image& image) {
  double sum = 0;
  for (const glm::vec3& pixel : image.pixels) sum += double(pixel.y);
  return sum / double(image.pixels.size());
}

class GoniotoolRenderTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    plastic_ = folder_.writeTable("plastic.binary", "ggx", plastic);
    matte_ = folder_.writeTable("matte.binary", "lambert", {{Rgb(0.5, 0.4, 0.3)}});
  }

  /// The plans of all bundled scenes in a grey material, as the core makes them, in both forms.
  void scenesTellTheirPlans() {
    const ToolResult text = runTool({"scenes"}), json = runJson({"scenes"});
    VERIFY_SUCCESS(text);
    VERIFY_SUCCESS(json);
    QCOMPARE(json.json["scenes"].size(), bundledSceneNames().size());
    QStringList lines = text.out.split('\n', Qt::SkipEmptyParts);
    for (const nlohmann::json& told : json.json["scenes"]) {
      const Scene scene = openScene(told["scene"].get<std::string>());
      const std::vector<std::shared_ptr<const RenderMaterial>> grey{diffuseMaterial(Rgb(0.5))};
      const EffectPlan plan = planEffects(scene, bindMaterials(scene, grey));
      QCOMPARE(lines.takeFirst(), QString::fromStdString(scene.name + ": " + scene.description));
      QCOMPARE(told["description"].get<std::string>(), scene.description);
      QCOMPARE(told["objects"].get<std::size_t>(), scene.objects.size());
      QCOMPARE(told["reflections"].get<int>(), plan.reflections);
      QCOMPARE(told["plan"].size(), effectCount);
      for (const nlohmann::json& one : told["plan"]) {
        const EffectDecision& expected = plan[effectOfId(one["effect"].get<std::string>())];
        QCOMPARE(one["simulated"].get<bool>(), expected.simulated);
        QCOMPARE(one["calledFor"].get<bool>(), expected.calledFor);
        QCOMPARE(one["reason"].get<std::string>(), expected.reason);
        QCOMPARE(lines.takeFirst(),
                 QString::fromStdString("  " + one["effect"].get<std::string>() +
                                        (expected.simulated ? ": yes, " : ": no, ") + expected.reason));
      }
    }
    QVERIFY(lines.isEmpty());
    const ToolResult row = runJson({"scenes", "row", "--material", plastic_, "--material", matte_});
    VERIFY_SUCCESS(row);
    QCOMPARE(row.json["scenes"][0]["scene"].get<std::string>(), std::string("row"));
    QCOMPARE(row.json["scenes"][0]["objects"].get<int>(), 3);
  }

  void picturesTellHowTheyWereMade() {
    const QString out = folder_.path("lamp.exr");
    const ToolResult result = runJson({"render", matte_, "--scene", "sphere-under-lamp", "--size", "24x16", "--samples",
                                       "8", "--seed", "7", "--out", out});
    VERIFY_SUCCESS(result);
    QCOMPARE(result.json["scene"].get<std::string>(), std::string("sphere-under-lamp"));
    QVERIFY(result.json["environment"].is_null());
    QVERIFY(result.json["width"] == 24 && result.json["height"] == 16 && result.json["samples"] == 8);
    QCOMPARE(result.json["counters"]["cameraRays"].get<int>(), 24 * 16 * 8);
    QVERIFY(result.json["counters"]["shadowRays"].get<int>() > 0 &&
            result.json["counters"]["bounceRays"].get<int>() > 0);
    QVERIFY(result.json["fireflies"]["brightest"].get<double>() > 1);
    QVERIFY(result.json["seconds"].get<double>() > 0);
    QCOMPARE(exrAttribute(out, "samples"), std::string("8"));
    QCOMPARE(exrAttribute(out, "scene"), std::string("sphere-under-lamp"));
    QCOMPARE(exrAttribute(out, "seed"), std::string("7"));
    QCOMPARE(exrAttribute(out, "material"), matte_.toStdString());
    QCOMPARE(exrAttribute(out, "effects"),
             std::string("emitted-light, direct-light, cast-shadows, interreflection, area-light-sampling"));
    QCOMPARE(exrAttribute(out, "reflections"), std::to_string(result.json["reflections"].get<int>()));
    QVERIFY(pictureAt(out).width == 24 && mean(pictureAt(out)) > 0);
  }

  void effectsAreToldWithoutAPicture() {
    const ToolResult reported = runTool({"render", matte_, "--scene", "bowl", "--effects"});
    VERIFY_SUCCESS(reported);
    QVERIFY(reported.out.contains("\n  self-shadowing: yes, "));
    const ToolResult json = runJson({"render", matte_, "--scene", "bowl", "--effects"});
    VERIFY_SUCCESS(json);
    QVERIFY(!json.json.contains("counters") && json.json["plan"].size() == effectCount);
    QCOMPARE(runTool({"render", matte_}).code, 2);
  }

  void effectsAreForced() {
    const QString dark = folder_.path("dark.exr"), planned = folder_.path("planned.exr"), all = folder_.path("all.exr");
    const QStringList common{"render", matte_, "--scene", "bowl", "--size", "24", "--samples", "16", "--out"};
    const ToolResult plan = runJson(common + QStringList{planned});
    VERIFY_SUCCESS(plan);
    const ToolResult off = runJson(common + QStringList{dark, "--off", "interreflection,emitted-light"});
    VERIFY_SUCCESS(off);
    QVERIFY(!decision(off.json["plan"], "interreflection")["simulated"].get<bool>());
    QVERIFY(decision(off.json["plan"], "interreflection")["calledFor"].get<bool>());
    QCOMPARE(off.json["reflections"].get<int>(), 1);
    QVERIFY(mean(pictureAt(dark)) < 0.98 * mean(pictureAt(planned)));
    const ToolResult everything = runJson(common + QStringList{all, "--everything", "--off", "emitted-light"});
    VERIFY_SUCCESS(everything);
    for (const nlohmann::json& one : everything.json["plan"])
      QCOMPARE(one["simulated"].get<bool>(), one["effect"] != "emitted-light");
    QVERIFY(everything.json["counters"]["bounceRays"] >= plan.json["counters"]["bounceRays"]);
    QVERIFY(std::abs(mean(pictureAt(all)) / mean(pictureAt(planned)) - 1) < 0.05);
    const ToolResult text = runTool({"render", matte_, "--effects", "--on", "cast-shadows"});
    QVERIFY(text.out.contains("\n  cast-shadows: yes (forced), "));
    const ToolResult coarse = runJson({"render", matte_, "--scene", "bowl", "--effects", "--remainder", "0.3"});
    QVERIFY(coarse.json["reflections"] < plan.json["reflections"]);
  }

  void effectsAreMeasured() {
    const ToolResult result =
        runJson({"render", matte_, "--scene", "two-spheres", "--effect-costs", "--size", "16", "--samples", "4"});
    VERIFY_SUCCESS(result);
    for (const nlohmann::json& one : result.json["plan"]) {
      QVERIFY(one["seconds"].is_number() && one["noise"].get<double>() > 0);
      if (one["effect"] == "direct-light") QCOMPARE(one["difference"].get<double>(), 0.0);
      if (one["effect"] == "environment-light") QVERIFY(one["difference"].get<double>() > 0.2);
    }
  }

  void severalMaterials() {
    const QString out = folder_.path("row.png");
    VERIFY_SUCCESS(
        runTool({"render", plastic_, matte_, "--scene", "row", "--size", "48x16", "--samples", "2", "--out", out}));
    QVERIFY(bytesOf(out).startsWith("\x89PNG"));
  }

  /// One distant light in the place of all others; another environment in the place of the scene's.
  void otherLights() {
    const auto plan = [&](const QString& scene, const QStringList& options) {
      return runJson(QStringList{"render", matte_, "--effects", "--scene", scene} + options).json;
    };
    for (const char* scene : {"sphere-under-lamp", "sphere-point-light", "sphere-on-plane"}) {
      const nlohmann::json json = plan(scene, {"--light", "0", "1", "0"});
      QVERIFY(decision(json["plan"], "direct-light")["simulated"].get<bool>());
      QVERIFY(!decision(json["plan"], "area-light-sampling")["simulated"].get<bool>());
      QVERIFY(json["environment"].is_null());
    }
    QVERIFY(plan("bowl", {"--environment", "furnace"})["environment"] == "furnace");
  }

  void scenesFromDisk() {
    folder_.writeText("tooth.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    folder_.writeText("own.json", R"({"format": "gonio scene", "version": 1, "environment": {"picture": "furnace"},
      "objects": [{"name": "a tooth", "shape": "mesh", "mesh": "tooth.obj", "fit": true}]})");
    for (const char* name : {"tooth.obj", "own.json"}) {
      const QString out = folder_.path("own.exr");
      VERIFY_SUCCESS(
          runTool({"render", matte_, "--scene", folder_.path(name), "--size", "16", "--samples", "4", "--out", out}));
      QVERIFY(mean(pictureAt(out)) > 0.02);
      QCOMPARE(exrAttribute(out, "scene"), QString(name).left(QString(name).indexOf('.')).toStdString());
    }
  }

  void errors_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("text");
    folder_.writeText("bad.json", R"({"format": "gonio scene", "version": 1, "objects": [{"shape": "sphere"}]})");
    const QString out = folder_.path("x.png");
    QTest::newRow("scene") << QStringList{"--scene", "teapot", "--out", out} << 1 << "(sphere, sphere-distant-light";
    QTest::newRow("file") << QStringList{"--scene", folder_.path("bad.json"), "--out", out} << 1
                          << "bad.json: objects[0].name: found nothing, expected a string";
    QTest::newRow("effect") << QStringList{"--on", "glow", "--out", out} << 2 << "emitted-light, direct-light";
    QTest::newRow("off") << QStringList{"--off", "direct-light,glow", "--out", out} << 2 << "glow";
    QTest::newRow("materials") << QStringList{matte_, "--out", out} << 2 << "found 2, expected at most 1";
    QTest::newRow("remainder") << QStringList{"--remainder", "2", "--out", out} << 2 << "remainder";
    QTest::newRow("nothing") << QStringList{} << 2 << "--out is missing";
  }
  void errors() {
    QFETCH(QStringList, arguments);
    QFETCH(int, code);
    QFETCH(QString, text);
    const ToolResult result = runTool(QStringList{"render", plastic_} + arguments);
    QCOMPARE(result.code, code);
    QVERIFY2(result.error.contains(text), qPrintable(result.error));
    QVERIFY(!QFile::exists(folder_.path("x.png")));
  }

  /// docs/scenes.md names every scene and every effect, and its example is a scene.
  void theDocumentIsTrue() {
    const std::string text = completePage("scenes").toStdString();
    for (const std::string& name : bundledSceneNames())
      QVERIFY2(text.find("\n| `" + name + "` |") != std::string::npos, name.c_str());
    for (std::size_t i = 0; i < effectCount; ++i) {
      const std::string id = effectId(Effect(i));
      QVERIFY2(text.find("\n| `" + id + "` |") != std::string::npos, id.c_str());
    }
    const std::size_t begin = text.find("\n    {\n"), end = text.find("\n    }\n");
    std::string example = text.substr(begin, end + 6 - begin);
    example.replace(example.find("vase.obj"), 8, "bowl");
    const Scene scene = parseScene(example, 2);
    QVERIFY(scene.objects.size() == 4 && materialSlotCount(scene) == 2 && scene.objects[3].emits());
  }

  /// Last of all tests.
  void zEveryKeyIsDocumented() {
    QVERIFY(seenKeys().size() > 15);
    QCOMPARE(undocumentedKeys(), QString());
  }

 private:
  TestFolder folder_{"goniotool-render"};
  QString plastic_, matte_;
};

GONIO_TEST(GoniotoolRenderTest)
}  // namespace goniotool_render_test

#include "goniotool_render_test.moc"
