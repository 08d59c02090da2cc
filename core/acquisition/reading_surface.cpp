// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/reading_surface.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/brdf/data_transform.h"
#include "core/coordinates/half_difference.h"
#include "core/math/monotone_cubic.h"
#include "core/math/parallel.h"
#include "core/support/error.h"

namespace gonio::acquisition {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

constexpr std::array powers{0.0, 0.5, 1.0};  ///< p
constexpr double maxExponent = 20;           ///< of the prediction
constexpr double modelError = 0.05;          ///< standard deviation of ln(rho + e)
// Nodes of the curves, rad, and of v. Steps are dense where values increase steeply.
constexpr std::array angleDegrees{0.,  5.,  10., 15., 20., 25.,  30., 35.,  40., 45.,  50.,
                                  55., 60., 65., 70., 75., 77.5, 80., 82.5, 85., 87.5, 90.};
constexpr std::array changeDegrees{0., 15., 30., 45., 60., 75., 90.};
constexpr std::array bodyDegrees{0., 20., 40., 55., 65., 75., 82.5, 90.};
constexpr std::size_t profileSteps = 40, changeSteps = 8;

// Penalties of roughness: of a over 5 degrees, b over 1/40 of v, c over its steps, k over 10 degrees.
constexpr double alongPenalty = 1e-3, profilePenalty = 1e-3, changePenalty = 3e-2, changeProfilePenalty = 1e-2,
                 bodyPenalty = 1;

template <std::size_t count>
constexpr std::array<double, count> radiansOf(std::array<double, count> angles) {
  for (double& angle : angles) angle = radians(angle);
  return angles;
}

constexpr auto angleNodes = radiansOf(angleDegrees);
constexpr auto changeNodes = radiansOf(changeDegrees);
constexpr auto bodyNodes = radiansOf(bodyDegrees);

// The parameters: a, then b without its first node (which is 0), then c (each angle: without its first node), then k.
constexpr std::size_t profileAt = angleDegrees.size(), changeAt = profileAt + profileSteps,
                      bodyAt = changeAt + changeDegrees.size() * changeSteps,
                      parameterCount = bodyAt + bodyDegrees.size();

struct SurfacePlace {
  double thetaD, thetaH, thetaI, thetaO;
};

SurfacePlace placeOf(const DirectionPair& pair) {
  const HalfDifference at = toHalfDifference(pair.wi, pair.wo);
  return {at.thetaD, at.thetaH, polarAngle(pair.wi), polarAngle(pair.wo)};
}

/// v as a function of the distance.
class Level {
 public:
  /// @param readings with `rho` of every reading.
  Level(double power, const FactorReadings& readings, const Rgb& floor) : power_(power) {
    std::vector<std::pair<double, Rgb>> across;
    for (std::size_t i = 0; i < readings.plan.curves.size(); ++i)
      if (readings.plan.curves[i] == FactorCurve::across)
        across.emplace_back(distanceOf(placeOf(readings.plan.plan.samples[i].directions)),
                            glm::log(glm::max(readings.values.rgb[i], Rgb(0)) + floor));
    std::ranges::sort(across, {}, [](const auto& reading) { return reading.first; });
    distances_.push_back(0);
    std::vector<double> changes{0}, roots{0};
    Rgb last = across.empty() ? Rgb(0) : across.front().second;
    for (const auto& [distance, z] : across) {
      if (distance <= distances_.back() + 1e-9) continue;
      const Rgb change = glm::abs(z - last);
      changes.push_back(changes.back() + change.x + change.y + change.z);
      distances_.push_back(distance);
      last = z;
    }
    // A share of the root of the distance: nodes also where the readings do not change.
    constexpr double rootShare = 0.3;
    const double total = std::max(changes.back(), 1e-12), end = std::sqrt(distances_.back());
    for (std::size_t i = 0; i < distances_.size(); ++i)
      levels_.push_back((1 - rootShare) * changes[i] / total +
                        (end > 0 ? rootShare * std::sqrt(distances_[i]) / end : 0));
    if (distances_.back() < 1) {
      levels_.push_back(levels_.back() + rootShare * (1 - end));
      distances_.push_back(1);
    }
    for (double& level : levels_) level /= levels_.back();
  }

