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

/// Interpolation (blending) of materials.
namespace gonio::interpolation {

/// The space in which materials are blended.
enum class InterpolationSpace {
  linear,        ///< BRDF values
  parameters,    ///< parameters of a model fitted to each material
  differential,  ///< BRDF values, after a differential edit has changed the fitted parameters of each material to the
                 ///< blended ones, which preserves its measured detail (Tsirikoglou et al. 2016, "Differential
                 ///< Appearance Editing for Measured BRDFs"; Tongbuasirilai 2023, "Data-Driven Approaches for Sparse
                 ///< Reflectance Modeling and Acquisition", section 4.4.1)
  factors,       ///< curves of PDV factors
  dictionary     ///< sparse codes over an ensemble of dictionaries, i.e. transformed BRDF values (Tongbuasirilai 2023,
                 ///< section 4.4.2)
};
/// Whether a space blends a representation of the materials that misses some of their detail: `parameters`, `factors`
/// and `dictionary`. InterpolationOptions::preserveDetail acts in these.
constexpr bool losesDetail(InterpolationSpace space) {
  return space != InterpolationSpace::linear && space != InterpolationSpace::differential;
}
/// Names in JSON and on the command line, in the order of the enumeration.
inline constexpr std::array<std::string_view, 5> interpolationSpaceNames{"linear", "parameters", "differential",
                                                                         "factors", "dictionary"};

/// One of the materials to blend.
struct InterpolationMaterial {
  /// The material as a table, with `edits` applied.
  std::shared_ptr<const TabulatedBrdf> table;
  /// The factors of a material that consists of PDV factors; they are used unchanged. Null: the table is factorised.
  std::shared_ptr<const factorization::PdvFactors> factors = nullptr;
  /// The code of a material that is a code. If null, or if its ensemble, transform or cell scaling differs from that of
  /// the first code, the table is encoded.
  std::shared_ptr<const dictionary::SparseCode> code = nullptr;
  std::shared_ptr<const dictionary::Ensemble> ensemble = nullptr;  ///< of `code`; null: InterpolationOptions::ensemble
  /// The material in its native form, without `edits`, if `table` was sampled from it (such as RGL and UTIA files).
  /// Null: the material is the table.
  std::shared_ptr<const Brdf> base = nullptr;
  editing::EditList edits = {};

  /// The material that a weight of 1 gives.
  std::shared_ptr<const Brdf> material() const { return base ? editing::applyEdits(base, edits) : table; }
};

struct InterpolationOptions {
  /// In spaces that lose detail: adds the detail that the representation of each material misses, by the weight of the
  /// material (core/interpolation/measured_detail.h). The blend then begins and ends at the materials. Without it the
  /// blend is the published one, the representation alone. No effect in other spaces.
  bool preserveDetail = true;
  const models::Model* model = nullptr;  ///< for `parameters` and `differential`; null: GGX
  fitting::FitOptions fit = {};
  /// For `factors`, if no material consists of factors; otherwise tables are factorised with the form, transform, terms
  /// and nodes of the first material that does. Without nodes of |Dp|, all materials share deviationNodes() of the set.
  factorization::PdvOptions pdv = {};
  /// For `dictionary`; not used if a material is a code over an ensemble of its own (InterpolationMaterial::ensemble).
  std::shared_ptr<const dictionary::Ensemble> ensemble = nullptr;
  dictionary::EncodeOptions encode = {.coefficients = 1024};  ///< for tables
  std::size_t codeCoefficients = 1024;                        ///< per channel, of a blended code: the largest remain
};

/// A table of transformed values, which may be negative.
struct TransformedTable {
  HalfDifferenceGrid grid;
  std::vector<glm::vec3> values;    ///< in the order of TabulatedBrdf::values()
  std::vector<std::uint8_t> valid;  ///< as TabulatedBrdf::valid()
};

/// A blend that a preview's shader can evaluate per pixel while the weights change: at a node, the BRDF value is the
/// inverse transform of the sum of weight times value over the tables; between nodes, values are interpolated.
struct TransformedMixture {
  DataTransform transform = DataTransform::none;
  std::vector<TransformedTable> tables;  ///< one per material
};

/// Materials prepared for blending: fits, factorisations and codes are computed once, so that new weights only cost the
/// blend itself. Immutable.
///
/// Weights: one per material, each in [0, 1], with sum 1. A weight of 1 gives that material itself, bitwise, in its
/// native form. In spaces that lose detail the blend is discontinuous there unless it preserves the detail.
/// Representations are made from tables; mixesNativeForms() states what is blended.
class Interpolation {
 public:
  using Table = std::shared_ptr<const TabulatedBrdf>;
  virtual ~Interpolation() = default;

