// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/rgl_brdf.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/brdf/density_mixture.h"
#include "core/brdf/normal_square.h"
#include "core/brdf/value_bound.h"
#include "core/math/fast_functions.h"

namespace gonio {

namespace {

using Tables = RglBrdf::Tables;

/// Closer to the horizon (89.94 degrees) the stored product, which the instrument does not reach, is not divided
/// further: quotients stay bounded.
constexpr double minCosine = 1e-3;

/// One slice, whatever the incident direction.
constexpr SliceBlend onlySlice{1, {0}, {1}};

/// The signs that bring an incident direction into the measured range of azimuths: half a turn, or a mirror image in
/// one or both axes.
glm::dvec2 intoRange(const RglData& data, const Direction& incident) {
  if (data.azimuthReduction < 2) return {1, 1};
  const double flipY = std::signbit(incident.y) ? 1 : -1;
  return {data.azimuthReduction == 4 ? (std::signbit(incident.x) ? 1 : -1) : flipY, flipY};
}

Direction flipped(const Direction& w, const glm::dvec2& signs) { return {w.x * signs.x, w.y * signs.y, w.z}; }

double turnOf(const RglData& data, double phiI) { return data.isotropic ? phiI : 0; }

/// Pairs are evaluated in blocks, so that loops over their coordinates are vectorised.
constexpr std::size_t blockSize = 64;

/// The pairs of a block in the measured range of azimuths, and their coordinates.
struct BlockCoordinates {
  using Numbers = std::array<double, blockSize>;
  Numbers inX, inY, inZ, outX, outY, outZ;
  Numbers thetaI, phiI;
  Numbers normalX, normalY;  ///< toNormalSquare() of the half vector
  Numbers sigmaX, sigmaY;    ///< toNormalSquare() of the incident direction

  void setPair(std::size_t i, const RglData& data, const Direction& incident, const Direction& outgoing) {
    const glm::dvec2 signs = intoRange(data, incident);
    const Direction in = flipped(incident, signs), out = flipped(outgoing, signs);
    inX[i] = in.x, inY[i] = in.y, inZ[i] = in.z;
    outX[i] = out.x, outY[i] = out.y, outZ[i] = out.z;
  }

  void compute(std::size_t count, bool isotropic) {
    const double turned = isotropic ? 1 : 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double sumX = inX[i] + outX[i], sumY = inY[i] + outY[i], sumZ = inZ[i] + outZ[i];
      thetaI[i] = fastAtan2(std::sqrt(inX[i] * inX[i] + inY[i] * inY[i]), inZ[i]);
      phiI[i] = fastAtan2(inY[i], inX[i]);
      const double thetaM = fastAtan2(std::sqrt(sumX * sumX + sumY * sumY), sumZ);
      const glm::dvec2 normal = toNormalSquare(thetaM, fastAtan2(sumY, sumX) - turned * phiI[i]);
      const glm::dvec2 sigma = toNormalSquare(thetaI[i], phiI[i]);
      normalX[i] = normal.x, normalY[i] = normal.y;
      sigmaX[i] = sigma.x, sigmaY[i] = sigma.y;
    }
  }
};

/// The value of pair i of a block, without the cosine.
Rgb valueAt(const Tables& tables, const BlockCoordinates& at, std::size_t i) {
  if (!(at.inZ[i] > horizonTolerance) || !(at.outZ[i] > horizonTolerance)) return Rgb(0);
  const RglData& data = tables.data;
  const glm::dvec2 normal(at.normalX[i], at.normalY[i]);
  const SliceBlend blend = data.incident.blend(at.phiI[i], at.thetaI[i]);
  Rgb value = interpolate<Rgb>(data.rgb, blend, tables.visibleNormals.invert(blend, normal).point);
  if (data.jacobian) {
    const double sigma = interpolate<double>(data.sigma, onlySlice, {at.sigmaX[i], at.sigmaY[i]});
    if (!(sigma > 0)) return Rgb(0);
    value *= interpolate<double>(data.ndf, onlySlice, normal) / (4 * sigma);
  }
  return value / std::max(at.outZ[i], minCosine);
}

/// @param isViewer whether the viewer is the file's incident direction, else the light.
void evaluateBlock(const Tables& tables, std::span<const DirectionPair> pairs, bool isViewer, std::span<Rgb> values) {
  BlockCoordinates at;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [wi, wo] = pairs[i];
    at.setPair(i, tables.data, isViewer ? wo : wi, isViewer ? wi : wo);
  }
  at.compute(pairs.size(), tables.data.isotropic);
  for (std::size_t i = 0; i < pairs.size(); ++i) values[i] = valueAt(tables, at, i);
}

