// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/accuracy_study.h"

#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/factorization/pdv_factors.h"
#include "core/fitting/fit_parameters.h"
#include "core/formats/code.h"
#include "core/formats/pdv.h"
#include "core/metrics/brdf_metrics.h"
#include "core/models/registry.h"
#include "core/rendering/render_picture.h"
#include "tests/core/dictionary/dictionary_test_support.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace accuracy_study_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::study;

constexpr HalfDifferenceGrid smallGrid{.thetaHCount = 30, .thetaDCount = 30, .phiDCount = 36};

StudySubject plastic() {
  static const auto table = bakeTable(*test::ggx(Rgb(0.05, 0.2, 0.3), Rgb(0.9, 0.5, 0.2), 0.2, 0.04), smallGrid);
  return {table, table};
}

StudyOptions smallPictures() {
  StudyOptions options;
  options.picture = {.width = 16, .height = 16, .samples = 4};
  return options;
}

std::vector<Representation> few() {
  RepresentationChoice choice;
  choice.names = {"table", "lambert", "ggx", "factors", "published"};
  choice.terms = {1, 3};
  choice.coefficients = {};
  return representationsOf(choice);
}

const StudyRecord& find(const std::vector<StudyRecord>& records, std::string_view id, double budget) {
  return *std::ranges::find_if(
      records, [&](const auto& r) { return r.representation.kind->id == id && r.representation.budget == budget; });
}

class AccuracyStudyTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void allRepresentationsInTheirOrder() {
    const auto all = representationsOf({});
    // Two tables, the models, eight counts of terms in two forms, seven codes, and the non-parametric factors.
    QCOMPARE(all.size(), 2 + models::allModels().size() + 16 + 7 + 1);
    QVERIFY(std::ranges::is_sorted(all, {}, &Representation::kind));
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) QVERIFY(all[i].fullLabel() != all[j].fullLabel());
    // The rows of a family follow one another, in the order of the families.
    std::vector<std::string_view> families;
    for (const RepresentationKind& kind : representationKinds())
      if (families.empty() || families.back() != kind.family->id) families.push_back(kind.family->id);
    QVERIFY(std::ranges::equal(families, representationFamilies(), {}, {}, &RepresentationFamily::id));
    try {
      representationsOf({.names = {"tables"}});
      QFAIL("accepted");
    } catch (const Error& error) {
      QVERIFY(std::string(error.what()).find("kind of representation 'tables'") != std::string::npos);
      QVERIFY(std::string(error.what()).find("codes, components") != std::string::npos);
    }
  }

  void representationsByTheirIds() {
    RepresentationChoice choice;
    choice.names = familiesWithoutFurtherData();
    for (const Representation& one : representationsOf(choice)) {
      const std::optional<double> budget = one.kind->hasBudget() ? std::optional(one.budget) : std::nullopt;
      QVERIFY2(representationById(one.id(), budget) == one, one.fullLabel().c_str());
    }
    // In older files the node at or below was called the nearest.
    QVERIFY(representationById("table-nearest") == representationById("table-cell"));
    QCOMPARE(representationById("table-nearest").id(), std::string("table-cell"));
    const auto fails = [](std::string_view id, std::optional<double> budget, const char* text) {
      try {
        representationById(id, budget);
        QFAIL("accepted");
      } catch (const Error& error) {
        QVERIFY2(std::string(error.what()).find(text) != std::string::npos, error.what());
      }
    };
    fails("ggxx", {}, "'ggxx', expected one of table-cell, table-trilinear, factors-2d");
    fails("components", 4, "'components'");
    fails("tucker", 4, "factors-2d, factors-3d, code, nonparametric, kautz-mccool");
    fails("tucker", 4,
          "gaussian-process, factors-2d-published, factors-3d-published, code-published, factors-2d-joint, "
          "factors-3d-joint, factors-3d-compact, code-basis-pursuit, neural or the id of a model");
    fails("lawrence", {}, "no budget, expected a whole number from 1 to 100000000 (bytes)");
    fails("code", {}, "no budget, expected a whole number from 1 to 65535 (coefficients");
    fails("factors-2d", 2.5, "the budget 2.5");
    fails("factors-3d", 0, "the budget 0");
    fails("factors-3d-published", 21, "the budget 21, expected a whole number from 1 to 20 (terms)");
  }

  /// In another scene all is compared with the reference's picture there.
  void studiesOfOtherScenes() {
    StudyOptions options = smallPictures();
    options.timed = false;
    options.scene = sphereScene();
    Image reference;
    options.referenceRendered = [&](const Image& picture) { reference = picture; };
    const RenderedComparison comparison(sphereScene(), *plastic().table, options.picture);
    options.measured = [&](const MeasuredRepresentation& studied) {
      const ComparisonPicture picture = comparison.render(*studied.brdf);
      QVERIFY(picture.image.pixels == studied.picture.pixels);
      QCOMPARE(studied.record.renderedSnr, comparison.signalToNoiseRatio(picture));
    };
    QCOMPARE(runStudy(plastic(), few(), options).size(), few().size());
    QVERIFY(reference.pixels == comparison.reference().pixels);
    QVERIFY(reference.pixels != RenderedComparison(*plastic().table, options.picture).reference().pixels);
  }

  /// Each record holds what its parts give when they are called by themselves.
  void recordsHoldWhatTheirPartsGiveAlone() {
    const auto representations = few();
    std::vector<std::string> reported;
    StudyOptions options = smallPictures();
    const RenderedComparison comparison(*plastic().table, options.picture);
    options.measured = [&](const MeasuredRepresentation& studied) {
      reported.push_back(studied.record.representation.fullLabel());
      const ComparisonPicture picture = comparison.render(*studied.brdf);
      QVERIFY(picture.image.pixels == studied.picture.pixels);
      QVERIFY(studied.tabulated({})->grid() == smallGrid);
      const double snr = comparison.signalToNoiseRatio(picture);
      QCOMPARE(studied.record.renderedSnr, snr);
    };
    const std::vector<StudyRecord> records = runStudy(plastic(), representations, options);
    QCOMPARE(records.size(), representations.size());
    for (std::size_t i = 0; i < records.size(); ++i) {
      const StudyRecord& record = records[i];
      QVERIFY(record.representation == representations[i]);
      QCOMPARE(reported[i], representations[i].fullLabel());
      QVERIFY(record.evaluation.lowerQuartile > 0 && record.evaluation.lowerQuartile <= record.evaluation.median &&
              record.evaluation.median <= record.evaluation.upperQuartile);
      QVERIFY(record.frameMilliseconds > 0);
      QCOMPARE(record.encodeSeconds > 0, record.representation.kind->family->id != "table");
      QCOMPARE(record.errors.size(), metrics::allBrdfMetrics().size());
    }
    const StudyRecord& trilinear = find(records, "table-trilinear", 0);
    QVERIFY(std::isinf(trilinear.renderedSnr));
    QVERIFY(std::ranges::all_of(trilinear.errors, [](double error) { return error == 0; }));
    QVERIFY(std::isfinite(find(records, "table-cell", 0).renderedSnr));
    QCOMPARE(trilinear.bytes, plastic().table->bytes());

    const auto fit = fitting::fit(*plastic().table, models::findModel("ggx"));
    const StudyRecord& ggx = find(records, "ggx", 8);
    QVERIFY(ggx.errors == fit.errors);
    QCOMPARE(ggx.bytes, 8 * sizeof(float));
    const auto one = factorization::factorizePdv(*plastic().table, {.terms = 1}).factors;
    const StudyRecord& factors = find(records, "factors-3d", 1);
    QVERIFY(factors.errors == metrics::brdfErrors(*plastic().table, *factorization::makePdvBrdf(one)));
    QCOMPARE(factors.bytes, formats::pdvFileBytes(one));
    QVERIFY(find(records, "factors-3d", 3).encodeSeconds > factors.encodeSeconds);
    // What is known of the material: it is a GGX model, three terms hold more than one, a lambertian body is no
    // highlight.
    QVERIFY(ggx.renderedSnr > 40);
    QVERIFY(find(records, "factors-3d", 3).renderedSnr > factors.renderedSnr + 1);
    QVERIFY(find(records, "lambert", 3).renderedSnr < ggx.renderedSnr - 15);
    QVERIFY(find(records, "table-cell", 0).renderedSnr < 40);
    const StudyRecord& published = find(records, "factors-2d-published", 3);
    const auto three = factorization::factorizePdv(
                           *plastic().table, factorization::publishedPdvOptions(factorization::PdvForm::twoFactors, 3))
                           .factors;
    QVERIFY(published.errors == metrics::brdfErrors(*plastic().table, *factorization::makePdvBrdf(three)));
    QCOMPARE(published.bytes, formats::pdvFileBytes(three));
    QVERIFY(published.errors != find(records, "factors-2d", 3).errors);
  }

  void codesAndComponents() {
    const HalfDifferenceGrid grid = dictionary::test_support::smallGrid;
    const auto table = bakeTable(*plastic().table, grid);
    BuildOptions build;
    build.dictionary = std::make_shared<const materials::NamedEnsemble>(
        materials::NamedEnsemble{dictionary::test_support::randomEnsemble(2), 1});
    const auto rough = bakeTable(*test::ggx(Rgb(0.1), Rgb(0.5), 0.5, 0.04), grid);
    const std::shared_ptr<const TabulatedBrdf> taught[] = {table, rough};
    build.components = std::make_shared<const dictionary::PrincipalComponents>(
        dictionary::learnPrincipalComponents(2, [&](std::size_t m) { return taught[m]; }));
    build.separated = std::make_shared<const dictionary::SeparatedComponents>(
        dictionary::learnSeparatedComponents(2, [&](std::size_t m) { return taught[m]; }));
    dictionary::TrainingMaterials training{{"plastic", "rough"}, grid, [&](std::size_t m) { return taught[m]; }};
    build.patches = std::make_shared<const dictionary::PatchDictionary>(dictionary::learnPatchDictionary(
        training, {.patch = {4, 3, 3}, .samples = 200, .kSvd = {.atoms = 30, .iterations = 5}}));
    RepresentationChoice choice;
    choice.names = {"codes", "components", "components-separated", "patches"};
    choice.coefficients = {200, 2000};
    choice.components = {1, 3};
    const auto all = representationsOf(choice);
    RepresentationBuilder builder({table, table}, build, all);
    std::vector<double> errors;
    for (const Representation& representation : all) {
      const BuiltRepresentation built = builder.build(representation);
      errors.push_back(metrics::brdfError(metrics::BrdfMetric::log, *table, *built.nodes));
      QVERIFY(std::ranges::equal(built.tabulated({})->values(), built.nodes->values()));
      // What is evaluated is what the nodes hold.
      const std::size_t cell = grid.index(4, 3, 8);
      const DirectionPair pair = grid.directions(cell);
      const Rgb value = built.brdf->evaluate(pair.wi, pair.wo), node(built.nodes->values()[cell]);
      QVERIFY2(glm::length(value - node) < 1e-3 * glm::length(node), representation.fullLabel().c_str());
    }
    QVERIFY(errors[1] < errors[0]);
    QVERIFY(errors[3] < errors[2]);
    // All components of the two, of which one is grey, hold both, but for half precision.
    QVERIFY2(errors[3] < 1e-3, qPrintable(QString::number(errors[3])));
    QVERIFY2(errors[1] < 0.05, qPrintable(QString::number(errors[1])));
    QVERIFY(errors[5] < errors[4]);
    QVERIFY(errors[7] < errors[6]);
    Representation tooMany = all[3];
    tooMany.budget = 4;
    QVERIFY_EXCEPTION_THROWN(builder.build(tooMany), Error);
    Representation unplanned = few().back();
    RepresentationBuilder other(plastic(), {}, few());
    other.build(few().back());
    unplanned.budget = 4;
    QVERIFY_EXCEPTION_THROWN(other.build(unplanned), Error);
  }

  /// What the study builds is what the functions of the library make with the options of each variant.
  void publishedCodesAndAlternatives() {
    const auto table = bakeTable(*plastic().table, dictionary::test_support::smallGrid);
    BuildOptions build;
    build.dictionary = std::make_shared<const materials::NamedEnsemble>(
        materials::NamedEnsemble{dictionary::test_support::randomEnsemble(2), 1});
    const dictionary::Encoder encoder(build.dictionary->ensemble);
    const auto encoded = [&](const dictionary::EncodeOptions& options) {
      const auto code = encoder.encode(*table, options).code;
      return formats::encodeCode(code, 1).size();
    };
    const std::array all{representationById("code-published", 100), representationById("code-basis-pursuit", 100),
                         representationById("factors-3d-joint", 2), representationById("factors-3d-joint", 3),
                         representationById("factors-3d-compact", 2)};
    RepresentationBuilder builder({table, table}, build, all);
    QCOMPARE(builder.build(all[0]).bytes, encoded(dictionary::publishedEncodeOptions(100)));
    QCOMPARE(builder.build(all[1]).bytes,
             encoded({.coefficients = 100, .method = dictionary::CodingMethod::basisPursuit}));
    for (const Representation& joint : {all[2], all[3]}) {
      const auto factors = factorization::factorizePdv(*table, {.terms = int(joint.budget), .joint = true}).factors;
      const BuiltRepresentation built = builder.build(joint);
      QCOMPARE(built.bytes, formats::pdvFileBytes(factors));
      QVERIFY(*factorization::pdvFactorsOf(*built.brdf) == factors);
    }
    using namespace factorization;
    const auto compact = factorizePdv(*table, compactPdvOptions({.terms = 2, .joint = true})).factors;
    QVERIFY(*pdvFactorsOf(*builder.build(all[4]).brdf) == compact);
  }

  /// Published factors are evaluated as they are; their size is that of the 272 columns that the model uses.
  void publishedNonparametricFactors() {
    factorization::NonparametricFactors factors;
    for (auto& c : factors.channels) {
      c.diffuse = 0.2, c.specular = 3;
      for (std::size_t i = 0; i < factors.nodes; ++i) c.d[i] = std::exp(-0.1 * double(i)), c.f[i] = 0.5, c.g[i] = 1;
    }
    const auto rows = representationsOf({.names = {"published-nonparametric"}});
    QCOMPARE(rows.size(), std::size_t(1));
    QCOMPARE(rows[0].id(), std::string("published-nonparametric"));
    StudyOptions options = smallPictures();
    options.build.publishedNonparametric = std::make_shared<const factorization::NonparametricFactors>(factors);
    const StudyRecord record = runStudy(plastic(), rows, options).at(0);
    QCOMPARE(record.bytes, std::size_t(272 * 3 * 4));
    QVERIFY(record.errors == metrics::brdfErrors(*plastic().table, *factorization::makeNonparametricBrdf(factors)));
    QVERIFY(record.evaluation.median > 0 && record.frameMilliseconds > 0 && std::isfinite(record.renderedSnr));
    QVERIFY(std::isnan(record.encodeSeconds));
    QVERIFY_EXCEPTION_THROWN(runStudy(plastic(), rows, smallPictures()), Error);
    const auto others = familiesWithoutFurtherData();
    QVERIFY(std::ranges::count(others, "published-nonparametric") == 0);
  }

  /// Codes are of the dictionary's grid: a table on another is sampled first.
  void smallTablesAreCodedToo() {
    RepresentationChoice choice;
    choice.names = {"codes"};
    choice.coefficients = {16};
    const auto records = runStudy(plastic(), representationsOf(choice), smallPictures());
    QCOMPARE(records.size(), std::size_t(1));
    QVERIFY(std::isfinite(records[0].renderedSnr) && records[0].errors[0] > 0);
  }

  void cancelReturnsWhatIsDone() {
    const auto representations = few();
    for (const std::size_t wanted : {0, 1, 5}) {
      StudyOptions options = smallPictures();
      std::stop_source source;
      std::size_t done = 0;
      if (wanted == 0) source.request_stop();
      options.measured = [&](const MeasuredRepresentation&) {
        if (++done == wanted) source.request_stop();
      };
      QCOMPARE(runStudy(plastic(), representations, options, {source.get_token(), {}}).size(), wanted);
    }
  }

  void progressNeverFalls() {
    double last = 0;
    bool falls = false;
    runStudy(plastic(), few(), smallPictures(), {{}, [&](double fraction) {
                                                   falls = falls || fraction < last || fraction > 1;
                                                   last = fraction;
                                                 }});
    QVERIFY(!falls);
    QCOMPARE(last, 1.0);
  }

  void hardCase44BlackReference() {
    const auto black = bakeTable(*test::ggx(Rgb(0), Rgb(0), 0.3, 0.04), smallGrid);
    for (const StudyRecord& record : runStudy({black, black}, few(), smallPictures()))
      QVERIFY(std::isnan(record.renderedSnr));
  }
};

GONIO_TEST(AccuracyStudyTest)
}  // namespace accuracy_study_test

#include "accuracy_study_test.moc"