  double operator()(const SurfacePlace& place) const {
    const double distance = distanceOf(place);
    const NodeInterval at = findInterval(distances_, distance);
    return std::lerp(levels_[at.index], levels_[at.index + 1], at.fraction);
  }

 private:
  double distanceOf(const SurfacePlace& place) const {
    const double c = std::max(0.0, std::cos(place.thetaD));
    const double scale = power_ == 0 ? 1 : power_ == 1 ? c : std::pow(c, power_);
    return std::min(1.0, std::sin(place.thetaH) * scale);
  }

  double power_;
  std::vector<double> distances_, levels_;  ///< increasing, both from 0 to 1
};

/// The entries of a row of the linear system: parameters with their factors.
template <std::size_t capacity>
struct SparseRow {
  std::array<std::pair<std::size_t, double>, capacity> entries{};
  std::size_t count = 0;

  void add(std::size_t parameter, double factor) { entries[count++] = {parameter, factor}; }
  template <class Values>
  double dot(const Values& values) const {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += entries[i].second * values[Index(entries[i].first)];
    return sum;
  }
};

/// The row of a + b + c.
SparseRow<8> highlightRow(const SurfacePlace& place, double v) {
  SparseRow<8> row;
  const NodeInterval a = findInterval(angleNodes, place.thetaD), c = findInterval(changeNodes, place.thetaD);
  row.add(a.index, 1 - a.fraction);
  row.add(a.index + 1, a.fraction);
  // Evenly spaced nodes; the value of the first is 0 and is no parameter.
  const auto addEven = [&](std::size_t first, std::size_t steps, double factor) {
    const double at = v * double(steps);
    const auto lower = std::min(std::size_t(at), steps - 1);
    if (lower > 0) row.add(first + lower - 1, factor * (1 - (at - double(lower))));
    row.add(first + lower, factor * (at - double(lower)));
  };
  addEven(profileAt, profileSteps, 1);
  addEven(changeAt + c.index * changeSteps, changeSteps, 1 - c.fraction);
  addEven(changeAt + (c.index + 1) * changeSteps, changeSteps, c.fraction);
  return row;
}

/// The row of k(theta_i) + k(theta_o).
SparseRow<4> bodyRow(const SurfacePlace& place) {
  SparseRow<4> row;
  for (const double theta : {place.thetaI, place.thetaO}) {
    const NodeInterval at = findInterval(bodyNodes, theta);
    row.add(bodyAt + at.index, 1 - at.fraction);
    row.add(bodyAt + at.index + 1, at.fraction);
  }
  return row;
}

/// Adds strength times the square of a combination of parameters.
template <std::size_t terms>
void addSquare(MatrixXd& penalty, double strength, const std::array<std::pair<std::size_t, double>, terms>& sum) {
  for (const auto& [i, u] : sum)
    for (const auto& [j, w] : sum) penalty(Index(i), Index(j)) += strength * u * w;
}

/// Second differences of a curve, with steps in units of `unit`.
template <std::size_t count>
void addBending(MatrixXd& penalty, std::size_t first, const std::array<double, count>& nodes, double unit,
                double strength) {
  for (std::size_t i = 0; i + 2 < count; ++i) {
    const double before = unit / (nodes[i + 1] - nodes[i]), after = unit / (nodes[i + 2] - nodes[i + 1]);
    addSquare<3>(penalty, strength, {{{first + i, before}, {first + i + 1, -before - after}, {first + i + 2, after}}});
  }
}

MatrixXd roughness() {
  MatrixXd penalty = MatrixXd::Zero(Index(parameterCount), Index(parameterCount));
  addBending(penalty, 0, angleNodes, radians(5), alongPenalty);
  addSquare<2>(penalty, profilePenalty, {{{profileAt, -2}, {profileAt + 1, 1}}});
  for (std::size_t i = 0; i + 2 < profileSteps; ++i)
    addSquare<3>(penalty, profilePenalty, {{{profileAt + i, 1}, {profileAt + i + 1, -2}, {profileAt + i + 2, 1}}});
  for (std::size_t angle = 0; angle < changeDegrees.size(); ++angle)
    for (std::size_t step = 0; step < changeSteps; ++step) {
      const std::size_t at = changeAt + angle * changeSteps + step;
      addSquare<1>(penalty, 1e-2 * changePenalty, {{{at, 1}}});
      if (angle > 0) addSquare<2>(penalty, changePenalty, {{{at, 1}, {at - changeSteps, -1}}});
      if (step > 0)
        addSquare<2>(penalty, changeProfilePenalty, {{{at, 1}, {at - 1, -1}}});
      else
        addSquare<1>(penalty, changeProfilePenalty, {{{at, 1}}});
    }
  addBending(penalty, bodyAt, bodyNodes, radians(10), bodyPenalty);
  for (std::size_t i = 0; i + 1 < bodyDegrees.size(); ++i)
    addSquare<2>(penalty, bodyPenalty, {{{bodyAt + i, -1}, {bodyAt + i + 1, 1}}});
  penalty.diagonal().array() += 1e-8;
  return penalty;
}

/// The readings of one channel.
struct ChannelReadings {
  VectorXd rho, logarithm;  ///< >= 0, and ln(rho + floor)
  VectorXd weights;
  double floor = 0;  ///< e
};

ChannelReadings channelOf(const FactorReadings& readings, int channel) {
  const std::size_t n = readings.values.rgb.size();
  std::vector<double> rho(n);
  for (std::size_t i = 0; i < n; ++i) rho[i] = std::max(0.0, readings.values.rgb[i][channel]);
  ChannelReadings result{Eigen::Map<const VectorXd>(rho.data(), Index(n)), {}, VectorXd::Ones(Index(n))};
  // Ten thousandths of a highlight are invisible, and dark readings rough.
  std::vector<float> values(rho.begin(), rho.end());
  result.floor = 1e-4 + 1e-2 * double(medianOf(values)) + 1e-4 * *std::ranges::max_element(rho);
  result.logarithm = (result.rho.array() + result.floor).log();
  for (std::size_t i = 0; i < n; ++i) {
    const auto& [wi, wo] = readings.plan.plan.samples[i].directions;
    result.weights[Index(i)] = cosineWeight(wi.z, wo.z);  // images hardly show grazing directions
  }
  if (!readings.values.noise.empty())
    for (std::size_t i = 0; i < n; ++i) {
      const double relative = readings.values.noise[i][channel] / ((rho[i] + result.floor) * modelError);
      result.weights[Index(i)] /= 1 + relative * relative;
    }
  return result;
}

/// The rows of all readings.
struct SurfaceRows {
  MatrixXd highlight;  ///< of all parameters before k
  MatrixXd body;       ///< of k
};

SurfaceRows surfaceRowsOf(const FactorReadings& readings, const Level& level) {
  const auto n = Index(readings.plan.plan.samples.size());
  SurfaceRows rows{MatrixXd::Zero(n, Index(bodyAt)), MatrixXd::Zero(n, Index(parameterCount - bodyAt))};
  for (Index i = 0; i < n; ++i) {
    const SurfacePlace place = placeOf(readings.plan.plan.samples[std::size_t(i)].directions);
    const auto highlight = highlightRow(place, level(place));
    for (std::size_t e = 0; e < highlight.count; ++e)
      rows.highlight(i, Index(highlight.entries[e].first)) += highlight.entries[e].second;
    const auto body = bodyRow(place);
    for (std::size_t e = 0; e < body.count; ++e)
      rows.body(i, Index(body.entries[e].first - bodyAt)) += body.entries[e].second;
  }
  return rows;
}

class SurfaceFit {
 public:
  SurfaceFit(const SurfaceRows& rows, const ChannelReadings& readings, const MatrixXd& penalty)
      : rows_(rows), readings_(readings), penalty_(penalty) {}