  std::size_t materials() const { return ends_.size(); }
  /// The materials to blend, called ends.
  const std::vector<InterpolationMaterial>& ends() const { return ends_; }
  /// InterpolationOptions::preserveDetail in a space that loses detail, else false.
  bool preservesDetail() const { return preservesDetail_; }
  /// Whether brdf() evaluates the materials in their native form at all weights: in `linear` and `differential`, and
  /// with preservesDetail(). The representation alone is made from their tables.
  virtual bool mixesNativeForms() const { return preservesDetail_; }

  /// The blend, evaluated directly without a table. @throws Error for invalid weights.
  std::shared_ptr<const Brdf> brdf(std::span<const double> weights) const;
  /// The blend of the materials' tables, on the grid of the first. @throws Error as brdf(); Cancelled.
  Table table(std::span<const double> weights, const TaskControl& control = {}) const;

  // The blend in the form of its space; empty if the space has another form. Computed from the fits, factors or codes
  // even if a weight is 1, where brdf() gives the material itself; without preserved detail. @throws Error as brdf().

  /// The blended parameters of the model, in `parameters` and `differential`.
  std::optional<models::ParameterValues> parameters(std::span<const double> weights) const;
  /// One edit per material, which changes its fitted parameters to the blended ones, in `differential` and, with
  /// preservesDetail(), in `parameters`. In `differential` the blend is the weighted sum of the edited materials; in
  /// `parameters` of the materials and the changes, clamped as a whole.
  std::vector<editing::DifferentialEdit> differentialEdits(std::span<const double> weights) const;
  /// The blended curves, in `factors`: the published ones, or with preservesDetail() those that are continuous at the
  /// materials (factorization::BlendForm).
  std::optional<factorization::PdvFactors> factors(std::span<const double> weights) const;
  /// The blended code, in `dictionary`. Takes about 100 ms if the codes use different dictionaries.
  std::optional<dictionary::SparseCode> code(std::span<const double> weights) const;

  /// The tables for a preview; null in `parameters` and `factors`. In `differential` apply differentialEdits() to the
  /// tables before mixing. In `dictionary` they contain all coefficients; with preservesDetail() brdf() uses them, too.
  /// About 50 ms and 18 MB per material. Differences from brdf() without preserved detail: no limit on the number of
  /// coefficients; transformed values are limited by the maximum of each material's code (ChannelCode::highest) instead
  /// of that of the blended code; negative BRDF values, which codes of both orders of the directions may have, become
  /// 0; single precision.
  virtual std::shared_ptr<const TransformedMixture> mixture() const { return nullptr; }

 protected:
  /// @throws Error if there are no materials.
  explicit Interpolation(std::span<const InterpolationMaterial> ends, bool preservesDetail = false);
  const std::vector<Table>& tables() const { return tables_; }

  // Without preserved detail; precondition of the first two: no weight is 1, except in spaces that lose detail.
  virtual std::shared_ptr<const Brdf> blendedBrdf(std::span<const double> weights) const = 0;
  /// Default: blendedBrdf() at the nodes of the first material's grid.
  virtual Table blendedTable(std::span<const double> weights, const TaskControl& control) const;
  /// What the space changes in the weighted sum of the representations, for preserved detail (changeOfSpace()).
  /// Default: from blendedBrdf() at these weights and at weights of 1.
  virtual std::shared_ptr<const Brdf> change(std::span<const double> weights) const;

  // For any weights.
  virtual std::optional<models::ParameterValues> blendedParameters(std::span<const double>) const { return {}; }
  virtual std::vector<editing::DifferentialEdit> blendedEdits(std::span<const double>) const { return {}; }
  virtual std::optional<factorization::PdvFactors> blendedFactors(std::span<const double>) const { return {}; }
  virtual std::optional<dictionary::SparseCode> blendedCode(std::span<const double>) const { return {}; }

 private:
  std::vector<InterpolationMaterial> ends_;
  std::vector<Table> tables_;
  bool preservesDetail_;
};

/// Prepares one or more materials. Fits, factorisations and codes take about 1 s per material. @throws Error if the
/// materials cannot be blended in the space: factors of different transforms, a missing ensemble, or codes of another
/// one; Cancelled.
std::shared_ptr<const Interpolation> prepareInterpolation(InterpolationSpace space,
                                                          std::span<const InterpolationMaterial> ends,
                                                          const InterpolationOptions& options = {},
                                                          const TaskControl& control = {});

}  // namespace gonio::interpolation
