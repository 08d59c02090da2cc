// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>
#include <glm/vec4.hpp>
#include <random>

#include "core/models/registry.h"
#include "offscreen_context.h"
#include "shader_pass.h"
#include "tests/core/dictionary/dictionary_test_support.h"
#include "tests/support/rounded.h"
#include "tests/support/test_program.h"
#include "transformed_space.h"
#include "widgets/interpolation/prepared_blend.h"
#include "widgets/preview/gl/subject_textures.h"

namespace blend_shader_test {
using namespace gonio;
using namespace gonio::interpolation;
using interpolation::InterpolationSpace;

constexpr int width = 64, height = 64;
constexpr HalfDifferenceGrid grid{.thetaHCount = 40, .thetaDCount = 36, .phiDCount = 32};

std::shared_ptr<const TabulatedBrdf> material(double roughness, const Rgb& colour) {
  const models::Model& model = models::ggx();
  models::ParameterValues values = models::defaultParameters(model.spec());
  values.values[*model.spec().find("roughness")] = Rgb(roughness);
  values.values[*model.spec().find("specular")] = colour;
  return bakeTable(*model.instantiate(values), grid);
}

DirectionPair rounded(const DirectionPair& pair) { return {test::rounded(pair.wi), test::rounded(pair.wo)}; }

/// The nodes that stand for directions of their own (phi_d means nothing at theta_d = 0), as many as there are pixels.
std::vector<std::size_t> someNodes() {
  const auto geometry = dictionary::GridGeometry::of(grid);
  std::vector<std::size_t> nodes;
  for (std::size_t cell = 0; cell < grid.size(); cell += 7) {
    const bool isUnique = cell / std::size_t(grid.phiDCount) % std::size_t(grid.thetaDCount) != 0;
    if (isUnique && geometry->aboveHorizon[cell] && nodes.size() < std::size_t(width * height)) nodes.push_back(cell);
  }
  return nodes;
}

/// Whether the filter finds values at all eight corners about a pair.
bool isAmidValidCells(const DirectionPair& pair) {
  const auto geometry = dictionary::GridGeometry::of(grid);
  const auto at = grid.position(toHalfDifference(pair.wi, pair.wo));
  const int h = int(at.thetaH), d = int(at.thetaD), phi = int(at.phiD);
  for (int corner = 0; corner < 8; ++corner) {
    const int i = std::min(h + (corner & 1), grid.thetaHCount - 1),
              j = std::min(d + (corner >> 1 & 1), grid.thetaDCount - 1), k = (phi + (corner >> 2)) % grid.phiDCount;
    if (!geometry->aboveHorizon[grid.index(i, j, k)]) return false;
  }
  return true;
}

/// How much a mixture's values change from a node to those about it, at most, over all channels and materials.
double changeAbout(const interpolation::TransformedMixture& mixture, std::size_t node) {
  const int k = int(node) % grid.phiDCount, j = int(node) / grid.phiDCount % grid.thetaDCount,
            i = int(node) / (grid.phiDCount * grid.thetaDCount);
  float most = 0;
  for (const interpolation::TransformedTable& table : mixture.tables)
    for (int about = 0; about < 27; ++about) {
      const std::size_t other = grid.index(std::clamp(i + about / 9 - 1, 0, grid.thetaHCount - 1),
                                           std::clamp(j + about / 3 % 3 - 1, 0, grid.thetaDCount - 1),
                                           (k + about % 3 - 1 + grid.phiDCount) % grid.phiDCount);
      if (!table.valid[other]) continue;
      for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(table.values[other][c] - table.values[node][c]));
    }
  return most;
}

