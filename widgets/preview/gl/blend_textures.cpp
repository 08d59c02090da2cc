// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/blend_textures.h"

#include <cassert>

#include "widgets/preview/gl/model_uniforms.h"
#include "widgets/preview/gl/shader_base.h"

namespace gonio::widgets {

namespace {

void append(std::vector<glm::vec3>& all, const std::vector<glm::vec3>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

void setEdits(QOpenGLShaderProgram& program, const std::vector<editing::DifferentialEdit>& edits) {
  if (edits.empty()) return;
  const auto target = edits[0].model->shaderParameters(edits[0].edited);
  std::vector<glm::vec3> own;
  for (const editing::DifferentialEdit& edit : edits) append(own, edit.model->shaderParameters(edit.fitted));
  program.setUniformValueArray("targetParameters", &target.front().x, int(target.size()), 3);
  program.setUniformValueArray("ownParameters", &own.front().x, int(own.size()), 3);
}

}  // namespace

void BlendTextures::addVariant(const PreviewBlend& blend, QStringList& definitions, QStringList& preamble) {
  definitions << QString("BLEND_TABLES %1").arg(blend.mixture->tables.size());
  if (const DataTransform transform = blend.mixture->transform; transform != DataTransform::none)
    definitions << "BLEND_IN_TRANSFORMED_DOMAIN" << QString("BLEND_TRANSFORM %1").arg(int(transform));
  if (blend.own) {
    definitions << "BLEND_OWN";
    addShaderBase(*blend.own, definitions, preamble);
  }
  if (blend.edits.empty()) return;
  const models::Model& model = *blend.edits[0].model;
  definitions << "BLEND_MOVES" << QString("MODEL_PARAMETERS %1").arg(model.shaderComponents().size());
  addModel(model, definitions, preamble);
}

void BlendTextures::bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program, PreviewResources& resources,
                         const PreviewBlend& blend) {
  const int count = int(blend.mixture->tables.size());
  assert(firstBlendUnit + count <= endOfBlendUnits);
  if (blend.mixture != uploaded_ || !textures_) {
    gl.glActiveTexture(GL_TEXTURE0 + firstBlendUnit);
    textures_ = resources.mixture(blend.mixture);
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
    weights[blend.ownIndex] -= float(blend.ownFraction);
    program.setUniformValue("blendOwnShare", float(blend.ownFraction));
    program.setUniformValue("blendOwnIndex", int(blend.ownIndex));
  }
  program.setUniformValueArray("blendTables", units.data(), count);
  program.setUniformValueArray("blendPhiPeriods", periods.data(), count, 1);
  program.setUniformValueArray("blendWeights", weights.data(), count, 1);
  setEdits(program, blend.edits);
}

void BlendTextures::release() {
  textures_.reset();
  own_.reset();
  uploadedOwn_.reset();
  uploaded_.reset();
}

}  // namespace gonio::widgets
