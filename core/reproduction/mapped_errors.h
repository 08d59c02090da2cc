// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "core/dictionary/principal_components.h"
#include "core/support/task_control.h"

namespace gonio::reproduction {

/// Test materials in the mapped values of eq. 5.7 (logRelative()) over the cells of a basis. The errors of many
/// reconstructions of them are computed without decoding tables.
class MappedMaterials {
 public:
  /// @param tables on the grid of the basis, which must outlive this object. Memory: 12 bytes per material and cell.
  /// Cost: O(cells materials) logarithms.
  MappedMaterials(const dictionary::PrincipalComponents& basis,
                  std::span<const std::shared_ptr<const TabulatedBrdf>> tables);

  /// 1 / MSE over the cells and channels of each material, against the table that its code decodes to: mapped values
  /// of negative BRDF values count as that of 0. @param codes one for each material, with the same number of
  /// coefficients. Cost: O(cells components materials), in parallel; deterministic. @throws Cancelled.
  std::vector<double> inverseErrors(std::span<const dictionary::ComponentCode> codes, const TaskControl& control) const;

 private:
  const dictionary::PrincipalComponents& basis_;
  Eigen::MatrixXf values_;  ///< mapped values: cells x (3 materials)
};

}  // namespace gonio::reproduction
