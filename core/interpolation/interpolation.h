// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/brdf/data_transform.h"
#include "core/brdf/tabulated_brdf.h"
#include "core/dictionary/encode.h"
#include "core/editing/edit.h"
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
  factors,       ///< curves of projected-deviation factors; what they do not explain is lost in between
  dictionary     ///< sparse codes over an ensemble of dictionaries, so the transformed reflectances (dissertation
                 ///< 4.4.2); what the codes leave out is lost in between
};
/// In JSON and on the command line, in the order of the enumeration.
inline constexpr std::array<std::string_view, 5> interpolationSpaceNames{"linear", "parameters", "differential",
                                                                         "factors", "dictionary"};

/// One of the materials between which is interpolated.
struct InterpolationEnd {
  std::shared_ptr<const TabulatedBrdf> table;
  /// Of a material that is factors: they are taken as they are. Else the table is factorised.
  std::shared_ptr<const factorization::PdvFactors> factors = nullptr;
  /// Of a material that is a code over the ensemble. Else, and where it has another transform than the first code, the
  /// table is encoded.
  std::shared_ptr<const dictionary::SparseCode> code = nullptr;
  /// The material in its own form where `table` was sampled from it (RGL and UTIA files ..), without and with `edits`.
  /// Null: the table is the material.
  std::shared_ptr<const Brdf> base = nullptr;
  EditList edits = {};

  /// What a weight of 1 gives.
  std::shared_ptr<const Brdf> material() const { return base ? applyEdits(base, edits) : table; }
};

struct InterpolationOptions {
  const models::Model* model = nullptr;  ///< of `parameters` and `differential`; null: GGX
  fitting::FitOptions fit = {};
  /// Of `factors`, where no material is factors: tables are factorised in the first one's form, transform, terms and
  /// nodes. Without nodes of |Dp| all materials share those of the set.
  factorization::PdvOptions pdv = {};
  std::shared_ptr<const dictionary::Ensemble> ensemble = nullptr;  ///< of `dictionary`, which needs it
  dictionary::EncodeOptions encode = {.coefficients = 1024};       ///< of tables
  std::size_t codeCoefficients = 1024;  ///< per channel, of what lies in between: the largest are kept
};

/// A table of transformed values, which may be negative.
struct TransformedTable {
  HalfDifferenceGrid grid;
  std::vector<glm::vec3> values;    ///< in the order of a TabulatedBrdf's
  std::vector<std::uint8_t> valid;  ///< the same
};

/// What a preview can mix for itself, pixel by pixel, while a point is dragged between the materials: the reflectance
/// is the inverse transform of the sum over the tables of weight times value.
struct TransformedMixture {
  DataTransform transform = DataTransform::none;
  std::vector<TransformedTable> tables;  ///< one per material
};

/// Materials prepared for blending: fits and factorisations are done, so that a point that is dragged between them
/// costs what the blend costs. Immutable.
///
/// Weights are one per material, each in [0, 1], with the sum 1. A weight of 1 gives that material itself, bit for bit,
/// in its own form: in spaces that lose detail in between there is a step beside the ends. `linear` and `differential`
/// mix the materials in their own form, all others what is made of their tables.
class Interpolation {
 public:
  using Table = std::shared_ptr<const TabulatedBrdf>;
  virtual ~Interpolation() = default;

  std::size_t materials() const { return ends_.size(); }
  const std::vector<InterpolationEnd>& ends() const { return ends_; }

  /// Evaluated directly, nothing is tabulated. @throws Error for weights that are none.
  std::shared_ptr<const Brdf> brdf(std::span<const double> weights) const;
  /// The same of the materials' tables, on the grid of the first. @throws Error as brdf(); Cancelled.
  Table table(std::span<const double> weights, const TaskControl& control = {}) const;

  // What the blend is made of; nothing in spaces that have no such thing. Also where a weight is 1 these are the fitted
  // ones, which stand for the material less exactly than itself. @throws Error as brdf().

  /// The blended parameters of the model, in `parameters` and `differential`.
  std::optional<models::ParameterValues> parameters(std::span<const double> weights) const;
  /// One edit a material, in `differential`: the blend is the weighted sum of the materials so edited.
  std::vector<DifferentialEdit> moves(std::span<const double> weights) const;
  /// The blended curves, in `factors`.
  std::optional<factorization::PdvFactors> factors(std::span<const double> weights) const;
  /// The blended code, in `dictionary`. Across dictionaries some 100 ms.
  std::optional<dictionary::SparseCode> code(std::span<const double> weights) const;

  /// In `linear`, in `differential` (to be moved by moves() before they are mixed) and in `dictionary` (all that the
  /// codes hold, uncut). Some 50 ms and 18 MB per material. The reflectances are those of brdf() up to the cut to the
  /// count of coefficients, the bounds of the codes (each material's here, the blend's there) and single precision.
  virtual std::optional<TransformedMixture> mixture() const { return {}; }

 protected:
  /// @throws Error when there are none.
  explicit Interpolation(std::span<const InterpolationEnd> ends);
  const std::vector<Table>& tables() const { return tables_; }

  // No weight is 1.
  virtual std::shared_ptr<const Brdf> blendedBrdf(std::span<const double> weights) const = 0;
  /// By default the blended BRDF at the nodes of the first material's grid.
  virtual Table blendedTable(std::span<const double> weights, const TaskControl& control) const;

  // Any weights.
  virtual std::optional<models::ParameterValues> blendedParameters(std::span<const double>) const { return {}; }
  virtual std::vector<DifferentialEdit> movesTo(std::span<const double>) const { return {}; }
  virtual std::optional<factorization::PdvFactors> blendedFactors(std::span<const double>) const { return {}; }
  virtual std::optional<dictionary::SparseCode> blendedCode(std::span<const double>) const { return {}; }

 private:
  std::vector<InterpolationEnd> ends_;
  std::vector<Table> tables_;
};

/// Prepares two or more materials (one is allowed). Fits take about 1 s per material, factorisations and codes too.
/// @throws Error where materials cannot be blended in the space: factors of different transforms, no dictionary or
/// codes of another one; Cancelled.
std::shared_ptr<const Interpolation> prepareInterpolation(InterpolationSpace space,
                                                          std::span<const InterpolationEnd> ends,
                                                          const InterpolationOptions& options = {},
                                                          const TaskControl& control = {});

}  // namespace gonio::editing
