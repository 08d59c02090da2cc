// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cmath>

#include "core/acquisition/reconstruction.h"
#include "core/brdf/data_transform.h"

/// What reconstructions are compared with, by definitions.
namespace gonio::acquisition {

using dictionary::PrincipalComponents;
using Eigen::MatrixXd;

/// Every `step`th cell of the basis that is read as itself, beginning with one.
inline SamplingPlan everyCell(const PrincipalComponents& basis, std::size_t step, std::size_t first = 3) {
  std::vector<std::uint32_t> cells;
  for (std::size_t i = first; i < basis.mapping.cells.size(); i += step)
    if (const std::uint32_t cell = basis.mapping.cells[i]; pairNode(basis.mapping.grid, cell) == cell)
      cells.push_back(cell);
  return planFor(basis.mapping.grid, cells);
}

inline std::size_t positionOf(const PrincipalComponents& basis, const PlannedSample& sample) {
  const auto& cells = basis.mapping.cells;
  const auto found = std::find(cells.begin(), cells.end(), nearestNode(basis.mapping.grid, sample.directions));
  return std::size_t(found - cells.begin());
}

/// D = U Sigma at the samples, and the mapped values, by their definitions.
inline MatrixXd rowsAt(const PrincipalComponents& basis, const SamplingPlan& plan, int components) {
  const auto u = basis.svd.u.view();
  MatrixXd rows(Eigen::Index(plan.samples.size()), components);
  for (Eigen::Index s = 0; s < rows.rows(); ++s)
    for (int k = 0; k < components; ++k)
      rows(s, k) = u(Eigen::Index(positionOf(basis, plan.samples[std::size_t(s)])), k) * basis.svd.singularValues[k];
  return rows;
}
inline MatrixXd mappedAt(const PrincipalComponents& basis, const SamplingPlan& plan, const MeasuredValues& values) {
  MatrixXd mapped(Eigen::Index(plan.samples.size()), 3);
  for (Eigen::Index s = 0; s < mapped.rows(); ++s) {
    const std::size_t i = positionOf(basis, plan.samples[std::size_t(s)]);
    for (int channel = 0; channel < 3; ++channel) {
      const double weighted = values.rgb[std::size_t(s)][channel] * basis.mapping.weights[i];
      mapped(s, channel) = std::log((weighted + 1e-3) / (basis.mapping.reference[i] + 1e-3)) - basis.mean[i];
    }
  }
  return mapped;
}

/// The variance of a cell's mapped value over the training signals in the components from `first` on.
inline double varianceFrom(const PrincipalComponents& basis, std::size_t position, int first) {
  double sum = 0;
  for (int k = first; k < basis.count(); ++k)
    sum += std::pow(basis.svd.singularValues[k] * double(basis.svd.u.view()(Eigen::Index(position), k)), 2);
  return sum / double(basis.svd.v.rows());
}

/// Q Q^T + N by its definition: the samples' covariance where coefficients have a variance of 1, those of the
/// components that are not used from cell to cell their own.
inline MatrixXd covarianceAt(const PrincipalComponents& basis, const SamplingPlan& plan, int components, double ridge) {
  const MatrixXd q = rowsAt(basis, plan, components);
  MatrixXd covariance = q * q.transpose();
  for (Eigen::Index s = 0; s < covariance.rows(); ++s)
    covariance(s, s) += ridge + double(basis.svd.v.rows()) *
                                    varianceFrom(basis, positionOf(basis, plan.samples[std::size_t(s)]), components);
  return covariance;
}

/// c of a reconstruction's code U (Sigma c).
inline MatrixXd coefficients(const PrincipalComponents& basis, const Reconstruction& found) {
  MatrixXd c(found.code.components(), 3);
  for (Eigen::Index channel = 0; channel < 3; ++channel)
    c.col(channel) =
        found.code.channels[std::size_t(channel)].cast<double>().cwiseQuotient(basis.svd.singularValues.head(c.rows()));
  return c;
}

/// The differences of two tables in mapped values: cells x channels.
inline MatrixXd differences(const PrincipalComponents& basis, const TabulatedBrdf& a, const TabulatedBrdf& b) {
  MatrixXd result(Eigen::Index(basis.mapping.cells.size()), 3);
  for (std::size_t i = 0; i < basis.mapping.cells.size(); ++i)
    for (int channel = 0; channel < 3; ++channel) {
      const auto mapped = [&](const TabulatedBrdf& table) {
        return logRelative(table.values()[basis.mapping.cells[i]][channel], basis.mapping.weights[i],
                           basis.mapping.reference[i]);
      };
      result(Eigen::Index(i), channel) = mapped(a) - mapped(b);
    }
  return result;
}
inline double difference(const PrincipalComponents& basis, const TabulatedBrdf& a, const TabulatedBrdf& b) {
  return differences(basis, a, b).cwiseAbs().maxCoeff();
}
inline double rootMeanSquareDifference(const PrincipalComponents& basis, const TabulatedBrdf& a,
                                       const TabulatedBrdf& b) {
  const MatrixXd all = differences(basis, a, b);
  return all.norm() / std::sqrt(double(all.size()));
}

}  // namespace gonio::acquisition
