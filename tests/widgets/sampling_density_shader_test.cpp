// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>

#include "core/dictionary/decode.h"
#include "core/materials/dictionary_file.h"
#include "tests/support/code_files.h"
#include "tests/support/random_directions.h"
#include "tests/support/rounded.h"
#include "tests/support/test_program.h"
#include "tests/widgets/offscreen_context.h"
#include "tests/widgets/shader_pass.h"
#include "widgets/preview/gl/subject_textures.h"

namespace sampling_density_shader_test {
using namespace gonio;

constexpr int side = 64, count = side * side;

/// A measured material with a sharp highlight, which no single density samples well.
std::shared_ptr<const TabulatedBrdf> sharpMaterial() {
  return dictionary::decode(materials::bundledEnsemble(materials::bundledIds().back())->ensemble,
                            test::readCodeFile("ilm_solo_m_68"));
}

/// What the shader draws for a viewer and three numbers, and its density there.
struct Drawn {
  Direction wi;
  double density = 0;
};

/// shaders/preview/sampling_density.glsl, sample by sample.
class SamplingDensityShaderTest : public QObject, protected QOpenGLFunctions_4_1_Core {
  Q_OBJECT
 private:
  std::unique_ptr<test::OffscreenContext> context_;
  widgets::PreviewResources resources_;
  const std::shared_ptr<const TabulatedBrdf> table_ = sharpMaterial();
  const std::shared_ptr<const TabulatedDensity> lobe_ = std::make_shared<const TabulatedDensity>(*table_);

  void upload(widgets::TextureSet& textures, std::size_t index, int unit, const std::vector<glm::vec3>& values) {
    std::vector<glm::vec4> texels;
    for (const glm::vec3& value : values) texels.emplace_back(value, 0);
    textures.bind(*this, index, GL_TEXTURE_2D, unit);
    widgets::uploadFloats(*this, 4, side, side, &texels.front().x);
  }

  /// @param viewers, numbers `count` of each.
  std::vector<Drawn> drawn(const std::vector<glm::vec3>& viewers, const std::vector<glm::vec3>& numbers) {
    const QByteArray fragment = widgets::assembleShader("preview/sampling_density.glsl") + R"(
uniform sampler2D viewers, numbers;
out vec4 drawn;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec3 wo = texelFetch(viewers, at, 0).xyz;
  vec3 wi = sampleDensity(wo, texelFetch(numbers, at, 0).xyz);
  drawn = vec4(wi, samplingDensity(wi, wo));
}
)";
    widgets::SubjectTextures subject;
    widgets::TextureSet inputs;
    const auto values = test::shaderPass(resources_, fragment, side, side, [&](QOpenGLShaderProgram& program) {
      subject.bind(*this, program, resources_, widgets::measuredSubject(table_, lobe_), true);
      upload(inputs, 0, widgets::environmentUnit, viewers);
      upload(inputs, 1, widgets::lightPoolUnit, numbers);
      program.setUniformValue("viewers", widgets::environmentUnit);
      program.setUniformValue("numbers", widgets::lightPoolUnit);
    });
    subject.release(this);
    std::vector<Drawn> result;
    for (const glm::vec4& value : values) result.push_back({Direction(value), double(value.w)});
    return result;
  }

 private Q_SLOTS:
  void initTestCase() {
    context_ = std::make_unique<test::OffscreenContext>();
    if (!context_->isValid()) QSKIP("no OpenGL 4.1 core context on this machine");
    QVERIFY(initializeOpenGLFunctions());
    resources_.initialize();
    QVERIFY(!lobe_->symmetricDensity());
  }
  void cleanupTestCase() {
    if (context_ && context_->isValid()) resources_.release();
  }

  /// A quarter of the numbers are those at the start of the unit interval, which single precision hits: they draw the
  /// mirror direction and its closest neighbours. Also there a sample weighs no more than the material reflects: a
  /// density that vanishes would show as white pixels.
  void noSampleWeighsMoreThanTheMaterial() {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<glm::vec3> viewers, numbers;
    for (int i = 0; i < count; ++i) {
      viewers.emplace_back(test::rounded(test::randomUpper(random)));
      numbers.emplace_back(uniform(random), i % 4 == 0 ? std::ldexp(float(i / 4 % 16), -24) : uniform(random),
                           i % 8 == 0 ? std::ldexp(float(i / 8 % 16), -24) : uniform(random));
    }
    const std::vector<Drawn> samples = drawn(viewers, numbers);
    int above = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const Direction &wi = samples[i].wi, wo(viewers[i]);
      if (!(wi.z > 1e-3)) continue;
      ++above;
      const Rgb value = table_->evaluate(wi, wo);
      const double weight = value.g * wi.z / samples[i].density;
      QVERIFY2(
          weight < 2,
          qPrintable(QString("sample %1 weighs %2, at a density of %3").arg(i).arg(weight).arg(samples[i].density)));
    }
    QVERIFY(above > count / 2);
  }

  /// The density is that of the core, but where the half vector is within rounding of the normal.
  void densityIsThatOfTheCore() {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<glm::vec3> viewers, numbers;
    while (viewers.size() < count) {
      viewers.emplace_back(test::rounded(test::randomUpper(random)));
      numbers.emplace_back(uniform(random), uniform(random), uniform(random));
    }
    const std::vector<Drawn> samples = drawn(viewers, numbers);
    std::vector<double> errors;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const Direction wi = glm::normalize(samples[i].wi), wo = glm::normalize(Direction(viewers[i]));
      if (!(wi.z > 1e-3) || std::hypot(wi.x + wo.x, wi.y + wo.y) < 1e-4) continue;
      errors.push_back(std::abs(samples[i].density / tabulatedMixture(*lobe_).pdf(wi, wo) - 1));
    }
    QVERIFY(errors.size() > count / 2);
    std::ranges::sort(errors);
    const double most = errors[errors.size() * 99 / 100];
    QVERIFY2(most < 0.02, qPrintable(QString("1 % of the densities are off by over %1").arg(most)));
  }
};

GONIO_TEST(SamplingDensityShaderTest)
}  // namespace sampling_density_shader_test

#include "sampling_density_shader_test.moc"
