// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/shader_base.h"

#include "core/factorization/pdv_factors.h"
#include "core/models/model.h"
#include "widgets/preview/gl/measured_textures.h"
#include "widgets/preview/gl/model_uniforms.h"

namespace gonio::widgets {

namespace {

const IncidenceTableBrdf* asIncidenceTable(const Brdf& base) {
  const auto* brdf = formOf<IncidenceTableBrdf>(base);
  return brdf && IncidenceTextures::fits(brdf->table()) ? brdf : nullptr;
}

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
  return formOf<TabulatedBrdf>(base) || formOf<RglBrdf>(base) || formOf<UtiaBrdf>(base) || asIncidenceTable(base) ||
         formOf<models::ModelBrdf>(base) || factorization::pdvFactorsOf(base);
}

bool fitsBesideBlends(const Brdf& base) { return formOf<RglBrdf>(base) || formOf<UtiaBrdf>(base); }

void addShaderBase(const Brdf& base, QStringList& definitions, QStringList& preamble) {
  if (const RglBrdf* rgl = formOf<RglBrdf>(base))
    definitions << RglTextures::definitions(*rgl);
  else if (formOf<UtiaBrdf>(base))
    definitions << UtiaTexture::definitions();
  else if (const IncidenceTableBrdf* table = asIncidenceTable(base))
    definitions << IncidenceTextures::definitions(table->table());
  else if (const models::ModelBrdf* model = formOf<models::ModelBrdf>(base))
    addModelAlone(model->model(), definitions, preamble);
  definitions << incidentDefinitions(base);
}

std::shared_ptr<ShaderBase> uploadShaderBase(QOpenGLFunctions_4_1_Core& gl, const Brdf& base) {
  if (const RglBrdf* rgl = formOf<RglBrdf>(base)) return std::make_shared<RglTextures>(gl, rgl->tables());
  if (const UtiaBrdf* utia = formOf<UtiaBrdf>(base)) return std::make_shared<UtiaTexture>(gl, *utia->values());
  if (const IncidenceTableBrdf* table = asIncidenceTable(base)) return std::make_shared<IncidenceTextures>(gl, *table);
  if (const models::ModelBrdf* model = formOf<models::ModelBrdf>(base)) return std::make_shared<ModelBase>(*model);
  if (factorization::pdvFactorsOf(base)) return std::make_shared<FactorBase>();
  return nullptr;
}

std::shared_ptr<const void> uploadedData(const std::shared_ptr<const Brdf>& base) {
  if (const RglBrdf* rgl = formOf<RglBrdf>(*base)) return rgl->tables();
  if (const UtiaBrdf* utia = formOf<UtiaBrdf>(*base)) return utia->values();
  return base;
}

QStringList incidentDefinitions(const Brdf& base) {
  QStringList result;
  const std::optional<IncidentDirection> incident = base.incidentDirection();
  if (incident && *incident != IncidentDirection::light) result << "INCIDENT_VIEWER";
  if (incident && *incident != IncidentDirection::viewer) result << "INCIDENT_LIGHT";
  return result;
}

}  // namespace gonio::widgets
