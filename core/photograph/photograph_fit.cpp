// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/photograph/photograph_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "core/brdf/data_transform.h"
#include "core/math/parallel.h"
#include "core/photograph/pixel_model.h"
#include "core/support/text.h"

namespace gonio::photograph {

using Eigen::Index, Eigen::MatrixXd, Eigen::MatrixX3d, Eigen::VectorXd;

namespace {

constexpr Index channelCount = 3;
constexpr double unbounded = std::numeric_limits<double>::infinity();

PixelRows rowsAt(const PixelRows& rows, const std::vector<std::size_t>& chosen) {
  PixelRows result;
  result.first.push_back(0);
  for (const std::size_t row : chosen) {
    const auto begin = std::ptrdiff_t(rows.first[row]), end = std::ptrdiff_t(rows.first[row + 1]);
    result.cells.insert(result.cells.end(), rows.cells.begin() + begin, rows.cells.begin() + end);
    result.weights.insert(result.weights.end(), rows.weights.begin() + begin, rows.weights.begin() + end);
    result.first.push_back(result.cells.size());
    result.lost.push_back(rows.lost[row]);
  }
  return result;
}

MatrixX3d coefficientsOf(const VectorXd& x, Index components) {
  return Eigen::Map<const MatrixX3d>(x.data(), components, channelCount);
}

/// Everything that the iterations share. The unknowns x are the coefficients of red, green and blue.
struct Problem {
  const PhotographPrior& prior;
  const PixelRows& rows;
  MatrixX3d data, noise;  ///< pixel values and the variances of their noise: rows x channels
  double share = 1;       ///< factor of the information of each row

  Index components() const { return prior.d.cols(); }
  MatrixX3d weights(double modelNoise) const { return pixelWeights(data, noise, modelNoise, share); }
  /// The energy of the data relative to that of differences beyond noise, which is at least a tenth of them; dB.
  double unexplainedSnr(const MatrixX3d& differences) const {
    const double energy = differences.squaredNorm();
    return 10 * std::log10(data.squaredNorm() / std::max(energy - noise.sum(), 0.1 * energy));
  }
  /// Twice the negative logarithm of the probability of x = mean + G w, up to a constant.
  double cost(const VectorXd& x, const VectorXd& w, const MatrixX3d& weights) const {
    const MatrixX3d difference = data - pixelValues(prior, rows, coefficientsOf(x, components()));
    return difference.cwiseProduct(difference).cwiseProduct(weights).sum() + w.squaredNorm();
  }
  /// The same photographs divided by an exposure.
  Problem dividedBy(double exposure) const {
    return {prior, rows, data / exposure, noise / (exposure * exposure), share};
  }
};

/// The squared differences of data and linearised pixel values about x, as a function of x.
struct Quadratic {
  VectorXd x;
  MatrixXd curvature;  ///< J^T W J
  VectorXd slope;      ///< J^T W (data - values)
  double energy = 0;   ///< (data - values)^T W (data - values)

