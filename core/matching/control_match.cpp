// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/matching/control_match.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <optional>

#include "core/fitting/bounded_least_squares.h"
#include "core/metrics/image_metrics.h"

namespace gonio::matching {

namespace {

using editing::ArtistControl;
using models::ParameterValues;

/// Radiance relative to the mean that darker cells are blurred with in the logarithm.
constexpr double logOffset = 0.05;
/// Residual of a control that differs from its default by a factor of 2: without influence where the picture shows
/// anything of the control.
constexpr double pull = 0.02;
/// A control that the picture does not need is reset: the mean squared residual may grow by this part, by so many of
/// its standard deviations, and by the square of this difference, which is not visible.
constexpr double allowedGrowth = 0.02, allowedDeviations = 2, invisible = 0.002;
/// Controls that differ from their defaults by less than this part are reset together.
constexpr double nearDefault = 0.1;

/// Pictures of a size and quality: cells per row, every how manyth is used, paths per cell of each half.
struct Stage {
  int side, stride, samples;
};
constexpr Stage coarse{24, 1, 16}, medium{64, 4, 32}, fine{96, 2, 64};
constexpr double startRoughness[] = {0.25, 0.5, 1, 2, 4};
constexpr std::size_t refinedStarts = 2;

const models::ParameterSpec& specOf(ArtistControl control) {
  return editing::artistControls().parameters[std::size_t(control)];
}

/// One number that is fitted: the logarithm of a control's channel (all channels unless it is a colour), the
/// saturation, or the exposure.
struct Variable {
  std::optional<ArtistControl> control = {};  ///< none: the exposure, stops
  int channel = 0;

  bool isLogarithmic() const { return control && control != ArtistControl::saturation; }
  double of(const ParameterValues& controls, double exposure) const {
    if (!control) return exposure;
    const double value = controls.values[std::size_t(*control)][channel];
    return isLogarithmic() ? std::log2(std::max(value, darkest)) : value;
  }
  void set(double x, ParameterValues& controls, double& exposure) const {
    if (!control) {
      exposure = x;
      return;
    }
    Rgb& value = controls.values[std::size_t(*control)];
    // The darkest value stands for 0 where the control permits it.
    const double next = !isLogarithmic() ? x : std::exp2(x) <= darkest ? std::max(0.0, least()) : std::exp2(x);
    if (specOf(*control).perChannel)
      value[channel] = next;
    else
      value = Rgb(next);
  }
  double neutral() const { return control && !isLogarithmic() ? 1 : 0; }
  double minimum(double current) const {
    if (!control) return -16;
    return std::min(current, isLogarithmic() ? std::log2(std::max(least(), darkest)) : least());
  }
  double maximum(double current) const {
    if (!control) return 16;
    const double most = specOf(*control).perChannel ? specOf(*control).hardMax : specOf(*control).softMax;
    return std::max(current, isLogarithmic() ? std::log2(most) : most);
  }

 private:
  static constexpr double darkest = 1.0 / 256;
  double least() const { return specOf(*control).softMin; }
};

/// Values of the controls and the exposure, and how well they fit.
struct State {
  ParameterValues controls;
  double exposure = 0;
  double cost = 0;         ///< mean squared residual without the noise of the ball
  double uncertainty = 0;  ///< standard deviation of the cost
};

using fitting::LinearMatrix;
using fitting::LinearVector;

/// Residuals, or their derivatives, of two pictures of the ball with independent noise. Sums of products of both do not
/// contain the noise, which otherwise would be fitted too: rougher materials have less.
template <class Values>
struct Halves {
  Values first, second;
};

/// The fit at one stage.
class Fit {
 public:
  Fit(const ReferencePicture& picture, const MatchedMaterial& material, const BallView& view, const Stage& stage,
      const State& start, const TaskControl& control)
      : cells_(referenceCells(picture, stage.side, stage.stride)),
        density_(std::make_shared<const TabulatedDensity>(*material.with(start.controls))),
        pictures_(material, view, cells_, stage.samples, density_, {control.stop, {}}),
        control_(control) {
    for (std::size_t cell = 0; cell < cells_.values.size(); ++cell)
      for (int c = 0; c < 3; ++c)
        if (cells_.known[cell][std::size_t(c)] != ReferenceCells::Known::no) used_.push_back({cell, c});
  }

