// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/reflection_bound.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>

#include "core/brdf/incidence_table_brdf.h"
#include "core/brdf/neural_brdf.h"
#include "core/brdf/rgl_brdf.h"
#include "core/brdf/tabulated_brdf.h"
#include "core/brdf/utia_brdf.h"
#include "core/brdf/value_bound.h"
#include "core/brdf/weighted_sum.h"
#include "core/dictionary/decode.h"
#include "core/editing/edit.h"
#include "core/factorization/pdv_factors.h"
#include "core/materials/material.h"
#include "core/models/registry.h"
#include "core/rendering/render_material.h"
#include "tests/core/dictionary/dictionary_test_support.h"
#include "tests/support/code_files.h"
#include "tests/support/function_brdf.h"
#include "tests/support/leading_parameters.h"
#include "tests/support/random_scenes.h"
#include "tests/support/test_program.h"

namespace reflection_bound_test {
using namespace gonio;
using namespace gonio::rendering;

using Form = std::shared_ptr<const Brdf>;

ReflectionBound boundOf(const Form& brdf) { return ReflectionBound(*brdf); }
Form glossy(double roughness, const Rgb& diffuse = Rgb(0.3, 0.2, 0.1)) {
  return test::ggx(diffuse, Rgb(0.8, 0.9, 1), roughness, 0.3);
}

/// A table of 1e-5 but in one ring of half vectors, where theta_d is small: retroreflection in a ring of a sphere.
Form retroreflector(double low, double high, double mostThetaD, double value) {
  const HalfDifferenceGrid grid;
  std::vector<TabulatedBrdf::Value> values(grid.size(), TabulatedBrdf::Value(1e-5f));
  std::vector<std::uint8_t> valid(grid.size(), 1);
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    const HalfDifference at = grid.node(cell);
    if (degrees(at.thetaH) > low && degrees(at.thetaH) < high && degrees(at.thetaD) < mostThetaD)
      values[cell] = TabulatedBrdf::Value(float(value));
    valid[cell] = grid.nodeAboveHorizon(cell);
  }
  return std::make_shared<const TabulatedBrdf>(grid, values, valid);
}

/// One term whose F1 is raised between two angles of the viewer.
factorization::PdvFactors raisedFactors(double low, double high, double value) {
  factorization::PdvFactors factors;
  factors.transform = DataTransform::none;
  factors.highest = 1e6;
  factorization::PdvTerm term;
  for (int i = 0; i < 181; ++i) {
    const double degreesOf = i * 0.5;
    factors.thetaNodes.push_back(radians(degreesOf));
    term.f1.push_back(degreesOf > low && degreesOf < high ? value : 1e-5);
  }
  factors.deviationNodes = {0, 1, 2};
  factors.phiNodes = {0, 1, pi};
  term.f2 = {1, 1, 1};
  term.f3 = {1, 1, 1};
  for (auto& channel : factors.channels) channel = {term};
  return factors;
}

/// The second term makes all values beside the highlight negative.
Form factorsWithNegativeValues(DataTransform transform) {
  factorization::PdvFactors factors = raisedFactors(10, 60, 3);
  factors.transform = transform;
  factors.lowest = -2;
  for (auto& channel : factors.channels) {
    channel.push_back(channel[0]);
    channel[1].f2 = {0.2, -1, -0.5};
  }
  return factorization::makePdvBrdf(factors);
}

Form factorised(int terms, DataTransform transform) {
  factorization::PdvOptions options;
  options.terms = terms;
  options.transform = transform;
  const HalfDifferenceGrid grid{.thetaHCount = 30, .thetaDCount = 20, .phiDCount = 36};
  return factorization::makePdvBrdf(factorization::factorizePdv(*bakeTable(*glossy(0.3), grid), options).factors);
}

