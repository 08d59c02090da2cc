// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/subject_textures.h"

#include <QVector4D>
#include <cmath>

#include "widgets/preview/gl/model_uniforms.h"
#include "widgets/preview/gl/textures.h"

namespace gonio::widgets {

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
    editChain_.bind(gl, program, edited->edits, factorUnit, factorization::pdvFactorsOf(*edited->base));
  } else if (const auto* alone = std::get_if<StandaloneModel>(&subject.shown)) {
    setModelUniform(program, "modelParameters", *alone->model, alone->parameters);
  } else if (const auto* blend = std::get_if<PreviewBlend>(&subject.shown)) {
    blendTextures_.bind(gl, program, resources, *blend);
  }
  if (samplesDirections) bindLobe(gl, program, subject.lobe);
}

void SubjectTextures::release(QOpenGLFunctions_4_1_Core* gl) {
  tableTexture_.reset();
  shaderBase_.reset();
  lobeTextures_.reset();
  uploadedBase_.reset();
  uploadedLobe_.reset();
  blendTextures_.release();
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
void SubjectTextures::bindLobe(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program,
                               const std::shared_ptr<const TabulatedDensity>& lobe) {
  program.setUniformValue("lobeCells", lobeCellUnit);
  program.setUniformValue("lobeRows", lobeRowUnit);
  double cosineFraction = lobe ? TabulatedDensity::cosineFraction : 1;
  GrainDensity grain = lobe ? lobe->grain() : GrainDensity{};
  if (lobe && lobe->symmetricDensity()) {
    cosineFraction = 1 - lobe->symmetricDensity()->specularFraction;
    grain = {
        .alphaX = lobe->symmetricDensity()->roughness, .alphaY = lobe->symmetricDensity()->roughness, .fraction = 1};
  }
  program.setUniformValue("lobeCosineShare", float(cosineFraction));
  program.setUniformValue("lobeGrainShare", float((1 - cosineFraction) * grain.fraction));
  program.setUniformValue("lobeGrain", QVector4D(float(grain.alphaX), float(grain.alphaY),
                                                 float(std::cos(grain.rotation)), float(std::sin(grain.rotation))));
  if (!lobeTextures_) lobeTextures_ = std::make_unique<TextureSet>();
  if (lobe && lobe != uploadedLobe_) {
    uploadWarp(gl, *lobeTextures_, lobe->warp(), lobeCellUnit, lobeRowUnit);
    uploadedLobe_ = lobe;
  }
  lobeTextures_->bind(gl, 0, GL_TEXTURE_3D, lobeCellUnit);
  lobeTextures_->bind(gl, 1, GL_TEXTURE_2D, lobeRowUnit);
}

}  // namespace gonio::widgets
