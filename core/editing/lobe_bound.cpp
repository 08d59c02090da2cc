// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/lobe_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gonio::editing {

namespace {

using Channels = LobeBound::Channels;
constexpr double infinity = std::numeric_limits<double>::infinity(),
                 epsilon2 = LobeChange::epsilon * LobeChange::epsilon;

Channels channels(const RgbRange& range) {
  return {Range(range.low.x, range.high.x), Range(range.low.y, range.high.y), Range(range.low.z, range.high.z)};
}

Range luminanceOf(const Channels& c) {
  const auto of = [](double red, double green, double blue) { return luminance(Rgb(red, green, blue)); };
  return {of(c[0].low, c[1].low, c[2].low), of(c[0].high, c[1].high, c[2].high)};
}

/// a / (a + b) of numbers that are not negative; 0 where a is 0.
Range shareOf(const Range& a, const Range& b) {
  const auto share = [](double x, double y) { return x > 0 ? (x < infinity ? x / (x + y) : 1) : 0; };
  return {share(a.low, b.high), share(a.high, b.low)};
}

/// (m M + eps^2) / (M^2 + eps^2), which with rising M > 0 rises to one extremum if m > 0, or falls to one, and returns.
double closeRatio(double m, double model) {
  return model < 1e150 ? (m * model + epsilon2) / (model * model + epsilon2) : 0;
}
/// Where the extremum is.
double extremeModel(double m) {
  const double root = LobeChange::epsilon * std::sqrt(epsilon2 + m * m);
  return m > 0 ? m / (1 + root / epsilon2) : m < 0 ? (epsilon2 + root) / -m : infinity;
}

/// The range of closeRatioOf() (lobe_change.cpp).
Range closeRatioOf(const Range& m, const Range& model) {
  constexpr double darkest = 1e-30;
  const auto over = [&](double value, auto&& choose) {
    const double extreme = std::clamp(extremeModel(value), model.low, model.high);
    return choose(choose(closeRatio(value, model.low), closeRatio(value, model.high)), closeRatio(value, extreme));
  };
  const double high = over(m.high, [](double a, double b) { return std::max(a, b); });
  const double low = over(m.low, [](double a, double b) { return std::min(a, b); });
  const double least = std::max(model.low, darkest), most = std::max(model.high, darkest);
  return {std::min(low, m.low / (m.low < 0 ? least : most)), std::min(high, m.high / (m.high < 0 ? most : least))};
}

/// P of LobeChange over a set.
Range centreOver(const PairBox& box, const models::LobeWidth& width) {
  constexpr double extent2 = LobeChange::peakExtent * LobeChange::peakExtent;
  const auto at = [&](double sine, double cosine, double alpha) {
    const double x = sine * sine / (alpha * alpha * extent2 * std::max(cosine * cosine, 1e-12));
    return 1 / (1 + x * x);
  };
  return {at(box.sinH.high, box.cosH.low, std::min(width.x, width.y)),
          at(box.sinH.low, box.cosH.high, std::max(width.x, width.y))};
}

/// The angles moved by whole turns to begin in [0, 2 pi); the whole turn where they exceed it.
Range wrapped(const Range& angles) {
  const double turns = 2 * pi * std::floor(angles.low / (2 * pi));
  const Range result(angles.low - turns, angles.high - turns);
  return result.high <= 2 * pi ? result : Range(0, 2 * pi);
}

Range intersection(const Range& a, const Range& b) {
  const double low = std::max(a.low, b.low), high = std::min(a.high, b.high);
  return low <= high ? Range(low, high) : a;  // they meet, but for rounding
}

/// All pairs with these half vectors' polar angles and difference angles.
PairBox everyViewer(const Range& thetaH, const Range& cosD, bool isIsotropic) {
  PairBox box({0, halfPi}, thetaH, {-pi, pi}, isIsotropic ? Range(0) : Range(0, 2 * pi));
  box.cosD = intersection(box.cosD, cosD);
  return box;
}

/// cos theta of wi (side 1) or wo (-1) when the half vector is at theta_h: wi, wo = cos theta_d h +- (x x' + y y'), x'
/// along theta_h.
Range heightOver(const Range& cosD, const Range& x, const Range& thetaH, double side) {
  return cosD * cosine(thetaH) + Range(side) * x * sine(thetaH);
}

/// Where turns of the half vector end: at `end`, or where a direction falls to minWarpCosine (endingAtTheHorizon() in
/// lobe_change.cpp). Steps along the turn while no direction of the set can end it, then until one surely does.
Range whereTurnsEnd(const Range& start, const Range& end, const Range& cosD, const Range& x) {
  constexpr int steps = 12;
  constexpr double rounding = 1e-9;
  const auto between = [](double a, double b, double t) { return a + t * (b - a); };
  const auto at = [&](double t) { return Range(between(start.low, end.low, t), between(start.high, end.high, t)); };
  const double direction = end.low + end.high < start.low + start.high ? -1 : 1;
  double first = 1, last = 1;
  for (int step = 0; step < steps && last == 1; ++step) {
    const double t = double(step) / steps, next = double(step + 1) / steps;
    const Range part = hull(at(t), at(next));
    bool isFree = true, isEnded = false;
    for (const double side : {1.0, -1.0}) {
      const Range z = heightOver(cosD, x, part, side);
      const Range rise = Range(direction) * (Range(side) * x * cosine(part) - cosD * sine(part));
      isFree = isFree && (z.low >= minWarpCosine + rounding || rise.low > rounding);
      isEnded = isEnded || (z.high <= minWarpCosine - rounding && rise.high < -rounding);
    }
    if (!isFree) first = std::min(first, t);
    if (isEnded) last = next;
  }
  return hull(at(first), at(last));
}

}  // namespace

