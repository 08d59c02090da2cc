// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/preview_resources.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>

#include "core/rendering/error_maps.h"
#include "core/support/error.h"

namespace gonio::widgets {

TableTexture::~TableTexture() {
  if (QOpenGLContext* context = QOpenGLContext::currentContext(); context && name)
    context->functions()->glDeleteTextures(1, &name);
}

void PreviewResources::initialize() {
  if (!initializeOpenGLFunctions()) throw Error(openGlTooOld);
  const bool isSoftware = CodeDecoder::isSoftware(*this);
  decodesCodes_ = !isSoftware;
  setUsesFlatUniforms(isSoftware);
  initialized_ = true;
}

void PreviewResources::release() {
  if (!initialized_) return;
  for (GLuint* texture :
       {&environmentTexture_, &lightPoolTexture_, &lightPoolRadianceTexture_, &colourMaps_[0], &colourMaps_[1]}) {
    if (*texture) glDeleteTextures(1, texture);
    *texture = 0;
  }
  decoder_.release(*this);
  programs_.release(*this);
  tables_.clear();
  bases_.clear();
  mixtures_.clear();
  uploadedEnvironment_.reset();
  uploadedMeshes_.clear();
  meshTexture_.reset();
  initialized_ = false;
}

void PreviewResources::setUsesFlatUniforms(bool uses) {
  GLint vectors = 0;
  glGetIntegerv(GL_MAX_VARYING_VECTORS, &vectors);
  programs_.setFlatVectors(uses ? std::optional(vectors - 1) : std::nullopt);  // one is the position's
}

bool PreviewResources::decode(const EnsembleCode& code, GLuint& texture) {
  if (!decodesCodes_) return false;
  const CodeTexels texels = codeTexels(*code.ensemble, code.code);
  if (!CodeDecoder::fits(*this, texels)) return false;
  try {
    decoder_.decode(*this, programs_, texels, texture);
  } catch (const Error&) {
    decodesCodes_ = false;  // the decoded table is at hand
  }
  return decodesCodes_;
}

std::shared_ptr<const TableTexture> PreviewResources::table(const std::shared_ptr<const TabulatedBrdf>& table,
                                                            const std::shared_ptr<const EnsembleCode>& code) {
  if (!table) return nullptr;
  std::erase_if(tables_, [](const auto& entry) { return entry.second.expired(); });
  auto& known = tables_[table];
  if (auto texture = known.lock()) return texture;
  auto texture = std::make_shared<TableTexture>();
  texture->phiPeriod = table->grid().phiDPeriod();
  if (!code || !decode(*code, texture->name))
    uploadTable(*this, texture->name, table->grid(), table->values(), table->valid());
  known = texture;
  return texture;
}

std::shared_ptr<ShaderBase> PreviewResources::base(const std::shared_ptr<const Brdf>& base) {
  std::erase_if(bases_, [](const auto& entry) { return entry.second.expired(); });
  auto& known = bases_[uploadedData(base)];
  auto uploaded = known.lock();
  if (!uploaded) known = uploaded = uploadShaderBase(*this, *base);
  return uploaded;
}

namespace {

/// Two tables of one grid as one, the second above the first along theta_h.
interpolation::TransformedTable stacked(interpolation::TransformedTable lower,
                                        const interpolation::TransformedTable& upper) {
  lower.grid.thetaHCount += upper.grid.thetaHCount;
  lower.values.insert(lower.values.end(), upper.values.begin(), upper.values.end());
  lower.valid.insert(lower.valid.end(), upper.valid.begin(), upper.valid.end());
  return lower;
}

}  // namespace

std::shared_ptr<const MixtureTextures> PreviewResources::mixture(
    const std::shared_ptr<const interpolation::TransformedMixture>& mixture,
    const std::shared_ptr<const interpolation::TransformedMixture>& codes) {
  std::erase_if(mixtures_, [](const auto& entry) { return entry.second.expired(); });
  auto& known = mixtures_[mixture];
  if (auto textures = known.lock()) return textures;
  auto textures = std::make_shared<MixtureTextures>();
  const auto upload = [&](const interpolation::TransformedTable& table) {
    auto& texture = *textures->tables.emplace_back(std::make_unique<TableTexture>());
    texture.phiPeriod = table.grid.phiDPeriod();
    uploadTable(*this, texture.name, table.grid, table.values, table.valid);
  };
  for (std::size_t i = 0; i < mixture->tables.size(); ++i)
    if (codes)
      upload(stacked(mixture->tables[i], codes->tables[i]));
    else
      upload(mixture->tables[i]);
  known = textures;
  return textures;
}

void PreviewResources::bindEnvironment(const std::shared_ptr<const rendering::EnvironmentMap>& environment) {
  if (environment != uploadedEnvironment_) {
    glActiveTexture(GL_TEXTURE0 + environmentUnit);
    uploadEnvironment(*this, environmentTexture_, lightPoolTexture_, lightPoolRadianceTexture_,
                      *environmentTexels(environment));
    uploadedEnvironment_ = environment;
  }
  glActiveTexture(GL_TEXTURE0 + environmentUnit);
  glBindTexture(GL_TEXTURE_2D, environmentTexture_);
  glActiveTexture(GL_TEXTURE0 + lightPoolUnit);
  glBindTexture(GL_TEXTURE_2D, lightPoolTexture_);
  glActiveTexture(GL_TEXTURE0 + lightPoolRadianceUnit);
  glBindTexture(GL_TEXTURE_2D, lightPoolRadianceTexture_);
}

void PreviewResources::bindMeshes(QOpenGLShaderProgram& program, const std::vector<rendering::MeshShape>& meshes) {
  if (meshes != uploadedMeshes_ || !meshTexture_) {
    meshTexture_.reset();
    QOpenGLFunctions_4_1_Core& gl = *this;
    meshTexture_ = std::make_unique<MeshTexture>(gl, meshes);
    uploadedMeshes_ = meshes;
  }
  meshTexture_->bind(*this, program);
}

void PreviewResources::bindColourMap(bool isSigned) {
  glActiveTexture(GL_TEXTURE0 + colourMapUnit);
  if (!colourMaps_[isSigned]) uploadColourMap(isSigned);
  glBindTexture(GL_TEXTURE_2D, colourMaps_[isSigned]);
}

void PreviewResources::uploadColourMap(bool isSigned) {
  constexpr int size = 256;
  std::vector<glm::vec4> texels;
  for (int i = 0; i < size; ++i) {
    const double x = i / (size - 1.0);
    const rendering::DisplayColour colour = isSigned ? rendering::signedColour(2 * x - 1) : rendering::viridis(x);
    texels.push_back(glm::vec4(colour[0], colour[1], colour[2], 255) / 255.f);
  }
  uploadColours(*this, colourMaps_[isSigned], size, texels);
}

}  // namespace gonio::widgets
