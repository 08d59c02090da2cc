// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QGuiApplication>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions_4_1_Core>
#include <QOpenGLShaderProgram>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <random>

#include "tests/core/models/model_test_support.h"
#include "tests/support/rounded.h"
#include "tests/support/test_program.h"
#include "tests/widgets/offscreen_context.h"
#include "widgets/preview/gl/model_uniforms.h"
#include "widgets/preview/gl/shader_library.h"

namespace model_shaders_test {
using namespace gonio;
using namespace gonio::models;
using namespace gonio::models::test_support;
using gonio::test::rounded;

constexpr int width = 64, height = 64, pairCount = width * height;

/// Pairs with an answer of their own: below the horizon, without a half vector, exact mirrors, back to the light.
std::vector<DirectionPair> specialPairs() {
  const Direction slanted = rounded(fromSpherical(1.2, 0.4)), grazing = rounded({1, 0, 1e-8}), normal(0, 0, 1);
  const auto mirrored = [](const Direction& w) { return Direction(-w.x, -w.y, w.z); };
  return {{slanted, -slanted},
          {slanted, {1, 0, 0}},
          {{1, 0, 0}, {-1, 0, 0}},
          {slanted, slanted},
          {slanted, mirrored(slanted)},
          {grazing, mirrored(grazing)},
          {grazing, grazing},
          {grazing, normal},
          {normal, normal}};
}

/// Pairs of all kinds in turn: any; about the mirror direction at all scales; grazing; nearly back to the light.
std::vector<DirectionPair> makePairs() {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<DirectionPair> pairs = specialPairs();
  while (pairs.size() < pairCount) {
    DirectionPair pair{randomDirection(random), randomDirection(random)};
    const double distance = std::pow(10, -6 + 6 * uniform(random));
    const Direction offset = distance * (randomDirection(random) - Direction(0, 0, 0.5));
    switch (pairs.size() % 4) {
      case 1:
        pair.wo = glm::normalize(Direction(-pair.wi.x, -pair.wi.y, pair.wi.z) + offset);
        break;
      case 2:
        pair.wi = fromSpherical(halfPi - distance, 2 * pi * uniform(random));
        break;
      case 3:
        pair.wo = glm::normalize(pair.wi + offset);
        break;
      default:
        break;
    }
    pair = {rounded(pair.wi), rounded(pair.wo)};
    if (pair.wi.z > 1e-6 && pair.wo.z > 1e-6) pairs.push_back(pair);
  }
  return pairs;
}

/// The values that float may lead to: exp() of an argument down to -88 that is rounded to 2^-24 is off by 5e-6, and
/// drivers add some units in the last place. Two steps of SGD amplify the rounding, so its C++ is evaluated with that
/// much less and more of what rounds: the masking takes exp(ln c + k ln(theta - theta_0)), as if c were off by k times
/// the error of theta; the Fresnel term is a difference of numbers about 1, as if F_0 were off by some units in the
/// last place. Turning a half vector into the frame of a grain rounds it by some units in the last place, as if the
/// rotation were off by as much.
struct Bounds {
  static constexpr double relativeOfC = 5e-4, absoluteOfF0 = 1e-6, absoluteOfRotation = 2e-7;
  ModelSpec::FloatError error;
  std::vector<Rgb> low, high;

  Bounds(const Model& model, const ParameterValues& parameters, std::span<const DirectionPair> pairs)
      : error(model.spec().floatError), low(pairs.size()), high(pairs.size()) {
    ParameterValues lower = parameters, higher = parameters;
    if (&model == &sgd()) {
      const std::size_t c = model.spec().find("c").value(), f0 = model.spec().find("f0").value();
      lower.values[c] *= 1 + relativeOfC;
      higher.values[c] *= 1 - relativeOfC;
      lower.values[f0] -= absoluteOfF0;
      higher.values[f0] += absoluteOfF0;
    }
    const auto rotation = model.spec().find("rotation");
    if (rotation) lower.values[*rotation] -= absoluteOfRotation, higher.values[*rotation] += absoluteOfRotation;
    model.instantiate(lower)->evaluate(pairs, low);
    model.instantiate(higher)->evaluate(pairs, high);
    // A half vector may lie on either side of a ridge.
    if (rotation)
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Rgb one = low[i];
        low[i] = glm::min(one, high[i]);
        high[i] = glm::max(one, high[i]);
      }
  }

  bool contain(std::size_t pair, int channel, double value) const {
    const double slack = error.absolute + error.relative * high[pair][channel];
    return value >= low[pair][channel] - slack && value <= high[pair][channel] + slack;
  }
};