/// By how much a mixture's values differ, at most, between the eight corners about a pair.
double spreadAbout(const interpolation::TransformedMixture& mixture, std::span<const double> weights,
                   const DirectionPair& pair) {
  const auto geometry = dictionary::GridGeometry::of(grid);
  const auto at = grid.position(toHalfDifference(pair.wi, pair.wo));
  Rgb low(1e30), high(-1e30);
  for (int corner = 0; corner < 8; ++corner) {
    const std::size_t cell = grid.index(std::min(int(at.thetaH) + (corner & 1), grid.thetaHCount - 1),
                                        std::min(int(at.thetaD) + (corner >> 1 & 1), grid.thetaDCount - 1),
                                        (int(at.phiD) + (corner >> 2)) % grid.phiDCount);
    Rgb sum(0);
    for (std::size_t m = 0; m < weights.size(); ++m) sum += weights[m] * Rgb(mixture.tables[m].values[cell]);
    for (int c = 0; c < 3; ++c)
      sum[c] = inverseTransformed(mixture.transform, sum[c], double(geometry->weights[Eigen::Index(cell)]));
    low = glm::min(low, sum);
    high = glm::max(high, sum);
  }
  const Rgb spread = high - low;
  return std::max({spread.x, spread.y, spread.z});
}

std::vector<DirectionPair> pairsAmidValidCells() {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto direction = [&] { return fromSpherical(std::acos(uniform(random)), 2 * pi * uniform(random)); };
  std::vector<DirectionPair> pairs;
  while (pairs.size() < std::size_t(width * height)) {
    const DirectionPair pair = rounded(DirectionPair{direction(), direction()});
    if (isAmidValidCells(pair)) pairs.push_back(pair);
  }
  return pairs;
}

/// preview/blend.glsl, pair by pair, against the interpolation that it stands for.
class BlendShaderTest : public QObject, protected QOpenGLFunctions_4_1_Core {
  Q_OBJECT
 private:
  std::unique_ptr<test::OffscreenContext> m_context;
  widgets::PreviewResources m_resources;

  GLuint directions(const std::vector<DirectionPair>& pairs, Direction DirectionPair::*which, int unit) {
    std::vector<glm::vec3> texels(std::size_t(width * height), glm::vec3(0, 0, 1));
    for (std::size_t i = 0; i < pairs.size(); ++i) texels[i] = glm::vec3(pairs[i].*which);
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glActiveTexture(GL_TEXTURE0 + GLenum(unit));
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, width, height, 0, GL_RGB, GL_FLOAT, texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
  }

