// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/rgl_parameterisation.h"

#include <algorithm>

#include "core/export/angle_placement.h"
#include "core/math/parallel.h"
#include "core/rendering/rendered_comparison.h"

namespace gonio::exports {

namespace {

constexpr double densityFloor = 0.02;
/// After three sizes of the ladder in a row, which have more angles and more nodes, something else limits the SNR.
constexpr int maxWithoutGain = 3;
constexpr double leastGain = 0.1;  // dB

/// From small to large, then of one size with ever more nodes. What a mirror-like material lacks is angles, what a
/// highlight over a body lacks is nodes.
constexpr RglSize ladder[] = {{8, 32}, {16, 32}, {32, 32}, {32, 48}, {64, 48}, {60, 64}, {32, 88}, {20, 112}};

/// The smallest files first, none above the limit; where all are, the first with as many angles as it has room for.
std::vector<RglSize> candidates(const RglLayout& layout, const RglOptions& options) {
  if (options.fixed) return {*options.fixed};
  std::vector<RglSize> result;
  for (const RglSize& size : ladder)
    if (rglBytes(layout, size) <= options.maxBytes) result.push_back(size);
  if (!result.empty()) return result;
  RglSize least{4, 16};
  while (rglBytes(layout, {least.thetaCount + 1, least.size}) <= options.maxBytes) ++least.thetaCount;
  return {least};
}

RglParameterisation sampled(const Brdf& material, const RglLayout& layout, std::span<const double> angles,
                            std::size_t size, const TaskControl& control) {
  std::vector<double> thetas(angles.begin(), angles.end());
  std::ranges::sort(thetas);
  std::vector<RglSlice> slices(thetas.size());
  parallelForBlocks(
      thetas.size(), 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) slices[i] = sampleSlice(material, layout, thetas[i], size);
      },
      control);
  RglParameterisation result;
  result.size = {thetas.size(), size};
  std::vector<const RglSlice*> pointers;
  for (const RglSlice& slice : slices) {
    result.clipped += slice.clipped;
    pointers.push_back(&slice);
  }
  result.data = assemble(layout, pointers);
  return result;
}

}  // namespace

std::uint64_t rglBytes(const RglLayout& layout, const RglSize& size) {
  constexpr std::uint64_t planes = 4;  // rgb and luminance
  const std::uint64_t slice = layout.vndfRows * layout.density.ndf.width + planes * size.size * size.size;
  return sizeof(float) * (layout.phis.size() * size.thetaCount * slice + 2 * layout.density.ndf.values.size());
}

RglParameterisation parameterise(const Brdf& material, const RglOptions& options, const TaskControl& control) {
  RglLayout layout = rglLayout(material, options.azimuths, densityFloor);
  layout.mirrorSymmetric = !options.bothSides;
  const std::vector<RglSize> sizes = candidates(layout, options);
  const std::size_t maxAngles = std::ranges::max(sizes, {}, &RglSize::thetaCount).thetaCount;
  const std::vector<double> angles = placeAngles(material, layout, maxAngles, control.between(0, 0.3));

  RenderOptions pictures;
  pictures.width = pictures.height = options.pictureSize;
  pictures.samples = options.samples;
  const RenderedComparison comparison(material, pictures, control.between(0.3, 0.4));
  std::optional<RglParameterisation> best;
  int sizesWithoutGain = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const TaskControl part =
        control.between(0.4 + 0.6 * double(i) / double(sizes.size()), 0.4 + 0.6 * double(i + 1) / double(sizes.size()));
    RglParameterisation next =
        sampled(material, layout, std::span(angles).first(sizes[i].thetaCount), sizes[i].size, part.between(0, 0.5));
    next.snr = comparison.signalToNoiseRatio(comparison.render(RglBrdf(next.data), part.between(0.5, 1)));
    sizesWithoutGain = best && next.snr < best->snr + leastGain ? sizesWithoutGain + 1 : 0;
    if (!best || next.snr > best->snr) best = std::move(next);
    if (best->snr >= options.snr || sizesWithoutGain == maxWithoutGain) break;
  }
  return std::move(*best);
}

}  // namespace gonio::exports