/// Draws half vectors from the luminance over the square that the visible normals warp to.
struct RglDensity {
  const Tables& tables;

  Direction sample(const Direction& wo, const glm::dvec2& u) const {
    const glm::dvec2 signs = intoRange(tables.data, wo);
    const Direction incident = flipped(wo, signs);
    const double phiI = azimuth(incident);
    const SliceBlend blend = tables.data.incident.blend(phiI, polarAngle(incident));
    const glm::dvec2 warped = tables.luminance.sample(blend, u).point;
    const glm::dvec2 square = tables.visibleNormals.sample(blend, warped).point;
    return flipped(reflected(incident, fromNormalSquare(square, turnOf(tables.data, phiI))), signs);
  }

  double density(const Direction& w, const Direction& wo) const {
    const glm::dvec2 signs = intoRange(tables.data, wo);
    const Direction incident = flipped(wo, signs), sum = incident + flipped(w, signs);
    if (!isHalfVector(sum)) return 0;
    const double phiI = azimuth(incident);
    const SliceBlend blend = tables.data.incident.blend(phiI, polarAngle(incident));
    const glm::dvec2 square = toNormalSquare(sum, turnOf(tables.data, phiI));
    const MarginalWarp::Sample normal = tables.visibleNormals.invert(blend, square);
    return normal.density * tables.luminance.density(blend, normal.point) * squarePerSolidAngle(square, sum, incident);
  }
};

DensityMixture<CosineDensity, RglDensity> densityOf(const Tables& tables) {
  constexpr double cosineFraction = 0.1;
  return {{cosineFraction, 1 - cosineFraction}, CosineDensity{}, RglDensity{tables}};
}

/// A file without a luminance of its own, and values that are none, leave the choice to the visible normals.
SliceStack<float> sampled(SliceStack<float> luminance) {
  for (float& value : luminance.values)
    if (!(value >= 0) || !std::isfinite(value)) value = 0;
  return luminance;
}

}  // namespace

SliceStack<float> visibleNormals(const SliceStack<float>& ndf, const ParameterGrid& incident, bool isotropic) {
  const std::size_t columns = ndf.width, rows = isotropic ? ndf.width : ndf.height;
  SliceStack<float> result{columns, rows, {}};
  result.values.reserve(incident.slices() * rows * columns);
  for (const float phi : incident.phis())
    for (const float theta : incident.thetas()) {
      const Direction w = fromSpherical(theta, phi);
      for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < columns; ++column) {
          const glm::dvec2 square(double(column) / double(columns - 1), double(row) / double(rows - 1));
          const Direction normal = fromNormalSquare(square, isotropic ? phi : 0);
          const double stretch = square.x * std::hypot(normal.x, normal.y);
          const double density = interpolate<double>(ndf, onlySlice, square) * std::max(0.0, glm::dot(w, normal));
          result.values.push_back(float(density * stretch));
        }
    }
  return result;
}

RglBrdf::RglBrdf(RglData data, IncidentDirection incident) : incident_(incident) {
  MarginalWarp normals(std::move(data.vndf), "vndf");
  MarginalWarp luminance(sampled(std::move(data.luminance)), "luminance", MarginalWarp::EmptySlice::uniform);
  tables_ = std::make_shared<const Tables>(Tables{std::move(data), std::move(normals), std::move(luminance)});
}

std::shared_ptr<const RglBrdf> RglBrdf::withIncident(IncidentDirection incident) const {
  return std::shared_ptr<const RglBrdf>(new RglBrdf(tables_, incident));
}

std::shared_ptr<const RglBrdf> RglBrdf::withColours(SliceStack<glm::vec3> rgb, SliceStack<float> luminance) const {
  Tables tables{tables_->data, tables_->visibleNormals,
                MarginalWarp(sampled(std::move(luminance)), "luminance", MarginalWarp::EmptySlice::uniform)};
  tables.data.rgb = std::move(rgb);
  tables.data.spectra = nullptr;
  return std::shared_ptr<const RglBrdf>(new RglBrdf(std::make_shared<const Tables>(std::move(tables)), incident_));
}

