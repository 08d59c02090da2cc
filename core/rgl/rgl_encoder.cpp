// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rgl/rgl_encoder.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/math/parallel.h"
#include "core/rgl/rgb_spectra.h"
#include "core/rgl/rgl_file.h"

namespace gonio::rgl {

namespace {

/// A picture of the source's nodes that is this close shows no error of theirs.
constexpr double exactSnr = 60;
/// Other scenes than the one that decides show other errors: files come this much closer where they can, dB.
constexpr double margin = 3;
constexpr double densityFloor = 0.02;
/// More angles and more nodes are tried in turn: what a mirror-like material lacks is angles, what a rough one with
/// noise lacks is nodes.
constexpr std::size_t angleCounts[] = {8, 16, 24, 32, 40, 48, 64, 96}, nodeCounts[] = {32, 40, 48, 64, 80, 108};
/// Steps without a gain, after which only the largest sizes are tried.
constexpr int maxWithoutGain = 2;
constexpr double leastGain = 0.1;  // dB
/// SNR that the largest files must gain over one that reaches the requested SNR without the margin.
constexpr double worthMore = 1;  // dB

/// A possible file: its values and their accuracy.
struct Candidate {
  RglSize size;
  std::shared_ptr<const RglBrdf> brdf, spectralBrdf;
  double rgbSnr = std::numeric_limits<double>::infinity(), spectralSnr = rgbSnr;
  double snr = rgbSnr;  ///< the lower one
  std::uint64_t bytes = 0;
  std::optional<EditedRgl> own;  ///< of the source's nodes
};

RglData sampled(const Brdf& material, const RglLayout& layout, std::span<const double> angles, std::size_t size,
                const TaskControl& control) {
  std::vector<double> thetas(angles.begin(), angles.end());
  std::ranges::sort(thetas);
  std::vector<RglSlice> slices(thetas.size());
  parallelForBlocks(
      thetas.size(), 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) slices[i] = sampleSlice(material, layout, thetas[i], size);
      },
      control);
  std::vector<const RglSlice*> pointers;
  pointers.reserve(slices.size());
  for (const RglSlice& slice : slices) pointers.push_back(&slice);
  return assemble(layout, pointers);
}

std::size_t negativeCount(const SliceStack<glm::vec3>& rgb) {
  std::size_t count = 0;
  for (const glm::vec3& value : rgb.values) count += (value.x < 0) + (value.y < 0) + (value.z < 0);
  return count;
}

/// The field `description`: origin, incident direction and accuracy.
std::string descriptionOf(const std::string& origin, double snr) {
  char ratio[64] = "exact (values of the source)";
  if (std::isfinite(snr)) std::snprintf(ratio, sizeof ratio, "rendered SNR %.1f dB (comparison scene)", snr);
  return origin +
         ". The incident direction (theta_i, phi_i) is that of the viewer, as in Mitsuba and pbrt. Accuracy: " + ratio +
         ".";
}

/// Size of the RGB file of a new parameterisation in bytes, without its directory.
std::uint64_t rglBytes(const RglLayout& layout, const RglSize& size) {
  constexpr std::uint64_t planes = 4;  // rgb and luminance
  const std::uint64_t slice = layout.vndfRows * layout.density.ndf.width + planes * size.size * size.size;
  return sizeof(float) * (layout.phis.size() * size.thetaCount * slice + 2 * layout.density.ndf.values.size());
}

/// With one more step of angles, and with one more of nodes, as far as the limit permits.
std::vector<RglSize> largerThan(const RglSize& size, const RglLayout& layout, std::uint64_t maxBytes) {
  std::vector<RglSize> result;
  const auto add = [&](std::span<const std::size_t> counts, std::size_t RglSize::*count) {
    const auto next = std::ranges::upper_bound(counts, size.*count);
    if (next == counts.end()) return;
    RglSize larger = size;
    larger.*count = *next;
    if (rglBytes(layout, larger) <= maxBytes) result.push_back(larger);
  };
  add(angleCounts, &RglSize::thetaCount);
  add(nodeCounts, &RglSize::size);
  return result;
}

/// For each number of angles the most nodes that the limit permits, where no larger number of angles has as many.
std::vector<RglSize> largestSizes(const RglLayout& layout, std::uint64_t maxBytes) {
  std::vector<RglSize> result;
  for (auto angles = std::rbegin(angleCounts); angles != std::rend(angleCounts); ++angles)
    for (auto nodes = std::rbegin(nodeCounts); nodes != std::rend(nodeCounts); ++nodes)
      if (const RglSize size{*angles, *nodes}; rglBytes(layout, size) <= maxBytes) {
        if (result.empty() || size.size > result.back().size) result.push_back(size);
        break;
      }
  return result;
}

