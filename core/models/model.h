// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/brdf/brdf.h"
#include "core/models/parameter_spec.h"

namespace gonio::models {

/// Chapter 4.2 of the dissertation: made to look right, derived from physics, or a series of basis functions.
enum class ModelFamily { empirical, analytic, series };

/// What a model is, for people and programs.
struct ModelSpec {
  std::string_view id;           ///< "ggx"; also the name of its shader (shaders/models/ggx.glsl)
  std::string_view name;         ///< "GGX"
  std::string_view description;  ///< one or two sentences: what it is for, where it is not reciprocal or gains energy
  std::string_view formula;
  std::string_view reference;  ///< author, title, year, equation
  std::span<const ParameterSpec> parameters;
  ModelFamily family = ModelFamily::analytic;
  /// What the model claims and the tests hold it to. Reciprocal: the value is the same when wi and wo are exchanged.
  bool reciprocal = true;
  /// The white-furnace albedo is at most 1 at every angle and for all other parameters within their soft ranges, when
  /// the linear parameters are at most 1 and add up to 1 at most (choices at their defaults).
  bool conservesEnergy = false;
  /// Whether the channels differ at equal parameters, because the formula knows their wavelengths. Such a model has no
  /// parameter that is per channel and not linear.
  bool dependsOnWavelength = false;

  /// Index of a parameter by its id, or nothing.
  std::optional<std::size_t> find(std::string_view parameterId) const;
};

/// One value a parameter, in the order of ModelSpec::parameters. A shared parameter has the same value in all three
/// channels.
struct ParameterValues {
  std::vector<Rgb> values;
  bool operator==(const ParameterValues&) const = default;
};

/// What the tangent of theta_h in the profile of a highlight scales with.
struct LobeWidth {
  double x = 0, y = 0;  ///< along the grain and across it; 0: there is no highlight to widen
  double rotation = 0;  ///< of the grain from the tangent, rad
};

/// One of the terms that a model is the sum of.
struct ModelLobe {
  std::unique_ptr<const Brdf> brdf;
  LobeWidth width;
  std::vector<Rgb> colours;     ///< all that its chromaticity depends on: the lobe is black where they are
  std::vector<Rgb> parameters;  ///< all else that it depends on
};

/// A parametric reflectance model: a factory of BRDFs. Immutable; the registry owns one of each.
class Model {
 public:
  /// What a model does with its parameters, which are valid: right count, finite, inside the hard ranges.
  struct Functions {
    std::unique_ptr<const Brdf> (*create)(const ParameterValues&);
    /// For instantiateUnclamped(); null where nothing is cut.
    std::unique_ptr<const Brdf> (*createUnclamped)(const ParameterValues&) = nullptr;
    /// For Model::shaderParameters(); null for the values as they are.
    std::vector<glm::vec3> (*shaderParameters)(const ParameterValues&) = nullptr;
    /// For Model::lobes(); null for models that are no sum of lobes.
    std::vector<ModelLobe> (*lobes)(const ParameterValues&) = nullptr;
    /// For Model::canonical(); null where parameters have one order.
    ParameterValues (*canonical)(const ParameterValues&) = nullptr;
  };
  /// @param spec outlives the model.
  Model(const ModelSpec& spec, const Functions& functions) : spec_(spec), functions_(functions) {}
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  const ModelSpec& spec() const { return spec_; }

  /// The BRDF at these parameters, with everything that does not depend on directions computed beforehand.
  /// Values outside the hard range are clamped to it (see clampToHardRange() for the report).
  /// @throws Error when the count of values is wrong or one is not finite; the text names the parameter.
  std::unique_ptr<const Brdf> instantiate(const ParameterValues& parameters) const;

  /// As instantiate(), without the cut at 0 of models whose linear parameters may be negative: linear in them, and its
  /// values may be negative. For fits.
  std::unique_ptr<const Brdf> instantiateUnclamped(const ParameterValues& parameters) const;

  /// What the model's shader twin (shaders/models/ID.glsl) takes as its array `p`: the parameters themselves, clamped,
  /// except where float cannot hold a parameter or something that does not depend on directions is computed
  /// beforehand. The count of entries is the same for all parameters.
  /// @throws Error as instantiate().
  std::vector<glm::vec3> shaderParameters(const ParameterValues& parameters) const;
  /// How many components each entry of shaderParameters() has: 3, or 1 where they are always equal.
  std::vector<int> shaderComponents() const;

  /// Whether it is a sum of a body and lobes about the half vector, each with its widths.
  bool hasLobes() const { return functions_.lobes != nullptr; }
  /// The terms of the sum, the same number for all parameters: their values add up to instantiate()'s. In the shader
  /// they are lobes_ID() (shaders/models). Only of a model that hasLobes(). @throws Error as instantiate().
  std::vector<ModelLobe> lobes(const ParameterValues& parameters) const;

  /// Parameters of the same values in the order that people expect: lobes from wide to sharp.
  ParameterValues canonical(const ParameterValues& parameters) const;

 private:
  const ModelSpec& spec_;
  Functions functions_;
};

/// The defaults of the specs.
ParameterValues defaultParameters(const ModelSpec& spec);

/// One clamped value, for a report to the user.
struct ClampedParameter {
  std::string_view id;
  int channel;
  double given, used;
};
/// Clamps to the hard ranges in place; returns what was changed.
/// @throws Error as Model::instantiate.
std::vector<ClampedParameter> clampToHardRange(const ModelSpec& spec, ParameterValues& parameters);

/// All models, in the order in which lists show them. Immutable, built once.
std::span<const Model* const> allModels();
/// By ModelSpec::id.
/// @throws Error that lists the known ids.
const Model& findModel(std::string_view id);

}  // namespace gonio::models