/// As blends of several materials, which have more terms than a file can hold.
Form factorsOfManyTerms() {
  constexpr int repeats = 30;
  const HalfDifferenceGrid grid{.thetaHCount = 30, .thetaDCount = 20, .phiDCount = 36};
  factorization::PdvFactors factors = factorization::factorizePdv(*bakeTable(*glossy(0.3), grid), {.terms = 2}).factors;
  for (auto& channel : factors.channels) {
    const auto terms = channel;
    for (int k = 1; k < repeats; ++k) channel.insert(channel.end(), terms.begin(), terms.end());
    for (factorization::PdvTerm& term : channel)
      for (auto& value : term.f1) value /= repeats;
  }
  return factorization::makePdvBrdf(factors);
}

/// A code of both orders of the directions, with negative values.
Form codeOfBothOrders() {
  using namespace dictionary;
  const Ensemble ensemble = dictionary::test_support::randomEnsemble(1);
  SparseCode code{.grid = ensemble.grid.wholeCircle(), .transform = DataTransform::logPlus, .channels = {}};
  std::mt19937_64 random(4);
  for (ChannelCode& channel : code.channels) {
    for (std::uint32_t k = 0; k < 40; ++k)
      channel.coefficients.push_back({17 * k, float(4 * test::uniform(random) - 2)});
    channel.highest = 2;
    channel.lowest = -0.5f;
  }
  return makeCodeBrdf(ensemble, code);
}

Form utia(IncidentDirection incident) {
  std::mt19937_64 random(3);
  std::vector<glm::vec3> values;
  for (std::size_t i = 0; i < UtiaBrdf::directionCount * UtiaBrdf::directionCount; ++i)
    values.emplace_back(0.1 * test::uniform(random), i % 997 == 0 ? 5 : 0, 0.2 * test::uniform(random));
  return std::make_shared<const UtiaBrdf>(values, incident);
}

Form incidences(IncidenceTable::Axis axis, bool symmetric) {
  std::mt19937_64 random(5);
  IncidenceTable table{.axis = axis,
                       .symmetric = symmetric,
                       .incident = {0.1, 0.4, 0.8, 1.2},
                       .azimuths = {},
                       .polars = {},
                       .values = {}};
  for (int i = 0; i < 7; ++i) table.azimuths.push_back((symmetric ? pi : 1.8 * pi) * i / 6);
  for (int i = 0; i < 20; ++i) table.polars.push_back(0.002 * i * i);
  for (std::size_t i = 0; i < 4 * 7 * 20; ++i)
    table.values.push_back(glm::vec3(float(10 * std::pow(test::uniform(random), 4))));
  return std::make_shared<const IncidenceTableBrdf>(table);
}

Form adaptive(bool isotropic, IncidentDirection incident) {
  std::mt19937_64 random(7);
  const std::vector<float> phis =
      isotropic ? std::vector<float>{0} : std::vector<float>{-3.14159274f, -1, 1, 3.14159274f};
  RglData data;
  data.incident = ParameterGrid(phis, {0, 0.4f, 0.9f, 1.5f});
  data.isotropic = isotropic;
  const auto fill = [&](auto& stack, std::size_t width, std::size_t height, std::size_t slices, const auto& value) {
    stack.width = width;
    stack.height = height;
    for (std::size_t i = 0; i < width * height * slices; ++i) stack.values.push_back(value());
  };
  const auto number = [&] { return float(0.1 + test::uniform(random)); };
  fill(data.ndf, 16, isotropic ? 2 : 8, 1, number);
  fill(data.sigma, 16, isotropic ? 2 : 8, 1, number);
  fill(data.luminance, 8, 8, data.incident.slices(), number);
  fill(data.rgb, 8, 8, data.incident.slices(),
       [&] { return glm::vec3(number(), test::uniform(random) < 0.05 ? 8 : 0.1, test::uniform(random) - 0.1); });
  data.vndf = visibleNormals(data.ndf, data.incident, isotropic);
  return std::make_shared<const RglBrdf>(std::move(data), incident);
}