/// The first size, smaller than usual where the limit is.
RglSize firstSize(const RglLayout& layout, const RglOptions& options) {
  if (options.size) return *options.size;
  if (const RglSize usual{angleCounts[0], nodeCounts[0]}; rglBytes(layout, usual) <= options.maxBytes) return usual;
  RglSize least{4, 16};
  while (rglBytes(layout, {least.thetaCount + 1, least.size}) <= options.maxBytes) ++least.thetaCount;
  return least;
}

class Encoder {
 public:
  Encoder(const Brdf& material, const RglFileSource* source, const RglOptions& options,
          const ReferencePictures& pictures)
      : material_(material), source_(source), options_(options), pictures_(pictures) {}

  EncodedRgl encode(const std::string& origin, const TaskControl& control) {
    std::optional<Candidate> best;
    if (source_ && !options_.size) {
      best = ownNodes(control.between(0, 0.2));
      if (isEnough(*best)) return written(std::move(*best), origin, control.between(0.2, 1));
    }
    Candidate made = chosen(std::move(best), control.between(0.2, 0.9));
    return written(std::move(made), origin, control.between(0.9, 1));
  }

 private:
  const RglData& sourceData() const { return source_->brdf->tables()->data; }

  /// Nothing or only colours have changed; or a new file would lose the spectra.
  bool isEnough(const Candidate& own) const {
    const bool suits = source_->onlyColoursChanged || sourceData().spectra;
    return !own.own->changed || own.snr >= std::max(suits ? 0 : exactSnr, options_.snr);
  }

  /// Sets and measures the file's BRDFs. Spectra of colours inside sRGB have exactly these colours.
  void setBrdf(Candidate& made, std::shared_ptr<const RglBrdf> brdf, const TaskControl& control) {
    const SliceStack<glm::vec3>& rgb = brdf->tables()->data.rgb;
    made.rgbSnr = made.spectralSnr = snrOf(*brdf, control.between(0, 0.5));
    made.spectralBrdf = brdf;
    if (negativeCount(rgb) > 0) {
      SliceStack<glm::vec3> seen = rgb;
      for (glm::vec3& value : seen.values)
        if (glm::any(glm::lessThan(value, glm::vec3(0)))) value = glm::vec3(spectralColour(Rgb(value)));
      made.spectralBrdf = brdf->withColours(seen, samplingLuminance(seen));
      made.spectralSnr = snrOf(*made.spectralBrdf, control.between(0.5, 1));
    }
    made.brdf = std::move(brdf);
    made.snr = std::min(made.rgbSnr, made.spectralSnr);
  }

  double snrOf(const Brdf& brdf, const TaskControl& control) {
    if (!reference_) reference_ = pictures_(control.between(0, 0.8));
    return reference_->signalToNoiseRatio(reference_->render(brdf, control.between(0.8, 1)));
  }

  Candidate ownNodes(const TaskControl& control) {
    const auto file = source_->brdf->withIncident(IncidentDirection::viewer);
    Candidate own{.own = editedColours(*file, material_, control.between(0, 0.5))};
    own.size = {sourceData().incident.thetas().size(), own.own->rgb.width};
    own.bytes = source_->bytes.size();
    if (!own.own->changed) {
      own.brdf = own.spectralBrdf = file;
      // A copy differs from the source at most in the spectra that it gets.
      if (!sourceData().spectra && negativeCount(sourceData().rgb) > 0) setBrdf(own, file, control.between(0.5, 1));
      own.rgbSnr = own.snr = std::numeric_limits<double>::infinity();
      return own;
    }
    setColours(own, std::move(own.own->rgb), control.between(0.5, 0.75));
    if (negativeCount(own.own->rgb) == 0) return own;
    // Edits that leave no negative values leave none between the nodes either.
    Candidate clipped = own;
    for (glm::vec3& value : clipped.own->rgb.values) value = glm::max(value, glm::vec3(0));
    setColours(clipped, std::move(clipped.own->rgb), control.between(0.75, 1));
    return clipped.snr > own.snr ? clipped : own;
  }

  void setColours(Candidate& own, SliceStack<glm::vec3> rgb, const TaskControl& control) {
    const auto file = source_->brdf->withIncident(IncidentDirection::viewer);
    setBrdf(own, file->withColours(rgb, samplingLuminance(rgb)), control);
    own.own->rgb = std::move(rgb);
  }

  /// Whether what was found is enough.
  bool consider(const Candidate& next) {
    const bool isSmaller = !reached_ || next.bytes < reached_->bytes;
    if (next.snr >= options_.snr + margin && (!enough_ || next.bytes < enough_->bytes)) enough_ = next;
    if (next.snr >= options_.snr && isSmaller) reached_ = next;
    if (!best_ || next.snr > best_->snr) best_ = next;
    return enough_.has_value();
  }

