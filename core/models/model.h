// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/brdf/brdf.h"
#include "core/models/parameter_spec.h"

namespace gonio::models {

/// Classes of models after Tongbuasirilai 2023, "Data-Driven Approaches for Sparse Reflectance Modeling and
/// Acquisition", section 4.2: designed for appearance, derived from physics, or a series of basis functions.
enum class ModelFamily { empirical, analytic, series };

/// The description of a model.
struct ModelSpec {
  std::string_view id;           ///< e.g. "ggx"
  std::string_view name;         ///< for display, e.g. "GGX"
  std::string_view description;  ///< one or two sentences: purpose, and whether it is not reciprocal or gains energy
  std::string_view formula;
  std::string_view reference;  ///< author, title, year, equation
  std::span<const ParameterSpec> parameters;
  /// Name of the file of its formula, if several models share one: core/models/FILE.glsl. Empty: shaderName().
  std::string_view file = {};
  ModelFamily family = ModelFamily::analytic;
  /// Whether exchanging wi and wo leaves the value unchanged; tested.
  bool reciprocal = true;
  /// Whether the directional albedo is at most 1 at every angle, if the linear parameters are at most 1 and have a sum
  /// of at most 1, for all other parameters in their soft ranges and choices at their defaults; tested.
  bool conservesEnergy = false;
  /// Whether channels differ for equal parameters, because the formula uses their wavelengths. Per-channel parameters
  /// of such models must be linear.
  bool dependsOnWavelength = false;
  /// How far the formula in GLSL, in single precision, may be from that in double precision, for parameters in their
  /// soft ranges; tested.
  struct FloatError {
    double relative = 2e-5, absolute = 1e-7;
  } floatError = {};
  /// Bound of the error of a fit to a constant BRDF, by the log metric; 0 for models with a term k_d / pi; tested.
  double constantError = 0;

  /// Index of the parameter with an id, if any.
  std::optional<std::size_t> find(std::string_view parameterId) const;
  /// The id as a word of GLSL, e.g. "ggx_anisotropic": its formula is formula_ggx_anisotropic().
  std::string shaderName() const;
  /// The file of its formula, e.g. "core/models/ggx.glsl".
  std::string formulaFile() const;
};

/// One value per parameter, in the order of ModelSpec::parameters. Shared parameters have the same value in all three
/// channels.
struct ParameterValues {
  std::vector<Rgb> values;
  bool operator==(const ParameterValues&) const = default;
};

/// Width of a highlight: its profile over tan theta_h scales with it.
struct LobeWidth {
  double x = 0, y = 0;  ///< along and across the grain; 0: the lobe has no width
  double rotation = 0;  ///< of the grain from the tangent, rad
};

/// One term of a model that is a sum of lobes.
struct ModelLobe {
  std::unique_ptr<const Brdf> brdf;
  LobeWidth width;
  std::vector<Rgb> colours;     ///< parameters that determine its chromaticity; the lobe is black if they are 0
  std::vector<Rgb> parameters;  ///< all other parameters on which it depends
};

class ShaderArguments;

/// A parametric BRDF model, which creates BRDFs. Immutable; the registry owns one instance per model.
class Model {
 public:
  /// The functions of a model. Their parameters are valid: right number, finite, in the hard ranges.
  struct Functions {
    std::unique_ptr<const Brdf> (*create)(const ParameterValues&);
    /// The arguments of the formula: shaderArguments<>() (core/models/shader_arguments.h).
    ShaderArguments (*arguments)(const ParameterValues&);
    /// For instantiateUnclamped(); null if the model does not clamp.
    std::unique_ptr<const Brdf> (*createUnclamped)(const ParameterValues&) = nullptr;
    /// For Model::lobes(); null for models that are not a sum of lobes.
    std::vector<ModelLobe> (*lobes)(const ParameterValues&) = nullptr;
    /// For Model::canonical(); null: the values themselves.
    ParameterValues (*canonical)(const ParameterValues&) = nullptr;
  };
  /// @param spec must outlive the model.
  Model(const ModelSpec& spec, const Functions& functions);
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  const ModelSpec& spec() const { return spec_; }

  /// The BRDF for given parameters; terms that do not depend on directions are precomputed. Values outside the hard
  /// range are clamped (clampToHardRange() reports them). @throws Error if the number of values is wrong or one is not
  /// finite; the message names the parameter.
  std::unique_ptr<const Brdf> instantiate(const ParameterValues& parameters) const;