PairBox warped(const LobeWarp& warp, const PairBox& box) {
  constexpr double rounding = 1e-9;
  const bool isIsotropic = box.phiO.low == 0 && box.phiO.high == 0;
  const auto scaled = [](double theta, double scale) { return std::atan2(scale * std::sin(theta), std::cos(theta)); };
  const double least = std::min(warp.scale.x, warp.scale.y), most = std::max(warp.scale.x, warp.scale.y);
  const Range end(scaled(box.thetaH.low, least), scaled(box.thetaH.high, most));
  const Range anywhere(std::max(0.0, std::min(box.thetaH.low, end.low) - rounding),
                       std::min(halfPi, std::max(box.thetaH.high, end.high) + rounding));
  if (least != most || box.cosD.low < 1e-5) return everyViewer(anywhere, box.cosD, isIsotropic);
  // Both directions turn in the plane of the normal and the half vector. x = sin theta_o cos theta_h cos psi - cos
  // theta_o sin theta_h = (1 + c) / 2 sin(theta_o - theta_h)
  // - (1 - c) / 2 sin(theta_o + theta_h), c = cos psi, rises with c.
  const Range near = sine(box.thetaO - box.thetaH), far = sine(box.thetaO + box.thetaH), c = box.cosPsi;
  Range x((1 + c.low) / 2 * near.low - (1 - c.low) / 2 * far.high,
          (1 + c.high) / 2 * near.high - (1 - c.high) / 2 * far.low);
  // wi.z - wo.z = 2 x sin theta_h
  if (box.sinH.low > rounding) x = intersection(x, box.rise / (Range(2) * box.sinH));
  const Range y = box.sinO * sine(box.psi);
  const Range turned = whereTurnsEnd(box.thetaH, end, box.cosD, x);
  const Range thetaH(std::max(0.0, turned.low - rounding), std::min(halfPi, turned.high + rounding));
  const auto cosines = [&](double side) {
    const Range z = heightOver(box.cosD, x, thetaH, side);
    return Range(std::clamp(z.low - rounding, 0.0, 1.0), std::clamp(z.high + rounding, 0.0, 1.0));
  };
  const Range cosO = cosines(-1), cosI = cosines(1);
  // The azimuth of the half vector from that of wo.
  const Range along = box.cosD * sine(thetaH) + x * cosine(thetaH);
  Range psi(-pi, pi);
  if (along.low > 0 || !y.contains(0)) {
    psi = {infinity, -infinity};
    for (const double a : {along.low, along.high})
      for (const double b : {y.low, y.high}) psi = hull(psi, std::atan2(b, a));
  }
  const Range azimuth = isIsotropic ? Range(0) : wrapped(box.phiO + box.psi - psi + Range(warp.fitted - warp.edited));
  PairBox result({std::acos(cosO.high), std::acos(cosO.low)}, thetaH, psi, azimuth);
  result.cosD = intersection(result.cosD, {box.cosD.low - rounding, box.cosD.high + rounding});
  result.cosI = intersection(result.cosI, cosI);
  return result;
}

/// Of the pairs of a set: what LobeChange::Ratios has at each.
struct LobeBound::Ratios {
  std::vector<Channels> parts, shares;  ///< M_k; M_k / M
  std::vector<Channels> weights;        ///< M_k / (M + eps); shares with keepsAlbedo
  Channels model, ratio;                ///< M, q
  Range step = 0;                       ///< S P: the part of q - 1 that is a peak
  std::vector<Range> luminances;        ///< y_k of highlights
  Channels rest;                        ///< r = 1 - H / M
};

