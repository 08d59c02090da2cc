// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/shader_base.h"

#include <algorithm>

#include "core/brdf/incidence_table_brdf.h"
#include "core/brdf/rgl_brdf.h"
#include "core/brdf/utia_brdf.h"
#include "core/factorization/pdv_factors.h"
#include "core/models/model.h"
#include "widgets/preview/gl/model_uniforms.h"
#include "widgets/preview/gl/textures.h"

namespace gonio::widgets {

namespace {

/// A table by angle of incidence on the graphics card, for shaders/preview/incidence_table.glsl: 16 bytes per value.
class IncidenceTextures final : public ShaderBase {
 public:
  /// Uploads the table, in a few ms.
  IncidenceTextures(QOpenGLFunctions_4_1_Core& gl, const IncidenceTableBrdf& brdf);
  void bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program) override;

  /// Whether the table fits the texture size that OpenGL 4.1 guarantees: 2,048 nodes per angle, and as many pairs of
  /// angle of incidence and azimuth of the light; and 512 MB.
  static bool fits(const IncidenceTable& table);
  /// The definitions of the shader variant.
  static QStringList definitions(const IncidenceTable& table);

 private:
  GLint counts_[4];  ///< numbers of polar angles, azimuths, angles of incidence and azimuths of the light
  TextureSet textures_;
};

/// An RGL file on the graphics card, for shaders/preview/rgl.glsl: about 1.5 MB for one of the database.
class RglTextures final : public ShaderBase {
 public:
  /// Uploads the tables, in a few ms.
  RglTextures(QOpenGLFunctions_4_1_Core& gl, std::shared_ptr<const RglBrdf::Tables> tables);
  void bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program) override;

  /// The definitions of the shader variant, without the incident direction.
  static QStringList definitions(const RglBrdf& brdf);

 private:
  std::shared_ptr<const RglBrdf::Tables> tables_;
  TextureSet warp_, others_;
};

/// A UTIA material on the graphics card, for shaders/preview/utia.glsl: 288 x 288 texels of RGBA32F, 1.3 MB.
class UtiaTexture final : public ShaderBase {
 public:
  /// Uploads the values, in about 1 ms.
  UtiaTexture(QOpenGLFunctions_4_1_Core& gl, const UtiaBrdf::Values& values);
  void bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program) override;

  /// The definitions of the shader variant, without the incident direction.
  static QStringList definitions() { return {"UTIA"}; }

 private:
  TextureSet texture_;
};

enum Texture : std::size_t { values, nodes };

IncidenceTextures::IncidenceTextures(QOpenGLFunctions_4_1_Core& gl, const IncidenceTableBrdf& brdf) {
  const IncidenceTable& table = brdf.table();
  std::vector<float> texels;
  texels.reserve(4 * table.values.size());
  for (std::size_t i = 0; i < table.values.size(); ++i) {
    const glm::vec3 value = brdf.isAboveHorizon(i) ? table.values[i] : glm::vec3(0);
    texels.insert(texels.end(), {value.x, value.y, value.z, brdf.isAboveHorizon(i) ? 1.f : 0.f});
  }
  const std::vector<double>* axes[] = {&table.polars, &table.azimuths, &table.incident, &table.rotations};
  for (int axis = 0; axis < 4; ++axis) counts_[axis] = GLint(axes[axis]->size());
  textures_.bind(gl, values, GL_TEXTURE_3D, tableUnit);
  uploadFloats(gl, 4, counts_[0], counts_[1], counts_[2] * counts_[3], texels.data());

  const int width = *std::ranges::max_element(counts_);
  std::vector<float> angles(4 * std::size_t(width));
  for (std::size_t axis = 0; axis < 4; ++axis)
    std::ranges::transform(*axes[axis], angles.begin() + std::ptrdiff_t(axis) * width,
                           [](double angle) { return float(angle); });
  textures_.bind(gl, nodes, GL_TEXTURE_2D, baseNodeUnit);
  uploadFloats(gl, 1, width, 4, angles.data());
}

void IncidenceTextures::bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program) {
  textures_.bind(gl, values, GL_TEXTURE_3D, tableUnit);
  textures_.bind(gl, nodes, GL_TEXTURE_2D, baseNodeUnit);
  program.setUniformValue("incidenceValues", tableUnit);
  program.setUniformValue("incidenceNodes", baseNodeUnit);
  gl.glUniform4iv(program.uniformLocation("incidenceCounts"), 1, counts_);
}