  /// As instantiate(), but without clamping at 0, so that the BRDF is linear in the linear parameters and may be
  /// negative if they are. For fits.
  std::unique_ptr<const Brdf> instantiateUnclamped(const ParameterValues& parameters) const;

  /// The arguments of the model's formula in GLSL, packed: what does not depend on directions is computed beforehand.
  /// Their number does not depend on the values. @throws Error as instantiate().
  std::vector<glm::vec4> shaderParameters(const ParameterValues& parameters) const;
  /// The number of these vectors. O(1).
  std::size_t shaderVectors() const { return shaderVectors_; }
  /// The arguments of the formula as they are taken from these vectors, if their array is `p`. O(1).
  const std::string& shaderArguments() const { return shaderArguments_; }

  /// Whether the model is a sum of lobes: the diffuse term, highlights about the half vector, each with a width, and in
  /// some models further lobes without one.
  bool hasLobes() const { return functions_.lobes != nullptr; }
  /// The lobes, of which the sum is instantiate(); their number does not depend on the values. In GLSL the formula
  /// returns them in an array. Precondition: hasLobes(). @throws Error as instantiate().
  std::vector<ModelLobe> lobes(const ParameterValues& parameters) const;

  /// Equivalent parameters of the same BRDF in canonical form, such as lobes by decreasing width.
  ParameterValues canonical(const ParameterValues& parameters) const;

 private:
  const ModelSpec& spec_;
  Functions functions_;
  std::string shaderArguments_;
  std::size_t shaderVectors_;
};

/// The default values of all parameters.
ParameterValues defaultParameters(const ModelSpec& spec);

/// A clamped value, to report to the user.
struct ClampedParameter {
  std::string_view id;
  int channel;
  double given, used;
};
/// Clamps the parameters to the hard ranges in place; returns the changes. @throws Error as Model::instantiate().
std::vector<ClampedParameter> clampToHardRange(const ModelSpec& spec, ParameterValues& parameters);
/// For parameters that a user has entered. @throws Error with one sentence that names each value outside its hard range
/// and the limits: "roughness is 2, expected 0.0001 to 1".
void checkHardRange(const ModelSpec& spec, const ParameterValues& parameters);

/// Blends parameters of one model: weighted means; geometric means for parameters with a logarithmic scale if all
/// values are positive. Choices must be equal. @param ends parameters of the materials, one per weight. @param weights
/// >= 0, sum 1. Parameters of weight 1 are returned bitwise unchanged. @throws Error that names a choice which differs.
ParameterValues blended(const ModelSpec& spec, std::span<const ParameterValues> ends, std::span<const double> weights);

/// A BRDF of Model::instantiate() that also provides its model and parameters, for materials that are models, such as
/// published fits.
class ModelBrdf final : public Brdf {
 public:
  /// @throws Error as Model::instantiate().
  ModelBrdf(const Model& model, ParameterValues parameters);

  const Model& model() const { return model_; }
  const ParameterValues& parameters() const { return parameters_; }

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    brdf_->evaluate(pairs, values);
  }
  bool isIsotropic() const override { return brdf_->isIsotropic(); }
  bool isReciprocal() const override { return brdf_->isReciprocal(); }
  bool isMirrorSymmetric() const override { return brdf_->isMirrorSymmetric(); }
  bool hasData(const DirectionPair& pair) const override { return brdf_->hasData(pair); }
  std::shared_ptr<const ValueBound> valueBound() const override { return brdf_->valueBound(); }
  bool hasImportanceSampling() const override { return brdf_->hasImportanceSampling(); }
  double samplingCost() const override { return brdf_->samplingCost(); }
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const override { return brdf_->sample(wo, u); }
  double pdf(const Direction& wi, const Direction& wo) const override { return brdf_->pdf(wi, wo); }

 private:
  const Model& model_;
  ParameterValues parameters_;
  std::unique_ptr<const Brdf> brdf_;
};

/// All models, in the order of display.
std::span<const Model* const> allModels();
/// The ids of the models that are sums of lobes, separated by commas, for messages.
std::string modelsWithLobes();
/// The model with a ModelSpec::id. @throws Error that lists the known ids.
const Model& findModel(std::string_view id);

}  // namespace gonio::models
