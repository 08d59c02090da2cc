// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/shader_base.h"

#include "core/factorization/pdv_factors.h"
#include "core/models/model_brdf.h"
#include "widgets/preview/gl/incidence_textures.h"
#include "widgets/preview/gl/model_uniforms.h"
#include "widgets/preview/gl/rgl_textures.h"
#include "widgets/preview/gl/utia_texture.h"

namespace gonio::widgets {

namespace {

const UtiaBrdf* asUtia(const Brdf& base) { return dynamic_cast<const UtiaBrdf*>(&base); }

const IncidenceTableBrdf* asIncidenceTable(const Brdf& base) {
  const auto* brdf = dynamic_cast<const IncidenceTableBrdf*>(&base);
  return brdf && IncidenceTextures::fits(brdf->table()) ? brdf : nullptr;
}

const models::ModelBrdf* asModel(const Brdf& base) { return dynamic_cast<const models::ModelBrdf*>(&base); }

/// A model has no textures.
class ModelBase final : public ShaderBase {
 public:
  explicit ModelBase(const models::ModelBrdf& brdf) : model_(brdf.model()), parameters_(brdf.parameters()) {}
  void bind(QOpenGLFunctions_4_1_Core&, QOpenGLShaderProgram& program) override {
    setModelUniform(program, "modelParameters", model_, parameters_);
  }

 private:
  const models::Model& model_;
  models::ParameterValues parameters_;
};

/// EditChain binds the curves, together with those of edits.
class FactorBase final : public ShaderBase {
 public:
  void bind(QOpenGLFunctions_4_1_Core&, QOpenGLShaderProgram&) override {}
};

}  // namespace

bool isShownNatively(const Brdf& base) {
  return base.asTable() || base.asRgl() || asUtia(base) || asIncidenceTable(base) || asModel(base) ||
         factorization::pdvFactorsOf(base);
}

bool fitsBesideBlends(const Brdf& base) { return base.asRgl() || asUtia(base); }

void addShaderBase(const Brdf& base, QStringList& definitions, QStringList& preamble) {
  if (const RglBrdf* rgl = base.asRgl())
    definitions << RglTextures::definitions(*rgl);
  else if (asUtia(base))
    definitions << UtiaTexture::definitions();
  else if (const IncidenceTableBrdf* table = asIncidenceTable(base))
    definitions << IncidenceTextures::definitions(table->table());
  else if (const models::ModelBrdf* model = asModel(base))
    addModelAlone(model->model(), definitions, preamble);
  definitions << incidentDefinitions(base);
}

std::shared_ptr<ShaderBase> uploadShaderBase(QOpenGLFunctions_4_1_Core& gl, const Brdf& base) {
  if (const RglBrdf* rgl = base.asRgl()) return std::make_shared<RglTextures>(gl, rgl->tables());
  if (const UtiaBrdf* utia = asUtia(base)) return std::make_shared<UtiaTexture>(gl, *utia->values());
  if (const IncidenceTableBrdf* table = asIncidenceTable(base)) return std::make_shared<IncidenceTextures>(gl, *table);
  if (const models::ModelBrdf* model = asModel(base)) return std::make_shared<ModelBase>(*model);
  if (factorization::pdvFactorsOf(base)) return std::make_shared<FactorBase>();
  return nullptr;
}

std::shared_ptr<const void> uploadedData(const std::shared_ptr<const Brdf>& base) {
  if (const RglBrdf* rgl = base->asRgl()) return rgl->tables();
  if (const UtiaBrdf* utia = asUtia(*base)) return utia->values();
  return base;
}

QStringList incidentDefinitions(const Brdf& base) {
  QStringList result;
  const std::optional<IncidentDirection> incident = incidentDirectionOf(base);
  if (incident && *incident != IncidentDirection::light) result << "INCIDENT_VIEWER";
  if (incident && *incident != IncidentDirection::viewer) result << "INCIDENT_LIGHT";
  return result;
}

}  // namespace gonio::widgets
