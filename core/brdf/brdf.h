// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "core/math/types.h"

namespace gonio {

class ValueBound;

/// A sampled direction of light and its density, 1/sr. pdf = 0: the sample failed and contributes nothing.
struct DirectionSample {
  Direction wi{0, 0, 1};
  double pdf = 0;
};

/// Which direction of a pair is used as the file's incident direction. This matters only if the measurement is not
/// reciprocal.
enum class IncidentDirection {
  viewer,  ///< wo, as in Mitsuba and pbrt, which sample the light for a given viewer
  light,   ///< wi, as the file names it
  mean     ///< the mean of both, which is reciprocal
};
inline constexpr IncidentDirection allIncidentDirections[] = {IncidentDirection::viewer, IncidentDirection::light,
                                                              IncidentDirection::mean};
/// The name in files: "viewer", "light" or "mean".
constexpr const char* incidentDirectionId(IncidentDirection incident) {
  return incident == IncidentDirection::light ? "light" : incident == IncidentDirection::mean ? "mean" : "viewer";
}

/// A BRDF. Values are linear RGB, 1/sr, without the cosine; core/math/types.h defines the conventions. Immutable: every
/// method may be called from several threads at once.
class Brdf {
 public:
  virtual ~Brdf() = default;

  /// Evaluates pairs.size() pairs into `values` (same size). Pairs with a direction below the horizon give 0; in BRDFs
  /// over half-vector coordinates, pairs without a half vector (wi = -wo) do too. Values are finite. A channel is
  /// negative only where a measurement contains a colour outside the sRGB gamut (RglBrdf), and in the results of
  /// models::Model::instantiateUnclamped() and editing::applyEditsUnclamped(): set it to 0 before a logarithm or root.
  virtual void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const = 0;

  /// One pair. For many pairs the batch form is faster.
  Rgb evaluate(const Direction& wi, const Direction& wo) const {
    const DirectionPair pair{wi, wo};
    Rgb value{0};
    evaluate(std::span(&pair, 1), std::span(&value, 1));
    return value;
  }

  /// Whether the value depends on the azimuths only through their difference.
  virtual bool isIsotropic() const { return true; }
  /// Whether exchanging wi and wo leaves the value unchanged, as physics requires; false if unknown.
  virtual bool isReciprocal() const { return true; }
  /// Whether mirroring both directions at any plane through the normal leaves the value unchanged (bilateral symmetry
  /// of an isotropic BRDF); false if unknown.
  virtual bool isMirrorSymmetric() const { return false; }

  /// Bounds of the values over sets of pairs, strict up to rounding, from which the effect plan proves what it may omit
  /// (core/brdf/value_bound.h). Null: no bound is known. May take up to a second for a sparse code.
  virtual std::shared_ptr<const ValueBound> valueBound() const { return nullptr; }

  /// Whether the value of a pair is known: false below the horizon and where a measurement has no data. There
  /// evaluate() returns 0, or the extrapolation that the class documents.
  virtual bool hasData(const DirectionPair& pair) const { return !isBelowHorizon(pair.wi) && !isBelowHorizon(pair.wo); }

  /// How a measurement that stores which direction was the incident one is read; empty for other BRDFs.
  virtual std::optional<IncidentDirection> incidentDirection() const { return std::nullopt; }
  /// The same measurement read with an incident direction; null for other BRDFs.
  virtual std::shared_ptr<const Brdf> readWith(IncidentDirection) const { return nullptr; }
  /// Whether a measurement has spectra; its values are their colours.
  virtual bool isSpectral() const { return false; }

  /// Whether sample() follows this BRDF better than cosine-weighted sampling does.
  virtual bool hasImportanceSampling() const { return false; }
  /// Approximate rendering time per sample with sample() and pdf(), relative to a closed-form density.
  virtual double samplingCost() const { return 1; }

  /// Importance sampling: samples a direction of light wi for the viewer wo (z > 0) with the density pdf(), which is
  /// roughly proportional to the value times cos theta_i. `u` in [0, 1)^3: u.x selects the component of a mixture, u.y
  /// and u.z the direction. The result is above the horizon with a positive density, or a failed sample with density 0.
  /// Default: cosine-weighted.
  virtual DirectionSample sample(const Direction& wo, const glm::dvec3& u) const;
  /// Density of sample() at wi, 1/sr: integrates over the upper hemisphere to the fraction of samples that do not fail;
  /// 0 below the horizon.
  virtual double pdf(const Direction& wi, const Direction& wo) const;
};

/// A BRDF as the form that it has, such as TabulatedBrdf, to read its nodes exactly; null if it has another form.
template <class Form>
const Form* formOf(const Brdf& brdf) {
  return dynamic_cast<const Form*>(&brdf);
}
template <class Form>
std::shared_ptr<const Form> formOf(const std::shared_ptr<const Brdf>& brdf) {
  return std::dynamic_pointer_cast<const Form>(brdf);
}

/// The BRDF read with this incident direction; the same object if it is already read so or stores no incident
/// direction.
inline std::shared_ptr<const Brdf> withIncident(const std::shared_ptr<const Brdf>& brdf, IncidentDirection incident) {
  return brdf->incidentDirection().value_or(incident) == incident ? brdf : brdf->readWith(incident);
}

/// The value of a pair when it is read with an incident direction. @param stored callable as Rgb(incident, outgoing)
/// with the file's own incident and outgoing directions.
template <class Stored>
Rgb valueInOrder(IncidentDirection incident, const DirectionPair& pair, const Stored& stored) {
  switch (incident) {
    case IncidentDirection::light:
      return stored(pair.wi, pair.wo);
    case IncidentDirection::mean:
      return (stored(pair.wo, pair.wi) + stored(pair.wi, pair.wo)) / 2.0;
    default:
      return stored(pair.wo, pair.wi);
  }
}

/// An isotropic BRDF that calls a function per pair, only for pairs with both directions at or above the horizon.
/// @tparam Value callable as Rgb(const Direction& wi, const Direction& wo), const, from several threads at once;
/// returns finite linear RGB, 1/sr, without the cosine.
template <typename Value>
class PairwiseBrdf final : public Brdf {
 public:
  PairwiseBrdf(Value value, bool reciprocal) : value_(std::move(value)), reciprocal_(reciprocal) {}

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto& [wi, wo] = pairs[i];
      values[i] = isBelowHorizon(wi) || isBelowHorizon(wo) ? Rgb(0) : value_(wi, wo);
    }
  }
  bool isReciprocal() const override { return reciprocal_; }

 private:
  Value value_;
  bool reciprocal_;
};

template <typename Value>
std::shared_ptr<const Brdf> makePairwiseBrdf(Value value, bool reciprocal = true) {
  return std::make_shared<const PairwiseBrdf<Value>>(std::move(value), reciprocal);
}

}  // namespace gonio
