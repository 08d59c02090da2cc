// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

#include <QTemporaryDir>
#include <QTest>
#include <functional>

#include "core/acquisition/reconstruction.h"
#include "core/acquisition/sample_selection.h"
#include "core/dictionary/encode.h"
#include "core/dictionary/training.h"
#include "core/factorization/pdv_factors.h"
#include "core/fitting/fit.h"
#include "core/formats/code.h"
#include "core/formats/pdv.h"
#include "core/formats/rgl.h"
#include "core/io/byte_source.h"
#include "core/materials/basis_file.h"
#include "core/materials/dictionary_file.h"
#include "core/materials/encode.h"
#include "core/math/parallel.h"
#include "core/rendering/render_picture.h"
#include "tests/core/dictionary/dictionary_test_support.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace same_bits_test {
using namespace gonio;
using namespace gonio::rendering;
using dictionary::test_support::ggxMaterials;
using Bytes = std::vector<std::byte>;

constexpr HalfDifferenceGrid grid = dictionary::test_support::smallGrid;
constexpr int materialCount = 5;

/// The bytes of several arrays of numbers, one behind the other.
template <typename... Arrays>
Bytes bytesOf(const Arrays&... arrays) {
  Bytes bytes;
  const auto append = [&bytes](const auto& array) {
    const auto part = std::as_bytes(std::span(array));
    bytes.insert(bytes.end(), part.begin(), part.end());
  };
  (append(arrays), ...);
  return bytes;
}

std::shared_ptr<const TabulatedBrdf> table() { return ggxMaterials(materialCount).load(2); }

/// What a command writes, made with small sizes.
class Results {
 public:
  Bytes fit() const {
    const fitting::FitResult result = fitting::fit(*large_, models::findModel("ggx"));
    return bytesOf(result.parameters.values, result.errors);
  }
  Bytes factors() const {
    const auto path = file("factors.pdv");
    formats::writePdv(factorization::factorizePdv(*large_, {.terms = 2}).factors, path);
    return contentOf(path);
  }
  Bytes code() const {
    const dictionary::Ensemble ensemble = dictionary::test_support::randomEnsemble(3);
    return formats::encodeCode(dictionary::Encoder(ensemble).encode(*table(), {.coefficients = 40}).code, 1);
  }
  Bytes trained() const {
    const dictionary::TrainingOptions options{
        .dictionaries = 2, .sparsities = {8, 20}, .iterations = 3, .tolerance = 0};
    const auto path = file("trained.dictionary");
    materials::writeDictionary(dictionary::train(ggxMaterials(materialCount), options).ensemble, path);
    return contentOf(path);
  }
  Bytes basis() const {
    const auto learned = dictionary::learnPrincipalComponents(materialCount, ggxMaterials(materialCount).load);
    return materials::encodeBasis(learned, learned.count(), {});
  }
  Bytes plan() const {
    Bytes bytes;
    for (const auto method : {acquisition::SelectionMethod::simultaneousPursuit,
                              acquisition::SelectionMethod::conditionNumber, acquisition::SelectionMethod::random})
      for (const std::byte byte :
           bytesOf(acquisition::selectSamples(*learned_, {.method = method, .samples = 6}).cells))
        bytes.push_back(byte);
    return bytes;
  }
  Bytes reconstructed() const {
    const auto cells = acquisition::selectSamples(*learned_, {.samples = 8}).cells;
    const acquisition::SamplingPlan plan = acquisition::planFor(grid, cells);
    const auto found = acquisition::reconstruct(*learned_, plan, acquisition::measure(*table(), plan));
    return bytesOf(found.table->values(), found.standardDeviation);
  }
  Bytes rendered() const {
    const Image image = renderPicture(*brdf_, comparisonScene(), {.width = 24, .height = 24, .samples = 4});
    return bytesOf(image.pixels, image.alpha);
  }
  Bytes baked() const { return bytesOf(bakeTable(*brdf_, large_->grid())->values()); }
  Bytes exported() const {
    const materials::EncodeOptions options{.size = {{5, 12}}, .pictureSize = 16, .samples = 16};
    return formats::encodeRgl(materials::unedited("same", brdf_), options).rgb;
  }

 private:
  std::filesystem::path file(const char* name) const {
    return std::filesystem::path(folder_.path().toStdString()) / name;
  }
  static Bytes contentOf(const std::filesystem::path& path) { return io::FileSource(path).readAll(1 << 24); }

  QTemporaryDir folder_;
  std::shared_ptr<const Brdf> brdf_ = test::ggx(Rgb(0.3, 0.1, 0.05), Rgb(0.9), 0.25, 0.05);
  /// Of more cells than a block of any loop has.
  std::shared_ptr<const TabulatedBrdf> large_ =
      bakeTable(*brdf_, {.thetaHCount = 30, .thetaDCount = 30, .phiDCount = 36});
  std::shared_ptr<const dictionary::PrincipalComponents> learned_ =
      std::make_shared<const dictionary::PrincipalComponents>(
          dictionary::learnPrincipalComponents(materialCount, ggxMaterials(materialCount).load));
};

/// As so many threads make them, more than there are cores too.
Bytes withThreads(int threads, const std::function<Bytes()>& work) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
  Bytes bytes;
  tbb::task_arena(threads).execute([&] {
    QCOMPARE(threadCount(), threads);
    bytes = work();
  });
  return bytes;
}

class SameBitsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Hard case 50: the number of threads changes no bit of any result.
  void hardCase50AnyThreads_data() {
    QTest::addColumn<int>("result");
    for (int i = 0; i < int(std::size(makers_)); ++i) QTest::newRow(makers_[i].name) << i;
  }
  void hardCase50AnyThreads() {
    QFETCH(int, result);
    const auto make = [&] { return (results_.*makers_[result].make)(); };
    const Bytes one = withThreads(1, make);
    QVERIFY(one.size() > 8);
    for (const int threads : {2, 3, 7, 64})
      QVERIFY2(withThreads(threads, make) == one, qPrintable(QString::number(threads)));
  }

 private:
  struct Maker {
    const char* name;
    Bytes (Results::*make)() const;
  };
  static constexpr Maker makers_[] = {{"fit", &Results::fit},
                                      {"factorise", &Results::factors},
                                      {"encode", &Results::code},
                                      {"train", &Results::trained},
                                      {"learn a basis", &Results::basis},
                                      {"plan", &Results::plan},
                                      {"reconstruct", &Results::reconstructed},
                                      {"render", &Results::rendered},
                                      {"bake", &Results::baked},
                                      {"export", &Results::exported}};
  Results results_;
};

GONIO_TEST(SameBitsTest)

}  // namespace same_bits_test

#include "same_bits_test.moc"
