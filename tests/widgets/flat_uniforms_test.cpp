// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/program_cache.h"

#include <QTest>

#include "core/models/registry.h"
#include "core/rendering/scene_file.h"
#include "tests/support/test_program.h"
#include "tests/widgets/offscreen_spheres.h"

namespace flat_uniforms_test {
using namespace gonio;
using namespace gonio::rendering;
using widgets::PassShaders;

const QByteArray vertex = "out vec2 position;\nvoid main() {\n  position = vec2(0.0);\n}\n";

PassShaders moved(const QByteArray& fragment, int vectors) {
  return widgets::withFlatUniforms({vertex, fragment}, vectors);
}

/// An edit of all parameters of a model.
editing::Edit wholeEdit(const char* id, editing::Composition composition) {
  const models::Model& model = models::findModel(id);
  editing::DifferentialEdit edit{
      .model = &model, .fitted = models::defaultParameters(model.spec()), .composition = composition};
  edit.edited = edit.fitted;
  for (std::size_t i = 0; i < edit.edited.values.size(); ++i)
    if (model.spec().parameters[i].choices.empty()) edit.edited.values[i] *= Rgb(0.9, 0.8, 0.7);
  return {edit};
}

class FlatUniformsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void declarationsAndConditions() {
    const PassShaders text = moved(
        "#version 410 core\n"
        "#define LIGHTS 2\n"
        "#define MANY 5\n"
        "#define LIST uniform vec4 a[3], b; uniform float c;\n"
        "#ifdef LIGHTS\n"
        "uniform vec3 lights[LIGHTS];  // some\n"
        "#endif\n"
        "uniform vec3 many[MANY];\n"
        "uniform vec3 unknown[OTHERS];\n"
        "uniform sampler2D table;\n"
        "LIST\n",
        31);
    const QByteArray fragment =
        "#version 410 core\n"
        "#define LIGHTS 2\n"
        "#define MANY 5\n"
        "#ifdef LIGHTS\n"
        "flat in vec3 flat_lights[2];\n#define lights flat_lights\n"
        "#endif\n"
        "uniform vec3 many[MANY];\n"
        "uniform vec3 unknown[OTHERS];\n"
        "uniform sampler2D table;\n"
        "flat in vec4 flat_a[3];\n#define a flat_a\n"
        "flat in vec4 flat_b;\n#define b flat_b\n"
        "flat in float flat_c;\n#define c flat_c\n\n";
    QCOMPARE(text.fragment, fragment);
    const QByteArray expected =
        "out vec2 position;\n"
        "#define LIGHTS 2\n"
        "#define MANY 5\n"
        "#ifdef LIGHTS\n"
        "uniform vec3 lights[2];\nflat out vec3 flat_lights[2];\n"
        "#endif\n"
        "uniform vec4 a[3];\nflat out vec4 flat_a[3];\n"
        "uniform vec4 b;\nflat out vec4 flat_b;\n"
        "uniform float c;\nflat out float flat_c;\n"
        "void main() {\n"
        "#ifdef LIGHTS\n"
        "flat_lights = lights;\n"
        "#endif\n"
        "flat_a = a;\nflat_b = b;\nflat_c = c;\n"
        "  position = vec2(0.0);\n}\n";
    QCOMPARE(text.vertex, expected);
  }

  void noMoreThanTheInputsHold() {
    const QByteArray text = "uniform mat3 axes;\nuniform vec4 four[4];\nuniform float one;\n";
    const auto isMoved = [&](int vectors, const char* name) {
      return moved(text, vectors).fragment.contains(QByteArray("flat_") + name);
    };
    QVERIFY(!isMoved(2, "axes") && isMoved(2, "one"));
    QVERIFY(isMoved(3, "axes") && !isMoved(3, "four") && !isMoved(3, "one"));
    QVERIFY(isMoved(7, "four") && !isMoved(7, "one"));
    QVERIFY(isMoved(8, "axes") && isMoved(8, "four") && isMoved(8, "one"));
  }

  /// Both kinds of programs draw the same: cards get the other one, which software OpenGL would never run.
  void thePicturesAreTheSame() {
    using editing::Composition;
    const test::OffscreenContext context;
    if (!context.isValid()) QSKIP("no OpenGL 4.1 core context on this machine");
    const auto table = test::bakedModel("abc", {});
    const auto resources = std::make_shared<widgets::PreviewResources>();
    resources->initialize();
    const editing::Edit layers = wholeEdit("layered", Composition::lobes);
    const models::Model& ggx = models::findModel("ggx");
    const std::pair<widgets::PreviewSubject, Scene> cases[] = {
        {{widgets::EditedMaterial{table, {}}}, sphereScene()},
        {{widgets::EditedMaterial{table, {{layers}}}}, sphereScene()},
        {{widgets::EditedMaterial{table, {{layers, wholeEdit("sgd", Composition::additive), layers}}}}, sphereScene()},
        {{widgets::EditedMaterial{table, {{layers}}}, std::make_shared<const TabulatedDensity>(*table)},
         sphereScene(studioEnvironment())},
        {{widgets::StandaloneModel{&ggx, models::defaultParameters(ggx.spec())}}, openScene("row")},
    };
    for (const auto& [subject, scene] : cases) {
      const Image plain = drawn(resources, subject, scene, false), flat = drawn(resources, subject, scene, true);
      double brightest = 0;
      for (std::size_t i = 0; i < plain.pixels.size(); ++i) {
        const float size = glm::length(plain.pixels[i]);
        QVERIFY(glm::length(flat.pixels[i] - plain.pixels[i]) <= 1e-4f * size);
        brightest = std::max(brightest, double(size));
      }
      QVERIFY(brightest > 0.01);
    }
    resources->release();
  }

 private:
  static Image drawn(const std::shared_ptr<widgets::PreviewResources>& resources,
                     const widgets::PreviewSubject& subject, const Scene& scene, bool flat) {
    resources->setUsesFlatUniforms(flat);
    widgets::PreviewRenderer renderer(resources);
    renderer.initialize();
    renderer.setSubject(subject);
    test::showSphere(renderer, scene);
    renderer.setSize({24, 24});
    renderer.accumulate(4);
    Image picture = renderer.readPicture();
    renderer.release();
    return picture;
  }
};

GONIO_TEST(FlatUniformsTest)
}  // namespace flat_uniforms_test

#include "flat_uniforms_test.moc"