  /// What the shader says of at most width x height pairs.
  std::vector<glm::vec4> shown(const widgets::PreviewBlend& blend, const std::vector<DirectionPair>& pairs) {
    QStringList definitions, preamble;
    widgets::BlendTextures::addVariant(blend, definitions, preamble);
    const QByteArray fragment = widgets::assembleShader("preview/blend.glsl", definitions, preamble) + R"(
uniform sampler2D wiTexture, woTexture;
out vec4 value;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  value = vec4(evaluateBlend(texelFetch(wiTexture, at, 0).xyz, texelFetch(woTexture, at, 0).xyz), 1.0);
}
)";
    widgets::BlendTextures textures;
    GLuint inputs[2]{};
    auto values = test::shaderPass(m_resources, fragment, width, height, [&](QOpenGLShaderProgram& program) {
      textures.bind(*this, program, m_resources, blend);
      inputs[0] = directions(pairs, &DirectionPair::wi, 0);
      inputs[1] = directions(pairs, &DirectionPair::wo, 1);
      program.setUniformValue("wiTexture", 0);
      program.setUniformValue("woTexture", 1);
    });
    glDeleteTextures(2, inputs);
    values.resize(pairs.size());
    return values;
  }

 private Q_SLOTS:
  void initTestCase() {
    m_context = std::make_unique<test::OffscreenContext>();
    if (!m_context->isValid()) QSKIP("no OpenGL 4.1 core context on this machine");
    QVERIFY(initializeOpenGLFunctions());
    m_resources.initialize();
  }
  void cleanupTestCase() {
    if (m_context && m_context->isValid()) m_resources.release();
  }

  void nodesOfEveryTransform_data() {
    QTest::addColumn<int>("transform");
    for (std::size_t t = 0; t < dataTransformNames.size(); ++t) QTest::newRow(dataTransformNames[t].data()) << int(t);
  }
  /// At a node nothing is interpolated: the closed form of two numbers, whatever core does. Three things round: the
  /// arithmetic; the cosines, of directions in single precision; and the place of a node, which the look-up finds to
  /// about 1e-4 of a cell. Toward the horizon the cosine-weighted values change by much of themselves from cell to
  /// cell.
  void nodesOfEveryTransform() {
    QFETCH(int, transform);
    const auto kind = DataTransform(transform);
    const std::vector<interpolation::Interpolation::Table> tables{material(0.3, {0.9, 0.5, 0.2}),
                                                                  material(0.6, {0.2, 0.6, 0.9})};
    const auto space = std::make_shared<const test::TransformedSpace>(tables, kind);
    const std::vector<double> weights{0.3, 0.7};
    const std::vector<std::size_t> nodes = someNodes();
    std::vector<DirectionPair> pairs;
    for (const std::size_t node : nodes) pairs.push_back(grid.directions(node));
    const auto mixture = std::make_shared<const interpolation::TransformedMixture>(*space->mixture());
    const auto values = shown({.interpolation = space, .mixture = mixture, .weights = weights}, pairs);
    double worst = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double w = cosineWeight(pairs[i].wi.z, pairs[i].wo.z);
      const double cosineError = 2e-7 / std::max(std::min(pairs[i].wi.z, pairs[i].wo.z), 1e-3);
      const double placeError = 1e-4 * changeAbout(*mixture, nodes[i]);
      for (int c = 0; c < 3; ++c) {
        double y = 0;
        for (std::size_t m = 0; m < 2; ++m) y += weights[m] * transformed(kind, tables[m]->values()[nodes[i]][c], w);
        const double allowed = (1e-5 + cosineError) * y + placeError;
        const double error = std::abs(transformed(kind, values[i][c], w) - y);
        worst = std::max(worst, error / allowed);
        QVERIFY2(error <= allowed, qPrintable(QString("node %1, channel %2: off by %3 of %4, allowed %5")
                                                  .arg(nodes[i])
                                                  .arg(c)
                                                  .arg(error)
                                                  .arg(y)
                                                  .arg(allowed)));
      }
    }
    qInfo("%zu nodes, largest error %.2g of the allowed one", nodes.size(), worst);
  }

  void measuredDetail_data() {
    QTest::addColumn<int>("space");
    for (const auto space :
         {InterpolationSpace::parameters, InterpolationSpace::factors, InterpolationSpace::dictionary})
      QTest::newRow(interpolationSpaceNames[std::size_t(space)].data()) << int(space);
  }
  /// The measured detail of three materials, pair by pair: the change of the space, in both orders of the directions
  /// where it is that of factors, and the lower bound, which acts at some pairs. The mean error is a few thousandths of
  /// the mean change of the space: the graphics card filters tables and curves in single precision.
  void measuredDetail() {
    QFETCH(int, space);
    std::mt19937_64 random(4);
    auto ensemble = std::make_shared<dictionary::Ensemble>();
    ensemble->grid = grid;
    for (int d = 0; d < 2; ++d)
      ensemble->dictionaries.push_back(
          {dictionary::test_support::randomDictionary(dictionary::modeSizes(grid), random), 10});
    const std::vector<interpolation::InterpolationMaterial> ends{
        {material(0.15, {0.9, 0.5, 0.2})}, {material(0.6, {0.2, 0.6, 0.9})}, {material(0.4, {0.2, 0.2, 0.2})}};
    interpolation::InterpolationOptions made{.ensemble = ensemble, .encode = {.coefficients = 400}};
    made.pdv.terms = 2;
    const auto blend = widgets::prepareBlend(InterpolationSpace(space), ends, made);
    const std::vector<double> weights{0.4, 0.59, 0.01};
    const auto subject = widgets::blendSubject(*blend, weights);
    const auto& mixed = std::get<widgets::PreviewBlend>(subject.shown);
    QVERIFY(mixed.preservesDetail());
    QCOMPARE(mixed.bothOrders, InterpolationSpace(space) == InterpolationSpace::factors);
    const auto pairs = pairsAmidValidCells();
    const auto values = shown(mixed, pairs);
    std::vector<Rgb> expected(pairs.size()), linear(pairs.size());
    blend->interpolation->brdf(weights)->evaluate(pairs, expected);
    widgets::prepareBlend(InterpolationSpace::linear, ends)->interpolation->brdf(weights)->evaluate(pairs, linear);
    double error = 0, change = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i)
      for (int c = 0; c < 3; ++c) {
        error += std::abs(expected[i][c] - double(values[i][c]));
        change += std::abs(expected[i][c] - linear[i][c]);
      }
    qInfo("mean error %.2g of the change, which is %.2g", error / change, change / double(3 * pairs.size()));
    QVERIFY2(error < 4e-3 * change, qPrintable(QString::number(error / change)));
  }

  void dictionarySpace_data() {
    QTest::addColumn<int>("transform");
    for (const DataTransform transform :
         {DataTransform::logPlus, DataTransform::cosineLog, DataTransform::root, DataTransform::logPlusTenth,
          DataTransform::logPlusHundredth, DataTransform::gamma15, DataTransform::gamma25, DataTransform::gamma3})
      QTest::newRow(dataTransformNames[std::size_t(transform)].data()) << int(transform);
  }
  /// Codes over several dictionaries: the mixture of decoded tables in the shader is the interpolated code in core,
  /// between the nodes too, where all corners have values. The look-up finds a place to about 1e-4 of a cell along each
  /// axis.
  void dictionarySpace() {
    QFETCH(int, transform);
    std::mt19937_64 random(4);
    auto ensemble = std::make_shared<dictionary::Ensemble>();
    ensemble->grid = grid;
    for (int d = 0; d < 3; ++d)
      ensemble->dictionaries.push_back(
          {dictionary::test_support::randomDictionary(dictionary::modeSizes(grid), random), 10});
    std::vector<interpolation::InterpolationMaterial> ends{{material(0.3, {0.9, 0.5, 0.2})},
                                                           {material(0.6, {0.2, 0.6, 0.9})}};
    for (std::size_t m = 0; m < 2; ++m) {
      dictionary::SparseCode code{.grid = grid, .transform = DataTransform(transform), .channels = {}};
      for (std::size_t c = 0; c < 3; ++c) {
        code.channels[c].dictionary = int(m + (c == 2));
        for (int k = 0; k < 20; ++k)
          code.channels[c].coefficients.push_back(
              {std::uint32_t(k * 2003 + random() % 2003), float(40.0 * double(random() % 1000) / 1000)});
      }
      ends[m].code = std::make_shared<const dictionary::SparseCode>(code);
    }
    // Nothing is cut: across dictionaries the blend is dense.
    const auto blend =
        widgets::prepareBlend(InterpolationSpace::dictionary, ends,
                              {.preserveDetail = false, .ensemble = ensemble, .codeCoefficients = grid.size()});
    const std::vector<double> weights{0.4, 0.6};
    const auto subject = widgets::blendSubject(*blend, weights);
    QVERIFY(std::holds_alternative<widgets::PreviewBlend>(subject.shown));
    auto pairs = pairsAmidValidCells();
    pairs.resize(256);
    const auto values = shown(std::get<widgets::PreviewBlend>(subject.shown), pairs);
    std::vector<Rgb> expected(pairs.size());
    blend->interpolation->brdf(weights)->evaluate(pairs, expected);
    const auto& mixture = *std::get<widgets::PreviewBlend>(subject.shown).mixture;
    double worst = 0, largest = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const double placeError = 3e-4 * spreadAbout(mixture, weights, pairs[i]);
      for (int c = 0; c < 3; ++c) {
        worst = std::max(worst, std::abs(expected[i][c] - values[i][c]) / (placeError + 1e-5 * (1 + expected[i][c])));
        largest = std::max(largest, expected[i][c]);
      }
    }
    qInfo("values to %.2g, largest error %.2g of the allowed one", largest, worst);
    QVERIFY(largest > 0.1);
    QVERIFY2(worst <= 1, qPrintable(QString::number(worst)));
  }
};

GONIO_TEST(BlendShaderTest)
}  // namespace blend_shader_test

#include "blend_shader_test.moc"
