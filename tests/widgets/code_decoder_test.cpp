// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/code_decoder.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>

#include "code_decoding_bound.h"
#include "core/materials/dictionary_file.h"
#include "core/support/error.h"
#include "offscreen_context.h"
#include "tests/support/code_files.h"
#include "tests/support/linear_oracles.h"
#include "tests/support/sphere_preview.h"
#include "tests/support/test_program.h"
#include "widgets/preview/gl/preview_renderer.h"
#include "widgets/preview/gl/textures.h"

namespace code_decoder_test {
using namespace gonio;
using namespace gonio::rendering;
using dictionary::Ensemble;
using dictionary::GridGeometry;
using dictionary::SparseCode;
using test::ensembleOn;
using test::oddGrid;
using test::randomCode;

/// Codes decoded on the graphics card against those decoded in core.
class CodeDecoderTest : public QObject, protected QOpenGLFunctions_4_1_Core {
  Q_OBJECT
 private:
  std::unique_ptr<test::OffscreenContext> m_context;
  widgets::ProgramCache m_programs;
  widgets::CodeDecoder m_decoder;

  std::vector<glm::vec4> texelsOf(GLuint texture, const HalfDifferenceGrid& grid) {
    std::vector<glm::vec4> texels(grid.size());
    glBindTexture(GL_TEXTURE_3D, texture);
    glGetTexImage(GL_TEXTURE_3D, 0, GL_RGBA, GL_FLOAT, texels.data());
    return texels;
  }
  std::vector<glm::vec4> decoded(const Ensemble& ensemble, const SparseCode& code) {
    GLuint texture = 0;
    m_decoder.decode(*this, m_programs, widgets::codeTexels(ensemble, code), texture);
    const auto texels = texelsOf(texture, code.grid);
    glDeleteTextures(1, &texture);
    return texels;
  }

  /// Every node of every channel within what single precision leaves open.
  void compareWithCore(const Ensemble& ensemble, const SparseCode& code) {
    const auto table = dictionary::decode(ensemble, code);
    const auto texels = decoded(ensemble, code);
    double worst = 0;
    for (int c = 0; c < 3; ++c) {
      const std::vector<double> allowed = test::allowedErrors(ensemble, code, c, *table);
      for (std::size_t cell = 0; cell < code.grid.size(); ++cell) {
        QCOMPARE(texels[cell].a, float(table->valid()[cell]));
        const double expected = table->values()[cell][c], found = texels[cell][c];
        const auto what = [&] {
          return QString("cell %1, channel %2: %3, expected %4, allowed %5").arg(cell).arg(c).arg(found).arg(expected);
        };
        QVERIFY2(std::abs(found - expected) <= allowed[cell], qPrintable(what().arg(allowed[cell])));
        if (allowed[cell] > 0) worst = std::max(worst, std::abs(found - expected) / allowed[cell]);
      }
    }
    qInfo("largest error %.2g of the allowed one", worst);
  }

 private Q_SLOTS:
  void initTestCase() {
    m_context = std::make_unique<test::OffscreenContext>();
    if (!m_context->isValid()) QSKIP("no OpenGL 4.1 core context on this machine");
    QVERIFY(initializeOpenGLFunctions());
  }
  void cleanupTestCase() {
    if (!m_context || !m_context->isValid()) return;
    m_decoder.release(*this);
    m_programs.release(*this);
    QCOMPARE(glGetError(), GLenum(GL_NO_ERROR));
  }

  /// Channels with different dictionaries and counts, in every transform.
  void randomCodes() {
    const Ensemble ensemble = ensembleOn(oddGrid, 3);
    for (const DataTransform transform :
         {DataTransform::logPlus, DataTransform::cosineLog, DataTransform::root, DataTransform::none}) {
      compareWithCore(ensemble, randomCode(ensemble, transform, {40, 90, 1}));
      if (QTest::currentTestFailed()) return;
    }
  }

  /// A grid whose phi_d is not folded, and one grid after another by the same decoder.
  void anotherGrid() {
    const HalfDifferenceGrid unfolded{.thetaHCount = 16, .thetaDCount = 9, .phiDCount = 10, .reciprocal = false};
    const Ensemble ensemble = ensembleOn(unfolded, 2);
    compareWithCore(ensemble, randomCode(ensemble, DataTransform::cosineLog, {30, 20, 25}));
  }

