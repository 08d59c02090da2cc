// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/noise_filter.h"

#include <QTest>
#include <cmath>

#include "core/metrics/image_metrics.h"
#include "core/models/model.h"
#include "core/rendering/path_tracer.h"
#include "core/rendering/scene_file.h"
#include "tests/support/test_program.h"
#include "tests/widgets/offscreen_context.h"
#include "widgets/preview/picture_drawer.h"

namespace noise_filter_test {
using namespace gonio;
using namespace gonio::rendering;

constexpr int side = 96;

std::shared_ptr<const TabulatedBrdf> rough(double roughness) {
  const models::Model& model = models::findModel("ggx");
  models::ParameterValues values = models::defaultParameters(model.spec());
  values.values[*model.spec().find("roughness")] = Rgb(roughness);
  return bakeTable(*model.instantiate(values));
}

/// Of what the screen shows, about: differences of bright pixels count as they are seen.
double visibleError(const Image& picture, const Image& reference) {
  const auto shown = [](const glm::vec3& c) { return std::pow(std::min(1.f, c.y), 1 / 2.2f); };
  double sum = 0;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    sum += std::pow(shown(picture.pixels[i]) - shown(reference.pixels[i]), 2);
  return std::sqrt(sum / double(picture.pixels.size()));
}

class NoiseFilterTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    context_ = std::make_unique<test::OffscreenContext>();
    if (!context_->isValid()) QSKIP("no OpenGL 4.1 core context on this machine");
    gl_.initializeOpenGLFunctions();
    resources_ = std::make_shared<widgets::PreviewResources>();
    picture_ = std::make_unique<widgets::PreviewRenderer>(resources_);
    picture_->initialize();
  }
  void cleanupTestCase() {
    filter_.release();
    if (picture_) picture_->release();
    picture_.reset();
    context_.reset();
  }

  /// At 14 samples, what two cores draw in a second, less than half of the error is left, of a mirror's seven tenths;
  /// of the first samples, which a user sees while moving a slider, a quarter to six tenths.
  void takesNoiseAway() {
    struct Row {
      int samples;
      double left;
    };
    const std::pair<double, std::vector<Row>> rows[] = {{0.3, {{1, 0.25}, {4, 0.33}, {14, 0.5}}},
                                                        {0.03, {{1, 0.4}, {4, 0.6}, {14, 0.7}}}};
    for (const auto& [roughness, limits] : rows) {
      const auto table = rough(roughness);
      draw("sphere", table, 512);
      const Image reference = picture_->readPicture();
      for (const auto& [samples, left] : limits) {
        draw("sphere", table, samples);
        const double noisy = visibleError(picture_->readPicture(), reference);
        const double filtered = visibleError(this->filtered(), reference);
        qInfo("roughness %g, %d samples: error %.4f, filtered %.4f", roughness, samples, noisy, filtered);
        QVERIFY(filtered < left * noisy);
      }
    }
  }

  /// What is read is not filtered.
  void thePictureItselfStays() {
    draw("sphere", rough(0.3), 4);
    const Image before = picture_->readPicture();
    filtered();
    QVERIFY(picture_->readPicture().pixels == before.pixels);
  }

  /// One distant light makes no noise: only rounding, and the subpixels of edges, remain.
  void picturesWithoutNoiseStay() {
    draw("sphere-distant-light", rough(0.3), 64);
    QVERIFY(metrics::signalToNoiseRatio(picture_->readPicture(), filtered()) > 45);
  }

  /// One sample at half the resolution: no change leaves the known picture as it is; with a change, less error
  /// is left than of one sample at the full resolution, which costs four times as much.
  void theChangeIsAddedToAKnownPicture() {
    for (const auto& [before, after, left] : {std::tuple{0.3, 0.3, 0.0}, std::tuple{0.3, 0.33, 0.1},
                                              std::tuple{0.1, 0.2, 0.6}, std::tuple{0.3, 0.1, 0.7}}) {
      const auto known = rough(before), changed = rough(after);
      const auto density = std::make_shared<const TabulatedDensity>(*known);
      draw("sphere", changed, 512);
      const Image reference = picture_->readPicture();
      draw("sphere", changed, 1);
      const double ofOneSample = visibleError(filtered(), reference);
      draw("sphere", known, 512);
      const Image first = picture_->readPicture();
      widgets::KnownPicture kept;
      kept.keep(*picture_, nullptr);
      picture_->setSubject(widgets::measuredSubject(changed, density));
      kept.drawBefore(*picture_, {side / 2, side / 2}, 1);
      picture_->setSize({side / 2, side / 2});
      picture_->accumulate(1);
      const double error = visibleError(filtered(&kept), reference);
      const double without = visibleError(first, reference);
      qInfo("roughness %g to %g: error %.4f, without the change %.4f, of a sample at full resolution %.4f", before,
            after, error, without, ofOneSample);
      if (before == after)
        QVERIFY(metrics::signalToNoiseRatio(first, filtered(&kept)) > 60);
      else
        QVERIFY(error < left * ofOneSample && error < without);
      kept.release();
    }
  }

  void aKnownPictureServesChangesOfOneMaterial() {
    const auto table = rough(0.3), other = rough(0.4);
    draw("sphere", table, 1);
    widgets::KnownPicture kept;
    QVERIFY(!kept.serves(widgets::measuredSubject(table), {side, side}));
    kept.keep(*picture_, nullptr);
    QVERIFY(kept.serves(widgets::measuredSubject(table), {side, side}));
    QVERIFY(!kept.serves(widgets::measuredSubject(table), {side, side / 2}));
    QVERIFY(!kept.serves(widgets::measuredSubject(other), {side, side}));
    QVERIFY(!kept.serves({}, {side, side}));
    kept.release();
  }

  /// While a slider moves at a large size, the first frame is drawn in any case and near the final picture; after a
  /// turn of the light, which no known picture serves, it is not.
  void theFirstFrameOfAChangeIsNearTheLast() {
    const QSize size(480, 480);
    widgets::PictureDrawer drawer;
    drawer.initialize();
    const auto table = rough(0.3);
    const models::Model& model = models::findModel("ggx");
    editing::DifferentialEdit edit = editing::unchangedEdit(model, models::defaultParameters(model.spec()));
    const auto density = std::make_shared<const TabulatedDensity>(*table);
    widgets::PictureRequest request;
    request.scene = openScene("sphere");
    request.sides[0].plan = request.sides[1].plan =
        widgets::previewPlan(request.scene, std::make_shared<const RenderMaterial>(table));
    request.viewport = request.picture = size;
    request.wantedSamples = 16;
    request.filtersNoise = true;
    QOpenGLFramebufferObject screen(size);
    const auto present = [&] {
      screen.bind();
      drawer.present(request);
      const QImage shown = screen.toImage();
      screen.release();
      Image image(size.width(), size.height());
      for (int y = 0; y < size.height(); ++y)
        for (int x = 0; x < size.width(); ++x) image.at(x, y) = glm::vec3(float(qGreen(shown.pixel(x, y))));
      return image;
    };
    const auto converge = [&] {
      widgets::PictureState state;
      do state = drawer.addFrame(request);
      while (state.sides[0].size != size || state.sides[0].samples < request.wantedSamples);
      return present();
    };
    const auto always = [] { return true; };
    const auto show = [&](double roughness) {
      edit.edited.values[*model.spec().find("roughness")] = Rgb(roughness);
      request.sides[0].subject = {widgets::EditedMaterial{table, {{edit}}}, density};
      ++request.sides[0].subjectNumber;
      return drawer.addFrame(request, always);
    };
    const double start = edit.fitted.values[*model.spec().find("roughness")][0];
    show(start * 1.01);
    const Image unchanged = converge();
    const widgets::PictureState first = show(start * 1.1);
    if (first.sides[0].size == size) QSKIP("this machine draws the first frame at the full resolution");
    QVERIFY(!first.isObsolete && first.sides[0].isFiltered);
    const Image ofChange = present();
    QVERIFY(drawer.addFrame(request, always).isObsolete);
    QVERIFY(present().pixels == ofChange.pixels);
    const Image last = converge();
    const double near = metrics::signalToNoiseRatio(last, ofChange);
    const double without = metrics::signalToNoiseRatio(last, unchanged);
    request.scene.environmentRotation += 0.3;
    drawer.addFrame(request);
    const Image ofTurn = present();
    const double far = metrics::signalToNoiseRatio(converge(), ofTurn);
    qInfo("first frame after a change %.1f dB, the picture before %.1f dB, after a turn %.1f dB", near, without, far);
    QVERIFY(near > 35 && near > without + 3 && near > far + 6);
    drawer.release();
  }

  /// A frame that nobody wants any more leaves the samples of those before it.
  void anObsoleteFrameIsTakenBack() {
    const QSize size(256, 256);
    const auto table = rough(0.3);
    draw("sphere", table, 1);
    picture_->setSize(size);
    picture_->accumulate(8);
    const Image before = picture_->readPicture();
    int asked = 0;
    if (picture_->accumulate(64, [&] { return ++asked == 2; })) QSKIP("this machine draws all in one band");
    QCOMPARE(picture_->samples(), 8);
    const Image after = picture_->readPicture();
    int same = 0;
    for (int y = 0; y < size.height(); ++y)
      same += std::equal(&before.at(0, y), &before.at(0, y) + size.width(), &after.at(0, y));
    QVERIFY(same > 0 && same < size.height());  // the upper rows were not reached, the lower ones have more samples
    QVERIFY(metrics::signalToNoiseRatio(before, after) > 15);
    QVERIFY(picture_->accumulate(64));
    QCOMPARE(picture_->samples(), 72);
  }

  /// The path tracer's normals and squares are those of the shader. In a studio its squares are smaller, since its
  /// samples have less noise than the shader's.
  void featuresAreThoseOfTheFilm_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("mostSquares");
    QTest::newRow("without noise") << "sphere-distant-light" << 0.03;
    QTest::newRow("studio") << "sphere-on-plane" << 0.25;
  }
  void featuresAreThoseOfTheFilm() {
    QFETCH(QString, name);
    QFETCH(double, mostSquares);
    const auto table = rough(0.5);
    const Scene scene = openScene(name.toStdString());
    const auto material = std::make_shared<const RenderMaterial>(table);
    draw(qPrintable(name), table, 512);
    const std::vector<glm::vec4> shaders = read(picture_->featureTexture());
    const RenderMaterials bound = bindMaterials(scene, RenderMaterials{material});
    Film film(side, side);
    film.enableFeatures();
    PathTracer(scene, bound, planEffects(scene, bound), 3).accumulate(film, 128);
    double normals = 0, squares = 0, all = 0;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const glm::vec4 a = shaders[std::size_t((side - 1 - y) * side + x)] / 512.f;
        const glm::vec4 b = film.features[std::size_t(y * side + x)] / 128.f;
        normals += glm::length(glm::vec3(a - b)) / (side * side);
        squares += std::abs(a.w - b.w);
        all += b.w;
      }
    qInfo("normals differ by %.4f, squares by %.3f of their sum", normals, squares / all);
    QVERIFY(normals < 0.01 && squares < mostSquares * all);
  }

  /// Filtered until all samples are there, and only where it is wanted.
  void theDrawerFiltersWhatHasFewSamples() {
    widgets::PictureDrawer drawer;
    drawer.initialize();
    const auto table = rough(0.3);
    widgets::PictureRequest request;
    request.sides[0].subject = widgets::measuredSubject(table, std::make_shared<const TabulatedDensity>(*table));
    request.sides[0].subjectNumber = 1;
    request.scene = openScene("sphere");
    request.sides[0].plan = request.sides[1].plan =
        widgets::previewPlan(request.scene, std::make_shared<const RenderMaterial>(table));
    request.viewport = request.picture = {side, side};
    request.wantedSamples = 128;
    for (const bool wanted : {true, false}) {
      request.filtersNoise = wanted;
      request.changed = std::chrono::steady_clock::now();
      request.scene.environmentRotation += 1;
      widgets::PictureState state = drawer.addFrame(request);
      QVERIFY(state.sides[0].samples < request.wantedSamples);
      QCOMPARE(state.sides[0].isFiltered, wanted);
      while (state.sides[0].samples < request.wantedSamples) state = drawer.addFrame(request);
      QVERIFY(!state.sides[0].isFiltered);
    }
    drawer.release();
  }

 private:
  void draw(const char* sceneName, const std::shared_ptr<const TabulatedBrdf>& table, int samples) {
    const Scene scene = openScene(sceneName);
    EffectPlan plan = widgets::previewPlan(scene, std::make_shared<const RenderMaterial>(table));
    picture_->setSubject(widgets::measuredSubject(table, std::make_shared<const TabulatedDensity>(*table)));
    picture_->setScene(scene, plan);
    picture_->setSize({side, side});
    for (; samples > 0; samples -= 64) picture_->accumulate(std::min(samples, 64));
  }

  std::vector<glm::vec4> read(GLuint texture) {
    std::vector<glm::vec4> texels(std::size_t(side * side));
    gl_.glBindTexture(GL_TEXTURE_2D, texture);
    gl_.glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, texels.data());
    return texels;
  }

  Image filtered(const widgets::KnownPicture* known = nullptr) {
    filter_.apply(gl_, *resources_, *picture_, known);
    const std::vector<glm::vec4> texels = read(filter_.shown().texture);
    Image image(side, side);
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) image.at(x, y) = glm::vec3(texels[std::size_t((side - 1 - y) * side + x)]);
    return image;
  }

  std::unique_ptr<test::OffscreenContext> context_;
  QOpenGLFunctions_4_1_Core gl_;
  std::shared_ptr<widgets::PreviewResources> resources_;
  std::unique_ptr<widgets::PreviewRenderer> picture_;
  widgets::NoiseFilter filter_;
};

GONIO_TEST(NoiseFilterTest)
}  // namespace noise_filter_test

#include "noise_filter_test.moc"
