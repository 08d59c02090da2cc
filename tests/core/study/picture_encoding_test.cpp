// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/picture_search.h"

#include <QTest>
#include <cmath>

#include "core/dictionary/decode.h"
#include "core/dictionary/training.h"
#include "core/rendering/render_picture.h"
#include "tests/core/dictionary/dictionary_test_support.h"
#include "tests/support/test_program.h"

namespace picture_encoding_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::dictionary;
using namespace gonio::dictionary::test_support;
using namespace gonio::study;

const RenderOptions picture{.width = 32, .height = 32, .samples = 16, .density = {}};

struct Studied {
  TrainingMaterials materials = ggxMaterials(7);
  /// Of all materials but the fourth, which is encoded.
  Ensemble ensemble = [this] {
    TrainingMaterials others = materials;
    others.load = [this](std::size_t m) { return materials.load(m == 3 ? 4 : m); };
    return train(others, {.dictionaries = 2, .sparsities = {10}, .iterations = 3}).ensemble;
  }();
  std::shared_ptr<const TabulatedBrdf> table = materials.load(3);
  Encoder encoder{ensemble};

  PictureEncoding encoded(double snr, EncodeOptions options) const {
    return encodeForPictures(encoder, *table, *table, snr, options, {}, picture);
  }
  /// By hand: of one transform and count.
  double snrOf(DataTransform transform, std::size_t coefficients) const {
    const RenderedComparison comparison(*table, picture);
    const EncodeResult found = encoder.encode(*table, {.coefficients = coefficients, .transforms = {transform}});
    return comparison.signalToNoiseRatio(comparison.render(*decode(ensemble, found.code)));
  }
};

const Studied& studied() {
  static const Studied s;
  return s;
}

constexpr double target = 45;

class PictureEncodingTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// What comes back has the SNR that it claims, in the transform that it claims, and 3 % fewer would not do.
  void fewestCoefficientsThatAreEnough() {
    std::vector<double> progress;
    const PictureEncoding found =
        encodeForPictures(studied().encoder, *studied().table, *studied().table, target, {.coefficients = 1000},
                          {.stop = {}, .progress = [&](double fraction) { progress.push_back(fraction); }}, picture);
    const SparseCode& code = found.encoded.code;
    QVERIFY(found.renderedSnr >= target);
    QVERIFY2(code.coefficients() > 8 && code.coefficients() < 1000, qPrintable(QString::number(code.coefficients())));
    QCOMPARE(found.renderedSnr, studied().snrOf(code.transform, code.coefficients()));
    QVERIFY(studied().snrOf(code.transform, std::size_t(double(code.coefficients()) / 1.04)) < target);
    QVERIFY(std::is_sorted(progress.begin(), progress.end()) && progress.back() == 1);
  }

  void theTransformIsTheOneThatNeedsFewer() {
    const auto countOf = [](std::vector<DataTransform> transforms) {
      return studied().encoded(target, {.coefficients = 1000, .transforms = std::move(transforms)});
    };
    const PictureEncoding both = countOf({DataTransform::logPlus, DataTransform::cosineLog});
    const std::size_t one = countOf({DataTransform::logPlus}).encoded.code.coefficients();
    const std::size_t other = countOf({DataTransform::cosineLog}).encoded.code.coefficients();
    QCOMPARE(both.encoded.code.coefficients(), std::min(one, other));
    QCOMPARE(both.encoded.candidates.size(), std::size_t(2));
    QVERIFY(both.encoded.candidates[1].code.transform == DataTransform::cosineLog);
  }

  /// Where no count is enough: the best that was found, which is one of the doubled counts.
  void whatCannotBeReached() {
    const PictureEncoding found = studied().encoded(300, {.coefficients = 100, .transforms = {DataTransform::logPlus}});
    double best = 0;
    for (const std::size_t count : {8, 16, 32, 64, 100})
      best = std::max(best, studied().snrOf(DataTransform::logPlus, count));
    QCOMPARE(found.renderedSnr, best);
  }
};

GONIO_TEST(PictureEncodingTest)
}  // namespace picture_encoding_test

#include "picture_encoding_test.moc"