  struct Result {
    VectorXd parameters;
    double cost = 0;
  };

  Result minimise() const {
    constexpr int maxSteps = 25, maxTries = 8;
    Result best{start(), 0};
    best.cost = costOf(best.parameters);
    double damping = 1e-3;
    for (int step = 0; step < maxSteps; ++step) {
      const auto [hessian, gradient] = normalEquations(best.parameters);
      const double before = best.cost;
      for (int tried = 0; tried < maxTries && best.cost == before; ++tried) {
        MatrixXd damped = hessian;
        damped.diagonal() += damping * (hessian.diagonal().array() + 1e-6).matrix();
        // Exponents change by at most 2 a step.
        const VectorXd change = damped.ldlt().solve(-gradient).cwiseMax(-2).cwiseMin(2);
        const VectorXd next = best.parameters + change;
        if (const double cost = costOf(next); cost < best.cost)
          best = {next, cost};
        else
          damping *= 5;
      }
      if (before - best.cost <= 1e-4 * before) break;
      damping = std::max(1e-9, damping / 5);
    }
    return best;
  }

 private:
  /// The body is the darkest readings, the highlight the linear least-squares solution for the logarithm of the rest.
  VectorXd start() const {
    std::vector<double> rho(readings_.rho.begin(), readings_.rho.end());
    const auto dark = rho.begin() + std::ptrdiff_t(rho.size() / 20);
    std::ranges::nth_element(rho, dark);
    const double body = std::max(1e-7, 0.7 * *dark);
    VectorXd parameters(Index{parameterCount});
    parameters.tail(rows_.body.cols()).setConstant(std::log(body) / 2);
    const VectorXd logarithm = (readings_.rho.array() - body).max(1e-3 * readings_.rho.array() + 1e-9).log();
    const MatrixXd weighted = readings_.weights.asDiagonal() * rows_.highlight;
    const auto n = rows_.highlight.cols();
    MatrixXd normal = rows_.highlight.transpose() * weighted + penalty_.topLeftCorner(n, n);
    normal.diagonal().array() += 1e-6;
    parameters.head(n) = normal.ldlt().solve(weighted.transpose() * logarithm);
    return parameters;
  }