  /// Codes of both orders of the directions, with negative values.
  void bothOrders() {
    const Ensemble half = ensembleOn(oddGrid, 2), both = dictionary::inBothOrders(half);
    SparseCode code = randomCode(both, DataTransform::cosineLog, {30, 20, 25});
    for (auto& channel : code.channels) channel.lowest = -0.3f;
    compareWithCore(both, code);
    const auto texels = decoded(half, code);
    QVERIFY(texels == decoded(both, code));
    QVERIFY(std::ranges::any_of(texels, [](const glm::vec4& texel) { return texel.g < -0.1f; }));
  }

  /// All coefficients that there are.
  void aFullCode() {
    const Ensemble ensemble = ensembleOn(oddGrid, 1);
    const int all = int(oddGrid.size());
    SparseCode code = randomCode(ensemble, DataTransform::logPlus, {all, all, all});
    for (auto& channel : code.channels)
      for (auto& c : channel.coefficients) c.value *= 0.1f;
    compareWithCore(ensemble, code);
  }

  /// A code of many coefficients, at every node of a MERL grid, in both transforms.
  void codeOfAMetallicPaint() {
    const auto bundled = materials::bundledEnsemble(materials::bundledIds().back());
    SparseCode code = test::readCodeFile("ilm_solo_m_68");
    QVERIFY(code.coefficients() > 1000);
    compareWithCore(bundled->ensemble, code);
    if (QTest::currentTestFailed()) return;
    // The same numbers as those of the other transform: another material, as smooth as this one.
    code.transform = code.transform == DataTransform::logPlus ? DataTransform::cosineLog : DataTransform::logPlus;
    compareWithCore(bundled->ensemble, code);
  }

  /// No coefficients: black wherever there are values, whether one channel has none or all.
  void noCoefficients() {
    const Ensemble ensemble = ensembleOn(oddGrid, 2);
    for (const std::array<int, 3> counts : {std::array{0, 0, 0}, std::array{20, 0, 5}}) {
      const auto code = randomCode(ensemble, DataTransform::logPlus, counts);
      const auto texels = decoded(ensemble, code);
      const auto geometry = GridGeometry::of(oddGrid);
      for (std::size_t cell = 0; cell < texels.size(); ++cell) {
        QCOMPARE(texels[cell].g, 0.0f);
        QCOMPARE(texels[cell].a, float(geometry->aboveHorizon[cell]));
      }
      compareWithCore(ensemble, code);
    }
  }

  /// One coefficient of an atom that is the cell scaling itself is one transformed value everywhere: the closed form.
  void aConstantDictionary() {
    const auto geometry = GridGeometry::of(oddGrid);
    Ensemble ensemble = ensembleOn(oddGrid, 1);
    double scale = 1;
    for (std::size_t mode = 0; mode < 3; ++mode) {
      Eigen::MatrixXd columns = ensemble.dictionaries[0].modes[mode];
      columns.col(0) = geometry->cellScaling[mode].matrix();
      scale *= columns.col(0).norm();
      ensemble.dictionaries[0].modes[mode] = test::orthonormalised(columns);
      if (ensemble.dictionaries[0].modes[mode](0, 0) < 0) ensemble.dictionaries[0].modes[mode].col(0) *= -1;
    }
    SparseCode code{.grid = oddGrid, .transform = DataTransform::cosineLog, .channels = {}};
    const std::array<double, 3> y{0.001, 0.7, 5};
    for (std::size_t c = 0; c < 3; ++c) code.channels[c].coefficients = {{0, float(y[c] * scale)}};
    const auto texels = decoded(ensemble, code);
    for (std::size_t cell = 0; cell < texels.size(); ++cell)
      for (int c = 0; c < 3; ++c) {
        const double expected =
            geometry->aboveHorizon[cell] ? std::expm1(y[std::size_t(c)]) / geometry->weights[Eigen::Index(cell)] : 0;
        QVERIFY2(std::abs(texels[cell][c] - expected) <= 3e-6 * expected, qPrintable(QString::number(cell)));
      }
  }

