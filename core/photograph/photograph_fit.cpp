// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/photograph/photograph_fit.h"

#include <algorithm>
#include <cmath>

#include "core/brdf/data_transform.h"
#include "core/math/parallel.h"
#include "core/photograph/photograph_solution.h"
#include "core/support/text.h"

namespace gonio::photograph {

using Eigen::Index, Eigen::MatrixXd, Eigen::MatrixX3d, Eigen::VectorXd;

namespace {

void readRegions(const std::vector<Region>& regions, MatrixX3d& values, MatrixX3d& variances) {
  values.resize(Index(regions.size()), channelCount);
  variances.resize(Index(regions.size()), channelCount);
  for (std::size_t row = 0; row < regions.size(); ++row)
    for (int channel = 0; channel < 3; ++channel) {
      values(Index(row), channel) = regions[row].value[channel];
      variances(Index(row), channel) = regions[row].variance[channel];
    }
}

/// Photographs that are explained to less than this, dB, also after a correction, say nothing about the input: the
/// components cannot represent the material.
constexpr double leastExplained = 12;

/// Whether the estimate is significant and at least `noticeable`.
void judge(InputCheck& check, double noticeable) {
  constexpr double significant = 4.5;  // three deviations
  check.evidence = 0.5 * check.estimate * check.estimate / (check.deviation * check.deviation);
  check.isSuspicious =
      check.evidence >= significant && std::abs(check.estimate) > noticeable && check.unexplainedSnr > leastExplained;
}

constexpr double noticeableLogarithm = 0.1;

/// Of a stated exposure. A derivative does not serve: about the solution with it, a factor of the exposure looks like
/// the highlights that a material has and the prior lacks.
InputCheck exposureCheck(const ExposureEvidence& evidence) {
  InputCheck check{.property = "exposure",
                   .estimate = evidence.logarithm,
                   .deviation = evidence.deviation,
                   .unexplainedSnr = evidence.unexplainedSnr};
  judge(check, noticeableLogarithm);
  return check;
}

/// What the stated input may differ by, as derivatives of the pixel values by one number each.
class InputChecks {
 public:
  /// About the most likely material, with some rows of the problem. @param whole of all rows.
  InputChecks(const PixelProblem& whole, const PhotographSet& set, const std::vector<Region>& regions,
              const std::vector<std::size_t>& chosen, const MostLikely& found, const TaskControl& control)
      : set_(set),
        rows_(rowsAt(whole.rows, chosen)),
        problem_{whole.prior, rows_, whole.data(chosen, Eigen::all), whole.noise(chosen, Eigen::all),
                 std::min(1.0, whole.share * double(whole.rows.count()) / double(chosen.size()))},
        prior_(found.prior),
        x_(found.x),
        at_(linearised(whole.prior, rows_, whole.coefficients(x_), control)),
        weights_(problem_.weights(found.modelNoise)),
        normal_(inverseCovariance(problem_, at_, x_, weights_, prior_)),
        control_(control) {
    for (const std::size_t row : chosen) regions_.push_back(regions[row]);
    predicted_ = at_.values;
    fromMean_ = problem_.data - predicted_;  // data less the linearised values at the mean of the prior
    const VectorXd step = x_ - prior_.mean;
    const Index components = problem_.components();
    for (Index channel = 0; channel < channelCount; ++channel)
      fromMean_.col(channel) += at_.jacobian[std::size_t(channel)] * step.segment(channel * components, components);
  }

  void addTo(std::vector<InputCheck>& checks) const {
    const double mean = predicted_.mean();
    // d = mean (f / mean)^g: the derivative by ln g at 1 is f ln(f / mean).
    checks.push_back(
        check("gamma", predicted_.array() * (predicted_.array() / mean).max(1e-6).log(), noticeableLogarithm));
    addOutlines(checks);
    const bool hasEnvironment = std::ranges::any_of(
        set_.photographs, [](const Photograph& photograph) { return photograph.light.environment != nullptr; });
    if (hasEnvironment) {
      constexpr double turn = radians(1.5);
      checks.push_back(check("rotation", (valuesWith(set_, turn) - predicted_) / turn, turn));
    }
  }