/// The formulas as GLSL against the same, or their twins, as C++.
class ModelShadersTest : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<gonio::test::OffscreenContext> context_;
  QOpenGLFunctions_4_1_Core gl_;
  std::unique_ptr<QOpenGLFramebufferObject> target_;
  GLuint vertexArray_ = 0, textures_[2] = {};
  const std::vector<DirectionPair> pairs_ = makePairs();

  void uploadDirections(int unit, Direction DirectionPair::*which) {
    std::vector<glm::vec3> texels;
    for (const DirectionPair& pair : pairs_) texels.emplace_back(pair.*which);
    gl_.glActiveTexture(GL_TEXTURE0 + GLenum(unit));
    gl_.glBindTexture(GL_TEXTURE_2D, textures_[unit]);
    gl_.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, width, height, 0, GL_RGB, GL_FLOAT, texels.data());
    gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }

  static std::unique_ptr<QOpenGLShaderProgram> makeProgram(const Model& model) {
    const QByteArray fragment = widgets::shaderText(widgets::modelFile(model)) +
                                widgets::modelUniform(model, "parameters").toUtf8() +
                                QString(R"(
uniform sampler2D wiTexture, woTexture;
out vec4 value;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  value = vec4(%1(texelFetch(wiTexture, at, 0).xyz, texelFetch(woTexture, at, 0).xyz, parameters), 1.0);
}
)")
                                    .arg(widgets::modelFunction(model))
                                    .toUtf8();
    auto program = std::make_unique<QOpenGLShaderProgram>();
    program->addShaderFromSourceCode(QOpenGLShader::Vertex,
                                     "#version 410 core\n" + widgets::shaderText("preview/fullscreen.vert"));
    program->addShaderFromSourceCode(QOpenGLShader::Fragment, "#version 410 core\n" + fragment);
    program->link();
    return program;
  }

  std::vector<glm::vec4> draw(QOpenGLShaderProgram& program, const Model& model, const ParameterValues& parameters) {
    target_->bind();
    program.bind();
    program.setUniformValue("wiTexture", 0);
    program.setUniformValue("woTexture", 1);
    widgets::setModelUniform(program, "parameters", model, parameters);
    gl_.glViewport(0, 0, width, height);
    gl_.glBindVertexArray(vertexArray_);
    gl_.glDrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<glm::vec4> values(pairCount);
    gl_.glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, values.data());
    return values;
  }

  /// Parameters as the shader can get them: the C++ twin starts from the same floats.
  static ParameterValues roundedParameters(const ModelSpec& spec, std::mt19937_64& random) {
    ParameterValues values = randomParameters(spec, random);
    for (Rgb& value : values.values) value = Rgb(glm::vec3(value));
    return values;
  }

 private Q_SLOTS:
  void initTestCase() {
    context_ = std::make_unique<gonio::test::OffscreenContext>();
    if (!context_->isValid()) QSKIP("no OpenGL 4.1 core context here");
    QVERIFY(gl_.initializeOpenGLFunctions());
    target_ = std::make_unique<QOpenGLFramebufferObject>(width, height, QOpenGLFramebufferObject::NoAttachment,
                                                         GL_TEXTURE_2D, GL_RGBA32F);
    gl_.glGenVertexArrays(1, &vertexArray_);
    gl_.glGenTextures(2, textures_);
    uploadDirections(0, &DirectionPair::wi);
    uploadDirections(1, &DirectionPair::wo);
  }
  void cleanupTestCase() {
    target_.reset();
    context_.reset();
  }

  void sameAsCpp_data() {
    QTest::addColumn<QString>("id");
    for (const Model* model : allModels())
      QTest::newRow(std::string(model->spec().id).c_str()) << QString::fromStdString(std::string(model->spec().id));
  }
  void sameAsCpp() {
    QFETCH(QString, id);
    const Model& model = findModel(id.toStdString());
    const auto program = makeProgram(model);
    QVERIFY2(program->isLinked(), qPrintable(program->log()));
    std::mt19937_64 random(11);
    constexpr int draws = 100;
    for (int n = 0; n < draws; ++n) {
      const ParameterValues values = n == 0 ? defaultParameters(model.spec()) : roundedParameters(model.spec(), random);
      const Bounds bounds(model, values, pairs_);
      const std::vector<glm::vec4> shaded = draw(*program, model, values);
      for (std::size_t i = 0; i < pairCount; ++i)
        for (int c = 0; c < 3; ++c)
          if (!bounds.contain(i, c, shaded[i][c]))
            QFAIL(qPrintable(QString("draw %1, pair %2, channel %3: %4, expected %5 to %6")
                                 .arg(n)
                                 .arg(i)
                                 .arg(c)
                                 .arg(shaded[i][c])
                                 .arg(bounds.low[i][c])
                                 .arg(bounds.high[i][c])));
    }
  }

  void finiteAtTheCornersOfTheHardRanges_data() { sameAsCpp_data(); }
  void finiteAtTheCornersOfTheHardRanges() {
    QFETCH(QString, id);
    const Model& model = findModel(id.toStdString());
    const auto program = makeProgram(model);
    std::mt19937_64 random(5);
    constexpr int draws = 50;
    for (int n = 0; n < draws; ++n) {
      const std::vector<glm::vec4> shaded = draw(*program, model, randomCorner(model.spec(), random));
      for (const glm::vec4& value : shaded)
        for (int c = 0; c < 3; ++c) QVERIFY(std::isfinite(value[c]) && value[c] >= 0);
    }
  }
};

GONIO_TEST(ModelShadersTest)
}  // namespace model_shaders_test

#include "model_shaders_test.moc"