  /// Transformed values that pass the bound are the bound; those below 0 are 0; without a bound the largest float is.
  void boundsAreKept() {
    const Ensemble ensemble = ensembleOn(oddGrid, 1);
    SparseCode code = randomCode(ensemble, DataTransform::cosineLog, {30, 30, 30});
    for (auto& channel : code.channels)
      for (auto& c : channel.coefficients) c.value *= 1000;
    code.channels[0].highest = 2;
    code.channels[1].highest = 0.5f;
    const auto texels = decoded(ensemble, code);
    const auto table = dictionary::decode(ensemble, code);
    const auto geometry = GridGeometry::of(oddGrid);
    int zeros = 0, bounded = 0, largest = 0;
    for (std::size_t cell = 0; cell < texels.size(); ++cell) {
      if (table->valid()[cell] == 0) continue;
      const double reached = std::expm1(2.0) / geometry->weights[Eigen::Index(cell)];
      QVERIFY(texels[cell].r <= reached * (1 + 1e-6));
      QVERIFY(std::isfinite(texels[cell].b));
      zeros += texels[cell].r == 0;
      bounded += std::abs(texels[cell].r - reached) <= 1e-6 * reached;
      largest += texels[cell].b == std::numeric_limits<float>::max();
      QCOMPARE(texels[cell].b == std::numeric_limits<float>::max(),
               table->values()[cell].b == std::numeric_limits<float>::max());
    }
    QVERIFY(zeros > 0 && bounded > 0 && largest > 0);
  }

