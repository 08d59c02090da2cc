// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>

#include "core/dictionary/principal_components.h"

/// Principal components of the diffuse and of the specular part of materials, after Sun, Jensen and Ramamoorthi 2018,
/// "Connecting Measured BRDFs to Analytic BRDFs by Data-Driven Diffuse-Specular Separation".
namespace gonio::dictionary {

/// A table as a sum, cell by cell. Both parts have its grid and its invalid cells.
struct SeparatedTable {
  std::shared_ptr<const TabulatedBrdf> diffuse, specular;
};

/// Separates a table. The diffuse part of a channel is a function d(theta_d), at most the value of each cell; the rest
/// is specular. d is the lower decile of the values at this theta_d, by solid angle, over cells with polar angles of at
/// most 75 degrees; beyond a theta_d of 60 degrees, where all such cells are close to the highlight, it is constant.
/// The decile ignores noise, and dark values at grazing angles. This separation is our own: that of the paper was not
/// available. About 0.2 s for a MERL table.
/// @throws Cancelled.
SeparatedTable separateDiffuse(const TabulatedBrdf& table, const TaskControl& control = {});

struct SeparatedComponents {
  PrincipalComponents diffuse, specular;

  /// Number of diffuse components of a code with `components` components in total: a quarter, rounded down, but at
  /// least 1 and at most diffuse.count().
  int diffuseCount(int components) const { return std::min(std::max(1, components / 4), diffuse.count()); }
  int specularCount(int components) const { return components - diffuseCount(components); }
  /// Largest number of components of a code.
  int count() const;
};

/// Learns both bases; calls `load` twice for each material. See learnPrincipalComponents().
SeparatedComponents learnSeparatedComponents(
    std::size_t materials, const std::function<std::shared_ptr<const TabulatedBrdf>(std::size_t material)>& load,
    const PcaOptions& options = {}, const TaskControl& control = {});

struct SeparatedCode {
  ComponentCode diffuse, specular;

  SeparatedCode inHalfPrecision() const { return {diffuse.inHalfPrecision(), specular.inHalfPrecision()}; }
  std::size_t halfBytes() const {
    return ComponentCode::halfBytes(diffuse.components()) + ComponentCode::halfBytes(specular.components());
  }
};

/// Separates a table and projects both parts. @param components in all, per channel. @throws Error if the grids differ;
/// Cancelled.
SeparatedCode encode(const SeparatedComponents& basis, const TabulatedBrdf& table, int components,
                     const TaskControl& control = {});

/// The sum of both decoded parts. Cells that a part does not cover are invalid. @throws as decode() of one basis.
std::shared_ptr<const TabulatedBrdf> decode(const SeparatedComponents& basis, const SeparatedCode& code,
                                            const TaskControl& control = {});

}  // namespace gonio::dictionary