void RglBrdf::evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const {
  for (std::size_t begin = 0; begin < pairs.size(); begin += blockSize) {
    const std::size_t count = std::min(blockSize, pairs.size() - begin);
    const auto block = pairs.subspan(begin, count);
    const auto results = values.subspan(begin, count);
    evaluateBlock(*tables_, block, incident_ != IncidentDirection::light, results);
    if (incident_ != IncidentDirection::mean) continue;
    std::array<Rgb, blockSize> reversed;
    evaluateBlock(*tables_, block, false, reversed);
    for (std::size_t i = 0; i < count; ++i) results[i] = (results[i] + reversed[i]) / 2.0;
  }
}

namespace {

/// Stored values over the whole square and all azimuths, the distributions over all azimuths.
class RglBound final : public ValueBound {
 public:
  RglBound(const RglData& data, IncidentDirection incident)
      : incident_(incident),
        jacobian_(data.jacobian),
        thetas_(data.incident.thetas().begin(), data.incident.thetas().end()),
        values_(int(thetas_.size()), 1),
        ndf_(int(data.ndf.width), 1),
        sigma_(int(data.sigma.width), 1) {
    const std::size_t perSlice = data.rgb.width * data.rgb.height;
    for (std::size_t n = 0; n < data.rgb.values.size(); ++n)
      values_.include(int(n / perSlice % thetas_.size()), 0, Rgb(data.rgb.values[n]));
    for (std::size_t n = 0; n < data.ndf.values.size(); ++n)
      ndf_.include(int(n % data.ndf.width), 0, Rgb(data.ndf.values[n]));
    for (std::size_t n = 0; n < data.sigma.values.size(); ++n)
      sigma_.include(int(n % data.sigma.width), 0, Rgb(data.sigma.values[n]));
    ndfWidth_ = int(data.ndf.width);
    sigmaWidth_ = int(data.sigma.width);
  }

  RgbRange over(const PairBox& box) const override {
    RgbRange result{Rgb(std::numeric_limits<double>::infinity()), Rgb(-std::numeric_limits<double>::infinity())};
    const auto include = [&](const RgbRange& one) {
      result.low = glm::min(result.low, one.low);
      result.high = glm::max(result.high, one.high);
    };
    if (incident_ != IncidentDirection::light) include(ofIncident(box.thetaO, box.cosI, box));
    if (incident_ != IncidentDirection::viewer) include(ofIncident(box.thetaI(), box.cosO, box));
    return result;
  }
  bool isLocal() const override { return false; }

 private:
  RgbRange ofIncident(const Range& theta, const Range& cosOut, const PairBox& box) const {
    const auto first = std::upper_bound(thetas_.begin(), thetas_.end(), theta.low - 1e-6) - thetas_.begin() - 1;
    const auto last = std::lower_bound(thetas_.begin(), thetas_.end(), theta.high + 1e-6) - thetas_.begin();
    const RgbRange stored =
        values_.over(NodeSpan({double(first), double(last)}, int(thetas_.size())), NodeSpan(0.0, 1));
    const Range cosine = max(cosOut, Range(minCosine));
    Range factor = Range(1) / cosine;
    if (jacobian_) {
      const Range density = spread(ndf_, box.thetaH, ndfWidth_), area = spread(sigma_, theta, sigmaWidth_);
      factor = factor * density / (Range(4) * max(area, Range(0)));
    }
    RgbRange result;
    for (int c = 0; c < 3; ++c) {
      const Range one = Range(stored.low[c], stored.high[c]) * factor;
      result.low[c] = std::min(0.0, one.low);
      result.high[c] = std::max(0.0, one.high);
    }
    return result;
  }
  static Range spread(const GridExtrema& columns, const Range& theta, int width) {
    const auto column = [width](double angle) { return toNormalSquare(angle, 0).x * (width - 1); };
    const RgbRange found = columns.over(NodeSpan(increasing(theta, column), width), NodeSpan(0.0, 1));
    return {found.low.x, found.high.x};
  }

  IncidentDirection incident_;
  bool jacobian_;
  std::vector<double> thetas_;
  GridExtrema values_, ndf_, sigma_;
  int ndfWidth_ = 0, sigmaWidth_ = 0;
};

}  // namespace

std::shared_ptr<const ValueBound> RglBrdf::valueBound() const {
  return std::make_shared<const RglBound>(tables_->data, incident_);
}

DirectionSample RglBrdf::sample(const Direction& wo, const glm::dvec3& u) const {
  return densityOf(*tables_).sample(wo, u);
}

double RglBrdf::pdf(const Direction& wi, const Direction& wo) const { return densityOf(*tables_).pdf(wi, wo); }

}  // namespace gonio