  /// The best state from `start` with these variables, by the method of Levenberg and Marquardt. @throws Cancelled.
  State improve(const State& start, const std::vector<Variable>& variables, int iterations) {
    Search search(*this, start, variables);
    for (int k = 0; k < iterations && search.improve(); ++k) continue;
    return search.best();
  }

  double signalToNoiseRatio(const State& state) {
    const auto [one, other] = pictures_.render(state.controls, control_);
    const double scale = std::exp2(state.exposure);
    double signal = 0, noise = 0;
    for (const auto& [cell, c] : used_) {
      if (cells_.known[cell][std::size_t(c)] != ReferenceCells::Known::yes) continue;
      const double wanted = cells_.values[cell][c];
      signal += wanted * wanted;
      noise += (wanted - scale * one[cell][c]) * (wanted - scale * other[cell][c]);
    }
    return metrics::decibels(signal, std::max(noise, 1e-6 * signal));
  }

 private:
  /// The search for a minimum from a start.
  class Search {
   public:
    Search(Fit& fit, const State& start, const std::vector<Variable>& variables)
        : fit_(fit), start_(start), variables_(variables) {
      const auto count = Eigen::Index(variables.size());
      x_ = lower_ = upper_ = LinearVector(count);
      for (Eigen::Index k = 0; k < count; ++k) {
        const Variable& variable = variables[std::size_t(k)];
        x_[k] = variable.of(start.controls, start.exposure);
        lower_[k] = variable.minimum(x_[k]);
        upper_[k] = variable.maximum(x_[k]);
      }
      residuals_ = residualsAt(x_);
    }

    /// One iteration; false where the cost no longer falls.
    bool improve() {
      constexpr int tries = 6;
      constexpr double tolerance = 1e-4;
      const Halves<LinearMatrix> slopes = derivatives();
      const LinearMatrix mean = 0.5 * (slopes.first + slopes.second);
      const LinearMatrix normal = mean.transpose() * mean;
      const LinearVector slope =
          0.5 * (slopes.first.transpose() * residuals_.second + slopes.second.transpose() * residuals_.first);
      const double cost = residuals_.first.dot(residuals_.second);
      for (int k = 0; k < tries; ++k) {
        LinearMatrix damped = normal;
        damped.diagonal() *= 1 + damping_;
        const LinearVector step = fitting::solveBounded(damped, -slope, lower_ - x_, upper_ - x_);
        const LinearVector next = (x_ + step).cwiseMax(lower_).cwiseMin(upper_);
        Halves<LinearVector> residuals = residualsAt(next);
        const double fall = cost - residuals.first.dot(residuals.second);
        if (fall > 0) {
          x_ = next;
          residuals_ = std::move(residuals);
          damping_ *= 0.2;
          return fall > tolerance * std::abs(cost);
        }
        damping_ *= 5;
      }
      return false;
    }

    State best() const {
      State state = stateAt(x_);
      const auto used = Eigen::Index(fit_.used_.size());
      const auto first = residuals_.first.head(used), second = residuals_.second.head(used);
      state.cost = first.dot(second) / double(used);
      state.uncertainty = 0.5 * (first - second).squaredNorm() / double(used) / std::sqrt(double(used));
      return state;
    }