  /// The smallest that reaches the SNR, of new ones and the source's own nodes.
  Candidate chosen(std::optional<Candidate> own, const TaskControl& control) {
    const RglLayout layout = rglLayout(material_, options_.azimuths, densityFloor);
    const RglSize first = firstSize(layout, options_);
    const std::size_t maxAngles = options_.size ? first.thetaCount : std::ranges::max(angleCounts);
    const std::vector<double> angles = placeAngles(material_, layout, maxAngles, control.between(0, 0.3));
    const auto made = [&](const RglSize& size, double from, double to) {
      return newNodes(layout, std::span(angles).first(size.thetaCount), size.size, control.between(from, to));
    };
    Candidate current = made(first, 0.3, 0.35);
    bool done = consider(current) || options_.size;
    constexpr double steps = 12;  // usually fewer
    int step = 0;
    for (int withoutGain = 0; !done && withoutGain < maxWithoutGain; ++step) {
      const double from = std::min(0.35 + 0.65 * step / steps, 0.95), to = from + 0.04;
      std::optional<Candidate> better;
      double gainPerByte = 0;
      for (const RglSize& size : largerThan(current.size, layout, options_.maxBytes)) {
        if (own && own->bytes <= rglBytes(layout, size)) done = consider(*std::exchange(own, std::nullopt));
        if (done) break;
        Candidate next = made(size, from, to);
        done = consider(next);
        const double gain = (next.snr - current.snr) / double(next.bytes - current.bytes);
        if (!better || gain > gainPerByte) better = std::move(next), gainPerByte = gain;
      }
      if (!better) break;
      withoutGain = better->snr < current.snr + leastGain ? withoutGain + 1 : 0;
      current = std::move(*better);
    }
    if (own && !done) consider(*own);
    if (!enough_ && !options_.size)
      for (const RglSize& size : largestSizes(layout, options_.maxBytes))
        if (consider(made(size, 0.97, 1))) break;
    if (enough_) return std::move(*enough_);
    return std::move(reached_ && best_->snr < reached_->snr + worthMore ? *reached_ : *best_);
  }

  Candidate newNodes(const RglLayout& layout, std::span<const double> angles, std::size_t size,
                     const TaskControl& control) {
    RglData data = sampled(material_, layout, angles, size, control.between(0, 0.5));
    Candidate made{.size = {angles.size(), size}};
    made.bytes = rglBytes(layout, made.size);
    setBrdf(made, std::make_shared<const RglBrdf>(std::move(data)), control.between(0.5, 1));
    return made;
  }

  EncodedRgl written(Candidate made, const std::string& origin, const TaskControl& control) {
    EncodedRgl result;
    result.size = made.size;
    result.rgbSnr = made.rgbSnr;
    result.spectralSnr = made.spectralSnr;
    result.ownParameterisation = made.own.has_value();
    result.unchanged = made.own && !made.own->changed;
    result.keepsSpectra = made.own || !source_ || !sourceData().spectra;
    result.negativeValues = negativeCount(made.brdf->tables()->data.rgb);
    const RglData data = wholeData(*made.brdf->tables());
    const auto file = [&](RglColours colours) {
      const std::string description =
          descriptionOf(origin, colours == RglColours::rgb ? made.rgbSnr : made.spectralSnr);
      return made.own ? withColours(source_->bytes, *source_->brdf->tables(), *made.own, colours, description)
                      : encodeRglData(data, description, colours);
    };
    result.rgb = file(RglColours::rgb);
    result.spectral = file(RglColours::spectra);
    result.rgbBrdf = std::move(made.brdf);
    result.spectralBrdf = std::move(made.spectralBrdf);
    // The source's spectra change by SpectralEdit.
    if (made.own && made.own->changed && sourceData().spectra) {
      result.spectralBrdf = readRgl(io::MemorySource(result.spectral)).brdf;
      result.spectralSnr = snrOf(*result.spectralBrdf, control);
    }
    return result;
  }

  const Brdf& material_;
  const RglFileSource* source_;
  const RglOptions& options_;
  const ReferencePictures& pictures_;
  std::optional<rendering::RenderedComparison> reference_;  ///< of the material, rendered when it is needed
  /// The smallest candidates with the SNR and a margin, and without; the one with the highest SNR.
  std::optional<Candidate> enough_, reached_, best_;
};

}  // namespace

EncodedRgl encodeRgl(const Brdf& material, const RglFileSource* source, const std::string& origin,
                     const RglOptions& options, const ReferencePictures& pictures, const TaskControl& control) {
  return Encoder(material, source, options, pictures).encode(origin, control);
}

}  // namespace gonio::rgl
