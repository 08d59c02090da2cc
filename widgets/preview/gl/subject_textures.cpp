// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/subject_textures.h"

#include <QVector4D>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/interpolation/measured_detail.h"
#include "widgets/preview/gl/model_uniforms.h"
#include "widgets/preview/gl/shader_base.h"
#include "widgets/preview/gl/textures.h"

namespace gonio::widgets {

namespace {

void setEdits(QOpenGLShaderProgram& program, const std::vector<editing::DifferentialEdit>& edits) {
  if (edits.empty()) return;
  setModelUniform(program, "targetParameters", *edits[0].model, edits[0].edited);
  std::vector<glm::vec4> own;
  for (const editing::DifferentialEdit& edit : edits)
    for (const glm::vec4& vector : edit.model->shaderParameters(edit.fitted)) own.push_back(vector);
  program.setUniformValueArray("ownParameters", &own.front().x, int(own.size()), 4);
}

/// The curves of a blend in pairs, as FactorTexture takes them: the blended ones, then those of the materials.
std::vector<editing::FactorEdit> pairsOf(const std::vector<editing::FactorEdit::Curves>& curves) {
  std::vector<editing::FactorEdit> pairs;
  if (curves.empty()) return pairs;
  pairs.push_back({.original = curves[0], .edited = curves[0]});
  for (std::size_t i = 1; i < curves.size(); i += 2)
    pairs.push_back({.original = curves[std::min(i + 1, curves.size() - 1)], .edited = curves[i]});
  return pairs;
}

void addCurves(const PreviewBlend& blend, QStringList& definitions) {
  const std::vector<editing::FactorEdit> pairs = pairsOf(blend.curves);
  const auto evaluated = [&](std::size_t pair, int set) {
    return QString("BLEND_CURVES(%1, %2, %3, %4)")
        .arg(pair)
        .arg(set)
        .arg(FactorTexture::termsOf(pairs[pair]))
        .arg(FactorTexture::axesOf(pairs[pair]));
  };
  QStringList parts;
  for (std::size_t i = 0; i < blend.weights.size(); ++i)
    if (blend.weights[i] > 0) parts << QString("blendWeights[%1] * ").arg(i) + evaluated(1 + i / 2, int(i % 2));
  definitions << QString("FACTOR_EDITS %1").arg(pairs.size()) << "BLEND_FACTORS " + evaluated(0, 0)
              << "BLEND_FACTOR_PARTS " + parts.join(" + ");
}

void addDetail(const PreviewBlend& blend, QStringList& definitions) {
  definitions << "BLEND_DETAIL";
  if (blend.bothOrders) definitions << "BLEND_BOTH_ORDERS";
  if (!blend.curves.empty()) addCurves(blend, definitions);
}

}  // namespace

void BlendTextures::addVariant(const PreviewBlend& blend, QStringList& definitions, QStringList& preamble) {
  definitions << QString("BLEND_TABLES %1").arg(blend.mixture->tables.size());
  if (blend.preservesDetail()) addDetail(blend, definitions);
  if (const DataTransform transform = (blend.codes ? blend.codes : blend.mixture)->transform;
      blend.codes || transform != DataTransform::none)
    definitions << QString("BLEND_TRANSFORM %1").arg(int(transform));
  if (blend.own) {
    definitions << "BLEND_OWN";
    addShaderBase(*blend.own, definitions, preamble);
  }
  if (blend.edits.empty()) return;
  const models::Model& model = *blend.edits[0].model;
  definitions << "BLEND_MOVES" << QString("MODEL_PARAMETERS %1").arg(model.shaderVectors());
  addModel(model, definitions, preamble);
}

void BlendTextures::bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program, PreviewResources& resources,
                         const PreviewBlend& blend) {
  const int count = int(blend.mixture->tables.size());
  assert(firstBlendUnit + count <= endOfBlendUnits);
  if (blend.mixture != uploaded_ || !textures_) {
    gl.glActiveTexture(GL_TEXTURE0 + firstBlendUnit);
    textures_ = resources.mixture(blend.mixture, blend.codes);
    uploaded_ = blend.mixture;
  }
  std::vector<GLint> units;
  std::vector<float> periods, weights;
  for (int i = 0; i < count; ++i) {
    const TableTexture& table = *textures_->tables[std::size_t(i)];
    units.push_back(firstBlendUnit + i);
    periods.push_back(float(table.phiPeriod));
    weights.push_back(float(blend.weights[std::size_t(i)]));
    gl.glActiveTexture(GL_TEXTURE0 + GLenum(units.back()));
    gl.glBindTexture(GL_TEXTURE_3D, table.name);
  }
  if (blend.own) {
    if (blend.own != uploadedOwn_ || !own_) own_ = resources.base(blend.own);
    uploadedOwn_ = blend.own;
    own_->bind(gl, program);
    // With preserved detail the native form replaces a part of the table's value, which bounds the blend as a whole.
    if (!blend.preservesDetail()) weights[blend.ownIndex] -= float(blend.ownFraction);
    program.setUniformValue("blendOwnFraction", float(blend.ownFraction));
    program.setUniformValue("blendOwnIndex", int(blend.ownIndex));
  }
  program.setUniformValueArray("blendTables", units.data(), count);
  program.setUniformValueArray("blendPhiPeriods", periods.data(), count, 1);
  program.setUniformValueArray("blendWeights", weights.data(), count, 1);
  setEdits(program, blend.edits);
  if (blend.preservesDetail()) bindDetail(gl, program, blend);
}

