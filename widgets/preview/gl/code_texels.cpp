// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/code_texels.h"

#include <algorithm>

#include "core/dictionary/decode.h"

namespace gonio::widgets {

namespace {

/// The places of a channel's groups and slabs among its sorted coefficients.
struct ChannelRanges {
  std::vector<glm::vec4> groups, slabs;
  std::vector<int> thetaHAtoms;  ///< of the slabs
};

ChannelRanges appendSorted(const dictionary::ChannelCode& channel, const dictionary::Sizes& sizes,
                           std::vector<glm::vec2>& all) {
  auto sorted = channel.coefficients;
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.index < b.index; });
  ChannelRanges ranges;
  int lastPair = -1;
  for (const auto& c : sorted) {
    const int pair = int(c.index) / sizes[0], thetaH = pair / sizes[1];
    if (ranges.thetaHAtoms.empty() || ranges.thetaHAtoms.back() != thetaH) {
      ranges.slabs.emplace_back(ranges.groups.size(), 0, 0, 0);
      ranges.thetaHAtoms.push_back(thetaH);
    }
    if (pair != lastPair) ranges.groups.emplace_back(pair % sizes[1], all.size(), 0, 0);
    lastPair = pair;
    all.emplace_back(int(c.index) % sizes[0], c.value);
    ranges.groups.back().z = float(all.size());
    ranges.slabs.back().y = float(ranges.groups.size());
  }
  return ranges;
}

void setThetaHAtoms(CodeTexels& texels, int channel, const Eigen::MatrixXd& atoms, const std::vector<int>& used) {
  constexpr int layers = CodeTexels::layersAtOnce;
  for (int node = 0; node < int(atoms.rows()); ++node) {
    const int row = (channel * texels.blocks() + node / layers) * 2 + node % layers / 4;
    glm::vec4* const line = texels.thetaHAtoms.data() + std::ptrdiff_t(row) * texels.slabs;
    for (std::size_t slab = 0; slab < used.size(); ++slab) line[slab][node % 4] = float(atoms(node, used[slab]));
  }
}

}  // namespace

CodeTexels codeTexels(const dictionary::Ensemble& ensemble, const dictionary::SparseCode& code) {
  dictionary::checkCode(ensemble, code);
  const dictionary::Sizes sizes = dictionary::modeSizes(code.grid);
  CodeTexels texels;
  texels.grid = code.grid;
  texels.transform = code.transform;
  std::array<ChannelRanges, 3> ranges;
  for (std::size_t c = 0; c < 3; ++c) {
    texels.highest[c] = code.channels[c].highest;
    ranges[c] = appendSorted(code.channels[c], sizes, texels.coefficients);
    texels.groups = std::max({texels.groups, int(ranges[c].groups.size()), 1});
    texels.slabs = std::max({texels.slabs, int(ranges[c].slabs.size()), 1});
  }
  if (texels.coefficients.empty()) texels.coefficients.emplace_back(0);
  texels.thetaHAtoms.resize(std::size_t(3 * texels.blocks() * 2 * texels.slabs), glm::vec4(0));
  const auto geometry = dictionary::GridGeometry::of(code.grid);
  for (std::size_t c = 0; c < 3; ++c) {
    for (auto* const list : {&ranges[c].groups, &ranges[c].slabs})
      list->resize(std::size_t(list == &ranges[c].groups ? texels.groups : texels.slabs), glm::vec4(0));
    texels.groupRanges.insert(texels.groupRanges.end(), ranges[c].groups.begin(), ranges[c].groups.end());
    texels.slabRanges.insert(texels.slabRanges.end(), ranges[c].slabs.begin(), ranges[c].slabs.end());
    const auto atoms = dictionary::unscaledAtoms(ensemble.dictionaries[std::size_t(code.channels[c].dictionary)],
                                                 *geometry, code.scaled);
    for (std::size_t mode = 0; mode < 2; ++mode) {
      const Eigen::MatrixXf single = atoms[mode].cast<float>();
      texels.atoms[mode].insert(texels.atoms[mode].end(), single.data(), single.data() + single.size());
    }
    setThetaHAtoms(texels, int(c), atoms[2], ranges[c].thetaHAtoms);
  }
  return texels;
}

}  // namespace gonio::widgets