  /// The texture is that of an uploaded table in everything that a shader can observe.
  void theTextureIsThatOfATable() {
    const Ensemble ensemble = ensembleOn(oddGrid, 2);
    const SparseCode code = randomCode(ensemble, DataTransform::logPlus, {20, 20, 20});
    const auto table = dictionary::decode(ensemble, code);
    GLuint uploaded = 0, texture = 0;
    widgets::uploadTable(*this, uploaded, oddGrid, table->values(), table->valid());
    m_decoder.decode(*this, m_programs, widgets::codeTexels(ensemble, code), texture);
    QVERIFY(texture != 0 && texture != uploaded);
    const auto properties = [this](GLuint name) {
      std::vector<GLint> values;
      glBindTexture(GL_TEXTURE_3D, name);
      for (const GLenum level : {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_DEPTH, GL_TEXTURE_INTERNAL_FORMAT})
        glGetTexLevelParameteriv(GL_TEXTURE_3D, 0, level, &values.emplace_back());
      for (const GLenum name2 :
           {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glGetTexParameteriv(GL_TEXTURE_3D, name2, &values.emplace_back());
      return values;
    };
    QCOMPARE(properties(texture), properties(uploaded));
    QCOMPARE(properties(texture).front(), oddGrid.phiDCount);
    // A texture that is there is filled anew.
    const GLuint first = texture;
    m_decoder.decode(*this, m_programs, widgets::codeTexels(ensemble, code.truncated(3)), texture);
    QCOMPARE(texture, first);
    QCOMPARE(texelsOf(texture, oddGrid), decoded(ensemble, code.truncated(3)));
    glDeleteTextures(1, &uploaded);
    glDeleteTextures(1, &texture);
  }

  /// Decoding happens in the middle of a frame: what is drawn into, and how, is as before.
  void whatIsBoundStays() {
    const Ensemble ensemble = ensembleOn(oddGrid, 1);
    const auto texels = widgets::codeTexels(ensemble, randomCode(ensemble, DataTransform::logPlus, {5, 5, 5}));
    GLuint framebuffer = 0, texture = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(1, 2, 3, 4);
    for (const GLenum capability : {GL_BLEND, GL_SCISSOR_TEST}) glEnable(capability);
    for (const GLenum capability : {GL_DEPTH_TEST, GL_CULL_FACE}) glDisable(capability);
    glActiveTexture(GL_TEXTURE2);
    QOpenGLShaderProgram& program = m_programs.program("preview/decode_fibres.frag");
    program.bind();
    m_decoder.decode(*this, m_programs, texels, texture);
    GLint bound[4] = {};
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, bound);
    QCOMPARE(bound[0], GLint(framebuffer));
    glGetIntegerv(GL_CURRENT_PROGRAM, bound);
    QCOMPARE(bound[0], GLint(program.programId()));
    glGetIntegerv(GL_ACTIVE_TEXTURE, bound);
    QCOMPARE(bound[0], GL_TEXTURE2);
    glGetIntegerv(GL_TEXTURE_BINDING_3D, bound);
    QCOMPARE(bound[0], GLint(texture));
    glGetIntegerv(GL_VIEWPORT, bound);
    for (int i = 0; i < 4; ++i) QCOMPARE(bound[i], i + 1);
    for (const GLenum capability : {GL_BLEND, GL_SCISSOR_TEST}) QVERIFY(glIsEnabled(capability));
    for (const GLenum capability : {GL_DEPTH_TEST, GL_CULL_FACE}) QVERIFY(!glIsEnabled(capability));
    for (const GLenum capability : {GL_BLEND, GL_SCISSOR_TEST}) glDisable(capability);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
  }

  /// A picture of a code that the card decodes is that of the decoded table.
  void pictures() {
    const auto ensemble = std::make_shared<const Ensemble>(ensembleOn(oddGrid, 2));
    auto code = std::make_shared<widgets::EnsembleCode>(
        widgets::EnsembleCode{ensemble, randomCode(*ensemble, DataTransform::logPlus, {20, 20, 20})});
    const auto resources = std::make_shared<widgets::PreviewResources>();
    resources->initialize();
    const auto drawn = [&](bool onTheCard) {
      resources->setDecodesCodes(onTheCard);
      widgets::PreviewRenderer renderer(resources);
      renderer.initialize();
      renderer.setSubject({widgets::EditedMaterial{dictionary::decode(*ensemble, code->code), {}, code}});
      test::showSphere(renderer, sphereScene());
      renderer.setSize({32, 32});
      renderer.accumulate(4);
      const Image picture = renderer.readPicture();
      renderer.release();
      return picture;
    };
    const Image expected = drawn(false), found = drawn(true);
    double brightest = 0;
    for (std::size_t i = 0; i < found.pixels.size(); ++i) {
      const float size = glm::length(expected.pixels[i]);
      QVERIFY(glm::length(found.pixels[i] - expected.pixels[i]) <= 1e-4f * (1 + size));
      brightest = std::max(brightest, double(size));
    }
    QVERIFY(brightest > 0.1);
    QVERIFY2(found.pixels != expected.pixels, "the card is expected to round differently: was it asked at all?");
    resources->release();
  }

  /// What the card cannot hold, it is not asked for.
  void tooLargeCodesDoNotFit() {
    const Ensemble ensemble = ensembleOn(oddGrid, 1);
    auto texels = widgets::codeTexels(ensemble, randomCode(ensemble, DataTransform::logPlus, {5, 5, 5}));
    QVERIFY(widgets::CodeDecoder::fits(*this, texels));
    // One thing after the other is too large: the side of a picture by its rows of groups, of slabs; a list.
    GLint side = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &side);
    const widgets::CodeTexels small = texels;
    texels.groups = side;
    QVERIFY(widgets::CodeDecoder::fits(*this, texels));
    texels.groups = side + 1;
    QVERIFY(!widgets::CodeDecoder::fits(*this, texels));
    texels = small;
    texels.slabs = side / oddGrid.thetaDCount;
    QVERIFY(widgets::CodeDecoder::fits(*this, texels));
    ++texels.slabs;
    QVERIFY(!widgets::CodeDecoder::fits(*this, texels));
    GLint listed = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &listed);
    if (listed > 1 << 27) return;  // a list of more than a gigabyte is not tried
    texels = small;
    texels.coefficients.resize(std::size_t(listed) + 1);
    QVERIFY(!widgets::CodeDecoder::fits(*this, texels));
  }

  void wrongCodesAreRefused() {
    const Ensemble ensemble = ensembleOn(oddGrid, 1);
    SparseCode code = randomCode(ensemble, DataTransform::logPlus, {5, 5, 5});
    code.channels[1].dictionary = 1;
    QVERIFY_THROWS_EXCEPTION(Error, widgets::codeTexels(ensemble, code));
    code.channels[1].dictionary = 0;
    widgets::codeTexels(ensemble, code);
    code.channels[2].coefficients[0].index = std::uint32_t(oddGrid.size());
    QVERIFY_THROWS_EXCEPTION(Error, widgets::codeTexels(ensemble, code));
    code = randomCode(ensemble, DataTransform::logPlus, {5, 5, 5});
    code.grid.phiDCount += 1;
    QVERIFY_THROWS_EXCEPTION(Error, widgets::codeTexels(ensemble, code));
  }
};

GONIO_TEST(CodeDecoderTest)
}  // namespace code_decoder_test

#include "code_decoder_test.moc"