   private:
    State stateAt(const LinearVector& x) const {
      State state{start_.controls, start_.exposure};
      for (Eigen::Index k = 0; k < x.size(); ++k) variables_[std::size_t(k)].set(x[k], state.controls, state.exposure);
      return state;
    }
    /// Of the cells, then the distances of the variables from their defaults.
    Halves<LinearVector> residualsAt(const LinearVector& x) const {
      const auto used = Eigen::Index(fit_.used_.size());
      Halves<LinearVector> residuals{LinearVector(used + x.size()), LinearVector(used + x.size())};
      const State state = stateAt(x);
      const double weight = pull * std::sqrt(double(used) / 1000);
      const auto [one, other] = fit_.pictures_.render(state.controls, fit_.control_);
      for (auto [part, picture] : {std::pair{&residuals.first, &one}, {&residuals.second, &other}}) {
        fit_.setResiduals(state, *picture, {part->data(), std::size_t(used)});
        for (Eigen::Index k = 0; k < x.size(); ++k) {
          const Variable& variable = variables_[std::size_t(k)];
          (*part)[used + k] = variable.control ? weight * (x[k] - variable.neutral()) : 0;
        }
      }
      return residuals;
    }
    Halves<LinearMatrix> derivatives() const {
      constexpr double forward = 1e-4;
      const LinearMatrix empty(residuals_.first.size(), x_.size());
      Halves<LinearMatrix> slopes{empty, empty};
      for (Eigen::Index k = 0; k < x_.size(); ++k) {
        LinearVector moved = x_;
        const double step = x_[k] + forward > upper_[k] ? -forward : forward;
        moved[k] += step;
        const Halves<LinearVector> next = residualsAt(moved);
        slopes.first.col(k) = (next.first - residuals_.first) / step;
        slopes.second.col(k) = (next.second - residuals_.second) / step;
      }
      return slopes;
    }

    Fit& fit_;
    State start_;
    const std::vector<Variable>& variables_;
    LinearVector x_, lower_, upper_;
    Halves<LinearVector> residuals_;
    double damping_ = 1e-3;
  };

  void setResiduals(const State& state, const std::vector<Rgb>& shown, std::span<double> residuals) const {
    const double scale = std::exp2(state.exposure), offset = logOffset * cells_.mean;
    for (std::size_t i = 0; i < used_.size(); ++i) {
      const auto& [cell, c] = used_[i];
      const double value = scale * std::max(0.0, shown[cell][c]), wanted = cells_.values[cell][c];
      const double difference = std::log((value + offset) / (wanted + offset));
      const bool isClipped = cells_.known[cell][std::size_t(c)] == ReferenceCells::Known::atLeast;
      residuals[i] = isClipped ? std::min(0.0, difference) : difference;
    }
  }

