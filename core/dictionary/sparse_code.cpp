// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/sparse_code.h"

namespace gonio::dictionary {

std::size_t SparseCode::coefficients() const {
  std::size_t most = 0;
  for (const ChannelCode& channel : channels) most = std::max(most, channel.coefficients.size());
  return most;
}

SparseCode SparseCode::truncated(std::size_t coefficients) const {
  SparseCode result = *this;
  for (ChannelCode& channel : result.channels)
    channel.coefficients.resize(std::min(channel.coefficients.size(), coefficients));
  return result;
}

}  // namespace gonio::dictionary