 private:
  /// Place and size of the spheres, if there are any.
  void addOutlines(std::vector<InputCheck>& checks) const {
    const auto hasOutline = [](const Photograph& photograph) { return isSphere(photograph.surface); };
    const auto first = std::ranges::find_if(set_.photographs, hasOutline);
    if (first == set_.photographs.end()) return;
    const double pixels = 0.01 * first->disc.radius;
    struct Outline {
      const char* name;
      double matching::Disc::*member;
    };
    for (const Outline& of : {Outline{"outline x", &matching::Disc::x}, Outline{"outline y", &matching::Disc::y},
                              Outline{"outline radius", &matching::Disc::radius}}) {
      PhotographSet moved = set_;
      for (photograph::Photograph& photograph : moved.photographs) photograph.disc.*of.member += pixels;
      checks.push_back(check(of.name, (valuesWith(moved, 0) - predicted_) / pixels, pixels));
    }
  }

  MatrixX3d valuesWith(const PhotographSet& set, double rotation) const {
    const PixelRows rows = assembleRows(problem_.prior.mapping, set, regions_, rotation, {control_.stop, {}});
    return pixelValues(problem_.prior, rows, problem_.coefficients(x_));
  }

  /// G^T J^T W q.
  VectorXd projected(const MatrixX3d& q) const {
    const Index components = problem_.components();
    const MatrixX3d weighted = weights_.cwiseProduct(q);
    VectorXd result = VectorXd::Zero(x_.size());
    for (Index channel = 0; channel < channelCount; ++channel)
      result.segment(channel * components, components) =
          at_.jacobian[std::size_t(channel)].transpose() * weighted.col(channel);
    return prior_.factor.transpose() * result;
  }

  /// J G w.
  MatrixX3d modelled(const VectorXd& w) const {
    const Index components = problem_.components();
    const VectorXd step = prior_.factor * w;
    MatrixX3d result(predicted_.rows(), channelCount);
    for (Index channel = 0; channel < channelCount; ++channel)
      result.col(channel) = at_.jacobian[std::size_t(channel)] * step.segment(channel * components, components);
    return result;
  }

  /// The estimate of a number of which the derivative of the pixel values is q, with a flat prior: the photographs have
  /// the covariance W^-1 + J G G^T J^T.
  InputCheck check(const char* name, const MatrixX3d& q, double noticeable) const {
    const VectorXd ofQ = projected(q), solvedQ = normal_.solve(ofQ);
    const double information = q.cwiseProduct(q).cwiseProduct(weights_).sum() - ofQ.dot(solvedQ);
    const double agreement = q.cwiseProduct(fromMean_).cwiseProduct(weights_).sum() - projected(fromMean_).dot(solvedQ);
    InputCheck result{.property = name};
    if (!(information > 0)) return result;
    result.estimate = agreement / information;
    // A material that stays unexplained with the estimated difference, too, is another one than the prior expects.
    const MatrixX3d shifted = fromMean_ - result.estimate * q;
    const MatrixX3d left = shifted - modelled(normal_.solve(projected(shifted)));
    result.unexplainedSnr = unexplainedSnr(problem_.data, problem_.noise, left);
    result.deviation = std::max(1.0, widening(result.unexplainedSnr, set_.photographs.size())) / std::sqrt(information);
    judge(result, noticeable);
    return result;
  }

