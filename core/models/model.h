// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

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
  std::string_view id;           ///< e.g. "ggx"; also the name of its shader (shaders/models/ggx.glsl)
  std::string_view name;         ///< for display, e.g. "GGX"
  std::string_view description;  ///< one or two sentences: purpose, and whether it is not reciprocal or gains energy
  std::string_view formula;
  std::string_view reference;  ///< author, title, year, equation
  std::span<const ParameterSpec> parameters;
  ModelFamily family = ModelFamily::analytic;
  /// Whether exchanging wi and wo leaves the value unchanged; tested.
  bool reciprocal = true;
  /// Whether the directional albedo is at most 1 at every angle, if the linear parameters are at most 1 and have a sum
  /// of at most 1, for all other parameters in their soft ranges and choices at their defaults; tested.
  bool conservesEnergy = false;
  /// Whether channels differ for equal parameters, because the formula uses their wavelengths. Per-channel parameters
  /// of such models must be linear.
  bool dependsOnWavelength = false;

  /// Index of the parameter with an id, if any.
  std::optional<std::size_t> find(std::string_view parameterId) const;
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

/// A parametric BRDF model, which creates BRDFs. Immutable; the registry owns one instance per model.
class Model {
 public:
  /// The functions of a model. Their parameters are valid: right number, finite, in the hard ranges.
  struct Functions {
    std::unique_ptr<const Brdf> (*create)(const ParameterValues&);
    /// For instantiateUnclamped(); null if the model does not clamp.
    std::unique_ptr<const Brdf> (*createUnclamped)(const ParameterValues&) = nullptr;
    /// For Model::shaderParameters(); null: the values themselves.
    std::vector<glm::vec3> (*shaderParameters)(const ParameterValues&) = nullptr;
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

  /// The array `p` of the model's GLSL implementation (shaders/models/ID.glsl): the clamped parameters, or precomputed
  /// values where float is not sufficient or work can be saved. The number of entries does not depend on the values.
  /// @throws Error as instantiate().
  std::vector<glm::vec3> shaderParameters(const ParameterValues& parameters) const;
  /// Number of independent components of each entry of shaderParameters(): 3, or 1 if all three are always equal. O(1).
  std::span<const int> shaderComponents() const { return shaderComponents_; }

  /// Whether the model is a sum of lobes: the diffuse term, highlights about the half vector, each with a width, and in
  /// some models further lobes without one.
  bool hasLobes() const { return functions_.lobes != nullptr; }
  /// The lobes, of which the sum is instantiate(); their number does not depend on the values. In GLSL they are
  /// lobes_ID() (shaders/models). Precondition: hasLobes(). @throws Error as instantiate().
  std::vector<ModelLobe> lobes(const ParameterValues& parameters) const;

  /// Equivalent parameters of the same BRDF in canonical form, such as lobes by decreasing width.
  ParameterValues canonical(const ParameterValues& parameters) const;

 private:
  const ModelSpec& spec_;
  Functions functions_;
  std::vector<int> shaderComponents_;
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

/// All models, in the order of display.
std::span<const Model* const> allModels();
/// The ids of the models that are sums of lobes, separated by commas, for messages.
std::string modelsWithLobes();
/// The model with a ModelSpec::id. @throws Error that lists the known ids.
const Model& findModel(std::string_view id);

}  // namespace gonio::models