LobeBound::Ratios LobeBound::ratiosOver(const PairBox& box, const Channels& values) const {
  Ratios ratios;
  for (const Part& part : parts_) {
    Channels& fitted = ratios.parts.emplace_back(channels(part.values->over(box)));
    for (Range& value : fitted) value = max(value, 0);
  }
  ratios.shares.resize(parts_.size());
  ratios.weights.resize(parts_.size());
  for (std::size_t c = 0; c < 3; ++c) {
    Range highlights = 0, others = 0;
    for (std::size_t k = 0; k < parts_.size(); ++k) (parts_[k].isHighlight ? highlights : others) += ratios.parts[k][c];
    ratios.model[c] = highlights + others;
    ratios.rest[c] = Range(1) - shareOf(highlights, others);
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      Range other = 0;
      for (std::size_t j = 0; j < parts_.size(); ++j)
        if (j != k) other += ratios.parts[j][c];
      ratios.shares[k][c] = shareOf(ratios.parts[k][c], other);
      ratios.weights[k][c] = shareOf(ratios.parts[k][c], other + Range(keepsAlbedo_ ? 0 : LobeChange::epsilon));
    }
    const Range offset(LobeChange::epsilon);
    ratios.ratio[c] =
        keepsAlbedo_ ? closeRatioOf(values[c], ratios.model[c]) : (values[c] + offset) / (ratios.model[c] + offset);
  }
  if (keepsAlbedo_) fillPeaks(box, values, ratios);
  return ratios;
}

void LobeBound::fillPeaks(const PairBox& box, const Channels& values, Ratios& ratios) const {
  const Range measured = luminanceOf(values), model = luminanceOf(ratios.model);
  const auto stepAt = [](double m, double M) {
    return M < infinity ? peakOf((m + LobeChange::epsilon) / (M + LobeChange::epsilon)) : 0;
  };
  const Range step(stepAt(measured.low, model.high), stepAt(measured.high, model.low));
  ratios.luminances.resize(parts_.size());
  Range centre(infinity, -infinity), total = 0;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    if (!parts_[k].isHighlight) continue;
    centre = hull(centre, centreOver(box, parts_[k].width));
    total += luminanceOf(ratios.parts[k]);
    Range other = 0;
    for (std::size_t j = 0; j < parts_.size(); ++j)
      if (j != k && parts_[j].isHighlight) other += luminanceOf(ratios.parts[j]);
    ratios.luminances[k] = shareOf(luminanceOf(ratios.parts[k]), other);
  }
  constexpr double darkest = 1e-30;
  if (step.high == 0 || !(total.high > darkest)) return;
  ratios.step = {total.low > darkest ? step.low * centre.low : 0, step.high * centre.high};
}

/// g_k = (1 + r + r^2 + r^3 + r^4) y^4 / (y^5 + others), which with y rises to a maximum at y^5 = 4 others. The y_j sum
/// up to 1, so that the sum of their fifth powers is at least n^-4.
Range LobeBound::peakShare(std::size_t part, const Ratios& ratios, std::size_t channel) const {
  Range others = 0;
  int highlights = 0;
  for (std::size_t j = 0; j < parts_.size(); ++j) {
    if (!parts_[j].isHighlight) continue;
    ++highlights;
    const Range& y = ratios.luminances[j];
    if (j != part) others += Range(std::pow(y.low, 5), std::pow(y.high, 5));
  }
  const Range& r = ratios.rest[channel];
  const auto excess = [](double x) { return excessOf(Rgb(x)).x; };
  if (highlights < 2) return {excess(r.low), excess(r.high)};
  const auto share = [](double y, double other) { return y > 0 ? std::pow(y, 4) / (std::pow(y, 5) + other) : 0; };
  const Range& y = ratios.luminances[part];
  const double top = std::clamp(std::pow(4 * others.low, 0.2), y.low, y.high);
  const double most = std::min(share(top, others.low), std::pow(y.high * highlights, 4));
  return {excess(r.low) * std::min({share(y.low, others.high), share(y.high, others.high), most}),
          excess(r.high) * most};
}

/// What an edited lobe multiplies, where it is carried from.
Channels LobeBound::carried(const Lobe& lobe, const Ratios& ratios) const {
  Channels result{1, 1, 1};
  if (lobe.part == noPart) return result;
  const double kept = std::pow(std::min(1.0, lobe.warp.scale.x * lobe.warp.scale.y), 2);
  for (std::size_t c = 0; c < 3; ++c) {
    const Range &ratio = ratios.ratio[c], excess = ratio - Range(1);
    if (lobe.isDiffuse) {
      const Range& share = ratios.shares[lobe.part][c];
      result[c] = Range(1) + Range(std::pow(share.low, 4), std::pow(share.high, 4)) * excess;
      continue;
    }
    result[c] = ratio;
    if (ratios.step.high == 0) continue;
    // q + v (q - 1) rises with q, since v >= -1.
    const Range v = (peakShare(lobe.part, ratios, c) * Range(kept) - Range(1)) * ratios.step;
    result[c] = {ratio.low + (v * Range(excess.low)).low, ratio.high + (v * Range(excess.high)).high};
  }
  return result;
}