  VectorXd highlightOf(const VectorXd& p) const {
    return (rows_.highlight * p.head(rows_.highlight.cols())).cwiseMin(30).cwiseMax(-30).array().exp();
  }
  VectorXd bodyOf(const VectorXd& p) const {
    return (rows_.body * p.tail(rows_.body.cols())).cwiseMin(30).cwiseMax(-30).array().exp();
  }
  VectorXd residualOf(const VectorXd& sum) const {
    return (sum.array() + readings_.floor).log().matrix() - readings_.logarithm;
  }

  double costOf(const VectorXd& p) const {
    const VectorXd residual = residualOf(highlightOf(p) + bodyOf(p));
    return residual.cwiseAbs2().dot(readings_.weights) + p.dot(penalty_ * p);
  }

  std::pair<MatrixXd, VectorXd> normalEquations(const VectorXd& p) const {
    const VectorXd highlight = highlightOf(p), body = bodyOf(p), sum = highlight + body;
    const VectorXd slope = (sum.array() + readings_.floor).inverse();
    MatrixXd jacobian(rows_.highlight.rows(), p.size());
    jacobian << highlight.cwiseProduct(slope).asDiagonal() * rows_.highlight,
        body.cwiseProduct(slope).asDiagonal() * rows_.body;
    const MatrixXd weighted = readings_.weights.asDiagonal() * jacobian;
    return {jacobian.transpose() * weighted + penalty_, weighted.transpose() * residualOf(sum) + penalty_ * p};
  }

  const SurfaceRows& rows_;
  const ChannelReadings& readings_;
  const MatrixXd& penalty_;
};

/// The readings of the two curves, as bounds.
class CurveReadings {
 public:
  explicit CurveReadings(const FactorReadings& readings) {
    for (std::size_t i = 0; i < readings.plan.curves.size(); ++i) {
      const SurfacePlace place = placeOf(readings.plan.plan.samples[i].directions);
      if (readings.plan.curves[i] == FactorCurve::along)
        along_.emplace_back(place.thetaD, readings.values.rgb[i]);
      else if (readings.plan.curves[i] == FactorCurve::across)
        across_.emplace_back(deviationOf(place), readings.values.rgb[i]);
    }
    for (auto* curve : {&along_, &across_}) std::ranges::sort(*curve, {}, [](const auto& at) { return at.first; });
  }

  /// The larger of two interpolated readings: in the mirror direction at the same angle, at the fixed angle at the same
  /// distance.
  Rgb larger(const SurfacePlace& place) const {
    return glm::max(interpolated(along_, place.thetaD), interpolated(across_, deviationOf(place)));
  }

 private:
  using Curve = std::vector<std::pair<double, Rgb>>;  ///< by increasing coordinate

