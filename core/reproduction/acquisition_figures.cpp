// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
//
// FROST and the baseline of Nielsen et al. 2015: figures 5.5 to 5.9 and table 5.1.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <set>

#include "core/acquisition/reconstruction.h"
#include "core/acquisition/sample_selection.h"
#include "core/brdf/data_transform.h"
#include "core/coordinates/half_difference.h"
#include "core/math/parallel.h"
#include "core/rendering/error_maps.h"
#include "core/reproduction/mapped_errors.h"
#include "core/reproduction/picture_rows.h"
#include "core/study/study_record.h"
#include "core/support/text.h"

namespace gonio::reproduction {

namespace {

using acquisition::SelectionMethod;
using dictionary::PrincipalComponents;

std::vector<Subject> pipelineSubjects() {
  return {{MaterialSet::merl, "gold-metallic-paint2", {"gold-metallic-paint3", "gold-metallic-paint"}}};
}
std::vector<Subject> ringSubjects() {
  return {{MaterialSet::rgl, "vch-silk-blue", {"vch-ultra-pink", "vch-golden-yellow"}}};
}
std::vector<Subject> threeSubjects() {
  return {{MaterialSet::merl, "green-latex", {"green-fabric", "green-plastic"}},
          {MaterialSet::merl, "gold-metallic-paint2", {"gold-metallic-paint3", "gold-metallic-paint"}},
          {MaterialSet::rgl, "cm-white", {"cm-toxic-green", "cm-military-green"}}};
}

constexpr std::array learnedSets{MaterialSet::merl, MaterialSet::rgl};

/// Training set of the figures that show materials: without all of these, and without the test materials of a quick
/// run, so that these figures share their components.
std::vector<InputMaterial> heldOutTraining(const Inputs& inputs) {
  std::set<std::string> held;
  for (const auto& subjects : {pipelineSubjects(), ringSubjects(), threeSubjects()})
    for (const Subject& subject : subjects) held.insert(inputs.find(subject).name);
  for (const InputMaterial& material : inputs.testMaterials(learnedSets)) held.insert(material.name);
  std::vector<InputMaterial> training = inputs.trainingMaterials();
  std::erase_if(training, [&](const InputMaterial& material) { return held.contains(material.name); });
  return training;
}

struct Selected {
  acquisition::SamplingPlan plan;
  double seconds = 0;
};

/// @param trial seed of the search of Nielsen et al.
Selected selected(const PrincipalComponents& basis, SelectionMethod method, int samples, int trial,
                  const TaskControl& control) {
  const auto start = std::chrono::steady_clock::now();
  const acquisition::SelectionOptions options{
      .method = method, .samples = samples, .seed = std::uint64_t(trial), .restarts = 5};
  const auto selection = acquisition::selectSamples(basis, options, {control.stop, {}});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return {acquisition::planFor(basis.mapping.grid, selection.cells), seconds};
}

acquisition::ReconstructionOptions publishedWithoutUncertainty() {
  acquisition::ReconstructionOptions options = acquisition::publishedReconstruction();
  options.uncertainty = false;
  return options;
}

std::shared_ptr<const TabulatedBrdf> reconstructed(const PrincipalComponents& basis, const TabulatedBrdf& material,
                                                   const acquisition::SamplingPlan& plan, const TaskControl& control) {
  return acquisition::reconstruct(basis, plan, acquisition::measure(material, plan), publishedWithoutUncertainty(),
                                  {control.stop, {}})
      .table;
}

using Tables = std::vector<std::shared_ptr<const TabulatedBrdf>>;

Tables tablesOf(const std::vector<InputMaterial>& materials, Inputs& inputs, const TaskControl& control) {
  Tables tables;
  for (const InputMaterial& material : materials) tables.push_back(inputs.table(material, control));
  return tables;
}

/// Inverse MSE of the materials, each reconstructed from the samples of the plan.
std::vector<double> inverseErrors(const PrincipalComponents& basis, const MappedMaterials& mapped, const Tables& tables,
                                  const acquisition::SamplingPlan& plan,
                                  const acquisition::ReconstructionOptions& options, const TaskControl& control) {
  std::vector<dictionary::ComponentCode> codes;
  for (const auto& table : tables)
    codes.push_back(acquisition::reconstructCode(basis, plan, acquisition::measure(*table, plan), options).code);
  return mapped.inverseErrors(codes, {control.stop, {}});
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? std::nan("") : sum / double(values.size());
}

// Figure 5.5.

MadeFigure makePipeline(const FigureRecord& record, Inputs& inputs, const TaskControl& control) {
  constexpr int samples = 20;
  const auto training = heldOutTraining(inputs);
  const auto basis = inputs.basis(training, control.between(0, 0.8));
  const InputMaterial subject = inputs.find(record.subjects[0]);
  const auto table = inputs.table(subject, control);
  const Selected chosen = selected(*basis, SelectionMethod::simultaneousPursuit, samples, runSeed, control);
  const auto result = reconstructed(*basis, *table, chosen.plan, control);
  const rendering::RenderedComparison comparison(*table, inputs.picture(), {control.stop, {}});
  const auto picture = comparison.render(*result, {control.stop, {}});
  MadeFigure made;
  Chart variance{.title = "(a) variance in the first components",
                 .xTitle = "number of components",
                 .yTitle = "fraction",
                 .series = {{.points = {}}},
                 .yRange = std::array{0., 1.02}};
  const Eigen::VectorXd sigma = basis->svd.singularValues.cast<double>();
  std::vector<double> numbers, fractions;
  double sum = 0;
  for (Eigen::Index k = 0; k < sigma.size(); ++k) {
    sum += sigma[k] * sigma[k];
    numbers.push_back(double(k + 1));
    fractions.push_back(sum / sigma.squaredNorm());
    variance.series[0].points.emplace_back(numbers.back(), fractions.back());
  }
  Chart places{.title = "(b) chosen directions",
               .xTitle = "theta_h [degrees]",
               .yTitle = "theta_d [degrees]",
               .series = {{.points = {}, .isLine = false, .hasMarkers = true}},
               .xRange = std::array{0., 90.},
               .yRange = std::array{0., 90.}};
  for (const auto& sample : chosen.plan.samples) {
    const HalfDifference at = toHalfDifference(sample.directions.wi, sample.directions.wo);
    places.series[0].points.emplace_back(degrees(at.thetaH), degrees(at.thetaD));
  }
  std::vector<Chart> charts{variance, places};
  const double ratio = comparison.signalToNoiseRatio(picture);
  for (const auto& [title, image] :
       {std::pair{std::string("(c) measured: ") + shownName(subject), &comparison.reference()},
        std::pair{"(d) from 20 samples: SNR " + shortText(ratio) + " dB", &picture.image}})
    charts.push_back({.title = title,
                      .xTitle = {},
                      .yTitle = {},
                      .series = {},
                      .xRange = std::array{0., 1.},
                      .yRange = std::array{0., 1.},
                      .isDisk = true,
                      .raster = shownPicture(*image)});
  made.drawing = drawCharts(std::string(record.title), charts, 2);
  made.table.columns = {{"number of components", numbers}, {"fraction of the variance", fractions}};
  made.values = {{"training materials", "", double(training.size())},
                 {"components with 99 % of the variance", "",
                  double(std::ranges::lower_bound(fractions, 0.99) - fractions.begin() + 1)},
                 {"rendered SNR, 20 samples", "dB", ratio}};
  return made;
}

// Figure 5.6.

MadeFigure makeSamplesAndComponents(const FigureRecord& record, Inputs& inputs, const TaskControl& control) {
  const auto basis = inputs.basis(heldOutTraining(inputs), control.between(0, 0.3));
  std::vector<InputMaterial> tests = inputs.testMaterials(learnedSets);
  if (!inputs.quick())
    for (const auto& subjects : {ringSubjects(), threeSubjects()})
      for (const Subject& subject : subjects) tests.push_back(inputs.find(subject));
  std::vector<int> sampleCounts, componentCounts;
  constexpr int step = 10;
  const int most = inputs.quick() ? 45 : 195;
  for (int m = 5; m <= most; m += step) sampleCounts.push_back(m);
  for (int p = 5; p <= std::min(inputs.quick() ? 45 : 135, basis->count()); p += step) componentCounts.push_back(p);
  const Selected chosen = selected(*basis, SelectionMethod::simultaneousPursuit,
                                   std::min(sampleCounts.back(), basis->count()), runSeed, control);
  const Tables tables = tablesOf(tests, inputs, control);
  const MappedMaterials mapped(*basis, tables);
  MadeFigure made;
  std::vector<double> ms, ps, inverses;
  for (const int p : componentCounts)
    for (const int m : sampleCounts) {
      if (m > int(chosen.plan.samples.size())) continue;
      acquisition::SamplingPlan first = chosen.plan;
      first.samples.resize(std::size_t(m));
      const acquisition::ReconstructionOptions options{
          .ridge = acquisition::publishedRidge, .components = p, .uncertainty = false, .equalNoise = true};
      ms.push_back(m), ps.push_back(p);
      inverses.push_back(mean(inverseErrors(*basis, mapped, tables, first, options, control)));
      control.report(0.3 + 0.7 * double(inverses.size()) / double(sampleCounts.size() * componentCounts.size()));
    }
  // A square of the picture for each pair.
  const double highest = *std::ranges::max_element(inverses);
  figures::Raster raster{int(sampleCounts.size()), int(componentCounts.size()), {}};
  raster.rgba.assign(4 * sampleCounts.size() * componentCounts.size(), 255);
  for (std::size_t i = 0; i < inverses.size(); ++i) {
    const std::size_t column = std::size_t(std::ranges::find(sampleCounts, int(ms[i])) - sampleCounts.begin());
    const std::size_t row = componentCounts.size() - 1 -
                            std::size_t(std::ranges::find(componentCounts, int(ps[i])) - componentCounts.begin());
    const auto colour = rendering::viridis(inverses[i] / highest);
    std::ranges::copy(colour, raster.rgba.begin() + std::ptrdiff_t(4 * (row * sampleCounts.size() + column)));
  }
  const double half = step / 2.0;
  const Chart chart{.title = "inverse MSE, from 0 (dark) to " + shortText(highest),
                    .xTitle = "number of samples m",
                    .yTitle = "number of components p",
                    .series = {},
                    .xRange = std::array{sampleCounts.front() - half, sampleCounts.back() + half},
                    .yRange = std::array{componentCounts.front() - half, componentCounts.back() + half},
                    .raster = raster};
  made.drawing = drawCharts(std::string(record.title), std::array{chart}, 1);
  made.table.columns = {{"samples m", ms}, {"components p", ps}, {"inverse MSE", inverses}};
  const std::size_t best = std::size_t(std::ranges::max_element(inverses) - inverses.begin());
  made.values = {{"inverse MSE at the fewest samples and components", "", inverses.front()},
                 {"highest inverse MSE", "", highest},
                 {"number of samples there", "", ms[best]},
                 {"number of components there", "", ps[best]}};
  return made;
}

// Figure 5.7.

struct Errors {
  std::string name;
  std::map<int, std::vector<double>> inverse;  ///< of the test materials, by the number of samples
};

constexpr int printedTrialSamples = 40;

/// A box from the quartiles, whiskers to the extremes, and a mark at the mean.
void addBox(Chart& chart, double x, const std::vector<double>& values) {
  const double low = study::quantile(values, 0.25), high = study::quantile(values, 0.75);
  const double least = study::quantile(values, 0), most = study::quantile(values, 1), w = 0.3;
  const std::string colour = chart.series.empty() ? "#0072b2" : "#009e73";
  chart.series.push_back(
      {.points = {{x - w, low}, {x + w, low}, {x + w, high}, {x - w, high}, {x - w, low}}, .colour = colour});
  chart.series.push_back({.points = {{x, high}, {x, most}}, .colour = colour, .isDashed = true});
  chart.series.push_back({.points = {{x, low}, {x, least}}, .colour = colour, .isDashed = true});
  chart.series.push_back({.points = {{x, mean(values)}},
                          .colour = colour,
                          .isLine = false,
                          .hasMarkers = true,
                          .marker = plots::Marker::star});
}

MadeFigure makeErrors(const FigureRecord& record, Inputs& inputs, const TaskControl& control) {
  const std::vector<InputMaterial> all = inputs.trainingMaterials();
  const int folds = inputs.quick() ? 1 : 10, trials = inputs.quick() ? 2 : 5;
  const std::vector<int> counts = inputs.quick() ? std::vector<int>{5, 10, 20, 40}
                                                 : std::vector<int>{5, 10, 15, 20, 25, 30, 35, 40, 45, 50, 55, 60};
  Errors full, fewer;
  std::vector<Errors> searches(std::size_t(trials), Errors{"", {}});
  std::size_t trainingCount = 0, fewerCount = 0;
  for (int fold = 0; fold < folds; ++fold) {
    std::vector<InputMaterial> training, tests;
    if (inputs.quick()) {
      training = heldOutTraining(inputs);
      tests = inputs.testMaterials(learnedSets);
    } else {
      for (std::size_t i = 0; i < all.size(); ++i)
        (int(i % std::size_t(folds)) == fold ? tests : training).push_back(all[i]);
    }
    trainingCount = training.size();
    fewerCount = std::min<std::size_t>(80, std::size_t(std::lround(double(trainingCount) * 80 / 131)));
    std::vector<InputMaterial> part;
    for (std::size_t i = 0; i < fewerCount; ++i) part.push_back(training[i * trainingCount / fewerCount]);
    const Tables tables = tablesOf(tests, inputs, control);
    const auto measureAll = [&](const PrincipalComponents& basis, const MappedMaterials& mapped, SelectionMethod method,
                                int trial, Errors& errors) {
      for (const int m : counts) {
        const Selected chosen = selected(basis, method, m, trial, control);
        const std::vector<double> own =
            inverseErrors(basis, mapped, tables, chosen.plan, publishedWithoutUncertainty(), control);
        errors.inverse[m].insert(errors.inverse[m].end(), own.begin(), own.end());
      }
    };
    const auto at = [&](double fraction) { return (fold + fraction) / folds; };
    {
      const auto basis = inputs.basis(part, control.between(at(0), at(0.15)));
      measureAll(*basis, MappedMaterials(*basis, tables), SelectionMethod::simultaneousPursuit, runSeed, fewer);
    }
    const auto basis = inputs.basis(training, control.between(at(0.2), at(0.4)));
    const MappedMaterials mapped(*basis, tables);
    measureAll(*basis, mapped, SelectionMethod::simultaneousPursuit, runSeed, full);
    for (int trial = 0; trial < trials; ++trial) {
      measureAll(*basis, mapped, SelectionMethod::conditionNumber, runSeed + trial, searches[std::size_t(trial)]);
      control.report(at(0.5 + 0.5 * (trial + 1) / trials));
    }
  }
  Errors search;
  for (const Errors& one : searches)
    for (const auto& [m, values] : one.inverse)
      search.inverse[m].insert(search.inverse[m].end(), values.begin(), values.end());
  full.name = "FROST, t = " + std::to_string(trainingCount);
  fewer.name = "FROST, t = " + std::to_string(fewerCount);
  search.name = "Nielsen et al. 2015, t = " + std::to_string(trainingCount);
  Chart curves{.title = "(a) mean over test materials",
               .xTitle = "number of samples",
               .yTitle = "inverse MSE",
               .series = {},
               .xRange = std::array{0., counts.back() + 5.}};
  MadeFigure made;
  made.table.columns = {{"method", {}}, {"samples", {}}, {"mean inverse MSE", {}}};
  for (const Errors* errors : {&full, &fewer, &search}) {
    ChartSeries series{.name = errors->name, .points = {}, .hasMarkers = true};
    for (const auto& [m, values] : errors->inverse) {
      series.points.emplace_back(m, mean(values));
      made.table.columns[0].texts.push_back(errors->name);
      made.table.columns[1].values.push_back(m);
      made.table.columns[2].values.push_back(mean(values));
    }
    curves.series.push_back(std::move(series));
    for (const int m : {5, 20, 40})
      made.values.push_back(
          {errors->name + ", " + std::to_string(m) + " samples, mean inverse MSE", "", mean(errors->inverse.at(m))});
  }
  Chart boxes{
      .title = "(b) 40 samples: FROST, trials 1 to " + std::to_string(trials) + " of Nielsen et al., all trials",
      .xTitle = "method",
      .yTitle = "inverse MSE",
      .series = {},
      .xRange = std::array{0., trials + 3.}};
  addBox(boxes, 1, full.inverse.at(printedTrialSamples));
  for (int trial = 0; trial < trials; ++trial)
    addBox(boxes, trial + 2, searches[std::size_t(trial)].inverse.at(printedTrialSamples));
  addBox(boxes, trials + 2, search.inverse.at(printedTrialSamples));
  made.drawing = drawCharts(std::string(record.title), std::array{curves, boxes}, 2);
  if (inputs.quick()) made.remarks = {"One split instead of ten folds, and two trials instead of five."};
  return made;
}

// Figures 5.8 and 5.9.

MadeFigure compareReconstructions(const FigureRecord& record, Inputs& inputs, int samples, const TaskControl& control) {
  const auto training = heldOutTraining(inputs);
  const auto basis = inputs.basis(training, control.between(0, 0.8));
  const Selected search = selected(*basis, SelectionMethod::conditionNumber, samples, runSeed, control);
  const Selected pursuit = selected(*basis, SelectionMethod::simultaneousPursuit, samples, runSeed, control);
  PictureRows rows(inputs.picture());
  MadeFigure made;
  for (const Subject& subject : record.subjects) {
    const InputMaterial material = inputs.find(subject);
    const auto table = inputs.table(material, control);
    const std::array compared{ComparedBrdf{"Nielsen et al. 2015", reconstructed(*basis, *table, search.plan, control)},
                              ComparedBrdf{"FROST", reconstructed(*basis, *table, pursuit.plan, control)}};
    const auto ratios = rows.add(shownName(material), *table, compared, control);
    for (std::size_t i = 0; i < compared.size(); ++i)
      made.values.push_back({std::string(subject.name) + ", " + compared[i].label + ", rendered SNR", "dB", ratios[i]});
  }
  made.drawing = rows.draw(std::string(record.title));
  made.table = rows.table();
  made.remarks = {"Training set: " + std::to_string(training.size()) + " materials, none of those shown."};
  return made;
}

MadeFigure makeRings(const FigureRecord& record, Inputs& inputs, const TaskControl& control) {
  return compareReconstructions(record, inputs, 10, control);
}
MadeFigure makeThreeReconstructions(const FigureRecord& record, Inputs& inputs, const TaskControl& control) {
  return compareReconstructions(record, inputs, 20, control);
}

// Table 5.1.

MadeFigure makeTimes(const FigureRecord& record, Inputs& inputs, const TaskControl& control) {
  const auto basis = inputs.basis(heldOutTraining(inputs), control.between(0, 0.6));
  const std::vector<int> counts =
      inputs.quick() ? std::vector<int>{5, 10, 20} : std::vector<int>{5, 10, 20, 30, 40, 50, 60};
  std::vector<std::vector<std::string>> rows;
  MadeFigure made;
  made.table.columns = {{"samples m", {}}, {"FROST [s]", {}}, {"Nielsen et al. 2015 [s]", {}}};
  for (const int m : counts) {
    const double frost = selected(*basis, SelectionMethod::simultaneousPursuit, m, runSeed, control).seconds;
    const double search = selected(*basis, SelectionMethod::conditionNumber, m, runSeed, control).seconds;
    rows.push_back({std::to_string(m), shortText(frost, 3), shortText(search, 3)});
    made.table.columns[0].values.push_back(m);
    made.table.columns[1].values.push_back(frost);
    made.table.columns[2].values.push_back(search);
    made.values.push_back({"FROST, m = " + std::to_string(m), "s", frost});
    made.values.push_back({"Nielsen et al. 2015, m = " + std::to_string(m), "s", search});
    control.report(0.6 + 0.4 * double(rows.size()) / double(counts.size()));
  }
  made.drawing = drawTable(std::string(record.title),
                           std::vector<std::string>{"samples m", "FROST [s]", "Nielsen et al. 2015 [s]"}, rows);
  return made;
}

constexpr std::string_view trainingAndScene =
    "The training set differs from that of the print (MERL and EPFL, 131 materials), and so does the scene. The pixels "
    "of a background, which are not counted here, add 3 to 14 dB (docs/results/acquisition-study.md).";

}  // namespace

std::vector<FigureRecord> acquisitionFigures() {
  return {
      {.id = "5.1",
       .isTable = true,
       .title = "Time to choose m samples",
       .shows = "Seconds on this machine, without learning the components.",
       .source = "table 5.1",
       .printed = {{"FROST, m = 5", 0.14, true},
                   {"FROST, m = 10", 0.47, true},
                   {"FROST, m = 20", 1.86, true},
                   {"FROST, m = 30", 4.21, true},
                   {"FROST, m = 40", 7.49, true},
                   {"FROST, m = 50", 12.05, true},
                   {"FROST, m = 60", 17.67, true},
                   {"Nielsen et al. 2015, m = 5", 76.01, true},
                   {"Nielsen et al. 2015, m = 10", 248.67, true},
                   {"Nielsen et al. 2015, m = 20", 772.74, true},
                   {"Nielsen et al. 2015, m = 30", 1600.46, true},
                   {"Nielsen et al. 2015, m = 40", 2772.74, true},
                   {"Nielsen et al. 2015, m = 50", 4357.08, true},
                   {"Nielsen et al. 2015, m = 60", 6366.88, true}},
       .differences =
           "The print's times are those of MATLAB on another machine. Gonio's search for the smallest condition "
           "number has five starts and updates factorisations instead of computing each again.",
       .isLearned = true,
       .fullMinutes = 2,
       .quickMinutes = 0.6,
       .make = makeTimes},
      {.id = "5.5",
       .title = "The steps of FROST",
       .shows = "Components of the training set, 20 chosen directions, and a material reconstructed from them.",
       .source = "figure 5.5: a diagram, no numbers printed",
       .subjects = pipelineSubjects(),
       .isLearned = true,
       .fullMinutes = 0.2,
       .quickMinutes = 0.1,
       .make = makePipeline},
      {.id = "5.6",
       .title = "Inverse MSE over the numbers of samples and components",
       .shows =
           "Mean over test materials, in the mapped values of eq. 5.7; directions by FROST over as many components as "
           "the largest number of samples, ridge 40.",
       .source = "figure 5.6: colours without numbers; the inverse MSE rises with both",
       .differences = "The print chooses the directions anew for each number of components.",
       .subjects = threeSubjects(),
       .isLearned = true,
       .fullMinutes = 2,
       .quickMinutes = 0.4,
       .make = makeSamplesAndComponents},
      {.id = "5.7",
       .title = "Inverse MSE over the number of samples",
       .shows = "FROST over the whole and a smaller training set, and the search of Nielsen et al. with several seeds; "
                "cross-validation in ten folds.",
       .source = "figure 5.7: plots only; axes to 25 (a) and 200 (b), FROST above Nielsen et al.",
       .differences = "The print does not state the domain of its MSE; here the mapped values of eq. 5.7.",
       .wholeSets = {MaterialSet::merl, MaterialSet::rgl},
       .isLearned = true,
       .fullMinutes = 30,
       .quickMinutes = 1.3,
       .make = makeErrors},
      {.id = "5.8",
       .title = "A material from ten samples",
       .shows = "vch-silk-blue by the directions of Nielsen et al. and of FROST.",
       .source = "figure 5.8: no numbers printed; rings by Nielsen et al., fewer by FROST",
       .differences = trainingAndScene,
       .subjects = ringSubjects(),
       .isLearned = true,
       .fullMinutes = 0.3,
       .quickMinutes = 0.1,
       .make = makeRings},
      {.id = "5.9",
       .title = "Three materials from 20 samples",
       .shows = "green-latex, gold-metallic-paint2 and cm-white by the directions of Nielsen et al. and of FROST, "
                "reconstructed with ridge 40 and as many components as samples.",
       .source = "figure 5.9; the assignment to methods follows from the text",
       .printed = {{"green-latex, Nielsen et al. 2015, rendered SNR", 44.98},
                   {"gold-metallic-paint2, Nielsen et al. 2015, rendered SNR", 34.45},
                   {"cm-white, Nielsen et al. 2015, rendered SNR", 25.75},
                   {"green-latex, FROST, rendered SNR", 51.62},
                   {"gold-metallic-paint2, FROST, rendered SNR", 41.76},
                   {"cm-white, FROST, rendered SNR", 32.16}},
       .differences = trainingAndScene,
       .subjects = threeSubjects(),
       .isLearned = true,
       .fullMinutes = 0.5,
       .quickMinutes = 0.2,
       .make = makeThreeReconstructions},
  };
}

}  // namespace gonio::reproduction