  struct Channel {
    std::size_t cell;
    int channel;
  };
  ReferenceCells cells_;
  std::shared_ptr<const TabulatedDensity> density_;
  BallPictures pictures_;
  const TaskControl& control_;
  std::vector<Channel> used_;
};

std::vector<Variable> variablesOf(std::span<const ArtistControl> controls, bool freeExposure) {
  std::vector<Variable> variables;
  if (freeExposure) variables.emplace_back();
  for (const ArtistControl control : controls) {
    const bool isColour = specOf(control).perChannel;
    // A grey tint is the same as an exposure: the tint of one channel is fixed.
    for (int c = 0; c < (isColour ? 3 : 1); ++c)
      if (!isColour || !freeExposure || c != 1) variables.push_back({control, c});
  }
  return variables;
}

/// @param deviations by which the cost may grow.
bool isAsGood(const State& simpler, const State& state, double deviations) {
  return simpler.cost <=
         state.cost + allowedGrowth * std::abs(state.cost) + deviations * state.uncertainty + invisible * invisible;
}

/// The fit of the controls that are left.
struct FittedControls {
  State state;
  std::vector<ArtistControl> controls;
};

/// The fit with some controls reset and the others fitted again, where it is as good; else as it is.
FittedControls without(Fit& fit, const FittedControls& fitted, const std::function<bool(ArtistControl)>& isReset,
                       bool freeExposure, double deviations = 0) {
  constexpr int iterations = 3;
  FittedControls simpler = fitted;
  for (const ArtistControl control : fitted.controls)
    if (isReset(control)) simpler.state.controls.values[std::size_t(control)] = Rgb(specOf(control).defaultValue);
  std::erase_if(simpler.controls, isReset);
  if (simpler.controls.size() == fitted.controls.size()) return fitted;
  simpler.state = fit.improve(simpler.state, variablesOf(simpler.controls, freeExposure), iterations);
  return isAsGood(simpler.state, fitted.state, deviations) ? simpler : fitted;
}

/// Resets the controls that the picture does not need, one after the other: colours first, which repeat others.
FittedControls simplified(Fit& fit, FittedControls fitted, bool freeExposure) {
  for (const ArtistControl control : {ArtistControl::tint, ArtistControl::coatStrength, ArtistControl::saturation,
                                      ArtistControl::specularStrength, ArtistControl::roughness})
    fitted = without(
        fit, fitted, [control](ArtistControl one) { return one == control; }, freeExposure);
  return fitted;
}

bool isNearDefault(const State& state, ArtistControl control) {
  const Rgb ratio = state.controls.values[std::size_t(control)] / specOf(control).defaultValue;
  return maxChannel(glm::abs(ratio - Rgb(1))) < nearDefault;
}

/// The tint's brightest channel becomes 1, the exposure takes the rest.
void normalise(State& state) {
  Rgb& tint = state.controls.values[std::size_t(ArtistControl::tint)];
  const double brightest = maxChannel(tint);
  if (!(brightest > 0)) return;
  tint /= brightest;
  state.exposure += std::log2(brightest);
}

}  // namespace

std::vector<ArtistControl> matchedControls(const editing::DifferentialEdit& edit) {
  std::vector<ArtistControl> controls;
  for (const ArtistControl control : {ArtistControl::roughness, ArtistControl::specularStrength, ArtistControl::tint,
                                      ArtistControl::saturation, ArtistControl::coatStrength})
    if (editing::actsOn(control, edit.model->spec())) controls.push_back(control);
  return controls;
}

ControlMatch matchControls(const ReferencePicture& picture, MatchedMaterial material, const rendering::Scene& scene,
                           const MatchOptions& options, const TaskControl& control) {
  assert(std::holds_alternative<editing::DifferentialEdit>(material.edits[material.index].content));
  material.edits[material.index].enabled = true;
  const BallView view = ballView(scene);
  const std::vector<ArtistControl> controls = matchedControls(material.edit());
  const std::vector<Variable> variables = variablesOf(controls, options.freeExposure);
  const State start{material.edit().controls};
  const bool hasRoughness = std::ranges::find(controls, ArtistControl::roughness) != controls.end();

  // Where the search begins matters for the roughness alone: highlights that do not overlap have no gradient.
  std::vector<State> states;
  for (const double factor : startRoughness) {
    State from = start;
    if (hasRoughness) from.controls.values[std::size_t(ArtistControl::roughness)] = Rgb(factor);
    states.push_back(Fit(picture, material, view, coarse, from, control).improve(from, variables, 6));
    control.report(0.05 * double(states.size()));
    if (!hasRoughness) break;
  }
  std::ranges::sort(states, {}, &State::cost);
  states.resize(std::min(states.size(), refinedStarts));
  Fit second(picture, material, view, medium, states.front(), control);
  for (State& state : states) {
    state = second.improve(state, variables, 8);
    control.report(0.25 + 0.15 * double(&state - states.data() + 1));
  }
  FittedControls best{*std::ranges::min_element(states, {}, &State::cost), controls};
  best = simplified(second, best, options.freeExposure);
  control.report(0.7);
  Fit last(picture, material, view, fine, best.state, control);
  best.state = last.improve(best.state, variablesOf(best.controls, options.freeExposure), 3);
  control.report(0.9);
  best = without(
      last, best, [state = best.state](ArtistControl one) { return isNearDefault(state, one); }, options.freeExposure,
      allowedDeviations);
  if (options.freeExposure) normalise(best.state);
  control.report(1);
  return {best.state.controls, best.state.exposure, last.signalToNoiseRatio(best.state)};
}

}  // namespace gonio::matching