void BlendTextures::bindDetail(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program,
                               const PreviewBlend& blend) {
  std::vector<float> bounds;
  for (const double weight : blend.weights) bounds.push_back(float(interpolation::boundFraction(weight)));
  program.setUniformValueArray("blendBounds", bounds.data(), int(bounds.size()), 1);
  if (blend.curves.empty()) return;
  gl.glActiveTexture(GL_TEXTURE0 + factorUnit);
  curves_.update(gl, pairsOf(blend.curves));
  curves_.setUniforms(program, factorUnit);
}

void BlendTextures::release(QOpenGLFunctions_4_1_Core* gl) {
  if (gl) curves_.release(*gl);
  textures_.reset();
  own_.reset();
  uploadedOwn_.reset();
  uploaded_.reset();
}

void SubjectTextures::addVariant(const PreviewSubject& subject, QStringList& definitions, QStringList& preamble) {
  if (const auto* edited = std::get_if<EditedMaterial>(&subject.shown)) {
    addShaderBase(*edited->base, definitions, preamble);
    EditChain::addVariant(edited->edits, definitions, preamble, factorization::pdvFactorsOf(*edited->base).get());
  } else if (const auto* alone = std::get_if<StandaloneModel>(&subject.shown)) {
    addModelAlone(*alone->model, definitions, preamble);
  } else if (const auto* blend = std::get_if<PreviewBlend>(&subject.shown)) {
    BlendTextures::addVariant(*blend, definitions, preamble);
  }
}

void SubjectTextures::bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program, PreviewResources& resources,
                           const PreviewSubject& subject, bool samplesDirections) {
  if (const auto* edited = std::get_if<EditedMaterial>(&subject.shown)) {
    bindBase(gl, program, resources, *edited);
    editChain_.bind(gl, program, edited->edits, factorUnit, edited->base);
  } else if (const auto* alone = std::get_if<StandaloneModel>(&subject.shown)) {
    setModelUniform(program, "modelParameters", *alone->model, alone->parameters);
  } else if (const auto* blend = std::get_if<PreviewBlend>(&subject.shown)) {
    blendTextures_.bind(gl, program, resources, *blend);
  }
  if (samplesDirections) bindDensity(gl, program, subject.density);
}

void SubjectTextures::release(QOpenGLFunctions_4_1_Core* gl) {
  tableTexture_.reset();
  shaderBase_.reset();
  densityTextures_.reset();
  uploadedBase_.reset();
  uploadedDensity_.reset();
  blendTextures_.release(gl);
  if (gl) editChain_.release(*gl);
}

void SubjectTextures::bindBase(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program,
                               PreviewResources& resources, const EditedMaterial& material) {
  if (formOf<TabulatedBrdf>(*material.base)) return bindTable(gl, program, resources, material);
  if (material.base != uploadedBase_ || !shaderBase_) {
    shaderBase_ = resources.base(material.base);
    uploadedBase_ = material.base;
  }
  shaderBase_->bind(gl, program);
}

void SubjectTextures::bindTable(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program,
                                PreviewResources& resources, const EditedMaterial& material) {
  gl.glActiveTexture(GL_TEXTURE0 + tableUnit);
  if (material.base != uploadedBase_ || !tableTexture_) {
    tableTexture_ = resources.table({material.base, formOf<TabulatedBrdf>(*material.base)}, material.code);
    uploadedBase_ = material.base;
  }
  gl.glActiveTexture(GL_TEXTURE0 + tableUnit);
  gl.glBindTexture(GL_TEXTURE_3D, tableTexture_->name);
  program.setUniformValue("table", tableUnit);
  program.setUniformValue("phiPeriod", float(tableTexture_->phiPeriod));
}

/// The density of the drawn directions; cosine-weighted while it is not known.
void SubjectTextures::bindDensity(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program,
                                  const std::shared_ptr<const TabulatedDensity>& density) {
  program.setUniformValue("densityCells", densityCellUnit);
  program.setUniformValue("densityRows", densityRowUnit);
  double cosineFraction = density ? TabulatedDensity::cosineFraction : 1;
  GrainDensity grain = density ? density->grain() : GrainDensity{};
  if (density && density->symmetricDensity()) {
    cosineFraction = 1 - density->symmetricDensity()->specularFraction;
    grain = {.alphaX = density->symmetricDensity()->roughness,
             .alphaY = density->symmetricDensity()->roughness,
             .fraction = 1};
  }
  program.setUniformValue("densityCosineFraction", float(cosineFraction));
  program.setUniformValue("densityGrainFraction", float((1 - cosineFraction) * grain.fraction));
  program.setUniformValue("densityGrain", QVector4D(float(grain.alphaX), float(grain.alphaY),
                                                    float(std::cos(grain.rotation)), float(std::sin(grain.rotation))));
  if (!densityTextures_) densityTextures_ = std::make_unique<TextureSet>();
  if (density && density != uploadedDensity_) {
    uploadWarp(gl, *densityTextures_, density->warp(), densityCellUnit, densityRowUnit);
    uploadedDensity_ = density;
  }
  densityTextures_->bind(gl, 0, GL_TEXTURE_3D, densityCellUnit);
  densityTextures_->bind(gl, 1, GL_TEXTURE_2D, densityRowUnit);
}

}  // namespace gonio::widgets