  const PhotographSet& set_;
  std::vector<Region> regions_;
  PixelRows rows_;
  PixelProblem problem_;
  const LocalPrior& prior_;
  const VectorXd& x_;
  PixelLinearisation at_;
  MatrixX3d weights_;
  Eigen::LLT<MatrixXd> normal_;  ///< inverse of the covariance of w, x = mean + G w
  MatrixX3d predicted_, fromMean_;
  TaskControl control_;
};

/// At most `most` regions well inside the surfaces: at the outline, pixel values do not change linearly with its place.
/// Of all regions if none is.
std::vector<std::size_t> insideOf(const PhotographSet& set, const std::vector<Region>& regions, std::size_t most) {
  constexpr double inside = 0.85;  // of the radius
  std::vector<SurfaceView> views(set.photographs.begin(), set.photographs.end());
  std::vector<std::size_t> all, chosen;
  for (std::size_t row = 0; row < regions.size(); ++row)
    if (views[regions[row].photograph].shows(regions[row].centre, inside)) all.push_back(row);
  if (all.empty()) return evenlySpaced(regions.size(), most);
  for (const std::size_t i : evenlySpaced(all.size(), most)) chosen.push_back(all[i]);
  return chosen;
}

/// One sentence about the suspicious check that explains the photographs best, if there is one.
std::string warningOf(std::vector<InputCheck> checks) {
  std::erase_if(checks, [](const InputCheck& check) { return !check.isSuspicious; });
  if (checks.empty()) return {};
  const InputCheck& worst = *std::ranges::max_element(checks, {}, &InputCheck::unexplainedSnr);
  const std::string by =
      worst.property == "exposure" ? "the exposure is " + shortText(std::exp(worst.estimate), 3) + " times"
      : worst.property == "gamma"
          ? "the image has a gamma (exponent) of " + shortText(std::exp(worst.estimate), 3) + " instead of"
      : worst.property == "rotation"
          ? "the environment is rotated by " + shortText(degrees(worst.estimate), 3) + " degrees from"
          : "the " + worst.property + " is " + shortText(worst.estimate, 3) + " pixels from";
  return "the photographs fit better if " + by + " what is stated; check the description";
}

/// One sentence about the photographs that are not explained, if there are any. @param differences of the problem's
/// data.
std::string poorMatches(const PhotographSet& set, const std::vector<Region>& regions, const PixelProblem& problem,
                        const MatrixX3d& differences) {
  constexpr double poor = 10;  // dB
  std::string names;
  for (std::size_t i = 0; i < set.photographs.size(); ++i) {
    std::vector<Index> rows;
    for (std::size_t row = 0; row < regions.size(); ++row)
      if (regions[row].photograph == i) rows.push_back(Index(row));
    const double snr =
        unexplainedSnr(problem.data(rows, Eigen::all), problem.noise(rows, Eigen::all), differences(rows, Eigen::all));
    if (snr < poor) names += (names.empty() ? "" : ", ") + set.photographs[i].name + " (" + shortText(snr, 2) + " dB)";
  }
  if (names.empty()) return {};
  return "the reconstruction does not match " + names +
         ": no training material is similar, or the description is wrong";
}

/// The coefficients and their covariance, for `result`. @param evidence of an unknown exposure, else null.
void setMaterial(const PixelProblem& problem, const MostLikely& found, const ExposureEvidence* evidence,
                 PhotographFit& result) {
  const Eigen::LLT<MatrixXd> normal =
      inverseCovariance(problem, found.at, found.x, problem.weights(found.modelNoise), found.prior);
  // With N = L L^T the inverse of the covariance of w, that of x has the factor G L^-T.
  MatrixXd factor = result.widening * normal.matrixU().solve<Eigen::OnTheRight>(found.prior.factor);
  if (evidence) {
    factor.conservativeResize(Eigen::NoChange, factor.cols() + 1);
    factor.rightCols(1) = evidence->deviation * evidence->slope;
  }
  const Index components = problem.components();
  const MatrixX3d coefficients = problem.coefficients(found.x);
  for (Index channel = 0; channel < channelCount; ++channel) {
    const auto c = std::size_t(channel);
    result.posteriorFactors[c] = factor.middleRows(channel * components, components);
    result.code.channels[c] = problem.prior.singularValues.cwiseProduct(coefficients.col(channel)).cast<float>();
  }
}

/// The pixel values of the reconstruction beside the photographs, for `result`. @param values without the exposure.
void setPredicted(const PhotographSet& set, const MatrixX3d& values, const std::vector<float>& lost,
                  PhotographFit& result) {
  std::vector<double> signal(set.photographs.size(), 0), error(set.photographs.size(), 0);
  for (std::size_t row = 0; row < result.regions.size(); ++row) {
    Rgb value;
    for (int channel = 0; channel < 3; ++channel) value[channel] = result.exposure * values(Index(row), channel);
    result.predicted.push_back(value);
    const Region& region = result.regions[row];
    signal[region.photograph] += glm::dot(region.value, region.value);
    error[region.photograph] += glm::dot(region.value - value, region.value - value);
    result.lost += double(lost[row]) / double(result.regions.size());
  }
  for (std::size_t i = 0; i < signal.size(); ++i) result.residualSnr.push_back(10 * std::log10(signal[i] / error[i]));
}

}  // namespace

PhotographFit fitPhotographs(const PhotographPrior& prior, const PhotographSet& set, std::size_t maxRegions,
                             const TaskControl& control) {
  constexpr std::size_t comparedRows = 200;
  PhotographFit result;
  result.regions = regionsOf(set, maxRegions);
  const PixelRows rows = assembleRows(prior.mapping, set, result.regions, 0, control.between(0, 0.2));
  PixelProblem whole{.prior = prior, .rows = rows, .data = {}, .noise = {}};
  readRegions(result.regions, whole.data, whole.noise);
  whole.share = sharedInformation(set.photographs, rows.count());
  const ComparedSignals compared = comparedSignals(whole, comparedRows, control.between(0.2, 0.3));
  const ExposureEvidence evidence =
      exposureEvidence(whole, compared, set.exposureKnown, set.photographs.size(), control.between(0.3, 0.8));
  if (!set.exposureKnown) {
    result.exposure = std::exp(evidence.logarithm);
    result.exposureDeviation = evidence.deviation;
  }
  const PixelProblem problem = whole.dividedBy(result.exposure);
  const MostLikely found =
      set.exposureKnown ? evidence.atStart : mostLikely(problem, compared, control.between(0.8, 0.9));
  const MatrixX3d differences = problem.data - found.at.values;
  result.bandwidth = found.bandwidth;
  result.modelNoise = found.modelNoise;
  result.unexplainedSnr = unexplainedSnr(problem.data, problem.noise, differences);
  result.widening = widening(result.unexplainedSnr, set.photographs.size());
  setMaterial(problem, found, set.exposureKnown ? nullptr : &evidence, result);
  setPredicted(set, found.at.values, rows.lost, result);
  if (set.exposureKnown) result.checks.push_back(exposureCheck(evidence));
  InputChecks(problem, set, result.regions, insideOf(set, result.regions, comparedRows), found, control.between(0.9, 1))
      .addTo(result.checks);
  result.warnings = set.warnings;
  std::string warning = warningOf(result.checks);
  if (warning.empty()) warning = poorMatches(set, result.regions, problem, differences);
  if (!warning.empty()) result.warnings.push_back(std::move(warning));
  constexpr double muchLight = 0.02;
  if (result.lost > muchLight)
    result.warnings.push_back(shortText(100 * result.lost, 3) +
                              " % of the light comes from directions without training data, at grazing angles");
  return result;
}

std::vector<glm::vec3> deviations(const dictionary::PrincipalComponents& basis, const PhotographFit& fit,
                                  const TaskControl& control) {
  std::vector<glm::vec3> result(basis.mapping.cells.size());
  const Index components = fit.posteriorFactors[0].rows();
  const auto u = basis.svd.u.view().leftCols(components);
  std::array<Eigen::MatrixXf, 3> factors;
  for (std::size_t channel = 0; channel < 3; ++channel)
    factors[channel] =
        (basis.svd.singularValues.head(components).asDiagonal() * fit.posteriorFactors[channel]).cast<float>();
  parallelForBlocks(
      result.size(), 2048,
      [&](std::size_t begin, std::size_t end) {
        const std::vector<float> leftOut = leftOutVariance(basis, int(components), begin, end);
        for (std::size_t channel = 0; channel < 3; ++channel) {
          const Eigen::VectorXf squares =
              (u.middleRows(Index(begin), Index(end - begin)) * factors[channel]).rowwise().squaredNorm();
          for (std::size_t i = begin; i < end; ++i)
            result[i][int(channel)] =
                std::sqrt(squares[Index(i - begin)] + float(fit.widening * fit.widening) * leftOut[i - begin]);
        }
      },
      control);
  return result;
}

}  // namespace gonio::photograph