Form edited(const Form& base, editing::Composition composition, double strength, bool coloured = false) {
  const models::Model& model = models::findModel("ggx");
  editing::DifferentialEdit edit = editing::unchangedEdit(model, models::defaultParameters(model.spec()));
  edit.composition = composition;
  edit.edited.values[*model.spec().find("roughness")] = Rgb(0.12);
  edit.edited.values[*model.spec().find("diffuse")] = Rgb(0.4, 0.05, 0.2);
  if (coloured) edit.controls.values.front() += Rgb(0.3, 0, 0.1);
  std::vector<editing::Edit> edits{{.content = edit, .strength = strength}};
  const auto original = std::make_shared<const factorization::PdvFactors>(raisedFactors(0, 1, 1e-5)),
             raised = std::make_shared<const factorization::PdvFactors>(raisedFactors(34, 39, 2));
  edits.push_back({.content = editing::FactorEdit{original, raised, strength > 0.5}, .strength = 0.7});
  return editing::applyEdits(base, edits);
}

/// By lobes: each lobe of the model with another width, strength and colour than the fit, at some strength.
Form lobed(const Form& base, const char* id, double wider, bool keepsAlbedo, double strength = 1,
           bool coloured = false) {
  const models::Model& model = models::findModel(id);
  editing::DifferentialEdit edit = editing::unchangedEdit(model, models::defaultParameters(model.spec()));
  edit.keepsAlbedo = keepsAlbedo;
  for (std::size_t i = 0; i < edit.edited.values.size(); ++i) {
    const models::ParameterSpec& spec = model.spec().parameters[i];
    if (std::string(spec.id).find("roughness") != std::string::npos) edit.edited.values[i] *= wider;
    if (coloured && spec.perChannel) edit.edited.values[i] *= Rgb(0.4, 1, 1.3);
  }
  return editing::applyEdits(base, std::vector<editing::Edit>{{.content = edit, .strength = strength}});
}

/// Edits by lobes of bases that their models fit well, badly, in a narrow band, with negative values, and two in a row.
std::vector<std::pair<std::string, Form>> lobedForms(const Form& table) {
  std::vector<std::pair<std::string, Form>> all;
  for (const bool keepsAlbedo : {true, false})
    for (const double wider : {2.5, 0.4}) {
      all.emplace_back("lobes of a table", lobed(table, "ggx", wider, keepsAlbedo, 0.7, keepsAlbedo));
      all.emplace_back("lobes of a model", lobed(glossy(0.1), "layered", wider, keepsAlbedo));
      all.emplace_back("lobes of a retroreflector",
                       lobed(retroreflector(35.5, 39.5, 2, 300), "ggx", wider, keepsAlbedo));
      all.emplace_back("lobes of raised factors",
                       lobed(factorization::makePdvBrdf(raisedFactors(34.4, 39.6, 2)), "ward", wider, keepsAlbedo));
      all.emplace_back("anisotropic lobes", lobed(table, "ggx-anisotropic", wider, keepsAlbedo, 0.8, true));
      all.emplace_back("lobes of anisotropic RGL",
                       lobed(adaptive(false, IncidentDirection::viewer), "car-paint", wider, keepsAlbedo, 0.8, true));
      all.emplace_back("lobes twice",
                       lobed(lobed(table, "ggx", wider, keepsAlbedo, 0.7, true), "layered", 1 / wider, keepsAlbedo));
    }
  return all;
}

/// A network with weights drawn by chance. @param scale of the weights.
Form neural(double scale) {
  std::mt19937_64 random(13);
  std::normal_distribution<double> normal(0, scale);
  std::vector<float> weights;
  for (std::size_t i = 0; i < NeuralBrdf::weightCount; ++i) weights.push_back(float(normal(random)));
  return std::make_shared<const NeuralBrdf>(weights);
}