  static double deviationOf(const SurfacePlace& place) { return 2 * std::cos(place.thetaD) * std::sin(place.thetaH); }
  /// Constant beyond the ends; nothing without readings.
  static Rgb interpolated(const Curve& curve, double x) {
    if (curve.empty()) return Rgb(0);
    const auto after = std::ranges::lower_bound(curve, x, {}, [](const auto& at) { return at.first; });
    if (after == curve.begin()) return after->second;
    if (after == curve.end()) return curve.back().second;
    const auto before = after - 1;
    return glm::mix(before->second, after->second, (x - before->first) / (after->first - before->first));
  }

  Curve along_, across_;
};

/// The fit for one p.
struct Surface {
  Level level;
  std::array<SurfaceFit::Result, 3> channels;
  double weight = 0;
};

class SurfaceBrdf final : public Brdf {
 public:
  /// @param highest upper bound of each channel; 0 for a black one. @param bounds further bounds, if any.
  SurfaceBrdf(std::vector<Surface> surfaces, const Rgb& highest, std::optional<CurveReadings> bounds)
      : surfaces_(std::move(surfaces)), highest_(highest), bounds_(std::move(bounds)) {}

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    for (std::size_t i = 0; i < pairs.size(); ++i) values[i] = evaluatePair(pairs[i]);
  }
  bool isReciprocal() const override { return true; }

 private:
  Rgb evaluatePair(const DirectionPair& pair) const {
    if (isBelowHorizon(pair.wi) || isBelowHorizon(pair.wo)) return Rgb(0);
    const SurfacePlace place = placeOf(pair);
    const SparseRow<4> body = bodyRow(place);
    Rgb rho(0);
    for (const Surface& surface : surfaces_) {
      const SparseRow<8> highlight = highlightRow(place, surface.level(place));
      for (int c = 0; c < 3; ++c) {
        const VectorXd& parameters = surface.channels[std::size_t(c)].parameters;
        rho[c] += surface.weight * (std::exp(std::min(maxExponent, highlight.dot(parameters))) +
                                    std::exp(std::min(maxExponent, body.dot(parameters))));
      }
    }
    if (bounds_) rho = glm::min(rho, bounds_->larger(place));
    return glm::min(rho, highest_);
  }

  std::vector<Surface> surfaces_;
  Rgb highest_;
  std::optional<CurveReadings> bounds_;
};

void weightByCosts(std::vector<Surface>& surfaces) {
  double total = 0;
  for (Surface& surface : surfaces) {
    double cost = 1e-12;
    for (const SurfaceFit::Result& channel : surface.channels) cost += channel.cost;
    total += surface.weight = 1 / cost;
  }
  for (Surface& surface : surfaces) surface.weight /= total;
}

}  // namespace

std::shared_ptr<const Brdf> fitReadings(const FactorReadings& readings, bool isBounded) {
  if (readings.values.rgb.size() != readings.plan.plan.samples.size() || readings.values.rgb.empty())
    throw Error("found " + std::to_string(readings.values.rgb.size()) + " values, expected one for each of the " +
                std::to_string(readings.plan.plan.samples.size()) + " readings");
  Rgb highest(0), floor;
  std::array<ChannelReadings, 3> channels;
  for (int c = 0; c < 3; ++c) {
    channels[std::size_t(c)] = channelOf(readings, c);
    floor[c] = channels[std::size_t(c)].floor;
    const double largest = channels[std::size_t(c)].rho.maxCoeff();
    highest[c] = isBounded || largest <= 0 ? largest : std::numeric_limits<double>::max();
  }
  std::vector<Surface> surfaces;
  std::vector<SurfaceRows> rows;
  for (const double power : powers) {
    surfaces.push_back({Level(power, readings, floor), {}, 0});
    rows.push_back(surfaceRowsOf(readings, surfaces.back().level));
  }
  const MatrixXd penalty = roughness();
  parallelForBlocks(powers.size() * 3, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      surfaces[i / 3].channels[i % 3] = SurfaceFit(rows[i / 3], channels[i % 3], penalty).minimise();
  });
  weightByCosts(surfaces);
  return std::make_shared<const SurfaceBrdf>(std::move(surfaces), highest,
                                             isBounded ? std::optional<CurveReadings>(readings) : std::nullopt);
}

}  // namespace gonio::acquisition