  Quadratic(const Problem& problem, const PixelLinearisation& at, const VectorXd& about, const MatrixX3d& weights)
      : x(about), curvature(MatrixXd::Zero(about.size(), about.size())), slope(VectorXd::Zero(about.size())) {
    const Index components = problem.components();
    for (Index channel = 0; channel < channelCount; ++channel) {
      const MatrixXd& jacobian = at.jacobian[std::size_t(channel)];
      const VectorXd difference = problem.data.col(channel) - at.values.col(channel), weight = weights.col(channel);
      const MatrixXd weighted = weight.asDiagonal() * jacobian;
      const Index first = channel * components;
      curvature.block(first, first, components, components).noalias() = jacobian.transpose() * weighted;
      slope.segment(first, components) = weighted.transpose() * difference;
      energy += difference.dot(weight.cwiseProduct(difference));
    }
  }
};

struct Solution {
  VectorXd w;
  Eigen::LLT<MatrixXd> normal;  ///< inverse of the covariance of w given the photographs
  double evidence = 0;          ///< logarithm of the probability of the photographs, up to terms in their variances
};

Solution solved(const Quadratic& of, const LocalPrior& prior) {
  const VectorXd step = of.x - prior.mean;
  const VectorXd slope = of.slope + of.curvature * step;
  const VectorXd right = prior.factor.transpose() * slope;
  MatrixXd normal = prior.factor.transpose() * (of.curvature * prior.factor);
  normal.diagonal().array() += 1;
  Solution result;
  result.normal.compute(normal);
  result.w = result.normal.solve(right);
  const double energy = of.energy + step.dot(of.slope + slope);
  const double logDeterminant = 2 * result.normal.matrixLLT().diagonal().array().log().sum();
  result.evidence = -0.5 * (energy - right.dot(result.w) + logDeterminant);
  return result;
}

constexpr std::array<double, 5> triedBandwidths{0.11, 0.22, 0.44, 0.89, unbounded};
constexpr std::array<double, 7> triedNoises{0.0025, 0.005, 0.01, 0.02, 0.04, 0.08, 0.16};

/// The state of the iterations.
struct State {
  std::size_t bandwidth = 2;  ///< in triedBandwidths
  double modelNoise = 0.04;
  VectorXd w, x;
  PixelLinearisation at;
};

/// Steps of Gauss and Newton with a fixed prior and noise. A step is shortened until it lowers the cost.
void iterate(const Problem& problem, const LocalPrior& prior, int steps, State& state, const TaskControl& control) {
  const MatrixX3d weights = problem.weights(state.modelNoise);
  double cost = problem.cost(state.x, state.w, weights);
  for (int step = 0; step < steps; ++step) {
    control.throwIfStopped();
    const VectorXd target = solved(Quadratic(problem, state.at, state.x, weights), prior).w;
    constexpr int trials = 6;
    constexpr double shorter = 0.4, negligible = 1e-3;
    double length = 1, gain = 0;
    for (int trial = 0; trial < trials && !(gain > 0); ++trial, length *= shorter) {
      const VectorXd w = state.w + length * (target - state.w), x = prior.mean + prior.factor * w;
      const double tried = problem.cost(x, w, weights);
      if (!(tried < cost)) continue;
      gain = cost - tried;
      cost = tried;
      state.w = w;
      state.x = x;
    }
    if (!(gain > 0)) return;
    state.at = linearised(problem.prior, problem.rows, coefficientsOf(state.x, problem.components()), control);
    if (gain < negligible * cost) return;
  }
}

/// Chooses the noise, and the bandwidth among `bandwidths`, of the largest evidence about the linearisation, which is
/// the result.
double choose(const Problem& problem, const std::vector<LocalPrior>& priors, const std::vector<std::size_t>& bandwidths,
              State& state, const TaskControl& control) {
  double evidence = -unbounded;
  State best = state;
  for (const double noise : triedNoises) {
    const MatrixX3d weights = problem.weights(noise);
    const double logWeights = 0.5 * problem.share * (weights.array() / problem.share).log().sum();
    const Quadratic quadratic(problem, state.at, state.x, weights);
    for (const std::size_t bandwidth : bandwidths) {
      control.throwIfStopped();
      const Solution solution = solved(quadratic, priors[bandwidth]);
      if (!(solution.evidence + logWeights > evidence)) continue;
      evidence = solution.evidence + logWeights;
      best.bandwidth = bandwidth;
      best.modelNoise = noise;
      best.w = solution.w;
      best.x = priors[bandwidth].mean + priors[bandwidth].factor * solution.w;
    }
  }
  state = std::move(best);
  state.at = linearised(problem.prior, problem.rows, coefficientsOf(state.x, problem.components()), control);
  return evidence;
}

void readRegions(const std::vector<Region>& regions, MatrixX3d& values, MatrixX3d& variances) {
  values.resize(Index(regions.size()), channelCount);
  variances.resize(Index(regions.size()), channelCount);
  for (std::size_t row = 0; row < regions.size(); ++row)
    for (int channel = 0; channel < 3; ++channel) {
      values(Index(row), channel) = regions[row].value[channel];
      variances(Index(row), channel) = regions[row].variance[channel];
    }
}

MatrixX3d rowsOf(const MatrixX3d& matrix, const std::vector<std::size_t>& chosen) {
  MatrixX3d result(Index(chosen.size()), channelCount);
  for (std::size_t i = 0; i < chosen.size(); ++i) result.row(Index(i)) = matrix.row(Index(chosen[i]));
  return result;
}

/// Mean difference of the logarithms of the data and of the training signals' pixel values.
double firstLogExposure(const std::array<MatrixXd, 3>& images, const MatrixX3d& values) {
  double sum = 0, count = 0;
  for (Index channel = 0; channel < channelCount; ++channel)
    for (Index row = 0; row < values.rows(); ++row)
      if (values(row, channel) > 0) {
        sum += std::log(values(row, channel)) - images[std::size_t(channel)].row(row).mean();
        ++count;
      }
  return count > 0 ? sum / count : 0;
}

/// What is known of the training signals in the photographs, for the weights of the prior.
struct Compared {
  std::vector<std::size_t> rows;   ///< of the problem
  std::array<MatrixXd, 3> images;  ///< signalImages() of them
};

struct Found {
  LocalPrior prior;
  State state;
  double evidence = 0;  ///< logarithm of the probability of the photographs, up to a constant
};

/// The most likely material, with the bandwidth and noise of the largest evidence.
Found solve(const Problem& problem, const Compared& compared, const TaskControl& control) {
  const MatrixX3d data = rowsOf(problem.data, compared.rows);
  const MatrixX3d distances = signalDistances(compared.images, data, rowsOf(problem.noise, compared.rows));
  std::vector<LocalPrior> priors;
  priors.reserve(std::size(triedBandwidths));
  for (const double bandwidth : triedBandwidths)
    priors.push_back(localPrior(problem.prior.v, distances, bandwidth, true, 0));
  State state;
  state.x = priors[state.bandwidth].mean;
  state.w = VectorXd::Zero(state.x.size());
  state.at = linearised(problem.prior, problem.rows, coefficientsOf(state.x, problem.components()), control);
  iterate(problem, priors[state.bandwidth], 5, state, control);
  control.report(0.5);
  choose(problem, priors, {0, 1, 2, 3, 4}, state, control);
  iterate(problem, priors[state.bandwidth], 3, state, control);
  control.report(0.8);
  const double evidence = choose(problem, priors, {state.bandwidth}, state, control);
  iterate(problem, priors[state.bandwidth], 2, state, control);
  control.report(1);
  return {std::move(priors[state.bandwidth]), std::move(state), evidence};
}

struct Posterior {
  double unexplainedSnr = 0, widening = 1;
  MatrixXd factor;  ///< F, with F F^T the covariance of x, widened
};

Posterior posteriorOf(const Problem& problem, const Found& found, std::size_t images) {
  const State& state = found.state;
  const Solution solution =
      solved(Quadratic(problem, state.at, state.x, problem.weights(state.modelNoise)), found.prior);
  Posterior result;
  result.unexplainedSnr = problem.unexplainedSnr(problem.data - state.at.values);
  result.widening = widening(result.unexplainedSnr, images);
  // With N = L L^T the inverse of the covariance of w, that of x has the factor G L^-T.
  result.factor = result.widening * solution.normal.matrixU().solve<Eigen::OnTheRight>(found.prior.factor);
  return result;
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

/// An exposure that is not known: the one of the largest evidence. The most likely exposure and material together would
/// be too dark a material, since dark materials differ little in the mapped values.
struct ExposureSearch {
  double logExposure = 0, deviation = 0;
  VectorXd slope;             ///< of the most likely x by the logarithm of the exposure
  double unexplainedSnr = 0;  ///< beside the largest evidence

  /// In steps of factors of 2 up the evidence, then by a parabola. @param start logarithm of the first exposure.
  ExposureSearch(const Problem& problem, const Compared& compared, double start, std::size_t images,
                 const TaskControl& control) {
    const double step = std::log(2), perLogarithm = problem.share * double(channelCount) * double(problem.rows.count());
    constexpr int most = 20, usual = 6;
    std::map<int, std::pair<Found, double>> tried;  // with the logarithm of the probability of the photographs
    const auto evidence = [&](int place) {
      const double log = start + place * step, done = std::min(1.0, double(tried.size()) / usual);
      if (!tried.contains(place)) {
        Found found =
            solve(problem.dividedBy(std::exp(log)), compared, control.between(done, std::min(1.0, done + 1.0 / usual)));
        const double value = found.evidence - perLogarithm * log;
        tried.emplace(place, std::pair(std::move(found), value));
      }
      return tried.at(place).second;
    };
    int best = 0;
    for (const int direction : {1, -1})
      while (std::abs(best) < most && evidence(best + direction) > evidence(best)) best += direction;
    const double below = evidence(best - 1), at = evidence(best), above = evidence(best + 1);
    const double bend = std::max(2 * at - below - above, 1e-3);
    logExposure = start + step * (best + std::clamp(0.5 * (above - below) / bend, -0.5, 0.5));
    const auto& [found, value] = tried.at(best);
    slope = (tried.at(best + 1).first.state.x - tried.at(best - 1).first.state.x) / (2 * step);
    const Problem divided = problem.dividedBy(std::exp(start + best * step));
    unexplainedSnr = divided.unexplainedSnr(divided.data - found.state.at.values);
    // The errors were 2.7 times larger (root of the mean square, 14 measured files, docs/results/photographs.md).
    constexpr double measured = 2.7;
    deviation = measured * std::max(1.0, widening(unexplainedSnr, images)) * step / std::sqrt(bend);
  }
};

/// Of a stated exposure, by a search as if it were unknown. A derivative does not serve: about the first solution, a
/// factor of the exposure looks like the highlights that a material has and the prior lacks.
InputCheck exposureCheck(const Problem& problem, const Compared& compared, std::size_t images,
                         const TaskControl& control) {
  const ExposureSearch search(problem, compared, 0, images, control);
  InputCheck check{.property = "exposure",
                   .estimate = search.logExposure,
                   .deviation = search.deviation,
                   .unexplainedSnr = search.unexplainedSnr};
  judge(check, noticeableLogarithm);
  return check;
}

/// What the stated input may differ by, as derivatives of the pixel values by one number each.
class InputChecks {
 public:
  /// At the state, with some rows of the problem. @param whole of all rows.
  InputChecks(const Problem& whole, const PhotographSet& set, const std::vector<Region>& regions,
              const std::vector<std::size_t>& chosen, const State& state, const LocalPrior& local,
              const TaskControl& control)
      : set_(set),
        rows_(rowsAt(whole.rows, chosen)),
        problem_{whole.prior, rows_, rowsOf(whole.data, chosen), rowsOf(whole.noise, chosen),
                 std::min(1.0, whole.share * double(whole.rows.count()) / double(chosen.size()))},
        prior_(local),
        x_(state.x),
        at_(linearised(whole.prior, rows_, coefficientsOf(state.x, whole.components()), control)),
        weights_(problem_.weights(state.modelNoise)),
        solution_(solved(Quadratic(problem_, at_, state.x, weights_), local)),
        control_(control) {
    for (const std::size_t row : chosen) regions_.push_back(regions[row]);
    predicted_ = at_.values;
    fromMean_ = problem_.data - predicted_;  // data less the linearised values at the mean of the prior
    const VectorXd step = x_ - prior_.mean;
    const Index components = problem_.components();
    for (Index channel = 0; channel < channelCount; ++channel)
      fromMean_.col(channel) += at_.jacobian[std::size_t(channel)] * step.segment(channel * components, components);
  }

  std::vector<InputCheck> all() const {
    std::vector<InputCheck> checks;
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
    return checks;
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
    return pixelValues(problem_.prior, rows, coefficientsOf(x_, problem_.components()));
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
    const VectorXd ofQ = projected(q), solvedQ = solution_.normal.solve(ofQ);
    const double information = q.cwiseProduct(q).cwiseProduct(weights_).sum() - ofQ.dot(solvedQ);
    const double agreement = q.cwiseProduct(fromMean_).cwiseProduct(weights_).sum() - projected(fromMean_).dot(solvedQ);
    InputCheck result{.property = name};
    if (!(information > 0)) return result;
    result.estimate = agreement / information;
    // A material that stays unexplained with the estimated difference, too, is another one than the prior expects.
    const MatrixX3d shifted = fromMean_ - result.estimate * q;
    const MatrixX3d left = shifted - modelled(solution_.normal.solve(projected(shifted)));
    result.unexplainedSnr = problem_.unexplainedSnr(left);
    result.deviation = std::max(1.0, widening(result.unexplainedSnr, set_.photographs.size())) / std::sqrt(information);
    judge(result, noticeable);
    return result;
  }

  const PhotographSet& set_;
  std::vector<Region> regions_;
  PixelRows rows_;
  Problem problem_;
  const LocalPrior& prior_;
  const VectorXd& x_;
  PixelLinearisation at_;
  MatrixX3d weights_;
  Solution solution_;
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

}  // namespace

double widening(double unexplainedSnr, std::size_t images) {
  // The regression of the logarithm (docs/results/photographs.md), within the residuals that it had.
  constexpr double lowest = 10, highest = 40, atZero = 0.956, perDecibel = 0.0315, ofImages = 0.4;
  return std::exp(atZero - perDecibel * std::clamp(unexplainedSnr, lowest, highest)) *
         std::pow(double(images), ofImages);
}

PhotographFit fitPhotographs(const PhotographPrior& prior, const PhotographSet& set, std::size_t maxRegions,
                             const TaskControl& control) {
  PhotographFit result;
  result.regions = regionsOf(set, maxRegions);
  const PixelRows rows = assembleRows(prior.mapping, set, result.regions, 0, control.between(0, 0.2));
  Problem whole{.prior = prior, .rows = rows, .data = {}, .noise = {}};
  readRegions(result.regions, whole.data, whole.noise);
  whole.share = sharedInformation(set.photographs, rows.count());
  constexpr std::size_t comparedRows = 200;
  Compared compared{.rows = evenlySpaced(rows.count(), comparedRows), .images = {}};
  compared.images = signalImages(prior, rowsAt(rows, compared.rows), control.between(0.2, 0.3));
  std::optional<ExposureSearch> search;
  if (!set.exposureKnown) {
    search.emplace(whole, compared, firstLogExposure(compared.images, rowsOf(whole.data, compared.rows)),
                   set.photographs.size(), control.between(0.3, 0.7));
    result.exposure = std::exp(search->logExposure);
    result.exposureDeviation = search->deviation;
  }
  const Problem problem = whole.dividedBy(result.exposure);
  const Found found =
      solve(problem, compared, control.between(set.exposureKnown ? 0.3 : 0.7, set.exposureKnown ? 0.4 : 0.8));
  const State& state = found.state;
  const Posterior posterior = posteriorOf(problem, found, set.photographs.size());
  result.unexplainedSnr = posterior.unexplainedSnr;
  result.widening = posterior.widening;
  const Index components = prior.d.cols();
  MatrixXd factor = posterior.factor;
  if (search) {
    factor.conservativeResize(Eigen::NoChange, factor.cols() + 1);
    factor.rightCols(1) = search->deviation * search->slope;
  }
  const MatrixX3d coefficients = coefficientsOf(state.x, components);
  for (Index channel = 0; channel < channelCount; ++channel) {
    const auto c = std::size_t(channel);
    result.posteriorFactors[c] = factor.middleRows(channel * components, components);
    result.code.channels[c] = prior.singularValues.cwiseProduct(coefficients.col(channel)).cast<float>();
  }
  result.bandwidth = triedBandwidths[state.bandwidth];
  result.modelNoise = state.modelNoise;
  std::vector<double> signal(set.photographs.size(), 0), error(set.photographs.size(), 0);
  for (std::size_t row = 0; row < result.regions.size(); ++row) {
    Rgb value;
    for (int channel = 0; channel < 3; ++channel)
      value[channel] = result.exposure * state.at.values(Index(row), channel);
    result.predicted.push_back(value);
    const Region& region = result.regions[row];
    signal[region.photograph] += glm::dot(region.value, region.value);
    error[region.photograph] += glm::dot(region.value - value, region.value - value);
    result.lost += double(rows.lost[row]) / double(rows.count());
  }
  for (std::size_t i = 0; i < signal.size(); ++i) result.residualSnr.push_back(10 * std::log10(signal[i] / error[i]));
  result.warnings = set.warnings;
  result.checks = InputChecks(problem, set, result.regions, insideOf(set, result.regions, comparedRows), state,
                              found.prior, control.between(set.exposureKnown ? 0.4 : 0.8, set.exposureKnown ? 0.5 : 1))
                      .all();
  if (set.exposureKnown)
    result.checks.insert(result.checks.begin(),
                         exposureCheck(whole, compared, set.photographs.size(), control.between(0.5, 1)));
  if (std::string warning = warningOf(result.checks); !warning.empty())
    result.warnings.push_back(std::move(warning));
  else if (result.unexplainedSnr < leastExplained)
    result.warnings.push_back("the reconstruction matches the photographs poorly (" +
                              shortText(result.unexplainedSnr, 2) +
                              " dB): no training material is similar, or the description is wrong");
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