std::vector<std::pair<std::string, Form>> forms() {
  std::vector<std::pair<std::string, Form>> all;
  for (const models::Model* model : models::allModels()) {
    const Form byDefault = model->instantiate(models::defaultParameters(model->spec()));
    all.emplace_back(model->spec().id, byDefault);
    models::ParameterValues values = models::defaultParameters(model->spec());
    std::mt19937_64 random(11);
    for (std::size_t i = 0; i < values.values.size(); ++i) {
      const models::ParameterSpec& spec = model->spec().parameters[i];
      for (int channel = 0; channel < 3; ++channel)
        if (spec.choices.empty() && (channel == 0 || spec.perChannel))
          values.values[i][channel] = spec.softMin + (spec.softMax - spec.softMin) * std::pow(test::uniform(random), 2);
      if (!spec.perChannel && spec.choices.empty()) values.values[i] = Rgb(values.values[i].x);
    }
    all.emplace_back(std::string(model->spec().id) + ", random parameters", model->instantiate(values));
  }
  const Form table = bakeTable(*glossy(0.2), {.thetaHCount = 30, .thetaDCount = 20, .phiDCount = 36});
  const Form whole =
      bakeTable(*glossy(0.5), {.thetaHCount = 20, .thetaDCount = 15, .phiDCount = 40, .reciprocal = false});
  all.emplace_back("table", table);
  all.emplace_back("table of the whole circle", whole);
  all.emplace_back("retroreflector", retroreflector(35.5, 39.5, 2, 300));
  all.emplace_back("raised F1", factorization::makePdvBrdf(raisedFactors(34.4, 39.6, 2)));
  for (const DataTransform transform :
       {DataTransform::logPlus, DataTransform::cosineLog, DataTransform::root, DataTransform::none}) {
    for (const int terms : {1, 4}) all.emplace_back("factors", factorised(terms, transform));
    all.emplace_back("factors with negative values", factorsWithNegativeValues(transform));
  }
  all.emplace_back("factors of many terms", factorsOfManyTerms());
  for (const IncidentDirection incident : allIncidentDirections) {
    all.emplace_back("UTIA", utia(incident));
    for (const bool isotropic : {true, false}) all.emplace_back("RGL", adaptive(isotropic, incident));
  }
  for (const bool symmetric : {true, false})
    for (const auto axis : {IncidenceTable::Axis::mirror, IncidenceTable::Axis::normal})
      all.emplace_back("incidence table", incidences(axis, symmetric));
  all.emplace_back("code", materials::readMaterial(test::codeFile("paper_blue")).brdf);
  all.emplace_back("code of both orders", codeOfBothOrders());
  for (const Form& base : {table, glossy(0.1)})
    for (const auto composition : {editing::Composition::additive, editing::Composition::logPlus})
      for (const double strength : {1.0, 0.4})
        all.emplace_back("edited", edited(base, composition, strength, base == table));
  all.emplace_back("lobes of a table", lobed(table, "ggx", 2, true, 0.7, true));
  models::ParameterValues every = models::defaultParameters(models::findModel("layered").spec());
  for (const char* id : {"sheen", "retro", "sheen-lobe", "retro-lobe"})
    every.values[*models::findModel("layered").spec().find(id)] = Rgb(1);
  all.emplace_back("layers of every kind", models::findModel("layered").instantiate(every));
  for (const double scale : {0.1, 0.4}) all.emplace_back("network", neural(scale));
  all.emplace_back("sum", weightedSum({table, glossy(0.3), all[1].second}, {0.2, 0.5, 0.3}));
  return all;
}

/// Forms of which no bound is known, so that everything is simulated.
bool hasNoBound(const std::string& name) {
  for (const char* id : {"holzschuch-pacanowski", "weidlich-wilkie", "spherical-harmonics"})
    if (name.starts_with(id)) return true;
  return false;
}

/// Light for a viewer and a half vector by its angles from the viewer's azimuth.
DirectionPair pairAt(double thetaO, double phiO, double thetaH, double psi) {
  const Direction wo = fromSpherical(thetaO, phiO), h = fromSpherical(thetaH, phiO + psi);
  return {2 * glm::dot(wo, h) * h - wo, wo};
}

