// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>

#include "core/brdf/direction_sample.h"

namespace gonio {

class RglBrdf;
class TabulatedBrdf;

/// A reflectance function. Values are linear RGB in 1/sr without the cosine (core/math/types.h has the conventions).
/// Immutable: every method may be called from any number of threads.
class Brdf {
 public:
  virtual ~Brdf() = default;

  /// Evaluates pairs.size() pairs into `values` (same size). A pair with a direction below the horizon, and one
  /// without a half vector, gives 0. Never non-finite. A channel is negative only where a measurement holds a colour
  /// outside the sRGB gamut (RglBrdf): what takes a logarithm or a root sets it to 0 first.
  virtual void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const = 0;

  /// One pair. For many pairs the batch form is faster.
  Rgb evaluate(const Direction& wi, const Direction& wo) const {
    const DirectionPair pair{wi, wo};
    Rgb value{0};
    evaluate(std::span(&pair, 1), std::span(&value, 1));
    return value;
  }

  /// Whether the value depends on the difference of the azimuths only.
  virtual bool isIsotropic() const { return true; }
  /// Whether the value stays when wi and wo are exchanged, as physics asks for; false where that is not so or not
  /// known.
  virtual bool isReciprocal() const { return true; }

  /// Whether the value of a pair is known: false below the horizon, and where a measurement has no data. It is 0 there,
  /// or what a class documents as its continuation beyond the measured angles.
  virtual bool hasData(const DirectionPair& pair) const { return !isBelowHorizon(pair.wi) && !isBelowHorizon(pair.wo); }
  /// This BRDF where it is a table, so that its nodes can be read exactly; null for all others.
  virtual const TabulatedBrdf* asTable() const { return nullptr; }
  /// The same for a file of the RGL database in its own parameterisation.
  virtual const RglBrdf* asRgl() const { return nullptr; }

  /// Whether sample() knows this BRDF better than a cosine does.
  virtual bool hasImportanceSampling() const { return false; }
  /// The time of a picture's sample with sample() and pdf(), about, in units of one from a lobe of closed form.
  virtual double samplingCost() const { return 1; }

  /// Samples a direction of light wi for the viewer wo (z > 0) from the density pdf(), for importance sampling: about
  /// proportional to the value times cos theta_i. `u` are three numbers in [0, 1): which lobe, then two for the
  /// direction. Above the horizon with a positive density, or lost: with the density 0. Cosine-weighted where a BRDF
  /// knows no better.
  virtual DirectionSample sample(const Direction& wo, const glm::dvec3& u) const;
  /// Density of sample() at wi, 1/sr: integrates over the upper hemisphere to the fraction of samples that are not
  /// lost; 0 below the horizon.
  virtual double pdf(const Direction& wi, const Direction& wo) const;
};

}  // namespace gonio