bool IncidenceTextures::fits(const IncidenceTable& table) {
  constexpr std::size_t most = 2048, mostValues = std::size_t(1) << 25;
  return std::max({table.polars.size(), table.azimuths.size(), table.incident.size() * table.rotations.size()}) <=
             most &&
         table.values.size() <= mostValues;
}

QStringList IncidenceTextures::definitions(const IncidenceTable& table) {
  QStringList result{"INCIDENCE_TABLE"};
  if (table.axis == IncidenceTable::Axis::mirror) result << "INCIDENCE_TABLE_MIRROR";
  if (table.symmetric) result << "INCIDENCE_TABLE_SYMMETRIC";
  if (table.rotations.size() > 1) result << "INCIDENCE_TABLE_ROTATIONS";
  return result;
}

enum Other : std::size_t { colours, distribution, area };

void uploadPlane(QOpenGLFunctions_4_1_Core& gl, const SliceStack<float>& plane) {
  uploadFloats(gl, 1, int(plane.width), int(plane.height), plane.values.data());
}

RglTextures::RglTextures(QOpenGLFunctions_4_1_Core& gl, std::shared_ptr<const RglBrdf::Tables> tables)
    : tables_(std::move(tables)) {
  const RglData& data = tables_->data;
  uploadWarp(gl, warp_, tables_->visibleNormals, tableUnit, rglRowUnit);
  const SliceStack<glm::vec3>& rgb = data.rgb;
  std::vector<float> texels;
  texels.reserve(4 * rgb.values.size());
  for (const glm::vec3& value : rgb.values) texels.insert(texels.end(), {value.x, value.y, value.z, 1});
  others_.bind(gl, colours, GL_TEXTURE_3D, rglColourUnit);
  uploadFloats(gl, 4, int(rgb.width), int(rgb.height), int(data.incident.slices()), texels.data());
  others_.bind(gl, distribution, GL_TEXTURE_2D, rglDistributionUnit);
  uploadPlane(gl, data.ndf);
  others_.bind(gl, area, GL_TEXTURE_2D, rglAreaUnit);
  uploadPlane(gl, data.sigma);
}

void RglTextures::bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program) {
  warp_.bind(gl, 0, GL_TEXTURE_3D, tableUnit);
  warp_.bind(gl, 1, GL_TEXTURE_2D, rglRowUnit);
  others_.bind(gl, colours, GL_TEXTURE_3D, rglColourUnit);
  others_.bind(gl, distribution, GL_TEXTURE_2D, rglDistributionUnit);
  others_.bind(gl, area, GL_TEXTURE_2D, rglAreaUnit);
  program.setUniformValue("rglNormals", tableUnit);
  program.setUniformValue("rglRows", rglRowUnit);
  program.setUniformValue("rglColours", rglColourUnit);
  program.setUniformValue("rglDistribution", rglDistributionUnit);
  program.setUniformValue("rglArea", rglAreaUnit);
  const std::vector<float>&thetas = tables_->data.incident.thetas(), &phis = tables_->data.incident.phis();
  program.setUniformValueArray("rglThetas", thetas.data(), int(thetas.size()), 1);
  program.setUniformValueArray("rglPhis", phis.data(), int(phis.size()), 1);
}

QStringList RglTextures::definitions(const RglBrdf& brdf) {
  const RglData& data = brdf.tables()->data;
  QStringList result{QString("RGL_THETAS %1").arg(data.incident.thetas().size()),
                     QString("RGL_PHIS %1").arg(data.incident.phis().size()),
                     QString("RGL_REDUCTION %1").arg(data.azimuthReduction)};
  if (!data.isotropic) result << "RGL_ANISOTROPIC";
  if (data.jacobian) result << "RGL_JACOBIAN";
  return result;
}

UtiaTexture::UtiaTexture(QOpenGLFunctions_4_1_Core& gl, const UtiaBrdf::Values& values) {
  constexpr int side = int(UtiaBrdf::directionCount);
  std::vector<float> texels;
  texels.reserve(4 * values.size());
  for (const glm::vec3& value : values) texels.insert(texels.end(), {value.x, value.y, value.z, 1});
  texture_.bind(gl, 0, GL_TEXTURE_2D, tableUnit);
  uploadFloats(gl, 4, side, side, texels.data());
}

void UtiaTexture::bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program) {
  texture_.bind(gl, 0, GL_TEXTURE_2D, tableUnit);
  program.setUniformValue("utiaValues", tableUnit);
}

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