/// The directional albedo by a grid of half vectors that is fine about the normal, the largest channel.
double albedoByHalfVectors(const Brdf& brdf, double thetaO, double phiO) {
  constexpr int rings = 240, sectors = 60;
  std::vector<DirectionPair> pairs;
  std::vector<double> weights;
  for (int i = 0; i < rings; ++i) {
    const double low = halfPi * std::pow(double(i) / rings, 2), high = halfPi * std::pow(double(i + 1) / rings, 2);
    for (int k = 0; k < sectors; ++k) {
      const DirectionPair pair = pairAt(thetaO, phiO, (low + high) / 2, 2 * pi * (k + 0.5) / sectors);
      const double cosD = std::sqrt((1 + glm::dot(pair.wi, pair.wo)) / 2);
      if (!(pair.wi.z > 0)) continue;
      pairs.push_back(pair);
      weights.push_back(4 * cosD * pair.wi.z * (std::cos(low) - std::cos(high)) * 2 * pi / sectors);
    }
  }
  std::vector<Rgb> values(pairs.size());
  brdf.evaluate(pairs, values);
  Rgb sum(0);
  for (std::size_t i = 0; i < values.size(); ++i) sum += weights[i] * values[i];
  return maxChannel(sum);
}

double largestAlbedo(const Brdf& brdf, double step) {
  double largest = 0;
  for (double theta = 0; theta < 90; theta += step)
    for (int turn = 0; turn < (brdf.isIsotropic() ? 1 : 7); ++turn)
      largest = std::max(largest, albedoByHalfVectors(brdf, radians(theta), 0.9 * turn));
  return largest;
}

class ReflectionBoundTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Pairs of random boxes, from narrow to wide: no value leaves the bounds of its box.
  void valuesLieWithinTheirBounds() {
    auto all = forms();
    const Form table = bakeTable(*glossy(0.2), {.thetaHCount = 30, .thetaDCount = 20, .phiDCount = 36});
    for (auto& form : lobedForms(table)) all.push_back(form);
    for (const auto& [name, brdf] : all) {
      const auto bound = brdf->valueBound();
      QVERIFY2((bound == nullptr) == hasNoBound(name), name.c_str());
      if (!bound) continue;
      std::mt19937_64 random(1);
      const auto rangeIn = [&](double low, double high) {
        const double width = (high - low) * std::pow(10, -4 * test::uniform(random));
        const double start = low + (high - low - width) * test::uniform(random);
        return Range(start, start + width);
      };
      const auto in = [&](const Range& range) { return range.low + range.width() * test::uniform(random); };
      for (int n = 0; n < 1500; ++n) {
        const bool atHighlight = n % 3 == 0;
        const double mostHalf = atHighlight ? 0.05 : halfPi;
        const PairBox box(rangeIn(0, halfPi), rangeIn(0, mostHalf), rangeIn(0, pi),
                          brdf->isIsotropic() ? Range(0) : rangeIn(0, 2 * pi));
        const RgbRange values = bound->over(box);
        for (int k = 0; k < 12; ++k) {
          const double side = brdf->isIsotropic() && k % 2 == 1 ? -1 : 1;
          const DirectionPair pair = pairAt(in(box.thetaO), in(box.phiO), in(box.thetaH), side * in(box.psi));
          if (!(pair.wi.z > 0) || !(pair.wo.z > 0)) continue;
          QVERIFY(!box.isEmpty());
          QVERIFY(box.cosI.high >= pair.wi.z - 1e-12 && box.cosI.low <= pair.wi.z + 1e-12);
          const Rgb value = brdf->evaluate(pair.wi, pair.wo);
          for (int c = 0; c < 3; ++c) {
            const double slack = 1e-6 * std::abs(value[c]) + 1e-12;
            if (value[c] <= values.high[c] + slack && value[c] >= values.low[c] - slack) continue;
            QFAIL(qPrintable(QString("%1: %2 outside [%3, %4]")
                                 .arg(name.c_str())
                                 .arg(value[c])
                                 .arg(values.low[c])
                                 .arg(values.high[c])));
          }
        }
      }
    }
  }

  /// The directional albedo at dense viewers never exceeds the bound.
  void noViewerSeesMore() {
    for (const auto& [name, brdf] : forms()) {
      const ReflectionBound bound = boundOf(brdf);
      const double found = largestAlbedo(*brdf, 8.9);
      QVERIFY2(bound.maxAlbedo() >= 0.999 * found,
               qPrintable(QString("%1: %2, bound %3").arg(name.c_str()).arg(found).arg(bound.maxAlbedo())));
    }
  }

  /// It is not far above it for the common forms, so that plans save what they can.
  void itIsTight() {
    const std::vector<std::pair<Form, double>> cases{{glossy(0.3), 1.45},
                                                     {glossy(0.1), 1.8},
                                                     {glossy(0.01), 2.7},
                                                     {bakeTable(*glossy(0.2)), 1.9},
                                                     {factorised(1, DataTransform::root), 1.8}};
    for (const auto& [brdf, factor] : cases) {
      const double found = largestAlbedo(*brdf, 4.99), bound = boundOf(brdf).maxAlbedo();
      QVERIFY2(bound < factor * found, qPrintable(QString("%1, bound %2").arg(found).arg(bound)));
    }
  }

  /// Reflection between two angles of the viewer alone, retroreflection, and one raised cell.
  void narrowBandsAreNotOverlooked() {
    const auto band = factorization::makePdvBrdf(raisedFactors(34.4, 39.6, 2));
    QVERIFY(boundOf(band).maxAlbedo() > 2 * pi);
    const Form ring = retroreflector(35.5, 39.5, 2, 300);
    const double seen = albedoByHalfVectors(*ring, radians(37.5), 0);
    QVERIFY(seen > 0.1);
    QVERIFY(boundOf(ring).maxAlbedo() > seen);
    for (const double thetaH : {0.0, 20.0, 61.0}) {
      const Form spike = retroreflector(thetaH - 0.6, thetaH + 0.6, 1.5, 1e6);
      QVERIFY(boundOf(spike).maxAlbedo() >= 0.99 * largestAlbedo(*spike, 1));
      QVERIFY(boundOf(spike).maxAlbedo() > 1);
    }
  }

  /// A material that reflects along some azimuths alone has no azimuth that stands for all.
  void narrowAzimuthsAreNotOverlooked() {
    std::vector<glm::vec3> values(UtiaBrdf::directionCount * UtiaBrdf::directionCount, glm::vec3(0));
    const std::size_t viewer = 2 * UtiaBrdf::azimuthCount + 5;
    for (std::size_t light = 0; light < UtiaBrdf::directionCount; ++light)
      values[viewer * UtiaBrdf::directionCount + light] = glm::vec3(0.3f);
    const Form brdf = std::make_shared<const UtiaBrdf>(values);
    const double seen = albedoByHalfVectors(*brdf, 2 * UtiaBrdf::polarStep, 5 * UtiaBrdf::azimuthStep);
    QVERIFY(seen > 0.9);
    QVERIFY(boundOf(brdf).maxAlbedo() >= seen);
  }

  /// A(F) = albedo F in the brightest channel.
  void lambertIsALine() {
    const Rgb reflectance(0.3, 0.7, 0.1);
    const Form lambert = models::findModel("lambert").instantiate({{reflectance}});
    for (const ReflectionBound& bound : {diffuseMaterial(reflectance)->bound(), boundOf(lambert)})
      for (double fraction = 0; fraction <= 1; fraction += 1.0 / 256) {
        QVERIFY(bound.at(fraction) >= 0.7 * fraction * (1 - 1e-12));
        QVERIFY(bound.at(fraction) <= 0.7 * fraction * (1 + 1e-5));
      }
  }

  /// All that a mirror reflects may come from a speck.
  void mirrorsRiseAtOnce() {
    const ReflectionBound bound = boundOf(test::ggx(Rgb(0), Rgb(1), 0.005, 0.9));
    QVERIFY(bound.maxAlbedo() > 0.85);
    QVERIFY(bound.at(1e-3) > 0.8);
    QVERIFY(bound.at(1e-4) > 0.5);
    QCOMPARE(bound.at(0), 0.0);
  }

  void itNeverFalls() {
    for (const double roughness : {0.003, 0.05, 0.2, 0.7}) {
      const ReflectionBound bound = boundOf(glossy(roughness));
      double last = 0;
      for (double place = 0; place <= 1; place += 1.0 / 500) {
        const double value = bound.at(place * place);
        QVERIFY(std::isfinite(value) && value >= last * (1 - 1e-12));
        last = value;
      }
      QCOMPARE(bound.at(2), bound.at(1));
      QCOMPARE(bound.at(0), 0.0);
    }
  }

  /// A(F) of single viewers by brute force: all cells of a grid of the hemisphere, the brightest first.
  void fractionsAreBounds() {
    constexpr int rings = 300, sectors = 300;  // a half: models are symmetric about the plane of the viewer
    for (const double roughness : {0.1, 0.3, 0.6}) {
      const Form brdf = glossy(roughness);
      const ReflectionBound bound = boundOf(brdf);
      std::vector<double> largest(rings * sectors, 0);
      for (const double theta : {0.0, 30.0, 60.0, 75.0, 80.0, 85.0, 89.0}) {
        std::vector<double> values;
        const Direction wo = fromSpherical(radians(theta), 0);
        for (int i = 0; i < rings; ++i)
          for (int j = 0; j < sectors; ++j)
            values.push_back(maxChannel(
                brdf->evaluate(fromSpherical(std::asin(std::sqrt((i + 0.5) / rings)), pi * (j + 0.5) / sectors), wo)));
        std::ranges::sort(values, std::greater());
        double sum = 0;
        for (std::size_t n = 0; n < values.size(); ++n)
          largest[n] = std::max(largest[n], sum += pi * values[n] / double(values.size()));
      }
      for (const double fraction : {0.001, 0.01, 0.1, 0.3, 1.0}) {
        const double expected = largest[std::size_t(fraction * double(largest.size())) - 1], found = bound.at(fraction);
        QVERIFY2(
            found > 0.98 * expected && found < 2.2 * expected + 1.0 / 512,
            qPrintable(QString("%1 at %2: %3, expected %4").arg(roughness).arg(fraction).arg(found).arg(expected)));
      }
    }
  }

  void blackIsBlack() {
    const auto blackness = [](const Form& brdf) { return RenderMaterial(brdf).isBlack(); };
    QVERIFY(diffuseMaterial(Rgb(0))->isBlack());
    QVERIFY(!diffuseMaterial({0, 0, 1e-6})->isBlack());
    QVERIFY(blackness(test::ggx(Rgb(0), Rgb(0), 0.1, 1)));
    QVERIFY(blackness(retroreflector(0, 0, 0, 0)) == false);
    const HalfDifferenceGrid grid{.thetaHCount = 9, .thetaDCount = 9, .phiDCount = 9};
    std::vector<TabulatedBrdf::Value> values(grid.size(), TabulatedBrdf::Value(0));
    const auto table = [&] {
      return std::make_shared<const TabulatedBrdf>(grid, values, std::vector<std::uint8_t>(grid.size(), 1));
    };
    QVERIFY(blackness(table()));
    values[grid.index(4, 5, 3)] = TabulatedBrdf::Value(0, 0, 1e-3f);
    QVERIFY(!blackness(table()));
  }

  /// Where no bound of the values is known, none of the reflection is.
  void unknownIsInfinite() {
    const Form unknown =
        std::make_shared<const test::FunctionBrdf>([](const Direction&, const Direction&) { return Rgb(0); });
    QVERIFY(!boundOf(unknown).isFinite() && std::isinf(boundOf(unknown).at(1e-9)));
    QVERIFY(!RenderMaterial(unknown).isBlack());
  }
};

GONIO_TEST(ReflectionBoundTest)
}  // namespace reflection_bound_test

#include "reflection_bound_test.moc"
