// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/preview_renderer.h"

#include <QMatrix3x3>
#include <QVector2D>
#include <QVector3D>
#include <QVector4D>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/vec4.hpp>

#include "core/support/error.h"
#include "widgets/preview/gl/textures.h"

namespace gonio::widgets {

namespace {

constexpr int maxSamples = 64;  // of scene.frag
// A pass in which rays search meshes is short: Mesa's software renderer leaves a shader's loops after 65,535 rounds.
constexpr int maxMeshSamples = 8;
constexpr double bandMilliseconds = 12;
constexpr int mostBands = 16;  // waiting for each has its cost too
QVector3D toVector(const Direction& d) { return {float(d.x), float(d.y), float(d.z)}; }

}  // namespace

PreviewRenderer::PreviewRenderer(std::shared_ptr<PreviewResources> resources) : resources_(std::move(resources)) {
  const Scene sphere = sphereScene();
  setScene(sphere, previewPlan(sphere, diffuseMaterial(Rgb(0.5))));
}

PreviewRenderer::~PreviewRenderer() = default;

void PreviewRenderer::initialize() {
  if (!resources_->isInitialized()) resources_->initialize();
  if (!initializeOpenGLFunctions()) throw Error("the graphics driver does not offer OpenGL 4.1 core");
}

void PreviewRenderer::release() {
  accumulation_.reset();
  tableTexture_.reset();
  shaderBase_.reset();
  lobeTextures_.reset();
  uploadedBase_.reset();
  uploadedLobe_.reset();
  blendTextures_.release();
  if (resources_->isInitialized()) editChain_.release(*this);
  if (resources_.use_count() == 1) resources_->release();
  restart();
}

void PreviewRenderer::setSubject(const PreviewSubject& subject) {
  subject_ = subject;
  restart();
}

void PreviewRenderer::setLobe(std::shared_ptr<const TabulatedLobe> lobe) {
  subject_.lobe = std::move(lobe);
  restart();
}

void PreviewRenderer::setScene(const Scene& scene, const EffectPlan& plan) {
  SceneUniforms uniforms(scene, plan);
  const bool same = scene.camera == scene_.camera && scene.environment == scene_.environment &&
                    scene.environmentRotation == scene_.environmentRotation && uniforms == sceneUniforms_;
  scene_ = scene;
  sceneUniforms_ = std::move(uniforms);
  if (!same) restart();
}

void PreviewRenderer::setSize(const QSize& size) {
  if (size == size_ && accumulation_) return;
  size_ = size.expandedTo({1, 1});
  accumulation_.reset();
  restart();
}

QOpenGLShaderProgram& PreviewRenderer::sceneProgram() {
  QStringList definitions = sceneUniforms_.definitions(), preamble;
  if (const auto* edited = std::get_if<EditedMaterial>(&subject_.shown)) {
    addShaderBase(*edited->base, definitions, preamble);
    EditChain::addVariant(edited->edits, definitions, preamble, factorization::pdvFactorsOf(*edited->base).get());
  } else if (const auto* alone = std::get_if<ModelAlone>(&subject_.shown)) {
    addModelAlone(*alone->model, alone->parameters, definitions, preamble);
  } else if (const auto* blend = std::get_if<PreviewBlend>(&subject_.shown)) {
    BlendTextures::addVariant(*blend, definitions, preamble);
  }
  return resources_->program("preview/scene.frag", definitions, preamble);
}

void PreviewRenderer::setCameraUniforms(QOpenGLShaderProgram& program) {
  const CameraFrame camera = cameraFrame(scene_.camera);
  QMatrix3x3 axes;
  for (int row = 0; row < 3; ++row) {
    axes(row, 0) = float(camera.right[row]);
    axes(row, 1) = float(camera.up[row]);
    axes(row, 2) = float(camera.forward[row]);
  }
  const glm::dvec2 extent = viewExtent(camera, double(size_.width()) / size_.height());
  program.setUniformValue("eye", toVector(camera.eye));
  program.setUniformValue("cameraAxes", axes);
  program.setUniformValue("viewExtent", QVector2D(float(extent.x), float(extent.y)));
  program.setUniformValue("orthographic", camera.orthographic);
  program.setUniformValue("pictureSize", QVector2D(float(size_.width()), float(size_.height())));
  sceneUniforms_.set(program);
}

/// Uniforms and textures of what is shown.
void PreviewRenderer::bindMaterial(QOpenGLShaderProgram& program) {
  if (const auto* edited = std::get_if<EditedMaterial>(&subject_.shown)) {
    bindBase(program, *edited);
    editChain_.bind(*this, program, edited->edits, factorUnit, factorization::pdvFactorsOf(*edited->base));
  } else if (const auto* alone = std::get_if<ModelAlone>(&subject_.shown)) {
    setModelParameters(program, "modelParameters", *alone->model, alone->parameters);
  } else if (const auto* blend = std::get_if<PreviewBlend>(&subject_.shown)) {
    blendTextures_.bind(*this, program, *resources_, *blend);
  }
  if (sceneUniforms_.drawsDirections()) bindLobe(program);
}

void PreviewRenderer::setSampleUniforms(QOpenGLShaderProgram& program, int count) {
  QVector4D numbers[maxSamples];
  QVector2D offsets[maxSamples];
  constexpr int dimensions = 5;
  for (int i = 0; i < count; ++i) {
    const int index = samples_ + i;
    const auto number = [&](int d) { return float(additiveRecurrence(dimensions, d, index)); };
    numbers[i] = {number(0), number(1), number(2), float(index)};
    offsets[i] = {number(3) - 0.5f, number(4) - 0.5f};
  }
  program.setUniformValue("sampleCount", count);
  program.setUniformValueArray("sampleNumbers", numbers, count);
  program.setUniformValueArray("pixelOffsets", offsets, count);
}

void PreviewRenderer::bindBase(QOpenGLShaderProgram& program, const EditedMaterial& material) {
  if (material.base->asTable()) return bindTable(program, material);
  if (material.base != uploadedBase_ || !shaderBase_) {
    shaderBase_ = resources_->base(material.base);
    uploadedBase_ = material.base;
  }
  shaderBase_->bind(*this, program);
}

void PreviewRenderer::bindTable(QOpenGLShaderProgram& program, const EditedMaterial& material) {
  glActiveTexture(GL_TEXTURE0 + tableUnit);
  if (material.base != uploadedBase_ || !tableTexture_) {
    tableTexture_ = resources_->table({material.base, material.base->asTable()}, material.code);
    uploadedBase_ = material.base;
  }
  glActiveTexture(GL_TEXTURE0 + tableUnit);
  glBindTexture(GL_TEXTURE_3D, tableTexture_->name);
  program.setUniformValue("table", tableUnit);
  program.setUniformValue("phiPeriod", float(tableTexture_->phiPeriod));
}

/// The density of the drawn directions; cosine-weighted while it is not known.
void PreviewRenderer::bindLobe(QOpenGLShaderProgram& program) {
  program.setUniformValue("lobeCells", lobeCellUnit);
  program.setUniformValue("lobeRows", lobeRowUnit);
  program.setUniformValue("lobeCosineShare", subject_.lobe ? float(TabulatedLobe::cosineShare) : 1.f);
  const GrainLobe grain = subject_.lobe ? subject_.lobe->grain() : GrainLobe{};
  program.setUniformValue("lobeGrainShare", float((1 - TabulatedLobe::cosineShare) * grain.share));
  program.setUniformValue("lobeGrain", QVector4D(float(grain.alphaX), float(grain.alphaY),
                                                 float(std::cos(grain.rotation)), float(std::sin(grain.rotation))));
  if (!lobeTextures_) lobeTextures_ = std::make_unique<TextureSet>();
  if (subject_.lobe && subject_.lobe != uploadedLobe_) {
    uploadWarp(*this, *lobeTextures_, subject_.lobe->warp(), lobeCellUnit, lobeRowUnit);
    uploadedLobe_ = subject_.lobe;
  }
  lobeTextures_->bind(*this, 0, GL_TEXTURE_3D, lobeCellUnit);
  lobeTextures_->bind(*this, 1, GL_TEXTURE_2D, lobeRowUnit);
}

void PreviewRenderer::bindTextures(QOpenGLShaderProgram& program) {
  if (!sceneUniforms_.meshes().empty()) resources_->bindMeshes(program, sceneUniforms_.meshes());
  if (!sceneUniforms_.usesEnvironment()) return;
  resources_->bindEnvironment(scene_.environment);
  program.setUniformValue("environment", environmentUnit);
  program.setUniformValue("lightPool", lightPoolUnit);
  program.setUniformValue("lightPoolRadiance", lightPoolRadianceUnit);
  program.setUniformValue("environmentTurn", QVector2D(float(std::cos(scene_.environmentRotation)),
                                                       float(std::sin(scene_.environmentRotation))));
}

/// Unbinds the texture of the active unit: comes before textures are bound.
void PreviewRenderer::createTarget() {
  if (accumulation_) return;
  accumulation_ = std::make_unique<QOpenGLFramebufferObject>(size_, QOpenGLFramebufferObject::NoAttachment,
                                                             GL_TEXTURE_2D, GL_RGBA32F);
  samples_ = 0;
}

void PreviewRenderer::prepareTarget() {
  accumulation_->bind();
  glViewport(0, 0, size_.width(), size_.height());
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  if (samples_ == 0) {
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
  }
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
}

void PreviewRenderer::accumulate(int count) {
  if (!hasMaterial() || count <= 0) return;
  QOpenGLShaderProgram& program = sceneProgram();
  program.bind();
  createTarget();
  bindMaterial(program);
  bindTextures(program);
  setCameraUniforms(program);
  prepareTarget();
  const int most = sceneUniforms_.meshes().empty() ? maxSamples : maxMeshSamples;
  for (int left = count; left > 0; left -= most) {
    const int pass = std::min(left, most);
    setSampleUniforms(program, pass);
    drawInBands();
    samples_ += pass;
  }
  glDisable(GL_BLEND);
  program.release();
  accumulation_->release();
}

/// The time of a band tells how many rows the next one has.
void PreviewRenderer::drawInBands() {
  using Clock = std::chrono::steady_clock;
  glEnable(GL_SCISSOR_TEST);
  const int fewestRows = (size_.height() + mostBands - 1) / mostBands;
  int rows = 2 * fewestRows;
  for (int row = 0; row < size_.height();) {
    const Clock::time_point start = Clock::now();
    glScissor(0, row, size_.width(), rows);
    resources_->drawFullscreen();
    glFinish();
    row += rows;
    const double milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    rows = std::max(fewestRows, int(rows * std::clamp(bandMilliseconds / std::max(milliseconds, 1e-3), 0.25, 4.0)));
  }
  glDisable(GL_SCISSOR_TEST);
}

void PreviewRenderer::showTraced(const Film& film) {
  setSize({film.width, film.height});
  createTarget();
  std::vector<glm::vec4> texels;
  texels.reserve(film.radiance.size());
  for (int y = film.height - 1; y >= 0; --y)
    for (int x = 0; x < film.width; ++x) {
      const std::size_t index = std::size_t(y) * std::size_t(film.width) + std::size_t(x);
      texels.emplace_back(film.radiance[index], film.coverage[index]);
    }
  glActiveTexture(GL_TEXTURE0 + accumulationUnit);
  glBindTexture(GL_TEXTURE_2D, accumulation_->texture());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, film.width, film.height, GL_RGBA, GL_FLOAT, texels.data());
  samples_ = film.samples;
}

Image PreviewRenderer::readPicture() {
  Image image(size_.width(), size_.height());
  image.alpha.assign(image.pixels.size(), 0.f);
  if (!accumulation_ || samples_ == 0) return image;
  std::vector<glm::vec4> texels(image.pixels.size());
  accumulation_->bind();
  glReadPixels(0, 0, size_.width(), size_.height(), GL_RGBA, GL_FLOAT, texels.data());
  accumulation_->release();
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const glm::vec4 mean = texels[image.index(x, image.height - 1 - y)] / float(samples_);
      image.at(x, y) = glm::vec3(mean);
      image.alpha[image.index(x, y)] = mean.a;
    }
  return image;
}

}  // namespace gonio::widgets
