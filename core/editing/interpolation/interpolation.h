// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/factorization/pdv_factors.h"
#include "core/fitting/fit.h"
#include "core/models/model.h"

/// Materials between materials.
namespace gonio::editing {

/// What is blended.
enum class InterpolationSpace {
  linear,        ///< the reflectances
  parameters,    ///< those of a model fitted to each material; what the model does not explain is lost in between
  differential,  ///< each material is moved toward the others in parameter space by a differential edit, which keeps
                 ///< its measured detail; then the reflectances (Tongbuasirilai and Unger 2016, dissertation 4.4.1)
  factors        ///< curves of projected-deviation factors; what they do not explain is lost in between
};
/// In JSON and on the command line, in the order of the enumeration.
inline constexpr std::array<std::string_view, 4> interpolationSpaceNames{"linear", "parameters", "differential",
                                                                         "factors"};

/// One of the materials between which is interpolated.
struct InterpolationEnd {
  std::shared_ptr<const TabulatedBrdf> table;
  /// Of a material that is factors: they are taken as they are. Else the table is factorised.
  std::shared_ptr<const factorization::PdvFactors> factors = nullptr;
};

struct InterpolationOptions {
  const models::Model* model = nullptr;  ///< of `parameters` and `differential`; null: GGX
  fitting::FitOptions fit = {};
  /// Of `factors`; without nodes of |Dp| all materials share those of the set.
  factorization::PdvOptions pdv = {};
};

/// Materials prepared for blending: fits and factorisations are done, so that a point that is dragged between them
/// costs what the blend costs. Immutable.
///
/// Weights are one a material, each in [0, 1], with the sum 1. A weight of 1 gives that material itself, bit for bit:
/// in spaces that lose detail in between there is a step beside the ends.
class Interpolation {
 public:
  using Table = std::shared_ptr<const TabulatedBrdf>;
  virtual ~Interpolation() = default;

  std::size_t materials() const { return tables_.size(); }

  /// Evaluated directly, nothing is tabulated. @throws Error for weights that are none.
  std::shared_ptr<const Brdf> brdf(std::span<const double> weights) const;
  /// The same as a table on the grid of the first material. @throws Error as brdf(); Cancelled.
  Table table(std::span<const double> weights, const TaskControl& control = {}) const;
  /// The blended parameters, in spaces that have a model. @throws Error as brdf().
  std::optional<models::ParameterValues> parameters(std::span<const double> weights) const;

 protected:
  /// @throws Error when there are none.
  explicit Interpolation(std::vector<Table> tables);
  const std::vector<Table>& tables() const { return tables_; }

  // No weight is 1 but for blendedParameters().
  virtual std::shared_ptr<const Brdf> blendedBrdf(std::span<const double> weights) const = 0;
  /// By default the blended BRDF at the nodes of the first material's grid.
  virtual Table blendedTable(std::span<const double> weights, const TaskControl& control) const;
  virtual std::optional<models::ParameterValues> blendedParameters(std::span<const double>) const { return {}; }

 private:
  std::vector<Table> tables_;
};

/// @throws Error telling the count, weight or sum that is wrong; weights that are not numbers too.
void checkWeights(std::span<const double> weights, std::size_t materials);

/// Prepares two or more materials (one is allowed). Fits about 1 s a material, factorisations too.
/// @throws Error where materials cannot be blended in the space: factors of different transforms; Cancelled.
std::shared_ptr<const Interpolation> prepareInterpolation(InterpolationSpace space,
                                                          std::span<const InterpolationEnd> ends,
                                                          const InterpolationOptions& options = {},
                                                          const TaskControl& control = {});

}  // namespace gonio::editing