/// Where lobes are carried from.
struct LobeBound::Origin {
  LobeWarp warp;
  Ratios ratios;
  bool mayLackData;  ///< there the ratio of here is carried
};

/// The values of an edited lobe. @param origin of the lobe before this one; set to that of this one.
Channels LobeBound::edited(const Lobe& lobe, const PairBox& box, const Ratios& here, const Base& base,
                           std::optional<Origin>& origin) const {
  const bool isMoved = lobe.part != noPart && !lobe.isDiffuse && !lobe.warp.isIdentity();
  if (isMoved && !(origin && origin->warp == lobe.warp)) {
    const PairBox there = warped(lobe.warp, box);
    const Channels measured = base(there);
    origin = {lobe.warp, ratiosOver(there, measured),
              std::ranges::all_of(measured, [](const Range& value) { return value.contains(0); })};
  }
  Channels ratio = carried(lobe, isMoved ? origin->ratios : here);
  if (isMoved && origin->mayLackData) {
    const Channels ofHere = carried(lobe, here);
    for (std::size_t c = 0; c < 3; ++c) ratio[c] = hull(ratio[c], ofHere[c]);
  }
  if (lobe.isRecoloured) {
    // A mean of the channel's ratio and of those of all channels.
    const Range all = hull(hull(ratio[0], ratio[1]), ratio[2]);
    ratio = {all, all, all};
  }
  Channels result = channels(lobe.edited->over(box));
  const RgbRange light = lobe.isScaled ? scale_.over(box.cosI) : RgbRange{Rgb(1), Rgb(1)};
  const RgbRange viewer = lobe.isScaled ? scale_.over(box.cosO) : RgbRange{Rgb(1), Rgb(1)};
  for (std::size_t c = 0; c < 3; ++c)
    result[c] = max(result[c], 0) * channels(light)[c] * channels(viewer)[c] * ratio[c];
  return result;
}

/// value - strength times the fitted lobes that change. Those multiply m^ = q M, which is between min(m, M) and m and,
/// where the fit is bright, close to m: m - m^ <= (m - M) eps^2 / (M^2 + eps^2). Without keepsAlbedo it is m + eps.
Range LobeBound::unchanged(std::size_t channel, const Ratios& here, const Range& value, double strength) const {
  const Range& model = here.model[channel];
  const auto leftOf = [](double M) { return M < 1e150 ? epsilon2 / (M * M + epsilon2) : 0; };
  const double above = std::max(0.0, value.high - model.low);
  const Range product =
      keepsAlbedo_ ? Range(std::min(value.low, model.low), value.high) : value + Range(LobeChange::epsilon);
  const Range difference = keepsAlbedo_ ? Range(std::min(0.0, value.low - model.high), above) : value - model;
  Range removed = 0, highlights = 0;
  double correlated = 0;  // of what may be removed less than the share of the value
  for (const Lobe& lobe : lobes_) {
    if (lobe.part == noPart) continue;
    const Range &fraction = here.shares[lobe.part][channel], &share = here.weights[lobe.part][channel];
    if (lobe.isDiffuse) {
      // M_k + (M_k / M)^4 M_k (q - 1)
      const Range fourth(std::pow(fraction.low, 4), std::pow(fraction.high, 4));
      const Range part = here.parts[lobe.part][channel] + fourth * share * difference;
      removed += part;
      correlated -= part.low;
      continue;
    }
    Range v = 0;
    if (here.step.high > 0) v = (peakShare(lobe.part, here, channel) - Range(1)) * here.step;
    removed += share * product + share * v * difference;
    highlights += share;
    correlated -= (share * v * difference).low;
  }
  const Range s(strength);
  Range result = value - s * removed;
  const double part = std::min(1.0, highlights.low), most = std::min(1.0, highlights.high);
  const double slack = keepsAlbedo_ ? above * leftOf(model.low) : 0;
  const double offset = keepsAlbedo_ ? 0 : LobeChange::epsilon * highlights.low;
  const double high =
      value.high * (1 - strength * (value.high >= 0 ? part : most)) + strength * (most * slack - offset + correlated);
  if (high < result.high) result.high = high;
  return {std::min(result.low, result.high), result.high};
}

Channels LobeBound::over(const PairBox& box, const Channels& values, double strength, const Base& base) const {
  const Ratios here = ratiosOver(box, values);
  Channels result;
  for (std::size_t c = 0; c < 3; ++c) result[c] = unchanged(c, here, values[c], strength);
  std::optional<Origin> origin;
  for (const Lobe& lobe : lobes_) {
    const Channels added = edited(lobe, box, here, base, origin);
    for (std::size_t c = 0; c < 3; ++c) result[c] += Range(strength) * added[c];
  }
  return result;
}

}  // namespace gonio::editing
